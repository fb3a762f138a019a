"""Runs programs and measures what they cost: CPU time, wall-clock time, peak memory, updates."""
import os
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

import yaml

from adit import Run, Unusable, programs

LOOKS = 0.02  # time between two looks at the memory of the processes [s]
ELEMENTS = ("elements", "bodies", "columns")  # of the simplified models


@dataclass
class Meter:
    """Computes the runs of one variant below `folder` and adds up what they cost. Memory is that of the largest run: the sum
    over its processes of the largest memory of each."""
    folder: Path
    cpu_s: float = 0
    wall_s: float = 0
    memory_bytes: int = 0
    counts: dict = field(default_factory=lambda: {"particles": 0, "zones": 0, "elements": 0, "updates": 0})

    def run(self, program, scene, name, settings=(), *words):
        """Computes a scene with these `--set` texts and returns its Run."""
        out = self.folder / name
        self.folder.mkdir(parents=True, exist_ok=True)
        sets = [word for setting in settings for word in ("--set", setting)]
        with open(self.folder / f"{name}.log", "w+b") as errors:
            begun = time.monotonic()
            process = subprocess.Popen([programs.program(program), "run", scene, *sets, *words, "--out", out],
                                       stdout=subprocess.DEVNULL, stderr=errors)
            usage, memory = wait(process)
            errors.seek(0)
            said = errors.read().decode(errors="replace").splitlines()
        if process.returncode:
            raise Unusable(f"{out} failed (exit code {process.returncode}): {said[-1] if said else 'it said nothing'}")
        run = Run(out)
        self.wall_s += time.monotonic() - begun
        self.cpu_s += usage.ru_utime + usage.ru_stime
        self.memory_bytes = max(self.memory_bytes, memory)
        self._count(run.summary)
        return run

    def run_scene(self, scene, name, settings=()):
        """The same of a scene that is given as mappings and lists."""
        self.folder.mkdir(parents=True, exist_ok=True)
        file = self.folder / f"{name}.yaml"
        file.write_text(yaml.safe_dump(scene, sort_keys=False), encoding="utf-8")
        return self.run("coupler", file, name, settings)

    def _count(self, summary):
        elements = next((summary[kind] for kind in ELEMENTS if kind in summary), 0)
        found = {"particles": summary.get("particles", 0), "zones": summary.get("zones", 0), "elements": elements,
                 "updates": summary.get("particle_updates", 0) + summary.get("zone_updates", 0) + elements * summary["steps"]}
        for what, number in found.items():
            self.counts[what] += int(number)


def wait(process):
    """Waits for a process that starts others and waits for them: (resources that all of them used, memory [bytes])."""
    largest = {}
    while True:
        for pid in family(process.pid):
            largest[pid] = max(largest.get(pid, 0), memory_of(pid))
        ended, status, usage = os.wait4(process.pid, os.WNOHANG)
        if ended:
            process.returncode = os.waitstatus_to_exitcode(status)
            return usage, sum(largest.values())
        time.sleep(LOOKS)


def family(pid):
    """The process and all that it started."""
    yield pid
    try:
        for thread in Path(f"/proc/{pid}/task").iterdir():
            for child in (thread / "children").read_text().split():
                yield from family(int(child))
    except OSError:  # it has ended
        return


def memory_of(pid):
    """The most memory that the process has held so far [bytes]; 0 if it has ended."""
    try:
        status = Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return 0
    line = next((line for line in status.splitlines() if line.startswith("VmHWM")), "VmHWM: 0 kB")
    return 1024 * int(line.split()[1])
