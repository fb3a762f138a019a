"""Participants under MPI: the time of a step on 1, 2 and 4 ranks, beside one of them LAMMPS's own granular step, and the messages and
bytes that a step sends between ranks, counted by Open MPI and by PETSc.

All hold the same model, 13 GB in all, and compute some of its steps in turn: the ratios are those of the turns. Times are
valid only if each rank has a free core; counts of messages are right on any machine.
"""

import contextlib
import json
import pathlib
import statistics
import subprocess
import tempfile

from benchmarks.peers.held import Granular, Server, mpirun

SIZES = (500, 500), (1000, 1000)  # discs along x and rows, likewise zones
TIMED, ROUNDS, STEPS = (1, 2, 4), 7, 20
COUNTED, RANKS, COUNTED_STEPS = (200, 200), (2, 4, 8, 16), 100
GRANULAR = "LAMMPS granular with history"

MATERIAL = "plane: PLANE_STRESS time { duration: 1 } material { young_modulus: 25e9 poisson_ratio: 0.2 density: 2500 }"
FALLS = "body_loads { acceleration { y: -9.81 } }"
PROGRAMS = ("adit_lammps",)


def run(root):
    for size in SIZES:
        yield from taking_turns("LAMMPS", size, {ranks: particles(root, size, ranks) for ranks in TIMED} | {GRANULAR: lambda: Granular(*size)})
        yield from taking_turns("FEniCSx", size, {ranks: zones(root, size, ranks) for ranks in TIMED})
    yield from messages(root)


def record(name, size, ranks, value, unit):
    return {"name": name, "size": size[0] * size[1], "threads": ranks, "value": value, "unit": unit}


def particles(root, size, ranks, *options):
    """Returns a function that starts a server of LAMMPS with a square of bonded particles."""
    square = f"x_min: 0 x_max: {size[0]} y_min: 0 y_max: {size[1] * 0.75**0.5} radius: 0.5"
    described = f"{MATERIAL} particles {{ engine: GENERAL packing {{ {square} }} bonds {{}} {FALLS} }}"
    program = root / "build/release/adapters/lammps/adit_lammps"
    return lambda: Server("particles", [*mpirun(ranks, *options), program, "--log-level", "off"], described)


def zones(root, size, ranks):
    block = f"x_min: 0 x_max: {size[0]} y_min: 0 y_max: {size[1]} zones_x: {size[0]} zones_y: {size[1]}"
    described = f"{MATERIAL} continuum {{ block {{ {block} }} {FALLS} }}"
    return lambda: Server("continuum", [*mpirun(ranks), root / "adapters/fenicsx/serve.py"], described)


def taking_turns(code, size, make):
    with contextlib.ExitStack() as stack:
        held = {who: stack.enter_context(one()) for who, one in make.items()}
        turns = [{who: one.seconds(STEPS) for who, one in held.items()} for _ in range(ROUNDS)]
    for who in held:
        ranks = who if who in TIMED else 1
        name = code if who in TIMED else who
        yield record(f"{name}, step", size, ranks, 1e3 * statistics.median(turn[who] for turn in turns), "ms")
        if who != 1:
            ratios = sorted(turn[1] / turn[who] for turn in turns)
            over = f"one rank of {code} over it"
            yield from (record(f"{name}, {over}, {which}", size, ranks, ratios[k], "1")
                        for which, k in (("least", 0), ("median", ROUNDS // 2), ("most", -1)))


def messages(root):
    """Messages and bytes of a step between all ranks: the difference of a run and a longer one."""
    for ranks in RANKS:
        short, long = (counted(root, ranks, steps) for steps in (COUNTED_STEPS, 2 * COUNTED_STEPS))
        for name, few, many in zip(("messages of ghosts", "bytes of ghosts", "messages of orders", "bytes of orders"), short, long):
            yield record(f"LAMMPS, {name}", COUNTED, ranks, (many - few) / COUNTED_STEPS, "a step")
        for name, twice in zip(("messages", "bytes"), map(sum, zip(*exchanged_zones(ranks)))):  # sent, and received
            yield record(f"FEniCSx, {name} of the product", COUNTED, ranks, twice / 2, "a step")


def exchanged_zones(ranks):
    """The output of peers/fenicsx_messages.py."""
    script = pathlib.Path(__file__).with_name("peers") / "fenicsx_messages.py"
    command = [*mpirun(ranks), "/usr/bin/python3", script, *map(str, (*COUNTED, COUNTED_STEPS))]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()[-1])


def counted(root, ranks, steps):
    """Messages and bytes of particles that ranks show each other, and of orders and answers, since the start."""
    with tempfile.TemporaryDirectory() as folder:
        monitor = {"pml_monitoring_enable": 2, "pml_monitoring_enable_output": 3, "pml_monitoring_filename": f"{folder}/of"}
        options = [word for name, value in monitor.items() for word in ("--mca", name, str(value))]
        with particles(root, COUNTED, ranks, *options)() as server:
            server.seconds(steps)
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
