"""The continuum's step: elastic zone-steps per second of both kinds of zone, over size and threads.

A zone-step is everything that a time step does, for one zone and the one point that comes with it. Beside it stand
the memory traffic that it cannot avoid, and what share that is of the bandwidth that STREAM's triad reaches at the
same time, over as many bytes and with as many threads. With --peers: another continuum beside ours on the same block.
"""

import json
import subprocess

from benchmarks.peers import continuum as peers

GRIDS = ((100, 100), (400, 250), (1000, 1000))  # zones along x and y
THREADS = (1, 2)
# Floors of one thread, in 10^6 zone-steps per second; two threads must reach 1.8 times as much.
FLOORS = {100000: 80, 1000000: 60}
PROGRAMS, BESIDE_PEERS = ("continuum_bench",), ("coupler", "fdm_server")


def run(root):
    program = root / "build/release/tests/bench/continuum_bench"
    return [record for columns, rows in GRIDS for threads in THREADS for record in measure(program, columns, rows, threads)]


def pairs(root):
    return peers.pairs(root)


def measure(program, columns, rows, threads):
    lines = subprocess.run([program, str(columns), str(rows), str(threads)],
                           check=True, capture_output=True, text=True).stdout.splitlines()
    return [record for line in lines for record in records(json.loads(line))]


def records(m):
    zones, threads, speed = int(m["zones"]), m["threads"], m["zone_steps_per_s"]
    floor = FLOORS.get(zones)
    needed = f" (floor {floor * (1 if threads == 1 else 1.8):.0f}e6)" if floor and threads <= 2 else ""

    def record(name, value, unit):
        return {"name": f"{name}, {m['kind']}", "size": zones, "threads": threads, "value": value, "unit": unit}

    return [record("elastic zone-steps", speed, f"zone-steps/s{needed}"),
            record("elastic zone-steps, memory traffic", m["bytes_per_zone"], "bytes per zone"),
            record("elastic zone-steps, triad beside", m["triad_bytes_per_s"] / 1e9, "GB/s"),
            record("elastic zone-steps, share of triad", speed * m["bytes_per_zone"] / m["triad_bytes_per_s"], "1")]
