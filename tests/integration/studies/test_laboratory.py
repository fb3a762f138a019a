"""Specimens of concrete have in the laboratory the strengths that their material states."""

import csv
import subprocess

from programs import ADIT, SOURCE, ProgramTest

CASE = SOURCE / "cases" / "laboratory"
TENSILE, COMPRESSIVE, SLOPE = 2.5e6, 39e6, 1.698  # stated; (1 + sin 15 deg) / (1 - sin 15 deg)


class Laboratory(ProgramTest):
    def test_strengths_are_those_stated(self):
        done = subprocess.run([*ADIT, "run", CASE, "--of", "concrete", "--sizes", "10", "--seeds", "3", "--out", self.folder / "study"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "study" / "strengths_concrete.csv", newline="") as file:
            rows = list(csv.DictReader(file))

        def strengths(test):
            found = {row["seed"]: float(row["strength_Pa"]) for row in rows if row["test"] == test}
            self.assertEqual(list(found), ["1", "2", "3"])
            return list(found.values())

        for tension in strengths("tension"):
            self.assertAlmostEqual(tension / TENSILE, 1, delta=0.05)
        self.assertAlmostEqual(sum(strengths("splitting")) / 3 / TENSILE, 1, delta=0.3)  # of few cells: the packings scatter
        crushed = strengths("0")
        for strength in crushed:
            self.assertAlmostEqual(strength / COMPRESSIVE, 1, delta=0.05)
        self.assertAlmostEqual((sum(strengths("10000000.0")) - sum(crushed)) / 3 / 10e6 / SLOPE, 1, delta=0.15)
        self.assertIn("1.698 stated", done.stdout)
