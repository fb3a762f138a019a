"""How far from rest a model is when time begins: the ratios and the drift of the summary follow from the accelerations and stresses of
time 0."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.discs import point

YOUNG, DENSITY, SIZE, WANTED = 1e8, 2000.0, 4, 3e-3


class Statics(ComputedTest):
    def at_rest(self, **support):
        """A block that is pushed aside by its weight; sets the forces that its free points lack, and their mean and largest size."""
        places = [(x, y) for y in range(1, SIZE + 1) for x in range(SIZE + 1)]  # all but those that are held
        self.computed({
            "material": {"young_modulus": YOUNG, "poisson_ratio": 0.25, "density": DENSITY},
            "time": {"duration": 0.01},
            "statics": {"unbalanced_ratio": WANTED},
            "continuum": {
                "block": {"x_min": 0, "x_max": SIZE, "y_min": 0, "y_max": SIZE, "zones_x": SIZE, "zones_y": SIZE},
                "body_loads": [{"acceleration": {"x": 3, "y": -10}}],
                "histories": [{"name": f"p{x}_{y}", "quantity": f"acceleration_{axis}", "at": point((x, y))}
                              for x, y in places for axis in "xy"]} | support,
            "output": {"history_interval": 1e-9, "field_times": [0]}})
        masses = np.array([DENSITY * (0.5 if x in (0, SIZE) else 1) * (0.5 if y == SIZE else 1) for x, y in places])
        self.lacking = masses[:, None] * [[self.run.histories[f"p{x}_{y}_a{axis}_m_per_s2"][0] for axis in "xy"] for x, y in places]
        sizes = np.hypot(*self.lacking.T)
        self.mean, self.largest = sizes.sum() / (SIZE + 1)**2, sizes.max()
        xx, yy, xy = self.run.fields(0)["grid"]["stress_Pa"].T
        self.internal = np.mean(np.sqrt(xx**2 + yy**2 + 2 * xy**2))  # of zones of 1 m
        return self.run.summary

    def test_ratios(self):
        summary = self.at_rest(motions=[{"where": {"y_max": 0}, "velocity": {"x": 0, "y": 0}}])
        self.assertTrue(0 < summary["statics_unbalanced_ratio"] <= WANTED)
        self.assertAlmostEqual(summary["statics_unbalanced_ratio"], self.mean / self.internal, delta=0.01 * WANTED)
        self.assertAlmostEqual(summary["statics_largest_ratio"], self.largest / self.internal, delta=0.01 * summary["statics_largest_ratio"])
        self.assertEqual(summary["statics_drift_m_per_s"], 0)
        self.assertGreater(summary["statics_steps"], summary["statics_stops"])
        self.assertGreater(summary["statics_stops"], 0)
        moved = self.run.fields(0)["grid"]["displacement_m"]
        self.assertEqual(np.abs(moved).max(), 0)  # which count from time 0

    def test_drift(self):
        """The speed at which the dashpots of a base would balance what all other points lack."""
        summary = self.at_rest(quiet=[{"where": {"y_max": 0}}], motions=[{"where": {"y_max": 0, "x_max": 0}, "velocity": {"x": 0}}])
        drag = SIZE * np.sqrt(DENSITY * 1.2 * YOUNG)  # of P waves; along x the base is held
        expected = abs(self.lacking[:, 1].sum()) / drag
        self.assertGreater(expected, 1e-5)
        self.assertAlmostEqual(summary["statics_drift_m_per_s"], expected, delta=1e-3 * expected)

    def test_excavated_quiet_side(self):
        """Ground that is taken away takes the dashpots of its edges along: with them the points that stay would be driven by local
        damping, faster in every step."""
        self.computed({
            "plane": "plane_stress",
            "material": {"young_modulus": YOUNG, "poisson_ratio": 0.2, "density": DENSITY},
            "time": {"duration": 0.01},
            "statics": {"unbalanced_ratio": 1e-6, "damping": "local", "max_steps": 4000},
            "continuum": {
                "block": {"x_min": -4, "x_max": 4, "y_min": 0, "y_max": 4, "zones_x": 16, "zones_y": 8},
                "body_loads": [{"acceleration": {"y": -10}}],
                "excavations": [{"where": {"x_min": 2, "y_min": 1, "y_max": 3}, "stage": 1}],
                "quiet": [{"where": {"x_max": -4}}, {"where": {"x_min": 4}}], "motions": [{"where": {"y_max": 0}, "velocity": {"x": 0, "y": 0}}]}})
        self.assertLess(self.run.summary["statics_unbalanced_ratio"], 1e-6)


if __name__ == "__main__":
    unittest.main()
