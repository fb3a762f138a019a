"""Interfaces that slide far in large strain, against closed forms and against small strain."""

import math
import unittest

import numpy as np

from figures.computed import ComputedTest
from runs.test_interfaces import DAMPED, GRAVITY, ROCK, rectangle

FRICTION = math.radians(30)


class Incline(ComputedTest):
    """A block of 4 m at rest on a longer base, which gravity then draws along it."""

    def slide(self, along=8.0, *, large_strain=True, duration=1.0, load=1.0, within=0.05, rest=True, water=None, **law):
        ground = {"material": ROCK} if water is None else {"material": {**ROCK, "pores": {"porosity": 0.3}}, "water": water}
        continuum = {
            "large_strain": large_strain,
            "blocks": [rectangle("base", (0.0, 12.0), (-1.0, 0.0), (24, 2)), rectangle("block", (1.0, 5.0), (0.0, 2.0), (8, 4))],
            "motions": [{"where": {"y_max": -1.0}, "velocity": {"x": 0.0, "y": 0.0}}],
            "body_loads": [{"acceleration": {"y": -GRAVITY * load}},
                           {"acceleration": {"x": along * load}, "time": {"table": {"time": [0.0, within], "value": [0.0, 1.0]}}}],
            "interfaces": [{"name": "foot", "along": {"line": {"points": [{"x": 0.0, "y": 0.0}, {"x": 12.0, "y": 0.0}]}},
                            "law": {"friction_angle": FRICTION, **law}}],
            "histories": [{"name": "block", "quantity": "velocity_x", "at": {"x": 3.0, "y": 1.0}}]
            + [{"name": "foot", "quantity": quantity, "interface": "foot", "at": {"x": 3.0, "y": 0.0}}
               for quantity in ("offset", "opening", "normal_stress", "shear_stress")],
            "damping": DAMPED}
        # What friction is left with at rest depends on the way there, which is another one in large strain.
        begin = {"statics": {}} if rest else {"initial_stress": {"yy": -2 * 2500 * GRAVITY * load, "yy_per_metre": 2500 * GRAVITY * load}}
        return self.computed({**ground, **begin, "time": {"duration": duration}, "continuum": continuum})

    def acceleration(self, run):
        late = self.time > 0.3
        return np.polyfit(self.time[late], run.histories["block_vx_m_per_s"][late], 1)[0]

    def test_a_block_without_friction_falls_along_its_base_over_several_zones(self):
        run = self.slide(friction_angle=0.0, within=1e-6)
        self.assertLess(run.summary["max_energy_drift"], 1e-10)
        self.assertAlmostEqual(self.acceleration(run) / 8, 1, delta=1e-3)
        self.assertAlmostEqual(run.histories["foot_offset_m"][-1] / (8 * self.time[-1]**2 / 2), 1, delta=1e-3)
        self.assertGreater(run.histories["foot_offset_m"][-1], 3 * 0.5)

    def test_friction_holds_it_back_across_the_nodes_of_the_base(self):
        run = self.slide(duration=1.2)
        self.assertLess(run.summary["max_energy_drift"], 1e-8)
        friction = (8 - self.acceleration(run)) / (GRAVITY * math.tan(FRICTION))
        self.assertAlmostEqual(friction, 1, delta=5e-3)  # the pressure is uneven, and faces that part slip unheld
        self.assertGreater(run.histories["foot_offset_m"][-1], 3 * 0.5)

    def test_below_water_friction_is_that_of_the_effective_weight(self):
        run = self.slide(duration=1.2, water={"level": 2.0, "bulk_modulus": 50e6})
        self.assertLess(run.summary["max_energy_drift"], 1e-8)
        friction = (8 - self.acceleration(run)) / (GRAVITY * (1 - 1000 / 2500) * math.tan(FRICTION))
        self.assertAlmostEqual(friction, 1, delta=5e-3)
        self.assertGreater(run.histories["foot_offset_m"][-1], 3 * 0.5)

    def test_small_motions_are_those_of_small_strain(self):
        for water in (None, {"level": 2.0, "bulk_modulus": 50e6}):
            def difference(load):
                large, small = (self.slide(4.0, large_strain=kind, duration=0.02, load=load, within=1e-6, rest=False, water=water).histories for kind in (True, False))
                return np.max(np.abs(large["block_vx_m_per_s"] - small["block_vx_m_per_s"])) / np.max(np.abs(small["block_vx_m_per_s"]))
            coarse, fine = difference(200.0), difference(100.0)
            self.assertLess(coarse, 0.01)
            self.assertAlmostEqual(fine / coarse, 0.5, delta=0.05)


class Disc(ComputedTest):
    """A disc in a ring that is held: two halves of it are drawn in opposite directions, and nothing holds it back."""

    PULL = 10.0

    def spin(self, around):
        centre = {"centre": {"x": 0.0, "y": 0.0}}
        run = self.computed({
            "material": {"young_modulus": 1e9, "poisson_ratio": 0.2, "density": 2000.0},
            "time": {"duration": 0.4},
            "continuum": {
                "large_strain": True,
                "blocks": [rectangle("disc", (-0.5, 0.5), (-0.5, 0.5), (around // 4, around // 4)),
                           {"name": "disc", "ring": {**centre, "inner_side": 1.0, "outer_radius": 1.0}, "along": {"zones": around}, "across": {"zones": around // 8}},
                           {"name": "ring", "ring": {**centre, "inner_radius": 1.0, "outer_radius": 1.5}, "along": {"zones": around}, "across": {"zones": 3}}],
                "motions": [{"where": {"annulus": {**centre, "inner_radius": 1.49, "outer_radius": 1.6}}, "velocity": {"x": 0.0, "y": 0.0}}],
                "body_loads": [{"where": {"group": "disc", "y_min": 0.001}, "acceleration": {"x": self.PULL}},
                               {"where": {"group": "disc", "y_max": -0.001}, "acceleration": {"x": -self.PULL}}],
                "interfaces": [{"name": "rim", "between": {"left": "disc", "right": "ring"}, "law": {"friction_angle": 0.0}}],
                "histories": [{"name": "half", "quantity": quantity, "at": {"x": 0.0, "y": 0.5}}
                              for quantity in ("displacement_x", "displacement_y", "velocity_x", "velocity_y")]
                + [{"name": "rim", "quantity": quantity, "interface": "rim", "at": {"x": 0.0, "y": 1.0}} for quantity in ("offset", "opening")]}})
        self.assertLess(run.summary["max_energy_drift"], 1e-6)
        h = run.histories
        angle = np.arctan2(h["half_ux_m"], 0.5 + h["half_uy_m"])
        rate = np.hypot(h["half_vx_m_per_s"], h["half_vy_m_per_s"]) / 0.5
        return angle, rate, abs(h["rim_offset_m"])

    def test_it_turns_within_its_ring_without_resistance(self):
        """The couple 4/3 rho a R^3 cos(angle) turns the inertia pi/2 rho R^4: rate^2 = 2 (8 a/(3 pi R)) sin(angle)."""
        misses = []
        for around in (16, 32):
            angle, rate, offset = self.spin(around)
            self.assertGreater(math.degrees(angle[-1]), 35)  # past several points of the ring
            expected = np.sqrt(2 * 8 * self.PULL / (3 * math.pi) * np.sin(angle))
            late = angle > 0.1
            misses.append(abs(rate[late] / expected[late] - 1).max())
            np.testing.assert_allclose(offset[late], angle[late], rtol=0.02)
        self.assertLess(misses[1], 0.01)
        self.assertLess(misses[1], misses[0] / 3)  # second order


if __name__ == "__main__":
    unittest.main()
