"""Motions of a study reach levels at the free surface of ground that answers nonlinearly, and keep the ratio of their components; its table
is the same wherever and however often it is computed."""

import math
import subprocess
import unittest

import numpy as np

from programs import PATIENCE_S, wait_until
from studies.test_study import COLUMN, SOFT, StudyTest

from adit import Run

WITHIN = 0.02  # of a level, as docs/study.md says
MOTIONS = """
scene: column.yaml
motions:
  of:
    - {ricker: {frequency: 2 Hz, time: 1 s}}
    - {synthetic: {spectrum: ec8_type_1, ground: b, seed: 1}}
"""
SURFACE = MOTIONS + """
  stripes: {pga: [0.05 g, 0.1 g, 0.2 g], at: surface}
questions: [drift_ux_m]
damage: [{of: drift_ux_m, states: [{name: minor, above: 0.005}, {name: major, above: 0.02}]}]
"""
HYSTERETIC = COLUMN.replace("density: 2 t/m^3}", "density: 2 t/m^3, hysteretic: {hyperbola: {reference_strain: 1e-3, exponent: 0.919}, "
                            "memory: reversals, damping: {darendeli: {}}}}").replace(
    "  base:", "  damping: {maxwell: {ratio: 0.02, low_frequency: 0.5 Hz, high_frequency: 20 Hz}}\n  base:")
RECORDS = """
scene: column.yaml
motions:
  folder: records
  files: "*_H1.csv"
  components: [{key: continuum.base.across, instead_of: _H1, name: _UP}]
  stripes: {pga: [0.1 g, 0.2 g, 0.4 g]}
questions: [drift_ux_m, surface_ay_m_per_s2]
"""


