"""Fields, names and energies of ground: who owns a zone, what yields, what a foundation holds."""

import unittest

import numpy as np

from figures.computed import ComputedTest

YOUNG, POISSON, DENSITY = 1e9, 0.25, 2000.0
G = 0.4e9  # Lamé's other constant, too
STEP, END = 1e-4, 0.02


def box(x_min, x_max, y_min, y_max):
    return {"x_min": x_min, "x_max": x_max, "y_min": y_min, "y_max": y_max}


def one_zone(name, left):
    return {"name": name, "rectangle": box(left, left + 1, 0, 1), "along": {"zones": 1}, "across": {"zones": 1}}


class Ground(ComputedTest):
    def ledger(self, size, tolerance=1e-9, **expected):
        for name in ("strain", "released", "external_work", "multiplier_work", "dissipated"):
            np.testing.assert_allclose(self.run.histories[f"continuum_{name}_J"], expected.get(name, 0) + 0 * self.time, rtol=0,
                                       atol=tolerance * size, err_msg=name)

    def test_of_two_grounds_of_which_one_yields(self):
        """Both are sheared; the right one bears no more than its cohesion."""
        rate, cohesion = 0.01, 20e3
        self.computed({
            "material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY},
            "time": {"duration": END, "dt": STEP},
            "continuum": {
                "blocks": [one_zone("left", 0), one_zone("right", 1)],
                "materials": [{"where": {"x_min": 1}, "material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY,
                                                                     "mohr_coulomb": {"cohesion": cohesion}}}],
                "motions": [{"where": {"y_max": 0.5}, "velocity": {"x": 0, "y": 0}}, {"where": {"y_min": 0.5}, "velocity": {"x": rate, "y": 0}}],
            },
            "output": {"history_interval": STEP, "peaks": {}}})
        t = self.time
        strain, limit = rate * t, cohesion / G
        yields = strain > limit
        plastic = np.where(yields, strain - limit, 0)
        stress = G * (strain - plastic)
        grid = self.run.fields()["grid"]
        upper = grid.points[:, 1] > 0.5
        motion = np.where(upper, rate, 0)
        self.told_piece("grid", {
            "displacement_m": np.outer(motion * END, [1, 0, 0]), "velocity_m_per_s": np.outer(motion, [1, 0, 0]),
            "stress_Pa": [(0, 0, G * strain[-1]), (0, 0, cohesion)], "weight": 1, "material": [0, 1], "group": [1, 2],
            "yield_state": [0, 1 | 4], "plastic_shear_strain": [0, plastic[-1]],
            "peak_displacement_m": motion * END, "peak_velocity_m_per_s": motion, "peak_acceleration_m_per_s2": 2 * motion / STEP,
            "peak_shear_strain": strain[-1], "peak_largest_principal_stress_Pa": [G * strain[-1], cohesion],
            "peak_smallest_principal_stress_Pa": [-G * strain[-1], -cohesion],
            # The left one states no strength; the right one is at its strength from its yield on.
            "demand": [0, 1], "peak_demand": [0, 1], "peak_demand_time_s": [0, t[strain >= (1 - 1e-9) * limit][0]]}, tolerance=1e-6)
        self.assertEqual(self.run.summary["continuum_groups"], ["", "left", "right"])
        self.assertEqual(self.run.summary["continuum_materials"], ["material", "continuum.materials[0].material"])
        stored = G * strain**2 / 2 + stress**2 / 2 / G
        lost = cohesion * plastic
        kinetic = 2 * DENSITY / 2 / 2 * rate**2
        self.ledger(stored[-1], tolerance=1e-3, strain=stored, dissipated=lost, external_work=stored + lost + np.where(t > 0, kinetic, 0))

    def stretched(self, law, gradient):
        """Of one zone of a law that is strained steadily: its fields at the end."""
        (xx, xy), (yx, yy) = gradient
        corners = [(x, y) for x in (0, 1) for y in (0, 1)]
        self.computed({
            "material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY} | law,
            "time": {"duration": END, "dt": STEP},
            "continuum": {
                "block": box(0, 1, 0, 1) | {"zones_x": 1, "zones_y": 1},
                "motions": [{"where": box(x, x, y, y), "velocity": {"x": xx * x + xy * y, "y": yx * x + yy * y}} for x, y in corners]},
            "output": {"history_interval": STEP}})
        grid = self.run.fields()["grid"]
        return {name: grid[name][0] for name in ("stress_Pa", "yield_state", "plastic_shear_strain")}

    def test_of_ground_that_tears(self):
        """Its largest stress stays at the tension that it bears, while strain flows along it."""
        rate, tension = 0.01, 50e3
        found = self.stretched({"mohr_coulomb": {"cohesion": 500e3, "friction_angle": 0.5, "tension": tension}}, ((rate, 0), (0, 0)))
        np.testing.assert_allclose(found["stress_Pa"], [tension, tension / 3, 0], atol=1e-6 * tension)  # lambda = G
        self.assertEqual(found["yield_state"], 2 | 8)
        strain, limit = rate * self.time, tension / 3 / G
        flowed = np.maximum(strain - limit, 0)
        self.assertGreater(flowed[-1], limit)
        stored = 3 * G * (strain - flowed)**2 / 2
        kinetic = DENSITY / 4 * rate**2
        lost = tension * flowed
        self.ledger(lost[-1], tolerance=1e-3, strain=stored, dissipated=lost, external_work=stored + lost + np.where(self.time > 0, kinetic, 0))

    def test_of_ground_that_softens(self):
        """Its stress follows the curve, and its state says that it has no limit of elasticity."""
        rate, reference = 0.05, 5e-4
        found = self.stretched({"hysteretic": {"hyperbola": {"reference_strain": reference}}}, ((0, rate), (0, 0)))
        strain = rate * self.time
        curve = G * strain / (1 + strain / reference)
        np.testing.assert_allclose(found["stress_Pa"], [0, 0, curve[-1]], atol=0.01 * curve[-1])
        self.assertEqual((found["yield_state"], found["plastic_shear_strain"]), (256, 0))
        kinetic = DENSITY / 4 * rate**2
        work = np.concatenate([[0], np.cumsum((curve[1:] + curve[:-1]) / 2 * np.diff(strain))]) + np.where(self.time > 0, kinetic, 0)
        np.testing.assert_allclose(self.run.histories["continuum_external_work_J"], work, atol=0.01 * work[-1])
        ledger = self.run.histories
        np.testing.assert_allclose(ledger["continuum_strain_J"] + ledger["continuum_dissipated_J"] + np.where(self.time > 0, kinetic, 0),
                                   ledger["continuum_external_work_J"], atol=1e-9 * work[-1])

    def test_of_a_foundation(self):
        """It holds one of two zones, which move to the right together, until it slips."""
        speed, stiffness, slip = 0.5, 5e6, 30e3
        self.computed({
            "material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY},
            "time": {"duration": END, "dt": STEP},
            "continuum": {
                "block": box(0, 4, 0, 1.5) | {"zones_x": 2, "zones_y": 1},
                "motions": [{"where": {"x_min": -1}, "velocity": {"x": speed, "y": 0}}],
                "foundations": [{"where": {"x_max": 2}, "x": {"stiffness": stiffness, "slip_stress": slip}}],
            },
            "output": {"history_interval": STEP}})
        t, area = self.time, 2 * 1.5
        stress = np.minimum(stiffness * speed * t, slip)
        self.assertEqual(stress[-1], slip)
        stored = area * stress**2 / 2 / stiffness
        work = area * np.concatenate([[0], np.cumsum((stress[1:] + stress[:-1]) / 2 * speed * STEP)])
        kinetic = DENSITY * 4 * 1.5 / 2 * speed**2
        self.ledger(work[-1], strain=stored, dissipated=work - stored, external_work=work + np.where(t > 0, kinetic, 0))


if __name__ == "__main__":
    unittest.main()
