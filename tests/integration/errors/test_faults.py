"""A lost participant is named within 10 s, with exit code 3, and the results until then stay readable."""

import csv
import os
import pathlib
import signal
import subprocess
import time
import unittest

from programs import CASE, COUPLER, ProgramTest, Server, coupler

LONG = ("--set", "time.duration=50 s", "--set", "output.history_interval=0.1 ms", "--set", "output.field_times=[1 ms]")


class Faults(ProgramTest):
    def lose(self, victim, send_signal):
        """Ends one of two servers in mid-run; returns the coupler's exit code, message and delay."""
        with Server("fdm_server") as fdm, Server("dem_server") as dem:
            run = subprocess.Popen([COUPLER, "run", CASE / "coupled.yaml", "--out", self.folder / "run",
                                    "--fdm", fdm.address, "--dem", dem.address, *LONG],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            self.addCleanup(run.kill)
            self.wait_for(lambda: (self.folder / "run" / "fields" / "fields.pvd").exists())
            server = {"fdm_server": fdm, "dem_server": dem}[victim]
            start = time.monotonic()
            server.process.send_signal(send_signal)
            message = run.communicate(timeout=30)[1]
            return run.returncode, message, time.monotonic() - start, server.address

    @staticmethod
    def wait_for(condition, patience=30):
        end = time.monotonic() + patience
        while not condition():
            if time.monotonic() > end:
                raise TimeoutError
            time.sleep(0.02)

    def assert_named(self, victim, send_signal):
        code, message, delay, address = self.lose(victim, send_signal)
        self.assertEqual(code, 3, message)
        self.assertLess(delay, 10)
        last = message.strip().split("\n")[-1]
        self.assertIn(victim, last)
        self.assertIn(address, last)
        rows = list(csv.DictReader((self.folder / "run" / "histories.csv").read_text().splitlines()))
        self.assertGreater(len(rows), 5)
        self.assertTrue(all(None not in row.values() for row in rows))
        summary = self.summary(self.folder / "run")
        self.assertFalse(summary["completed"])
        self.assertIn(victim, summary["error"])

    def test_continuum_killed(self):
        self.assert_named("fdm_server", signal.SIGKILL)

    def test_particles_killed(self):
        self.assert_named("dem_server", signal.SIGKILL)

    def test_particles_hang(self):
        self.assert_named("dem_server", signal.SIGSTOP)

    def test_servers_end_with_the_coupler_that_started_them(self):
        run = subprocess.Popen([COUPLER, "run", CASE / "coupled.yaml", "--out", self.folder / "run", *LONG],
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.wait_for(lambda: (self.folder / "run" / "fields" / "fields.pvd").exists())
        children = [int(pid) for pid in pathlib.Path(f"/proc/{run.pid}/task/{run.pid}/children").read_text().split()]
        self.assertEqual(len(children), 2)
        run.kill()
        run.wait()
        self.wait_for(lambda: not any(alive(pid) for pid in children), 10)

    def test_a_busy_server_refuses_at_once_and_serves_again_afterwards(self):
        with Server("dem_server") as dem:
            long = subprocess.Popen([COUPLER, "run", CASE / "full_dem.yaml", "--out", self.folder / "long",
                                     "--dem", dem.address, *LONG], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.addCleanup(long.kill)
            self.wait_for(lambda: (self.folder / "long" / "fields" / "fields.pvd").exists())
            start = time.monotonic()
            second = coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "second", "--dem", dem.address)
            self.assertEqual(second.returncode, 2, second.stderr)
            self.assertIn("busy", second.stderr)
            self.assertLess(time.monotonic() - start, 5)
            long.kill()
            long.wait()
            again = ("run", CASE / "full_dem.yaml", "--out", self.folder / "third", "--dem", dem.address,
                     "--set", "time.duration=1 ms", "--set", "output.field_times=[]")
            self.wait_for(lambda: coupler(*again).returncode == 0, 10)


def alive(pid):
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    return pathlib.Path(f"/proc/{pid}/stat").read_text().split(")")[1].split()[0] != "Z"


if __name__ == "__main__":
    unittest.main()
