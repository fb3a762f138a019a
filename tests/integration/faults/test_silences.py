"""Silences that last (nightly): beyond 8 s the run ends within 10 s with exit code 3 and the name of the server, and goes on from
its checkpoint with the results of a run that was never disturbed. A peer that beats may take its time."""

import os
import signal
import time
import unittest

from faults.faulty import SCENE, SHORT, FaultTest, at, frame
from faults.gate import Gate
from programs import coupler, wait_until
from resume.resumed import results_of


def a_byte_a_second(data):
    for i in range(len(data)):
        yield data[i:i + 1]
        time.sleep(1)


class Silences(FaultTest):
    @classmethod
    def setUpClass(cls):
        cls.serve()

    def test_ten_seconds_of_silence(self):
        """It heals after the run has ended; the run goes on by the same servers."""
        often = ("--set", "output.checkpoint.interval=1 ms")
        whole = self.run_scene(SCENE, *SHORT, out="whole")
        for which in self.servers:
            gate = Gate(self, "advance", 10)
            address, done, seconds = self.run_by(which, *often, requests=gate.carry, answers=gate.carry)
            self.assert_lost(which, address, done, "no sign of life for 8 s")
            self.assertLess(seconds, 10)
            wait_until(lambda: coupler("resume", self.folder / "run", f"--{which}", self.servers[which].address).returncode == 0, 10)
            self.assertTrue(results_of(self.folder / "run") == results_of(whole))

    def test_six_seconds_of_silence(self):
        whole = self.run_scene(SCENE, *SHORT, out="whole")
        gate = Gate(self, "advance", 6)
        _, done, _ = self.run_by("dem", requests=gate.carry, answers=gate.carry)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(results_of(self.folder / "run") == results_of(whole))

    def test_half_open_from_the_server(self):
        gate = Gate(self, "predicted")
        address, done, seconds = self.run_by("dem", answers=gate.carry)
        self.assert_lost("dem", address, done, "no sign of life for 8 s")
        self.assertLess(seconds, 10)
        self.assert_serves("dem")

    def test_half_open_to_the_server(self):
        """The server hears nothing and says so, and the coupler names it."""
        gate = Gate(self, "advance")
        address, done, seconds = self.run_by("dem", requests=gate.carry)
        self.assert_lost("dem", address, done)
        self.assertLess(seconds, 10)
        self.assert_serves("dem")

    def test_one_byte_a_second_from_a_server(self):
        for kind in ("model", "predicted"):
            address, done, seconds = self.run_by("fdm", answers=at(kind, 1, a_byte_a_second))
            self.assert_lost("fdm", address, done, "more slowly than")
            self.assertLess(seconds, 15)
            self.assert_serves("fdm")

    def test_one_byte_a_second_to_a_server(self):
        address, done, seconds = self.run_by("fdm", requests=at("advance", 1, a_byte_a_second))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assert_said(done.stderr, f"fdm_server at {address} cannot answer", "more slowly than")
        self.assertLess(seconds, 15)
        self.assert_serves("fdm")

    def test_an_answer_that_is_late(self):
        def late(data):
            for _ in range(12):
                yield frame(heartbeat={})
                time.sleep(1)
            yield data

        for kind in ("model", "predicted"):
            _, done, seconds = self.run_by("dem", answers=at(kind, 1, late))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertGreater(seconds, 12)

    def test_the_coupler_stops(self):
        """The server parts from a coupler that has stopped, for the next one."""
        run = self.started("--dem", self.servers["dem"].address)
        os.kill(run.pid, signal.SIGSTOP)
        begin = time.monotonic()
        self.assert_serves("dem", within=12)
        self.assertGreater(time.monotonic() - begin, 5)
        os.kill(run.pid, signal.SIGCONT)
        self.assertEqual(run.wait(20), 3)

    def test_a_server_that_does_not_begin_to_listen(self):
        done, seconds = self.run_beside("echo loading >&2; exec sleep 60")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assert_said(done.stderr, "fdm_server: did not start listening within 10 s", "the last line of its log: loading")
        self.assertLess(seconds, 15)


if __name__ == "__main__":
    unittest.main()
