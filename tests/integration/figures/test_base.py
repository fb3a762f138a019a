"""What a base tells of its motion: the tables of the input are those of the motion that the scene states, whatever answers above."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.discs import point

DENSITY, SHEAR_MODULUS = 2000.0, 8e7
STEP, END, FREQUENCY, PEAK = 1e-3, 1.0, 4.0, 0.5
SPEED = np.sqrt(SHEAR_MODULUS / DENSITY)  # of S waves: 200 m/s


class Base(ComputedTest):
    def shaken(self, kind):
        """A column of 8 m whose sides move across it only."""
        poisson = 0.25
        histories = [{"name": name, "quantity": f"{what}_x", "at": point((0.5, y))}
                     for name, y in (("foot", 0), ("crest", 8)) for what in ("acceleration", "velocity", "displacement")]
        self.computed({
            "material": {"young_modulus": SHEAR_MODULUS * 2 * (1 + poisson), "poisson_ratio": poisson, "density": DENSITY},
            "time": {"duration": END, "dt": STEP},
            "continuum": {
                "block": {"x_min": 0, "x_max": 1, "y_min": 0, "y_max": 8, "zones_x": 1, "zones_y": 8},
                "motions": [{"where": {"y_min": 0.5 if kind == "rigid" else 0}, "velocity": {"y": 0}}],
                "base": {"kind": kind, "acceleration": {"sine": {"frequency": FREQUENCY, "end": END}, "peak": PEAK, "baseline": False}},
                "histories": histories},
            "output": {"history_interval": STEP,
                       "spectra": [{"history": name, "shortest_period": 0.05, "longest_period": 1} for name in ("foot", "crest")]}})
        self.spectra = {name: self.run.spectra[f"{name}_ax"] for name in ("foot", "crest")}
        stated = self.spectra["crest"]["input"]
        np.testing.assert_allclose(stated["acceleration_m_per_s2"], PEAK * np.sin(2 * np.pi * FREQUENCY * stated["time_s"]), atol=0.01 * PEAK)
        for what in ("input", "reference"):
            for column, values in self.spectra["foot"][what].items():
                np.testing.assert_array_equal(values, self.spectra["crest"][what][column])
        return self.time

    def test_a_rigid_one(self):
        """It has the motion; what it tells of itself is what was put in."""
        t = self.shaken("rigid")
        for column in ("acceleration_m_per_s2", "velocity_m_per_s", "displacement_m"):
            given = np.interp(t, self.spectra["foot"]["input"]["time_s"], self.spectra["foot"]["input"][column])
            np.testing.assert_allclose(self.spectra["foot"]["motion"][column], given, atol=0.02 * np.abs(given).max(), err_msg=column)
        moved = self.run.histories["foot_ux_m"]
        omega = 2 * np.pi * FREQUENCY
        np.testing.assert_allclose(moved, PEAK / omega * (t - np.sin(omega * t) / omega), atol=1e-3 * moved.max())

    def test_a_compliant_one(self):
        """The motion is that of an outcrop: half of it rises, and a crest of ground as below has the whole, later by the way of the wave."""
        t = self.shaken("compliant")
        crest = self.run.histories["crest_vx_m_per_s"]
        omega, late = 2 * np.pi * FREQUENCY, t - 8 / SPEED
        outcrop = lambda when: np.where(when > 0, PEAK / omega * (1 - np.cos(omega * when)), 0)  # noqa: E731
        np.testing.assert_allclose(crest, outcrop(late), atol=0.01 * crest.max())
        foot = self.run.histories["foot_vx_m_per_s"]
        np.testing.assert_allclose(foot, (outcrop(t) + outcrop(t - 16 / SPEED)) / 2, atol=0.01 * crest.max())


if __name__ == "__main__":
    unittest.main()
