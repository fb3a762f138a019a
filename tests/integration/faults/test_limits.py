"""A machine that has no more memory, threads, open files or room for a file: exit code 2 or 5, or 3 where it is a server's machine,
one sentence that says what is lacking; a server serves again once it is there."""

import os
import resource
import subprocess
import tempfile
import unittest

from faults.faulty import SCENE, SHORT, FaultTest
from programs import CASE, COUPLER, PATIENCE_S, Server, counts_resources, coupler, wait_until

MIB = 1 << 20
LARGE = ("--set", "particles.packing.radius=4 mm", "--set", "time.duration=1 us", "--set", "output.field_times=[]")
NOBODY = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups")


class Limits(FaultTest):
    def limited(self, *limits, before=(), out=None, options=SHORT):
        command = [*before, "prlimit", *limits, COUPLER, "run", SCENE, "--out", out or self.folder / "run", *options]
        return subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=PATIENCE_S)

    def assert_ends(self, done, code, *words):
        self.assertEqual(done.returncode, code, done.stderr)
        self.assert_said(done.stderr, *words)

    @counts_resources
    def test_no_descriptors_for_the_coupler(self):
        for count in (6, 8, 12, 16):
            self.assert_ends(self.limited(f"--nofile={count}"), 2, "Too many open files")

    @counts_resources
    def test_no_descriptors_for_a_server(self):
        with Server("dem_server") as server:
            join = ("run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--dem", server.address, *SHORT)
            used = len(os.listdir(f"/proc/{server.process.pid}/fd"))
            for more in (0, 1):
                resource.prlimit(server.process.pid, resource.RLIMIT_NOFILE, (used + more, 1024))
                done = coupler(*join)
                self.assert_ends(done, 3, f"dem_server at {server.address}: ")
            resource.prlimit(server.process.pid, resource.RLIMIT_NOFILE, (1024, 1024))
            wait_until(lambda: coupler(*join).returncode == 0, 10)

    @counts_resources
    def test_no_threads(self):
        """Root may start as many as it likes."""
        folder = tempfile.mkdtemp(prefix="adit_nobody_")
        self.addCleanup(subprocess.run, ["rm", "-r", folder])
        if os.getuid() == 0:
            os.chown(folder, 65534, 65534)
        if os.getuid() != 0 or subprocess.run([*NOBODY, "test", "-x", COUPLER]).returncode:
            self.skipTest("no other user can run the programs here")
        for count in (1, 2, 3, 4, 5, 6):
            done = self.limited(f"--nproc={count}", before=NOBODY, out=f"{folder}/run")
            if done.returncode == 3:  # a server that the coupler has started
                self.assert_said(done.stderr, "_server")
            else:
                self.assert_ends(done, 2, "Resource temporarily unavailable", "ulimit -u")

    @counts_resources
    def test_no_memory_for_a_server(self):
        with Server("dem_server") as server:
            resource.prlimit(server.process.pid, resource.RLIMIT_AS, (200 * MIB, resource.RLIM_INFINITY))
            join = ("run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--dem", server.address)
            self.assert_ends(coupler(*join, *LARGE), 2, f"dem_server at {server.address}: there is not enough memory", "ulimit -v")
            self.assertEqual(coupler(*join, *SHORT).returncode, 0)

    @counts_resources
    def test_no_memory_for_the_coupler(self):
        with Server("dem_server") as server:
            command = ["prlimit", f"--as={100 * MIB}", COUPLER, "run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--dem",
                       server.address, *LARGE, "--set", "output.field_times=[1 us]"]
            done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S)
            self.assert_ends(done, 2, "there is not enough memory", "ulimit -v")

    def test_no_room_in_a_file(self):
        """A limit of a file's size ends the run as a full disk does."""
        fine = ("--set", "output.history_interval=1 us", "--set", "time.duration=50 s")
        done = self.limited(f"--fsize={2 * MIB}", options=fine)
        self.assert_ends(done, 5, "histories.csv: File too large", "ulimit -f")
        self.assert_unfinished("File too large", more_than=100)
        self.assert_ends(self.limited("--fsize=1000"), 5, "File too large")


if __name__ == "__main__":
    unittest.main()
