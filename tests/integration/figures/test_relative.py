"""Motions of zones and of particles, of which each may count against another place: displacement, velocity and acceleration belong to
one motion, and its spectra, amplification and peaks to it, too."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.discs import driven, point, table

STEP, END, FREQUENCY = 1e-3, 1.0, 8.0
SPEEDS = np.array([0.02, -0.05])  # of the lower and the upper side, or of two discs
QUANTITIES = {"displacement": "u{}_m", "velocity": "v{}_m_per_s", "acceleration": "a{}_m_per_s2"}
SINE = {"sine": {"frequency": FREQUENCY}}
MATERIAL = {"young_modulus": 1e7, "poisson_ratio": 0.2, "density": 2000}


def histories(name, place, **relative):
    return [{"name": name, "quantity": f"{what}_{axis}", "at": point(place), **relative} for what in QUANTITIES for axis in "xy"]


def course(steps):
    """Displacement, velocity of half a step before and acceleration of a unit motion along x."""
    n = np.arange(steps + 1)
    after = np.sin(2 * np.pi * FREQUENCY * (n + 0.5) * STEP)
    before = np.concatenate([[0], after[:-1]])
    acceleration = (after - before) / STEP
    acceleration[0] = after[0] / (STEP / 2)  # from rest within half a step
    return {"displacement": STEP * np.cumsum(before), "velocity": before, "acceleration": acceleration}


class Relative(ComputedTest):
    def expected(self, **factors):
        """Columns of motions along x, as factors of the unit motion."""
        unit = course(round(END / STEP))
        return {f"{name}_{column.format(axis)}": (factor if axis == "x" else 0) * unit[what]
                for name, factor in factors.items() for what, column in QUANTITIES.items() for axis in "xy"}

    def test_of_zones(self):
        """At a third of the height, against a quarter of it."""
        self.computed({
            "material": MATERIAL, "time": {"duration": END, "dt": STEP},
            "continuum": {
                "block": {"x_min": 0, "x_max": 2, "y_min": 0, "y_max": 1, "zones_x": 1, "zones_y": 1},
                "motions": [{"where": {"y_min": y, "y_max": y}, "velocity": {"x": speed, "y": 0}, "time": SINE} for y, speed in enumerate(SPEEDS)],
                "histories": histories("p", (0.5, 1 / 3)) + histories("r", (0.5, 1 / 3), relative_to=point((1.7, 0.25)))
                + histories("low", (1, 0)) + histories("high", (1, 1)),
            },
            "output": {"history_interval": STEP,
                       "spectra": [{"history": "high", "relative_to": "low", "shortest_period": 0.05, "longest_period": 0.5}]}})
        low, high = SPEEDS
        self.told_histories(self.expected(p=low + (high - low) / 3, r=(high - low) / 12, low=low, high=high))
        self.assertAlmostEqual(self.run.summary["high_ax_largest_amplification"], abs(high / low), places=9)
        transfer = self.run.spectra["high_ax"]["transfer"]
        known = np.isfinite(transfer["ratio"])
        self.assertTrue(known.any())
        np.testing.assert_allclose(transfer["ratio"][known], abs(high / low), rtol=1e-9)
        np.testing.assert_allclose(transfer["low_ax_amplitude_m_per_s"] * abs(high / low), transfer["amplitude_m_per_s"], rtol=1e-9)
        at = self.run.summary["high_ax_largest_amplification_Hz"]
        self.assertIn(at, transfer["frequency_Hz"][known])
        for column in ("acceleration_m_per_s2", "velocity_m_per_s", "displacement_m"):
            below, above = self.run.spectra["high_ax"]["input"][column], self.run.spectra["high_ax"]["motion"][column]
            np.testing.assert_allclose(above, high / low * below, rtol=1e-6, atol=1e-6 * np.abs(above).max(), err_msg=column)
        for column in ("sd_5pct_m", "sv_5pct_m_per_s", "sa_5pct_m_per_s2"):
            np.testing.assert_allclose(self.run.spectra["high_ax"]["response"][column],
                                       abs(high / low) * self.run.spectra["high_ax"]["reference"][column], rtol=1e-9, err_msg=column)

    def test_of_particles(self):
        places = [(0, 0), (5, 0)]
        self.computed({
            "material": MATERIAL, "time": {"duration": END, "dt": STEP},
            "particles": {
                "placed": {"path": "discs.csv"}, "contacts": {"normal_stiffness": 1e6, "shear_stiffness": 1e6},
                "motions": [driven(place, (speed, 0)) | {"time": SINE} for place, speed in zip(places, SPEEDS)],
                "histories": histories("p", places[1]) + histories("r", places[0], relative_to=point(places[1])),
            },
            "output": {"history_interval": STEP, "peaks": {}}}, discs=table(places))
        low, high = SPEEDS
        self.told_histories(self.expected(p=high, r=low - high))
        particles, unit = self.run.fields()["particles"], course(round(END / STEP))
        for what, size in {"displacement_m": "displacement", "velocity_m_per_s": "velocity", "acceleration_m_per_s2": "acceleration"}.items():
            np.testing.assert_allclose(particles[f"peak_{what}"], np.abs(SPEEDS) * np.abs(unit[size]).max(), rtol=1e-9, err_msg=what)


if __name__ == "__main__":
    unittest.main()
