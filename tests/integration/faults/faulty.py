"""What a fault must leave behind: one sentence that names the right one, results that can be read, servers that serve."""

import shutil
import subprocess
import time

from foreign import Listener, framed, road
from link import wire_pb2
from programs import CASE, COUPLER, PATIENCE_S, ProgramTest, Server, coupler, wait_until

SCENE = CASE / "coupled.yaml"
SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[1 ms]", "--set", "output.checkpoint={}")
LONG = ("--set", "time.duration=50 s", "--set", "output.history_interval=0.1 ms", "--set", "output.field_times=[1 ms]")


def at(kind, nth, replace):
    """Whole frames, but for the nth one of a kind: `replace` yields what goes on in its place, given its bytes."""
    count = 0

    def carry(found, data):
        nonlocal count
        count += found == kind
        yield from replace(data) if found == kind and count == nth else [data]

    return carry


def frame(**content):
    """The bytes of a frame."""
    return framed(wire_pb2.Frame(**content).SerializeToString())


class FaultTest(ProgramTest):
    @classmethod
    def serve(cls):
        """Two servers that outlive all runs of the tests of a class."""
        cls.servers = {}
        for which in ("fdm", "dem"):
            cls.servers[which] = Server(f"{which}_server")
            cls.addClassCleanup(cls.servers[which].__exit__)

    def run_by(self, which, *options, command=None, **ways):
        """A short run whose way to one of the servers is `ways`; returns the address that it meets, the run and its time [s]."""
        listener = Listener(road(self.servers[which], **ways))
        begin = time.monotonic()
        command = command or ("run", SCENE, "--out", self.folder / "run", *SHORT)
        done = coupler(*command, f"--{which}", listener.address, *options)
        return listener.address, done, time.monotonic() - begin

    def started(self, *options, before=(), **popen):
        """A long run that has written fields."""
        run = subprocess.Popen([*map(str, (*before, COUPLER, "run", SCENE, "--out", self.folder / "run", *LONG, *options))],
                               **{"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True, **popen})
        self.addCleanup(run.communicate)
        self.addCleanup(run.kill)
        wait_until(lambda: (self.folder / "run/fields/fields.pvd").exists() or run.poll() is not None)
        self.assertIsNone(run.poll())
        return run

    def run_beside(self, script, command="run"):
        """A run by a coupler beside a server that is a shell's script, or beside none; and its time [s]."""
        for name in ("coupler", "fdm_server"):
            (self.folder / name).mkdir(exist_ok=True)
        program = shutil.copy(COUPLER, self.folder / "coupler")  # which looks for servers beside itself
        if script is not None:
            server = self.folder / "fdm_server/fdm_server"
            server.write_text(f"#!/bin/sh\n{script}\n")
            server.chmod(0o755)
        begin = time.monotonic()
        done = subprocess.run([program, command, CASE / "full_fdm.yaml"], cwd=self.folder, capture_output=True, text=True, timeout=PATIENCE_S)
        return done, time.monotonic() - begin

    def assert_said(self, errors, *words):
        last = errors.strip().splitlines()[-1]
        for word in words:
            self.assertIn(word, last)

    def assert_lost(self, which, address, done, *words):
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assert_said(done.stderr, f"{which}_server at {address}: ", *words)

    def assert_unfinished(self, *words, run="run", more_than=0):
        """What was written is whole, and the summary says how it ended."""
        run = self.folder / run
        self.assert_whole_rows(run, more_than)
        summary = self.summary(run)
        self.assertFalse(summary["completed"])
        for word in words:
            self.assertIn(word, summary["error"])
        self.assertEqual([*run.rglob("*.part"), *run.glob("checkpoints/unfinished"), *run.glob("reserve")], [])

    def assert_serves(self, which, within=10):
        """The server takes the next run, once it has parted from the one before."""
        short = ("--set", "time.duration=1 ms", "--set", "output.field_times=[]")
        wait_until(lambda: coupler("run", CASE / f"full_{which}.yaml", "--out", self.folder / "next", *short, f"--{which}",
                                   self.servers[which].address).returncode == 0, within)
