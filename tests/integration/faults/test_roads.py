"""Networks that are slow or silent for a time leave no trace in the results. One that is gone, while no end is told, ends the run
within 10 s with exit code 3 and the name of the server, which is free again."""

import time
import unittest

from faults.faulty import FaultTest
from faults.gate import Gate
from programs import PATIENCE
from resume.resumed import results_of

BRIEF = ("--set", "time.duration=0.3 ms", "--set", "output.field_times=[0.1 ms]")  # 36 steps


def byte_by_byte(_, data):
    for byte in data:
        yield bytes([byte])


def slowly(_, data):
    time.sleep(0.02)
    yield data


class Roads(FaultTest):
    @classmethod
    def setUpClass(cls):
        cls.serve()

    def assert_heals(self, which="dem", **ways):
        _, done, _ = self.run_by(which, *BRIEF, **ways)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = results_of(self.folder / "run")
        _, done, _ = self.run_by(which, *BRIEF)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(found == results_of(self.folder / "run"))

    def test_frames_split_at_every_byte(self):
        for which in self.servers:
            self.assert_heals(which, requests=byte_by_byte, answers=byte_by_byte)

    def test_a_slow_network(self):
        self.assert_heals(requests=slowly, answers=slowly)

    def test_silence_of_two_seconds(self):
        gate = Gate(self, "advance", 2)
        self.assert_heals(requests=gate.carry, answers=gate.carry)

    def test_half_open(self):
        gate = Gate(self, "advance")
        address, done, seconds = self.run_by("fdm", requests=gate.carry, answers=gate.carry)
        self.assert_lost("fdm", address, done, "no sign of life for 8 s")
        self.assertLess(seconds, 10 * PATIENCE)
        self.assert_unfinished(f"fdm_server at {address}")
        self.assert_serves("fdm")


if __name__ == "__main__":
    unittest.main()
