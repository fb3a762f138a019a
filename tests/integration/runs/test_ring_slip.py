"""Circular linings that are tied to the ground, slip freely on it, or slip with friction, against closed forms."""

import math
import unittest

import numpy as np

from figures.computed import ComputedTest

from adit.cases.tunnels import lined_tunnel
from programs import SOURCE

FREE = {"interface": {"tension": 1e9}}  # slips freely and never parts
GLUED = {"interface": {"cohesion": 1e9, "tension": 1e9}}


def amplitude(values, wave):
    return 2 * np.mean(values * wave)


class Sheared(ComputedTest):
    """Sheared far away, at rest."""

    def ovalled(self, interface, fine=False):
        """The tunnel, and the amplitudes of thrust, moment and shear force by a shear strain of 1."""
        side, around, across, ratio = (120.0, 128, 64, 1.055) if fine else (60.0, 64, 26, 1.09)
        half, force = side / 2, 50e3 * side
        lining = {"name": "lining", "along": {"circle": {"centre": {"x": 0.0, "y": 0.0}, "radius": 3.0}}, "thickness": 0.25,
                  "young_modulus": 30e9, **interface}
        run = self.computed({"extends": str(SOURCE / "cases/lined_tunnel/ovaling.yaml"), "continuum": {
            "linings": [lining],
            "blocks": [{"ring": {"centre": {"x": 0.0, "y": 0.0}, "inner_radius": 3.0, "outer_side": side}, "along": {"zones": around},
                        "across": {"zones": across, "ratio": ratio}}],
            "edge_loads": [{"where": {key: at}, "force": {axis: sign * force}} for key, at, axis, sign in
                           (("y_min", half, "x", 1), ("y_max", -half, "x", -1), ("x_min", half, "y", 1), ("x_max", -half, "y", -1))],
            "motions": [{"where": {"x_max": -half, "y_max": -half}, "velocity": {"x": 0.0, "y": 0.0}},
                        {"where": {"x_min": half, "y_max": -half}, "velocity": {"y": 0.0}}]}})
        angle, *forces = lined_tunnel.around(run)
        turned = 2 * np.radians(angle - 45)
        found = [abs(amplitude(force, wave(turned))) for force, wave in zip(forces, (np.cos, np.cos, np.sin))]
        return lined_tunnel.Tunnel.of(run), np.array(found) / lined_tunnel.far_strain(run)

    def test_a_ring_that_slips_bears_what_the_closed_forms_say(self):
        # In full slip Penzien's (2000) moment is that of Wang (1993): 6 EI d/D^2 with his alpha is the same expression.
        tunnel, found = self.ovalled(FREE, fine=True)
        np.testing.assert_allclose(found, lined_tunnel.full_solution(tunnel, slips=True), rtol=0.01)
        self.assertAlmostEqual(found[1] / lined_tunnel.wang_moment(tunnel), 1, delta=0.01)
        self.assertAlmostEqual(found[0] * tunnel.radius / lined_tunnel.wang_moment(tunnel), 1, delta=0.01)  # Wang: N = M/r

    def test_a_ring_that_is_tied_bears_what_the_closed_forms_say(self):
        tunnel, found = self.ovalled({}, fine=True)
        np.testing.assert_allclose(found, lined_tunnel.full_solution(tunnel), rtol=0.01)
        self.assertAlmostEqual(found[0] / lined_tunnel.wang_thrust(tunnel), 1, delta=0.01)

    def test_friction_lies_between_full_slip_and_none(self):
        tied, glued, rough, smooth = (self.ovalled(interface)[1][0] for interface in (
            {}, GLUED, {"interface": {"cohesion": 50e3, "tension": 1e9}}, FREE))
        self.assertAlmostEqual(glued / tied, 1, delta=1e-3)
        self.assertLess(smooth, 0.5 * rough)
        self.assertLess(rough, 0.8 * glued)


