"""Specimens of concrete have in the laboratory the strengths that their material states, and crack where theory says."""

import csv
import math
import subprocess

from programs import ADIT, SOURCE, ProgramTest

CASE = SOURCE / "cases" / "laboratory"
TENSILE, COMPRESSIVE, SLOPE = 2.5e6, 39e6, 1.698  # stated; (1 + sin 15 deg) / (1 - sin 15 deg)


class Laboratory(ProgramTest):
    def studied(self, of, table, *options):
        """(rows of a table, what was printed)"""
        done = subprocess.run([*ADIT, "run", CASE, "--of", of, *options, "--out", self.folder / "study"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "study" / table, newline="") as file:
            return list(csv.DictReader(file)), done.stdout

    def test_strengths_are_those_stated(self):
        rows, told = self.studied("concrete", "strengths_concrete.csv", "--sizes", "10", "--seeds", "3")

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
        pressures = [float(row["pressure_Pa"]) for row in rows if row["test"] == "10000000.0"]
        slope = (sum(strengths("10000000.0")) - sum(crushed)) / sum(pressures)
        self.assertAlmostEqual(slope / SLOPE, 1, delta=0.15)
        self.assertIn("1.698 stated", told)

    def test_a_crack_takes_the_path_of_fracture_mechanics(self):
        """Within a cell in the mean over packings and orientations of the beam, and within one and a half in each."""
        rows, _ = self.studied("mixed_mode", "mixed_mode.csv", "--sizes", "20", "--seeds", "2")
        self.assertEqual([row["angle_deg"] for row in rows], ["0", "15", "30"] * 2)
        found = [float(row["mean_distance_m"]) / float(row["size_m"]) for row in rows]
        self.assertLess(math.sqrt(sum(value**2 for value in found) / len(found)), 1)
        self.assertLess(max(found), 1.5)
