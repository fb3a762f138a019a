"""The simplified models: cost of the chain's step over its size, and how much faster than real time the cases run."""

import json
import subprocess
import tempfile

from adit import Run

# Cases with what they must reach: (scene, seconds of wall time for its 40 s of motion).
CASES = (
    ("cases/hzm/uniform_0.2g.yaml", 5),
    ("cases/hzm/wave_1000_0.2g.yaml", 5),
    ("cases/qingcaosha/east_chain.yaml", 30),
    ("cases/qingcaosha/east_beam.yaml", 30),
)
PROGRAMS = ("simplified", "chain_bench")


def run(root):
    program = root / "build/release/simplified/simplified"
    return chain_steps(root) + [record for scene, limit in CASES for record in case(program, root, scene, limit)]


def chain_steps(root):
    """Nanoseconds a body and step: the Riccati sweep, and Eigen's sparse LDLT on the same equations."""
    program = root / "build/release/tests/bench/chain_bench"
    lines = subprocess.run([program, "200"], check=True, capture_output=True, text=True).stdout.splitlines()
    records = []
    for size in map(json.loads, lines):
        for name, key in (("chain, Riccati sweep", "sweep_ns"), ("chain, sparse LDLT", "direct_ns")):
            records.append({"name": name, "size": size["bodies"], "threads": 1, "value": size[key],
                            "unit": "ns per body and step"})
    return records


def case(program, root, scene, limit):
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([program, "run", root / scene, "--out", out], check=True, capture_output=True)
        summary = Run(out).summary
    size = summary.get("bodies", summary.get("elements"))
    name = f"{summary['case']} {summary['scene']}"
    return [{"name": f"{name}, wall time", "size": size, "threads": 1, "value": summary["wall_s"],
             "unit": f"s (limit {limit} s)"},
            {"name": f"{name}, real-time factor", "size": size, "threads": 1, "value": summary["real_time_factor"],
             "unit": "simulated s per wall s"}]
