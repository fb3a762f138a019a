"""A process that is killed, ends or stops is named within 10 s, with exit code 3, and the results until then stay readable. The
others are free again."""

import os
import pathlib
import signal
import subprocess
import time
import unittest

from faults.faulty import SHORT, FaultTest
from programs import CASE, COUPLER, PATIENCE, Server, children_of, coupler, wait_until

PACKS_FOR_MINUTES = "particles={random_packing: {x_min: 0 m, x_max: 500 m, y_min: 0 m, y_max: 500 m, radius_min: 0.5 m, radius_max: 1 m, stress: 1 MPa}}"


class Lost(FaultTest):
    def setUp(self):
        super().setUp()
        self.servers = {}
        for which in ("fdm", "dem"):
            self.servers[which] = Server(f"{which}_server")
            self.addCleanup(self.servers[which].__exit__)
        self.joined = [word for which, server in self.servers.items() for word in (f"--{which}", server.address)]

    def assert_named(self, which, *signals):
        """Sends the signals to one of two servers in mid-run."""
        run = self.started(*self.joined)
        begin = time.monotonic()
        for number in signals:
            self.servers[which].process.send_signal(number)
        errors = run.communicate(timeout=30 * PATIENCE)[1]
        self.assertLess(time.monotonic() - begin, 10)
        self.assertEqual(run.returncode, 3, errors)
        self.assert_said(errors, f"{which}_server at {self.servers[which].address}: ")
        self.assert_unfinished(f"{which}_server", more_than=5)
        self.assert_serves({"fdm": "dem", "dem": "fdm"}[which])

    def test_continuum_killed(self):
        self.assert_named("fdm", signal.SIGKILL)

    def test_particles_killed(self):
        self.assert_named("dem", signal.SIGKILL)

    def test_particles_told_to_end(self):
        self.assert_named("dem", signal.SIGTERM)

    def test_particles_crash(self):
        self.assert_named("dem", signal.SIGABRT)  # a sanitizer would report the others

    def test_particles_hang(self):
        self.assert_named("dem", signal.SIGSTOP)

    def test_both_killed(self):
        run = self.started(*self.joined)
        for server in self.servers.values():
            server.process.kill()
        errors = run.communicate(timeout=30 * PATIENCE)[1]
        self.assertEqual(run.returncode, 3, errors)
        self.assert_said(errors, "_server at ")
        self.assert_unfinished("_server at ", more_than=5)

    def test_killed_in_its_set_up(self):
        run = subprocess.Popen([COUPLER, "run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--set", PACKS_FOR_MINUTES],
                               stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        self.assertIn("builds its model", run.stderr.readline())
        os.kill(children_of(run.pid)[0], signal.SIGKILL)
        errors = run.communicate(timeout=10)[1]
        self.assertEqual(run.returncode, 3, errors)
        self.assert_said(errors, "dem_server at ")
        self.assertFalse((self.folder / "run/summary.json").exists())

    def test_a_signal_in_its_set_up(self):
        """There is nothing new yet that could be kept; what an earlier run left stays."""
        folder = self.run_scene(CASE / "full_dem.yaml", *SHORT, out="run")
        earlier = (folder / "summary.json").read_bytes()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            run = subprocess.Popen([COUPLER, "run", CASE / "full_dem.yaml", "--out", folder, "--set", PACKS_FOR_MINUTES],
                                   stderr=subprocess.DEVNULL, preexec_fn=lambda: signal.signal(number, signal.SIG_DFL))
            self.addCleanup(run.kill)
            wait_until(lambda: children_of(run.pid))
            time.sleep(0.5)
            servers = children_of(run.pid)
            run.send_signal(number)
            self.assertEqual(run.wait(5), -number)
            wait_until(lambda: not any(alive(pid) for pid in servers), 5)
            self.assertEqual((folder / "summary.json").read_bytes(), earlier)

    def test_a_pause_of_the_coupler_and_of_a_server(self):
        """As by Ctrl-Z and fg: the run goes on."""
        run = self.started(*self.joined)
        for pid in (run.pid, self.servers["dem"].process.pid):
            os.kill(pid, signal.SIGSTOP)
            time.sleep(1)
            os.kill(pid, signal.SIGCONT)
            time.sleep(0.2)
        self.assertIsNone(run.poll())
        run.terminate()
        self.assertEqual(run.wait(20), 128 + signal.SIGTERM)

    def test_the_coupler_is_killed(self):
        """Servers that it started end; others serve the next run."""
        run = self.started("--dem", self.servers["dem"].address)
        children = children_of(run.pid)
        self.assertEqual(len(children), 1)
        run.kill()
        run.wait()
        wait_until(lambda: not any(alive(pid) for pid in children), 10)
        self.assert_serves("dem")
        self.assert_whole_rows(self.folder / "run", more_than=5)

    def test_a_busy_server_refuses_at_once_and_serves_again_afterwards(self):
        run = self.started("--dem", self.servers["dem"].address)
        begin = time.monotonic()
        second = coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "second", "--dem", self.servers["dem"].address)
        self.assertEqual(second.returncode, 2, second.stderr)
        self.assertIn("busy", second.stderr)
        self.assertLess(time.monotonic() - begin, 5)
        run.kill()
        run.wait()
        self.assert_serves("dem")


def alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return pathlib.Path(f"/proc/{pid}/stat").read_text().split(")")[1].split()[0] != "Z"


if __name__ == "__main__":
    unittest.main()