class AtTheSurface(StudyTest):
    def runs(self, out="out"):
        return len(list((self.folder / out / "runs").iterdir()))

    def test_linear_ground_takes_two_runs_for_the_first_level_and_one_for_each_other(self):
        amplification = {}
        for name, given in (("ricker_2Hz", "ricker: {frequency: 2 Hz, time: 1 s}"),
                            ("ec8_type_1_b_1", "synthetic: {spectrum: ec8_type_1, ground: b, seed: 1}")):
            alone = self.run_scene(self.scene(COLUMN.replace("ricker: {frequency: 2 Hz, time: 1 s}", given)), out=name)
            amplification[name] = np.abs(Run(alone).histories["surface_ax_m_per_s2"]).max()  # at 1 m/s^2
        self.study(SURFACE)
        rows = self.rows()
        self.assertEqual(len(rows), 6)
        self.assertGreater(abs(amplification["ec8_type_1_b_1"] - 1), WITHIN)  # so that its first run misses the level
        self.assertLess(abs(amplification["ricker_2Hz"] - 1), WITHIN)
        self.assertEqual(self.runs(), 3 + (1 + 3))
        for row in rows:
            self.assertAlmostEqual(float(row["surface_pga_m_per_s2"]) / float(row["level"]), 1, delta=WITHIN)
            # The statics leave 1e-5 of the weight unbalanced.
            expected = amplification[row["motion"]] * float(row["pga_m_per_s2"])
            self.assertAlmostEqual(float(row["surface_pga_m_per_s2"]) / expected, 1, delta=1e-3)
        searched = [row for row in rows if row["motion"] == "ec8_type_1_b_1"]
        stated = float(searched[0]["pga_m_per_s2"]) / float(searched[0]["factor"])  # the motion as it is stated
        for row in searched:
            expected = float(row["level"]) / (amplification["ec8_type_1_b_1"] * stated)
            self.assertAlmostEqual(float(row["factor"]) / expected, 1, delta=1e-3)

    def test_every_measure_is_reached(self):
        for measure, level, column in (("pgv", "0.05", "surface_pgv_m_per_s"), ("arias", "0.1", "surface_arias_m_per_s"),
                                       ("sa", "2], period: 0.5 s, at: surface} #", "surface_sa(0.5s)_m_per_s2")):
            with self.subTest(measure):
                self.study(MOTIONS + f"  stripes: {{{measure}: [{level}], at: surface}}\nquestions: [drift_ux_m]\n", out=measure)
                for row in self.rows(measure):
                    self.assertAlmostEqual(float(row[column]) / float(row["level"]), 1, delta=WITHIN)
                self.assertLessEqual(self.runs(measure), 4)

    def test_hysteretic_ground_takes_more_runs_and_reaches_its_levels(self):
        self.scene(HYSTERETIC, "column.yaml")
        done = self.study(SURFACE)
        self.assertNotIn("have not reached", done.stdout)
        for row in self.rows():
            self.assertAlmostEqual(float(row["surface_pga_m_per_s2"]) / float(row["level"]), 1, delta=WITHIN)
            kept = Run(self.folder / "out" / row["folder"])
            self.assertAlmostEqual(np.abs(kept.histories["surface_ax_m_per_s2"]).max(), float(row["surface_pga_m_per_s2"]), 12)
            self.assertAlmostEqual(kept.scene["continuum"]["base"]["acceleration"]["peak"] / float(row["pga_m_per_s2"]), 1, delta=WITHIN)
        print(f"{self.runs()} runs for {len(self.rows())} levels")
        self.assertGreater(self.runs(), 2 * 6)
        self.assertLessEqual(self.runs(), 4 * 6)

    def test_ground_that_yields_keeps_what_it_reached(self):
        weak = COLUMN.replace("density: 2 t/m^3}", "density: 2 t/m^3, mohr_coulomb: {cohesion: 10 kPa, friction_angle: 0 deg}}")
        self.scene(weak, "column.yaml")
        one = SURFACE.replace("    - {synthetic: {spectrum: ec8_type_1, ground: b, seed: 1}}\n", "")
        done = self.study(one.replace("[0.05 g, 0.1 g, 0.2 g]", "[0.01 g, 0.5 g]"))
        self.assertIn("levels             1 of 2 runs have not reached theirs within 2 %; surface_pga_m_per_s2 tells", done.stdout)
        low, high = self.rows()
        self.assertAlmostEqual(float(low["surface_pga_m_per_s2"]) / float(low["level"]), 1, delta=WITHIN)
        self.assertLess(float(high["surface_pga_m_per_s2"]), 0.98 * float(high["level"]))

    def test_climbs_end_at_the_last_damage_state_and_curves_are_over_the_surface(self):
        levels = "[0.05 g, 0.1 g, 0.2 g, 0.4 g, 0.8 g, 1.6 g]"
        done = self.study(SURFACE.replace("stripes: {pga: [0.05 g, 0.1 g, 0.2 g]", f"increments: {{pga: {levels}"))
        self.assertIn("fragility over surface_pga [g]", done.stdout)
        for name in {row["motion"] for row in self.rows()}:
            reached = [int(row["drift_ux_m_state"]) for row in self.rows() if row["motion"] == name]
            self.assertEqual(reached[-1], 2)
            self.assertNotIn(2, reached[:-1])

    def test_what_no_allowed_factor_reaches_is_left_out(self):
        limited = SURFACE.replace("  stripes:", "  largest_factor: 2\n  stripes:")
        done = self.study(limited)
        self.assertRegex(done.stdout, r"ec8_type_1_b_1 at 1\.961 \(0_\d\) is left out: it would be scaled by 2\.\d+")
        self.assertLess(len(self.rows()), 6)
        for row in self.rows():
            self.assertTrue(0.5 <= float(row["factor"]) <= 2, row)
        said = self.refused(limited.replace("[0.05 g, 0.1 g, 0.2 g]", "[2 g]"))
        self.assertIn("no motion can be scaled to any of the levels by a factor of at most 2", said)

    def test_a_plan_tells_how_many_runs_come(self):
        self.assertIn("runs               at least 6, at most 36; 2 climbs", self.study(SURFACE, "--plan").stdout)
        climbs = SURFACE.replace("stripes", "increments")
        self.assertIn("runs               at least 2, at most 36; 2 climbs", self.study(climbs, "--plan").stdout)

    def test_parts_and_deaths_make_the_same_table(self):
        self.scene(HYSTERETIC, "column.yaml")
        self.study(SURFACE + SOFT, out="whole")
        for part in (1, 0):
            self.study(SURFACE + SOFT, "--part", f"{part}/2", out="parts")
        self.assertNotIn("computed in", self.study(SURFACE + SOFT, out="parts").stdout)
        self.assertEqual(self.table("parts"), self.table("whole"))
        for deaths in (0, 1, 2):
            process = subprocess.Popen(self.command("killed"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            wait_until(lambda: (self.folder / "killed" / "runs").exists() and self.runs("killed") > 3 * deaths, PATIENCE_S)
            process.kill()
            process.wait(PATIENCE_S)
        self.assertIn("computed in", self.study(SURFACE + SOFT, out="killed").stdout)
        self.assertEqual(self.table("killed"), self.table("whole"))

    def test_a_place_that_is_none_is_told(self):
        self.assertIn("surfac is no history of acceleration_x of the scene; did you mean `surface_ax_m_per_s2`?",
                      self.refused(SURFACE.replace("at: surface", "at: surfac")))


class Components(StudyTest):
    """Records of a wavelet of 1 m/s^2, with vertical ones of RATIO times that and twice its frequency."""
    RATIO = {"A": 0.5, "B": 0.8}

    def setUp(self):
        super().setUp()
        vertical = "\n    - {name: surface, quantity: acceleration_y, at: {x: 0 m, y: 20 m}}"
        self.scene(COLUMN.replace("  histories:", "  histories:" + vertical), "column.yaml")
        (self.folder / "records").mkdir()
        for name, ratio in self.RATIO.items():
            self.record(f"{name}_H1.csv", 100, 2)
            self.record(f"{name}_UP.csv", 100 * ratio, 4)

    def record(self, name, peak, frequency):
        times = np.arange(300) / 100
        squares = (math.pi * frequency * (times - 1))**2
        lines = [f"{time:.2f},{value:.6f}" for time, value in zip(times, peak * (1 - 2 * squares) * np.exp(-squares))]
        (self.folder / "records" / name).write_text("\n".join(["time_s,acceleration_gal", *lines]) + "\n")

    def test_keep_their_ratio_at_every_level(self):
        self.study(RECORDS)
        rows = self.rows()
        self.assertEqual(len(rows), 6)
        for row in rows:
            ratio = self.RATIO[row["motion"][0]]
            base = Run(self.folder / "out" / row["folder"]).scene["continuum"]["base"]
            self.assertAlmostEqual(base["across"]["peak"] / base["acceleration"]["peak"] / ratio, 1, delta=1e-3)
            self.assertAlmostEqual(base["acceleration"]["peak"] / float(row["level"]), 1, 9)
            # Linear ground: the vertical motion of the surface grows with the level, as the horizontal one does.
            first = next(each for each in rows if each["motion"] == row["motion"])
            for answer in ("drift_ux_m", "surface_ay_m_per_s2"):
                self.assertAlmostEqual(float(row[answer]) / float(first[answer]) * float(first["level"]) / float(row["level"]), 1, delta=1e-3)

    def test_are_as_recorded_in_a_cloud_and_follow_a_level_at_the_surface(self):
        self.study(RECORDS.replace("  stripes: {pga: [0.1 g, 0.2 g, 0.4 g]}\n", ""))
        for row in self.rows():
            self.assertNotIn("peak", Run(self.folder / "out" / row["folder"]).scene["continuum"]["base"]["across"])
        self.study(RECORDS.replace("0.4 g]", "0.4 g], at: surface"), out="surface")
        for row in self.rows("surface"):
            base = Run(self.folder / "surface" / row["folder"]).scene["continuum"]["base"]
            self.assertAlmostEqual(base["across"]["peak"] / base["acceleration"]["peak"] / self.RATIO[row["motion"][0]], 1, delta=1e-3)

    def test_that_change_are_computed_again(self):
        self.study(RECORDS)
        self.record("A_UP.csv", 70, 4)
        self.assertIn("3 runs computed in", self.study(RECORDS).stdout)

    def test_that_are_wrong_are_told(self):
        component = "{key: continuum.base.across, instead_of: _H1, name: _UP}"
        where = "study.yaml: motions.components[0]"
        for text, said in (
                (RECORDS.replace("name: _UP", "name: _V"), f"{where}: A_H1.csv has no A_V.csv beside it; add that file"),
                (RECORDS.replace("instead_of: _H1", "instead_of: _EW"), f"{where}.instead_of: A_H1.csv has no _EW in its name"),
                (RECORDS.replace('files: "*_H1.csv"', 'files: "*"'), f"{where}.instead_of: A_UP.csv has no _H1 in its name"),
                (RECORDS.replace("base.across", "base.kind"), "continuum.base.kind: is a mapping, expected one of rigid, compliant"),
                (RECORDS.replace("base.across", "base.acros"), "did you mean `across`?"),
                (RECORDS.replace("base.across", "base.acceleration"), f"{where}.key: at continuum.base.acceleration stands another component"),
                (MOTIONS + f"  components: [{component}]\nquestions: [drift_ux_m]\n", f"{where}: motion ricker_2Hz is no record"),
                (RECORDS.replace("instead_of: _H1, ", ""), "motions.components[0].instead_of")):
            with self.subTest(said):
                self.assertIn(said, self.refused(text))
        self.record("A_UP.csv", 0, 4)
        self.assertIn(f"{where}: motion A_H1: ", self.refused(RECORDS))


if __name__ == "__main__":
    unittest.main()
