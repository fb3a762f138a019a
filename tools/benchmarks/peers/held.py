"""Codes that hold a model and compute steps of it whenever they are asked to, so that several can take turns."""

import os
import pathlib
import shlex
import signal
import subprocess
import tempfile
import threading
import time

from benchmarks.peers.particles import GRANULAR, LAMMPS, beam, data
from adit.conformance.client import Participant, scene, text_format


def mpirun(ranks, *options):
    """The beginning of a command; each rank has a core of its own where there are enough of them."""
    as_root = ("--allow-run-as-root",) if os.geteuid() == 0 else ()
    bind = "core" if ranks <= len(os.sched_getaffinity(0)) else "none"
    return "mpirun", "-np", str(ranks), "--oversubscribe", "--bind-to", bind, *as_root, *options


class Server:
    """A participant under mpirun, which computes steps of a scene without a coupler."""

    def __init__(self, role, command, described):
        self.participant, self.ended, self.at = Participant(role, shlex.join(map(str, command))), threading.Event(), 0
        self.run = self.participant.run()
        threading.Thread(target=self.run.link.beat, args=(self.ended,), daemon=True).start()
        self.run.set_up(text_format.Parse(described, scene.Scene()))
        self.run.weigh(coupled=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Rank 0 tells the others to end."""
        self.ended.set()
        self.run.link.socket.close()
        mpirun = self.participant.process
        ranks = pathlib.Path(f"/proc/{mpirun.pid}/task/{mpirun.pid}/children").read_text().split()
        os.kill(min(map(int, ranks)), signal.SIGTERM)
        mpirun.wait()

    def step(self):
        self.run.step(self.at, self.run.model.critical_dt / 2)
        self.at += 1

    def seconds(self, steps):
        """Time of one step. The first step also waits for the computing that the last answer left over."""
        self.step()
        begin = time.perf_counter()
        for _ in range(steps):
            self.step()
        return (time.perf_counter() - begin) / steps


class Granular:
    """LAMMPS's own discs that touch with history, a packing of touching ones, on one rank."""

    def __init__(self, discs, rows):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "beam.data").write_text(data(*beam(discs, rows), bonded=False))
            (folder / "in.beam").write_text(GRANULAR.replace("STEPS", "0"))
            self.process = subprocess.Popen([*LAMMPS, "in.beam"], cwd=folder, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
            self.command("timer off")  # once it has read the files

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.communicate()

    def command(self, text):
        """The time of a command [s]."""
        print(text, file=self.process.stdin, flush=True)
        return float(next(line for line in self.process.stdout if line.startswith("seconds ")).split()[1])

    def seconds(self, steps):
        return self.command(f"run {steps} pre no post no") / steps
