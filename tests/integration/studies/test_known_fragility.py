"""Studies of a linear column whose capacity is lognormal by construction recover its median and dispersion, whichever way the motions get
their intensity."""

import json
import subprocess
import unittest

import numpy as np

from programs import ADIT, PATIENCE, ProgramTest
from studies.test_study import COLUMN

from adit import Run

MOTIONS = 24
STUDIES = 20
DISPERSION = 0.4
LEVELS = [round(float(each), 4) for each in np.geomspace(0.5, 8, 10)]  # m/s^2
MEDIAN = 2.0  # m/s^2
ANSWERS = """
import numpy as np
def ratio(run, drawn):
    return np.abs(run.histories["drift_ux_m"]).max() / drawn["capacity"]
"""


def ricker(number, **peak):
    """Motions of one shape, which differ in nothing but when they come: each of them answers alike."""
    return {"ricker": {"frequency": 2, "time": 1 + number / 100}, **peak}


WAYS = {
    "stripes": {"of": [ricker(number) for number in range(MOTIONS)], "stripes": {"pga": LEVELS}},
    "increments": {"of": [ricker(number) for number in range(MOTIONS)], "increments": {"pga": LEVELS}},
    "cloud": {"of": [ricker(number, peak=LEVELS[number % len(LEVELS)]) for number in range(10 * MOTIONS)]}}


class KnownFragility(ProgramTest):
    def setUp(self):
        super().setUp()
        self.scene(COLUMN.replace("2.5 s", "5 s"), "column.yaml")
        (self.folder / "answers.py").write_text(ANSWERS)
        self.run_scene(self.scene(COLUMN, "one.yaml"), out="one")
        self.drift = float(np.abs(Run(self.folder / "one").histories["drift_ux_m"]).max())  # at 1 m/s^2

    def fragility(self, way, seed):
        """The row of fragility.csv of a study; all of one way share their runs, because only the capacity is another."""
        study = {"scene": "column.yaml", "motions": WAYS[way], "functions": [{"name": "ratio", "file": "answers.py"}],
                 "random": [{"name": "capacity", "lognormal": {"median": MEDIAN * self.drift, "dispersion": DISPERSION}}],
                 "sampling": {"seed": seed, "method": "random"}, "damage": [{"of": "ratio", "states": [{"name": "broken", "above": 1}]}]}
        path = self.scene(json.dumps(study), f"{way}.yaml")
        done = subprocess.run([*ADIT, "study", path, "--out", self.folder / way, "--no-pictures"], capture_output=True, text=True, timeout=600 * PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = (self.folder / way / "fragility.csv").read_text().splitlines()
        return dict(zip(lines[0].split(","), lines[1].split(",")))

    def test_is_recovered_in_19_of_20_studies(self):
        held = {}
        for way in WAYS:
            rows = [self.fragility(way, seed) for seed in range(1, STUDIES + 1)]
            held[way] = {name: sum(float(row[f"{name}_low"]) <= true <= float(row[f"{name}_high"]) for row in rows)
                         for name, true in (("median", MEDIAN / 9.80665), ("dispersion", DISPERSION))}
        print(held)
        # An interval of 95 % holds the truth in 19 of 20 studies on average, and in 17 or more of 20 with a probability of 98 %.
        for way, counts in held.items():
            for name, count in counts.items():
                self.assertGreaterEqual(count, 17, f"{way}: {name}")

    def test_three_ways_agree_within_their_intervals(self):
        intervals = {way: [float(self.fragility(way, 1)[f"median_{end}"]) for end in ("low", "high")] for way in WAYS}
        print(intervals)
        self.assertLess(max(low for low, _ in intervals.values()), min(high for _, high in intervals.values()))


if __name__ == "__main__":
    unittest.main()
