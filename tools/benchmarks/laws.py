"""Cost of the laws of the ground: zone-steps per second, the cost relative to elastic zones, the speed-up by a second thread."""

import json
import subprocess

PROGRAMS = ("laws_bench",)


def run(root):
    lines = subprocess.run([root / "build/release/tests/bench/laws_bench"], check=True, capture_output=True,
                           text=True).stdout.splitlines()
    measured = [json.loads(line) for line in lines]
    elastic = {m["kind"]: m["zone_steps_per_s"] for m in measured if m["law"] == "elastic" and m["threads"] == 1}
    records = []
    for m in measured:
        name, speed, threads = f"{m['law']}, {m['kind']}", m["zone_steps_per_s"], m["threads"]
        of = {"size": 99856, "threads": threads}
        records.append({"name": name, **of, "value": speed, "unit": "zone-steps/s"})
        if threads == 1:
            one = speed
            records.append({"name": f"{name}, cost", **of, "value": elastic[m["kind"]] / speed, "unit": "elastic"})
        else:
            records.append({"name": f"{name}, speed-up", **of, "value": speed / one, "unit": "one thread"})
    return records
