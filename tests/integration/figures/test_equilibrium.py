"""Requirement: what a run puts out is in equilibrium. The stress that histories tell is the stress that acts: the shear stress at a depth
is the inertia of the ground above, whatever damps the ground."""

import json
import unittest

from programs import ProgramTest, columns

HEIGHT, ZONES, DENSITY = 20, 20, 2000
BOTTOM = 8  # of the zone whose stress is asked for: 8 to 9 m


def column(**ground):
    """A column of ground, one zone wide, that a rigid base shears."""
    sides = [{"where": {"x_max": 0, "y_min": 0.5}, "velocity": {"y": 0}}, {"where": {"x_min": 1, "y_min": 0.5}, "velocity": {"y": 0}}]
    points = [{"name": f"a{y}", "quantity": "acceleration_x", "at": {"x": 0.5, "y": y}} for y in range(BOTTOM + 1, HEIGHT + 1)]
    return {
        "material": {"young_modulus": 2e8, "poisson_ratio": 0.3, "density": DENSITY},
        "time": {"duration": 0.5},
        "continuum": {
            "block": {"x_min": 0, "x_max": 1, "y_min": 0, "y_max": HEIGHT, "zones_x": 1, "zones_y": ZONES},
            "motions": sides,
            "base": {"acceleration": {"sine": {"frequency": 4, "end": 0.5}, "peak": 1}},
            "histories": [{"name": "cut", "quantity": "stress_xy", "at": {"x": 0.5, "y": BOTTOM + 0.5}}, *points],
            **ground,
        },
        "output": {"history_interval": 1e-9},
    }


class Equilibrium(ProgramTest):
    def stress_and_inertia(self, **ground):
        """Stress in the zone and what the ground above it needs for its acceleration, at each step [Pa]."""
        values = columns(self.run_scene(self.scene(json.dumps(column(**ground)))))
        masses = [DENSITY * (0.5 if y == HEIGHT else 1.0) for y in range(BOTTOM + 1, HEIGHT + 1)]
        above = [-sum(m * a for m, a in zip(masses, row)) for row in zip(*(values[f"a{y}_ax_m_per_s2"] for y in range(BOTTOM + 1, HEIGHT + 1)))]
        return values["cut_sxy_Pa"], above

    def assert_equal_within(self, share, stress, inertia):
        largest = max(map(abs, inertia))
        self.assertGreater(largest, 1e4)
        self.assertLessEqual(max(abs(a - b) for a, b in zip(stress, inertia)) / largest, share)

    def test_of_undamped_ground(self):
        self.assert_equal_within(1e-9, *self.stress_and_inertia())

    def test_of_ground_damped_by_maxwell_elements(self):
        damping = {"maxwell": {"ratio": 0.05, "low_frequency": 1, "high_frequency": 30}}
        self.assert_equal_within(1e-9, *self.stress_and_inertia(damping=damping))

    def test_of_ground_with_rayleigh_damping(self):
        # The part of the masses, alpha m v, holds the ground from outside: 0.02 m/s^2 of 1 m/s^2 here.
        damping = {"rayleigh": {"ratio": 0.05, "low_frequency": 0.03, "high_frequency": 30}}
        self.assert_equal_within(0.02, *self.stress_and_inertia(damping=damping))


if __name__ == "__main__":
    unittest.main()
