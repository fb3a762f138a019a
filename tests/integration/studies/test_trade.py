"""adit trade measures how accuracy falls with cost."""

import csv
import os
import subprocess
import unittest

from programs import ADIT, PATIENCE_S, ProgramTest

ERRORS = ("force_l2", "near_l2", "far_l2")


def trade(*arguments, **environment):
    return subprocess.run([*ADIT, "trade", *map(str, arguments)], capture_output=True, text=True,
                          timeout=PATIENCE_S, env=os.environ | environment)


class Trade(ProgramTest):
    def test_writes_a_table_and_a_picture_and_errors_fall_with_the_zones(self):
        result = trade("bar", "--quick", "--out", self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex(result.stdout, r"coupled, within 10 %: .*; zones 0\.25 m \(.* updates\)")
        self.assertTrue((self.folder / "tiny.png").exists())
        with open(self.folder / "tiny.csv", newline="", encoding="utf-8") as file:
            rows = {row["variant"]: row for row in csv.DictReader(file)}
        row = rows["zones 0.5 m"]
        self.assertEqual(list(row), [
            "family", "variant", "solve", "substeps", "dt_s", "particles", "zones", "coupling_points",
            "particle_updates", "zone_updates", "updates", "energy_kept", "force_l2", "force_peak", "near_l2",
            "near_peak", "far_l2", "far_peak", "cpu_s", "wall_s"])
        self.assertEqual(int(row["updates"]), int(row["particle_updates"]) + int(row["zone_updates"]))
        coarse, middle, fine = (rows[f"zones {size} m"] for size in ("1", "0.5", "0.25"))
        alone = rows["particles only, dt factor 0.5"]
        for error in ERRORS:
            found = [float(row[error]) for row in (alone, fine, middle, coarse)]
            self.assertEqual(found, sorted(set(found)), error)
        self.assertGreater(int(alone["particle_updates"]), int(fine["particle_updates"]))

    def test_names_the_missing_program(self):
        result = trade("--quick", "--out", self.folder, ADIT_BUILD=str(self.folder))
        self.assertEqual(result.returncode, 2)
        self.assertIn(f"{self.folder / 'coupler' / 'coupler'} does not exist", result.stderr)


if __name__ == "__main__":
    unittest.main()
