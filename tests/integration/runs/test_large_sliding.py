"""Interfaces that slide far in large strain, against closed forms and against small strain."""

import math
import unittest

import numpy as np

from figures.computed import ComputedTest
from runs.test_interfaces import DAMPED, GRAVITY, ROCK, rectangle

FRICTION = math.radians(30)


class Incline(ComputedTest):
    """A block of 4 m on a longer base, under gravity that is inclined against it."""

    def slide(self, along=8.0, *, large_strain=True, duration=1.0, load=1.0, **law):
        continuum = {
            "large_strain": large_strain,
            "blocks": [rectangle("base", (0.0, 12.0), (-1.0, 0.0), (24, 2)), rectangle("block", (1.0, 5.0), (0.0, 2.0), (8, 4))],
            "motions": [{"where": {"y_max": -1.0}, "velocity": {"x": 0.0, "y": 0.0}}],
            "body_loads": [{"acceleration": {"x": along * load, "y": -GRAVITY * load}}],
            "interfaces": [{"name": "foot", "along": {"line": {"points": [{"x": 0.0, "y": 0.0}, {"x": 12.0, "y": 0.0}]}},
                            "law": {"friction_angle": FRICTION, **law}}],
            "histories": [{"name": "block", "quantity": "velocity_x", "at": {"x": 3.0, "y": 1.0}}]
            + [{"name": "foot", "quantity": quantity, "interface": "foot", "at": {"x": 3.0, "y": 0.0}}
               for quantity in ("offset", "opening", "normal_stress", "shear_stress")],
            "damping": DAMPED}
        return self.computed({"material": ROCK, "time": {"duration": duration}, "continuum": continuum,
                              "initial_stress": {"yy": -2 * 2500 * GRAVITY * load, "yy_per_metre": 2500 * GRAVITY * load}})

    def test_a_block_without_friction_falls_along_its_base_over_several_zones(self):
        run = self.slide(friction_angle=0.0)
        self.assertLess(run.summary["max_energy_drift"], 1e-10)
        h = run.histories
        late = self.time > 0.2
        self.assertAlmostEqual(np.polyfit(self.time[late], h["block_vx_m_per_s"][late], 1)[0] / 8, 1, delta=1e-3)
        self.assertAlmostEqual(h["foot_offset_m"][-1] / (8 * self.time[-1]**2 / 2), 1, delta=1e-3)
        self.assertGreater(h["foot_offset_m"][-1], 3 * 0.5)

    def test_small_motions_are_those_of_small_strain(self):
        def difference(load):
            large, small = (self.slide(4.0, large_strain=kind, duration=0.02, load=load).histories for kind in (True, False))
            return np.max(np.abs(large["block_vx_m_per_s"] - small["block_vx_m_per_s"])) / np.max(np.abs(small["block_vx_m_per_s"]))
        coarse, fine = difference(200.0), difference(100.0)
        self.assertLess(coarse, 0.01)
        self.assertAlmostEqual(fine / coarse, 0.5, delta=0.05)


if __name__ == "__main__":
    unittest.main()
