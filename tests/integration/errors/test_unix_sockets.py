"""Servers of the same machine are reached at a Unix socket, whose file comes and goes with the server."""

import os
import signal
import stat
import subprocess
import unittest

from programs import BUILD, CASE, COUPLER, PATIENCE_S, ProgramTest, Server, coupler

SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[]")


class UnixSockets(ProgramTest):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "dem"
        self.address = f"unix:{self.path}"

    def join(self, address, *options):
        return coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "joined", "--dem", address, *SHORT, *options)

    def refused(self, *options):
        """What a server says that does not begin to listen."""
        result = subprocess.run([BUILD / "dem_server/dem_server", *options], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(result.returncode, 2, result.stderr)
        return result.stderr

    def test_runs_follow_each_other_with_the_results_of_tcp(self):
        histories = self.folder / "joined/histories.csv"
        with Server("dem_server") as server:
            self.assertEqual(self.join(server.address).returncode, 0)
        by_tcp = histories.read_bytes()
        with Server("dem_server", self.address) as server:
            self.assertEqual(server.address, self.address)
            for _ in range(2):
                result = self.join(self.address)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(histories.read_bytes(), by_tcp)

    def test_the_file_goes_with_the_server(self):
        with Server("dem_server", self.address) as server:
            self.assertTrue(stat.S_ISSOCK(self.path.stat().st_mode))
            server.process.terminate()
            self.assertEqual(server.process.wait(PATIENCE_S), 0)
        self.assertFalse(self.path.exists())

    def test_the_file_of_a_dead_server_is_replaced(self):
        with Server("dem_server", self.address) as server:
            server.process.send_signal(signal.SIGKILL)
            server.process.wait(PATIENCE_S)
        self.assertTrue(self.path.exists())
        self.assertIn(f"nothing listens at {self.address}", self.join(self.address).stderr)
        with Server("dem_server", self.address):
            self.assertEqual(self.join(self.address).returncode, 0)

    def test_a_server_that_lives_keeps_its_file(self):
        with Server("dem_server", self.address):
            self.assertIn(f"{self.address} is in use", self.refused("--listen", self.address))
            self.assertEqual(self.join(self.address).returncode, 0)

    def test_a_file_of_somebody_stays(self):
        self.path.write_text("mine")
        self.assertIn("a file that is no socket is there", self.refused("--listen", self.address))
        self.assertEqual(self.path.read_text(), "mine")

    def test_paths_that_no_socket_can_have(self):
        long = f"unix:/tmp/{'x' * 103}"  # one byte too many
        self.assertIn("1 to 107 bytes", self.refused("--listen", long))
        result = self.join(long)
        self.assertEqual(result.returncode, 2)
        self.assertIn("this one has 108", result.stderr)
        self.assertIn("No such file or directory", self.refused("--listen", f"unix:{self.folder}/nowhere/dem"))

    def test_tls_is_for_other_machines(self):
        self.assertIn("leave it out", self.refused("--listen", self.address, "--tls", self.folder))

    @unittest.skipUnless(os.getuid() == 0, "only root can become another user")
    def test_another_user_is_not_let_in(self):
        nobody = 65534
        self.folder.chmod(0o755)
        out = self.folder / "theirs"
        out.mkdir()
        os.chown(out, nobody, nobody)
        if subprocess.run(["test", "-x", COUPLER], user=nobody).returncode:
            self.skipTest("another user cannot run the programs under test")
        with Server("dem_server", self.address):
            self.path.chmod(0o755)  # as by the usual umask
            result = subprocess.run([COUPLER, "run", CASE / "full_dem.yaml", "--out", out / "run", "--dem", self.address, *SHORT],
                                    capture_output=True, text=True, timeout=PATIENCE_S, user=nobody, cwd=out)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("this user may not connect", result.stderr)


if __name__ == "__main__":
    unittest.main()