class Excavated(ComputedTest):
    """Installed in stressed ground before the opening takes any of the stress away (Einstein and Schwartz 1979)."""

    PRESSURE, RATIO, SIDE = 1e6, 0.5, 240.0  # of the vertical stress; of the horizontal to it

    def lined(self, interface, fine=False):
        """The tunnel, the mean thrust, and the amplitudes of thrust, moment and shear force."""
        around, across, ratio = (192, 92, 1.0475) if fine else (96, 46, 1.0975)
        corner = self.SIDE / 2
        circle = {"centre": {"x": 0.0, "y": 0.0}}
        run = self.computed({
            "material": {"young_modulus": 300e6, "poisson_ratio": 0.3, "density": 2000.0},
            "time": {"duration": 1e-3, "dt_factor": 0.9}, "output": {"field_times": []}, "statics": {"unbalanced_ratio": 1e-7},
            "initial_stress": {"xx": -self.RATIO * self.PRESSURE, "yy": -self.PRESSURE},
            "continuum": {
                "blocks": [
                    {"name": "core", "rectangle": {"x_min": -1.5, "x_max": 1.5, "y_min": -1.5, "y_max": 1.5},
                     "along": {"zones": around // 4}, "across": {"zones": around // 4}},
                    {"name": "core", "ring": {**circle, "inner_side": 3.0, "outer_radius": 3.0}, "along": {"zones": around}, "across": {"zones": around // 32}},
                    {"ring": {**circle, "inner_radius": 3.0, "outer_side": self.SIDE}, "along": {"zones": around},
                     "across": {"zones": across, "ratio": ratio}}],
                "excavations": [{"where": {"group": "core"}, "stage": 1, "released": 0.0}],
                "linings": [{"name": "lining", "along": {"circle": {**circle, "radius": 3.0}}, "thickness": 0.15, "young_modulus": 30e9,
                             "stage": 2, **interface}],
                "motions": [{"where": {key: at}, "velocity": {"x": 0.0, "y": 0.0}}
                            for key, at in (("x_min", corner), ("x_max", -corner), ("y_min", corner), ("y_max", -corner))]}})
        angle, thrust, *others = lined_tunnel.around(run)
        turned = 2 * np.radians(angle)
        found = [thrust.mean(), *(amplitude(force, wave(turned)) for force, wave in zip((thrust, *others), (np.cos, np.cos, np.sin)))]
        return lined_tunnel.Tunnel.of(run), np.abs(found)

    def full_solution(self, tunnel, slips):
        mean, shear = (self.PRESSURE * (1 + sign * self.RATIO) / 2 for sign in (1, -1))
        return lined_tunnel.excavation_forces(tunnel, mean, shear, slips)

    def einstein_schwartz(self, t, slips):
        """Mean thrust and amplitudes of thrust and moment; c, f: their ratios of compressibility and flexibility."""
        nu, k = t.poisson, self.RATIO
        young = 2 * t.shear_modulus * (1 + nu) / (1 - nu**2)
        c, f = young * t.radius / t.axial, young * t.radius**3 / t.bending
        mean = (1 + k) / 2 * (1 - c * f * (1 - nu) / (c + f + c * f * (1 - nu)))
        if slips:
            bent = (1 - k) * (0.5 - (f + 6) * (1 - nu) / (2 * f * (1 - nu) + 6 * (5 - 6 * nu)))
            return self.PRESSURE * t.radius * np.array([mean, bent, bent * t.radius])
        beta = ((6 + f) * c * (1 - nu) + 2 * f * nu) / (3 * f + 3 * c + 2 * c * f * (1 - nu))
        b = c * (1 - nu) / (2 * (c * (1 - nu) + 4 * nu - 6 * beta - 3 * beta * c * (1 - nu)))
        a = beta * b
        return self.PRESSURE * t.radius * np.array([mean, (1 - k) * (0.5 + a), (1 - k) * (0.25 - a / 2 + b / 2) * t.radius])

    def test_a_tied_ring_bears_what_the_closed_forms_say(self):
        tunnel, found = self.lined({}, fine=True)
        np.testing.assert_allclose(found, self.full_solution(tunnel, slips=False), rtol=0.01)
        # Their moment without slip simplifies, and lies 2.6 % above that of the full solution.
        np.testing.assert_allclose(found[:2], self.einstein_schwartz(tunnel, slips=False)[:2], rtol=0.01)

    def test_a_ring_that_slips_bears_what_the_closed_forms_say(self):
        tunnel, found = self.lined(FREE, fine=True)
        np.testing.assert_allclose(found, self.full_solution(tunnel, slips=True), rtol=0.01)
        np.testing.assert_allclose(found[:3], self.einstein_schwartz(tunnel, slips=True), rtol=0.01)

    def test_friction_lies_between_full_slip_and_none(self):
        thrust = {angle: self.lined({"interface": {"friction_angle": math.radians(angle)}})[1][1] for angle in (5, 20)}
        tunnel = lined_tunnel.Tunnel.of(self.run)
        none, full = (self.full_solution(tunnel, slips)[1] for slips in (False, True))
        self.assertLess(2 * full, thrust[5])
        self.assertLess(1.5 * thrust[5], thrust[20])
        self.assertLess(thrust[20], 0.95 * none)


if __name__ == "__main__":
    unittest.main()
