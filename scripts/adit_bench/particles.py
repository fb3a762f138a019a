"""The bonded particles' step: bond-steps and particle-steps per second of a beam, over size and threads.

A bond-step is everything that a time step does, for one bond: its forces, its part in the motion of the particles,
contact detection. Beside it stand the memory held, the shares of what the machine allows at the same time: of the
bandwidth that STREAM's triad reaches over as many bytes as a step must read and write, of its sums and products, of
one square root and one division a bond; and other codes on the same beam, where they are installed.
"""

import json
import subprocess

from adit_bench.peers import particles as peers

BEAMS = ((52, 6), (312, 32), (1000, 100), (3162, 316))  # discs along x, rows
THREADS = (1, 2)
FLOOR, FLOOR_FROM = 120e6, 9000  # bond-steps per second of one thread; two must reach 1.8 times as much


def run(root):
    program = root / "build/release/tests/bench/particles_bench"
    of_discs = root / "build/release/tests/bench/discs_bench"
    own = [record for discs, rows in BEAMS for threads in THREADS for record in
           measure(program, discs, rows, threads) + measure_parallel(of_discs, discs, rows, threads)]
    return own + peers.run(*BEAMS[1])


def run_beam(program, discs, rows, threads):
    return json.loads(subprocess.run([program, str(discs), str(rows), str(threads)],
                                     check=True, capture_output=True, text=True).stdout)


def floor_of(size, threads, floor):
    return f" (floor {floor * (1 if threads == 1 else 1.8) / 1e6:.0f}e6)" if size > FLOOR_FROM else ""


def measure_parallel(program, discs, rows, threads):
    """Parallel bonds beside contacts with friction, with the energy ledger."""
    m = run_beam(program, discs, rows, threads)
    size = int(m["particles"])
    unit = f"bond-steps/s{floor_of(size, threads, FLOOR / 2)}"
    return [{"name": "bond-steps, parallel bonds", "size": size, "threads": threads,
             "value": m["steps_per_s"] * m["bonds"], "unit": unit},
            {"name": "discs, memory held", "size": size, "threads": threads,
             "value": m["bytes_held"] / size, "unit": "bytes per particle"}]


def measure(program, discs, rows, threads):
    m = run_beam(program, discs, rows, threads)
    size = int(m["particles"])
    bond_steps = m["steps_per_s"] * m["bonds"]
    floor = floor_of(size, threads, FLOOR)

    def record(name, value, unit):
        return {"name": name, "size": size, "threads": threads, "value": value, "unit": unit}

    return [record("bond-steps, contact bonds", bond_steps, f"bond-steps/s{floor}"),
            record("particle-steps, contact bonds", m["steps_per_s"] * size, "particle-steps/s"),
            record("particles, memory held", m["bytes_held"] / size, "bytes per particle"),
            record("particles, memory traffic", m["traffic_per_step"] / size, "bytes per particle-step"),
            record("bond-steps, triad beside", m["triad_bytes_per_s"] / 1e9, "GB/s"),
            record("bond-steps, share of triad", m["steps_per_s"] * m["traffic_per_step"] / m["triad_bytes_per_s"], "1"),
            record("bond-steps, share of sums and products",
                   bond_steps * m["operations_per_bond"] / m["operations_per_s"], "1"),
            record("bond-steps, share of divider", bond_steps / m["divisions_per_s"], "1")]
