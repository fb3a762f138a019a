"""Participants under mpirun, FEniCSx among them, as tests start and stop them."""

import importlib.util
import os
import shutil
import subprocess
import time
import unittest

from programs import CASE, COUPLER, SOURCE, Listening, ProgramTest, children_of, wait_until

SERVE = SOURCE / "adapters/fenicsx/serve.py"


def mpirun(ranks):
    """The beginning of a command on so many ranks."""
    # mpirun refuses root without a word.
    as_root = ["--allow-run-as-root"] if os.geteuid() == 0 else []
    return ["mpirun", "-np", str(ranks), "--oversubscribe", "--bind-to", "none", *as_root]


def served(ranks):
    return [*mpirun(ranks), str(SERVE)]


needed = unittest.skipUnless(shutil.which("mpirun") and importlib.util.find_spec("dolfinx"),
                             "needs the Debian packages python3-dolfinx-real and openmpi-bin (scripts/setup adapters)")


class Ranks(Listening):
    """A participant under mpirun, which ends what it started when it is asked to."""

    def end(self):
        if self.process.poll() is None:
            self.process.terminate()
        self.process.communicate()


class MpiServer(Ranks):
    def __init__(self, ranks=2):
        super().__init__(served(ranks))
        self.guards = children_of(self.process.pid)

    def rank(self, number):
        """The process id of the one that computes."""
        return next(child for guard in self.guards for child in children_of(guard) if self.number(guard) == number)

    @staticmethod
    def number(guard):
        with open(f"/proc/{guard}/environ", "rb") as file:
            return int(dict(entry.split(b"=", 1) for entry in file.read().split(b"\0") if entry)[b"OMPI_COMM_WORLD_RANK"])

    def guard(self, number):
        return next(guard for guard in self.guards if self.number(guard) == number)


@needed
class LostTest(ProgramTest):
    def assert_named(self, who, number, words):
        """Sends a signal to a process of the server in the middle of a run."""
        server = MpiServer()
        self.addCleanup(server.end)
        out = self.folder / "run"
        command = [COUPLER, "run", CASE / "variants/coupled_52x6.yaml", "--set", "time.duration=100 s", "--fdm", server.address, "--out", out]
        run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.kill)
        wait_until(lambda: (out / "histories.csv").is_file() and (out / "histories.csv").stat().st_size > 1000)
        begin = time.monotonic()
        os.kill(who(server), number)
        errors = run.communicate(timeout=30)[1]
        self.assertLess(time.monotonic() - begin, 10)
        self.assertEqual(run.returncode, 3, errors)
        self.assertIn(f"fenicsx_continuum at {server.address}: ", errors)
        self.assertRegex(errors, words)
        self.assert_whole_rows(out, more_than=2)
        server.process.communicate(timeout=20)  # mpirun ends, and all that it started
        self.assertNotEqual(server.process.returncode, 0)
        wait_until(lambda: not any(running(guard) for guard in server.guards))


def running(pid):
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False
