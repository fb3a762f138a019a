"""What the laws of the ground cost: zone-steps per second of one thread, and the cost relative to elastic zones."""

import json
import subprocess


def run(root):
    lines = subprocess.run([root / "build/release/tests/bench/laws_bench"], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    measured = [json.loads(line) for line in lines]
    elastic = {m["kind"]: m["zone_steps_per_s"] for m in measured if m["law"] == "elastic"}
    records = []
    for m in measured:
        name = f"{m['law']}, {m['kind']}"
        speed = m["zone_steps_per_s"]
        records += [{"name": name, "size": 10000, "threads": 1, "value": speed, "unit": "zone-steps/s"},
                    {"name": f"{name}, cost", "size": 10000, "threads": 1, "value": elastic[m["kind"]] / speed,
                     "unit": "elastic"}]
    return records
