"""Whoever is lost of the FEniCSx continuum under MPI, the run ends and nothing stays behind; and all of adit conformance."""

import signal
import subprocess
import unittest

from peers.mpi_server import LostTest, needed, served
from programs import ADIT


class Guards(LostTest):
    def test_the_first_rank_is_stopped(self):
        self.assert_named(lambda server: server.rank(0), signal.SIGSTOP, r"rank 0 of 2, process \d+ on \S+, was stopped by SIGSTOP")

    def test_a_guard_is_killed(self):
        self.assert_named(lambda server: server.guard(1), signal.SIGKILL, "rank 1 of 2")

    def test_a_guard_is_stopped(self):
        self.assert_named(lambda server: server.guard(1), signal.SIGSTOP, "rank 1 of 2 is silent")

    def test_the_first_guard_is_stopped(self):
        self.assert_named(lambda server: server.guard(0), signal.SIGSTOP, "no sign of life for 8 s")

    def test_mpirun_is_killed(self):
        self.assert_named(lambda server: server.process.pid, signal.SIGKILL, r"rank \d of 2|closed the connection")


@needed
class Conformance(unittest.TestCase):
    def test_all_checks(self):
        done = subprocess.run([*ADIT, "conformance", "--fdm", " ".join(served(2))], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)


if __name__ == "__main__":
    unittest.main()
