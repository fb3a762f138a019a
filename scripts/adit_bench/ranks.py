"""Participants under MPI: the time of a step over ranks, that of LAMMPS's own granular step beside it, and the messages and bytes that
a step sends between ranks, counted by Open MPI and by PETSc.

The machine needs a free core for each rank whose time is to mean anything; messages are counted right on any.
"""

import contextlib
import json
import os
import pathlib
import signal
import statistics
import subprocess
import sys
import tempfile

from adit import Run
from adit_bench.peers import particles as peers

SIZES = (500, 500), (1000, 1000)  # discs along x and rows, likewise zones
COUNTED, RANKS = (200, 200), (2, 4, 8, 16)
ROUNDS, STEPS, GRANULAR_STEPS = 3, 100, 200

SQUARE = """
plane: plane_stress
material: {{young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}}
time: {{dt: 0.05 ms, duration: {duration} ms}}
particles:
  engine: general
  packing: {{x_min: 0 m, x_max: {x} m, y_min: 0 m, y_max: {y} m, radius: 0.5 m}}
  body_loads: [{{acceleration: {{y: -9.81 m/s^2}}}}]
output: {{history_interval: 1 s, field_times: []}}
"""


def run(root):
    yield from speeds(root)
    yield from messages(root)


def record(name, size, ranks, value, unit):
    return {"name": name, "size": size[0] * size[1], "threads": ranks, "value": value, "unit": unit}


def speeds(root):
    for size in SIZES:
        for name, seconds in (("LAMMPS", particle_step), ("FEniCSx", lambda *given: zone_steps(*given)["seconds"])):
            found = [[seconds(root, size, ranks) for ranks in (1, 2)] for _ in range(ROUNDS)]
            for ranks, times in zip((1, 2), zip(*found)):
                yield record(f"{name}, step", size, ranks, 1e3 * statistics.median(times), "ms")
            yield record(f"{name}, two ranks over one", size, 2, statistics.median(one / two for one, two in found), "1")
        yield record("LAMMPS granular with history, step", size, 1, 1e3 * peers.granular_step(*size, GRANULAR_STEPS), "ms")


def messages(root):
    """Of a step, between all ranks: of a run and of a longer one, the difference."""
    for ranks in RANKS:
        short, long = (counted(root, ranks, steps) for steps in (STEPS, 2 * STEPS))
        for name, few, many in zip(("messages of ghosts", "bytes of ghosts", "messages of orders", "bytes of orders"), short, long):
            yield record(f"LAMMPS, {name}", COUNTED, ranks, (many - few) / STEPS, "a step")
        exchanged = zone_steps(root, COUNTED, ranks)["exchanged"]
        for name, twice in zip(("messages", "bytes"), map(sum, zip(*exchanged))):  # sent, and received
            yield record(f"FEniCSx, {name} of the product", COUNTED, ranks, twice / 2, "a step")


def mpirun(ranks, *options):
    as_root = ("--allow-run-as-root",) if os.geteuid() == 0 else ()
    return "mpirun", "-np", str(ranks), "--oversubscribe", *as_root, *options


@contextlib.contextmanager
def lammps(root, ranks, *options):
    """Its address on so many ranks, which end in order."""
    command = [*mpirun(ranks, *options), root / "build/release/adapters/lammps/adit_lammps", "--log-level", "off"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process.stdout.readline().split()[-1]
        finally:
            started = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
            os.kill(min(map(int, started)), signal.SIGTERM)  # rank 0, which tells the others


def compute(root, size, address, steps):
    """The summary of a run."""
    with tempfile.TemporaryDirectory() as folder:
        scene, out = pathlib.Path(folder) / "square.yaml", pathlib.Path(folder) / "run"
        scene.write_text(SQUARE.format(x=size[0], y=size[1] * 0.75**0.5, duration=0.05 * steps))
        command = [root / "build/release/coupler/coupler", "run", scene, "--dem", address, "--out", out]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        return Run(out).summary


def particle_step(root, size, ranks):
    """Seconds of a step of LAMMPS, which the coupler waits for."""
    with lammps(root, ranks, "--bind-to", "core") as address:
        summary = compute(root, size, address, STEPS)
    return (summary["coupler_wait_s"] + summary["coupler_solve_s"]) / summary["steps"]


def zone_steps(root, size, ranks):
    """What peers/fenicsx_steps.py prints."""
    script = pathlib.Path(peers.__file__).with_name("fenicsx_steps.py")
    command = [*mpirun(ranks), "/usr/bin/python3", script, *map(str, (*size, STEPS))]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()[-1])


def counted(root, ranks, steps):
    """Messages and bytes of particles that ranks show each other, and of orders and answers, since the start."""
    with tempfile.TemporaryDirectory() as folder:
        monitor = {"pml_monitoring_enable": 2, "pml_monitoring_enable_output": 3, "pml_monitoring_filename": f"{folder}/of"}
        options = [word for name, value in monitor.items() for word in ("--mca", name, str(value))]
        with lammps(root, ranks, "--bind-to", "none", *options) as address:
            compute(root, COUNTED, address, steps)
        counts = {"E": [0, 0], "I": [0, 0]}  # of the program's own messages, of those in collective calls
        for file in pathlib.Path(folder).glob("of.*.prof"):
            for line in file.read_text().splitlines():
                kind, *numbers = line.split("\t")
                if kind in counts:
                    add(counts[kind], *numbers[2:])
    return [*counts["E"], *counts["I"]]


def add(sum, size, messages, histogram=""):
    """A line of the monitor. Signs of life, which are empty, are left out; they depend on the clock."""
    empty = int(histogram.split(",")[0] or 0) if histogram else 0
    sum[0] += int(messages.split()[0]) - empty
    sum[1] += int(size.split()[0])
