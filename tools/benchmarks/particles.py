"""The bonded particles' step: bond-steps and particle-steps per second of a beam, over size and threads.

A bond-step is everything that a time step does, for one bond: its forces, its part in the motion of the particles,
contact detection. Beside it stand the memory held, the shares of what the machine allows at the same time: of the
bandwidth that STREAM's triad reaches over as many bytes as a step must read and write, of its sums and products, of
one square root and one division a bond. With --peers: other codes beside ours on the same beam.
"""

import json
import pathlib
import subprocess
import tempfile

from benchmarks.peers import packing as peer_packing
from benchmarks.peers import particles as peers

BEAMS = ((52, 6), (312, 32), (1000, 100), (3162, 316))  # discs along x, rows
THREADS = (1, 2)
KINDS = {"lattice": "contact bonds", "contact_bonds": "contact bonds, discs of any size",
         "parallel_bonds": "parallel bonds, discs of any size", "cells": "facets between cells"}
PACKING = "packing with friction, no bonds"
# Bond-steps per second of one thread from 10^4 particles on; two must reach 1.8 times as much.
FLOORS, FLOOR_FROM = {"lattice": 120e6, "parallel_bonds": 60e6, "cells": 60e6}, 9000
PROGRAMS = BESIDE_PEERS = ("particles_bench",)


def run(root):
    program = root / "build/release/tests/bench/particles_bench"
    beams = [record for kind in KINDS for discs, rows in BEAMS for threads in THREADS
             for record in measure(program, kind, discs, rows, threads)]
    return beams + packing(program)


def pairs(root):
    return peers.pairs(root, *BEAMS[1]) + peer_packing.pairs(root, *BEAMS[2])


def packing(program):
    """Discs that stay in contact."""
    with tempfile.TemporaryDirectory() as folder:
        return [record for threads in THREADS
                for record in measure(program, "packing", *BEAMS[2], threads, pathlib.Path(folder) / "packing")]


def measure(program, kind, discs, rows, threads, *file):
    m = json.loads(subprocess.run([program, kind, str(discs), str(rows), str(threads), *file],
                                  check=True, capture_output=True, text=True).stdout)
    of_kind = KINDS.get(kind, PACKING)
    size = int(m["particles"])
    bond_steps = m["steps_per_s"] * m["bonds"]
    needed = FLOORS.get(kind, 0) * (1 if threads == 1 else 1.8) / 1e6
    floor = f" (floor {needed:.0f}e6)" if needed and size > FLOOR_FROM else ""

    def record(name, value, unit):
        return {"name": f"{name}, {of_kind}", "size": size, "threads": threads, "value": value, "unit": unit}

    return [record("bond-steps", bond_steps, f"bond-steps/s{floor}"),
            record("particle-steps", m["steps_per_s"] * size, "particle-steps/s"),
            record("memory held", m["bytes_held"] / size, "bytes per particle"),
            record("memory traffic", m["traffic_per_step"] / size, "bytes per particle-step"),
            record("triad beside", m["triad_bytes_per_s"] / 1e9, "GB/s"),
            record("share of triad", m["steps_per_s"] * m["traffic_per_step"] / m["triad_bytes_per_s"], "1"),
            record("share of sums and products", bond_steps * m["operations_per_bond"] / m["operations_per_s"], "1"),
            record("share of divider", bond_steps / m["divisions_per_s"], "1"),
            record("contacts at the start", m["contacts"][0], "1"), record("contacts at the end", m["contacts"][1], "1")]
