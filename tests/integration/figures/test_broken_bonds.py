"""Bonds that shear, that join two groups, or that break before time begins: cracks.csv, fields and summary tell each where it belongs."""

import unittest

import numpy as np

from figures.computed import ComputedTest, told_report
from figures.discs import driven, near, point, scene, table
from figures.told import Told

STEP, END = 1e-4, 0.01
WHOLE = np.array([(0, 0), (1, 0)])
SHEARED = np.array([(0, 5), (1, 5)])
PARTED = np.array([(0, 10), (1, 10)])  # of which the second is of another group
BONDS = {"normal_stiffness": 1e8, "shear_stiffness": 4e7, "tensile_strength": 30.05e3, "shear_strength": 10.02e3}


class BrokenBonds(ComputedTest):
    def test_of_one_body_and_of_two(self):
        shift, stretch = 0.05, 0.1
        self.computed(scene(
            END, STEP, bonds=BONDS, groups=[{"name": "other", "where": near(PARTED[1])}],
            motions=[driven(p) for p in (*WHOLE, SHEARED[0], PARTED[0])] + [driven(SHEARED[1], (0, shift)), driven(PARTED[1], (stretch, 0))]),
            discs=table([*WHOLE, *SHEARED, *PARTED]))
        sheared = np.ceil(BONDS["shear_strength"] / 4e7 / shift / STEP)  # steps
        parted = np.ceil(BONDS["tensile_strength"] / 1e8 / stretch / STEP)
        sheared, parted = (int(step) for step in (sheared, parted))
        self.assertLess(parted, sheared)
        cracks = self.run.cracks
        self.assertEqual((list(cracks["mode"]), list(cracks["group"])), (["tensile", "shear"], ["particles-other", "particles"]))
        told = Told(self, "cracks.csv", cracks, {"mode", "group"})
        told.equal({"step": [parted, sheared], "time_s": [parted * STEP, sheared * STEP], "x_m": [0.5, 0.5], "y_m": [10, 5],
                    "length_m": 1 / np.sqrt(3), "parent_a": [4, 2], "parent_b": [5, 3], "stage": [0, 0]}, tolerance=1e-4)
        told.equal({"orientation_rad": np.pi / 2})
        told.all_told()
        kinds = "crack", "debond", "bond_force"
        told = Told(self, "summary.json", {key: number for key, number in self.run.summary.items() if any(kind in key for kind in kinds)})
        told.equal({"crack_count": 1, "first_crack_time_s": sheared * STEP, "first_crack_x_m": 0.5, "first_crack_y_m": 5, "cracks_in_statics": {},
                    "debonded_count": 1, "first_debonding_time_s": parted * STEP, "first_debonding_x_m": 0.5, "first_debonding_y_m": 10,
                    "debonded_in_statics": {}, "peak_bond_force_N": 1e8 * stretch * (parted - 1) * STEP,
                    "peak_bond_force_time_s": (parted - 1) * STEP, "peak_bond_force_x_m": 0.5, "peak_bond_force_y_m": 10}, tolerance=1e-4)
        told.all_told()
        self.assertEqual(self.run.summary["particles_groups"], ["particles", "other"])
        text, _ = told_report(self, self.run)
        for sentence in ("The only crack inside one body broke at 5.1 ms, x = 500 mm, y = 5 m.",
                         "The only debonded bond between two groups broke at 3.1 ms, x = 500 mm, y = 10 m."):
            self.assertTrue(sentence in text, sentence)
        bonds, discs = (self.run.fields()[kind] for kind in ("bonds", "particles"))
        heights = bonds.points[bonds.cells[:, 0], 1]
        self.assertEqual(dict(zip(heights, bonds["state"])), {0: 0, 5: 2, 10: 1})
        self.assertEqual(sorted(zip(discs["id"], discs["group"])), [*((i, 0) for i in range(5)), (5, 1)])
        bodies = dict(zip(discs["id"], discs["fragment"]))
        self.assertEqual((bodies[0] == bodies[1], sorted(set(bodies.values()))), (True, [0, 1, 2, 3, 4]))
        mass = 2000 * np.pi / 4
        kinetic = mass / 2 * (shift**2 + stretch**2)
        t = self.time
        way, gap = shift * t, stretch * t
        shear, normal = np.where(t < (sheared - 0.5) * STEP, 4e7 * way, 0), np.where(t < (parted - 0.5) * STEP, 1e8 * gap, 0)
        work = 4e7 * way**2 / 2 * (shear > 0) + 1e8 * gap**2 / 2 * (normal > 0)
        released = np.where(t < (sheared - 0.5) * STEP, 0, 4e7 * shift**2 * STEP**2 * sheared * (sheared - 1) / 2) + np.where(
            t < (parted - 0.5) * STEP, 0, 1e8 * stretch**2 * STEP**2 * parted * (parted - 1) / 2)
        np.testing.assert_allclose(self.run.histories["particles_released_J"], released, atol=1e-4 * released[-1])
        self.told_energies(size=released[-1], tolerance=1e-4, contact_bonds=work, motions=work + released + np.where(t > 0, kinetic, 0))

    def test_before_time_begins(self):
        """Loads that bonds cannot bear tear them in statics, one in a stage that takes its support away: they count there, and as
        cracks of the time 0. Walls stop what they held."""
        propped = SHEARED + [0, 10]
        prop = np.array([2, 15])
        text = scene(
            END, STEP, bonds=BONDS, groups=[{"name": "other", "where": near(PARTED[1])}, {"name": "prop", "where": near(prop)}],
            between=[{"first": "particles", "second": "prop"}],
            motions=[driven(p) for p in (*WHOLE, SHEARED[0], PARTED[0], propped[0], prop)], excavations=[{"where": near(prop), "stage": 1}],
            loads=[{"where": near(p), "force": {"x": factor * BONDS["tensile_strength"]}} for p, factor in (
                (SHEARED[1], 2), (PARTED[1], 2), (propped[1], 1.1))],
            walls=[{"name": f"stop_{y}", "from": point((x, y - 1)), "to": point((x, y + 1))} for x, y in ((1.6, 5), (1.6, 10), (2.6, 15))])
        self.computed(text | {"statics": {"unbalanced_ratio": 1e-6}}, discs=table([*WHOLE, *SHEARED, *PARTED, *propped, prop]))
        summary, cracks = self.run.summary, self.run.cracks
        self.assertEqual((summary["crack_count"], summary["cracks_in_statics"]), (2, {"0": 1, "1": 1}))
        self.assertEqual((summary["debonded_count"], summary["debonded_in_statics"]), (1, {"0": 1}))
        self.assertEqual((summary["first_crack_time_s"], summary["first_crack_x_m"], summary["first_crack_y_m"]), (0, 0.5, 5))
        self.assertEqual((summary["first_debonding_time_s"], summary["first_debonding_x_m"], summary["first_debonding_y_m"]), (0, 0.5, 10))
        self.assertEqual((set(cracks["step"]), set(cracks["time_s"])), ({0}, {0}))
        self.assertEqual(sorted(zip(cracks["y_m"], cracks["stage"], cracks["group"])),
                         [(5, 0, "particles"), (10, 0, "particles-other"), (15, 1, "particles")])


if __name__ == "__main__":
    unittest.main()
