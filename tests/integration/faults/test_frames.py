"""Frames that no correct end sends. From a server they end the run with exit code 3 and its name; from a coupler, whose bug they
are, with exit code 1 and the refusal of the server, which serves the next run."""

import random
import struct
import unittest

from faults.faulty import FaultTest, at, frame
from link import wire_pb2
from programs import PATIENCE

REQUESTS = ("hello", "setup", "weights", "couple", "advance", "snapshot_request", "save", "finish")
ANSWERS = ("hello", "model", "interface", "operator", "predicted", "snapshot", "state", "bye")


class Frames(FaultTest):
    @classmethod
    def setUpClass(cls):
        cls.serve()

    def assert_refused(self, replace, words, requests=REQUESTS, answers=ANSWERS):
        """`replace` yields what goes in the place of a frame; `words` are said of it in any of its phases."""
        for way, kinds in (("requests", requests), ("answers", answers)):
            for i, kind in enumerate(kinds):
                which = ("fdm", "dem")[i % 2]
                with self.subTest(f"{way} of {which}: {kind}"):
                    nth = 5 if kind in ("advance", "predicted") else 1
                    address, done, seconds = self.run_by(which, **{way: at(kind, nth, replace)})
                    code, said = (1, " cannot answer: ") if way == "requests" else (3, ": ")
                    self.assertEqual(done.returncode, code, done.stderr)
                    self.assert_said(done.stderr, f"{which}_server at {address}{said}")
                    self.assertRegex(done.stderr.splitlines()[-1], words)
                    self.assertLess(seconds, 10 * PATIENCE)
                    self.assert_serves(which)

    def test_oversized_frames(self):
        self.assert_refused(lambda data: [b"\xff\xff\xff\x7f" + data[4:]], "announced a frame of 2147483647 bytes, but at most")

    def test_empty_frames(self):
        self.assert_refused(lambda data: [struct.pack("<I", 0), data], "sent 0 bytes that are not a frame")

    def test_noise_in_the_place_of_a_frame(self):
        noise = struct.pack("<I", 100) + random.Random(7).randbytes(100)
        self.assert_refused(lambda data: [noise], "sent 100 bytes that are not a frame")

    def test_frames_sent_twice(self):
        words = "request out of order|came twice|where .* was expected|predicted something else than step"
        # A run that is over is not harmed, and a second part of a state is one that nobody asked for.
        self.assert_refused(lambda data: [data, data], words, REQUESTS[:6], ANSWERS[:-1])

    def test_frames_in_the_wrong_order(self):
        self.assert_refused(lambda data: [frame(advance={"step": 9, "dt": 1e-6})], "request out of order",
                            requests=REQUESTS[1:], answers=())
        self.assert_refused(lambda data: [frame(bye={})], "answered bye where .* was expected|did not begin with hello|in the place",
                            requests=(), answers=ANSWERS[:-1])

    def test_an_error_of_control_characters(self):
        evil = frame(error={"kind": wire_pb2.Error.INTERNAL, "message": "\x1b[2J\nno\r\x07"})
        address, done, _ = self.run_by("dem", answers=at("predicted", 5, lambda data: [evil]))
        self.assert_lost("dem", address, done, "no")
        self.assertFalse(set("\x1b\r\x07") & set(done.stderr.splitlines()[-1]))
        self.assert_serves("dem")


if __name__ == "__main__":
    unittest.main()
