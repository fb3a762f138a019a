"""What no correct coupler asks. It is our bug, exit code 1: the participant refuses it and says what was wrong, and serves the next
run. Numbers that break its model are told as instability, exit code 4."""

import unittest

from faults.faulty import FaultTest, at
from foreign import framed
from link import wire_pb2

NAN, INF = float("nan"), float("inf")


def with_first(field, value):
    def change(request):
        getattr(request, field)[0] = value
    return change


def with_value(field, value):
    return lambda request: setattr(request, field, value)


def changed(kind, change, nth):
    def replace(data):
        frame = wire_pb2.Frame.FromString(data[4:])
        change(getattr(frame, kind))
        yield framed(frame.SerializeToString())
    return at(kind, nth, replace)


class Requests(FaultTest):
    @classmethod
    def setUpClass(cls):
        cls.serve()

    def assert_refused(self, kind, change, *words, nth=5, code=1):
        for which in self.servers:
            address, done, _ = self.run_by(which, requests=changed(kind, change, nth))
            self.assertEqual(done.returncode, code, done.stderr)
            self.assert_said(done.stderr, f"{which}_server at {address}", *words)
            self.assert_serves(which)

    def test_numbers_that_are_not_finite(self):
        for value in (NAN, INF, -INF):
            self.assert_refused("weights", with_first("weights", value), "a number must be finite: weights.weights[0]", nth=1)
            self.assert_refused("couple", with_first("points", value), "a number must be finite: couple.points[0]", nth=1)
            self.assert_refused("advance", with_first("impulses", value), "a number must be finite: advance.impulses[0]")
            self.assert_refused("advance", with_value("dt", value), "a number must be finite: advance.dt")

    def test_numbers_that_contradict_the_conversation(self):
        self.assert_refused("weights", with_first("weights", 1e300), "outside [0, 1]", nth=1)
        self.assert_refused("weights", lambda request: request.weights.pop(), "weights", nth=1)
        self.assert_refused("advance", with_value("dt", -1.0), "dt", nth=1)
        self.assert_refused("advance", with_value("dt", 1e-300), "dt")
        self.assert_refused("advance", with_value("step", 2**63), "request out of order")
        self.assert_refused("advance", lambda request: request.impulses.pop(), "impulse components came for")

    def test_impulses_beyond_all_bounds(self):
        self.assert_refused("advance", with_first("impulses", 1e300), "step 4", code=4)


if __name__ == "__main__":
    unittest.main()
