"""Zones that get another material, or come into being, in later stages: stresses and displacements of columns by hand."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from resume.resumed import ResumeTest

YOUNG, POISSON, DENSITY, GRAVITY = 100e6, 0.25, 2000.0, 10.0
HEIGHT, GROUND = 10.0, 6.0  # of the grid; of what is there at first
LIGHT = {"young_modulus": 30e6, "poisson_ratio": POISSON, "density": 1200.0}
GROUTED = {"young_modulus": 4 * YOUNG, "poisson_ratio": POISSON, "density": DENSITY}
PLASTIC = {**GROUTED, "mohr_coulomb": {"cohesion": 1e6, "friction_angle": 0.5}}
ABOVE = {"y_min": GROUND}


def confined(material):
    """Stiffness of ground that cannot move sideways, with Poisson's ratio 1/4."""
    return 1.2 * material["young_modulus"]


def column(excavations, materials, **more):
    """A column between smooth sides, under its weight, with displacements from stage 1 on."""
    sides = [{"where": {key: at}, "velocity": {"x": 0.0}} for key, at in (("x_max", 0.0), ("x_min", 2.0))]
    places = {"top": GROUND, "middle": 8.0, "upper": HEIGHT}
    displacements = [{"name": name, "at": {"x": 1.0, "y": y}, "quantity": "displacement_y"} for name, y in places.items()]
    stresses = [{"name": name, "at": {"x": 0.75, "y": y}, "quantity": "stress_yy"} for name, y in (("grouted", 2.75), ("ground", 5.25), ("fill", 7.25))]
    return {"material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY}, "time": {"duration": 1e-3},
            "statics": {"unbalanced_ratio": 1e-9, "max_steps": 100000, "count_from_stage": 1},
            "continuum": {"block": {"x_min": 0.0, "x_max": 2.0, "y_min": 0.0, "y_max": HEIGHT, "zones_x": 4, "zones_y": 20},
                          "body_loads": [{"acceleration": {"y": -GRAVITY}}], "excavations": excavations, "materials": materials,
                          "motions": [{"where": {"y_max": 0.0}, "velocity": {"y": 0.0}}, *sides], "histories": displacements + stresses, **more},
            "output": {"field_times": []}}


def area(stage, material, y_min, y_max):
    return {"where": {"y_min": y_min, "y_max": y_max}, "stage": stage, "material": material}


class Columns(ComputedTest):
    def found(self, quantity, *names):
        return np.array([self.run.histories[f"{name}_{quantity}"][0] for name in names])

    def test_ground_that_is_replaced_by_lighter_ground_bears_its_weight(self):
        """Stresses within 1e-6 of the weight above; the fill begins free of stress."""
        self.computed(column([{"where": ABOVE, "stage": 1}], [area(2, LIGHT, GROUND, HEIGHT)]))
        fill = 4.0 * LIGHT["density"]
        expected = -GRAVITY * np.array([fill + DENSITY * (GROUND - 2.75), fill + DENSITY * (GROUND - 5.25), LIGHT["density"] * (HEIGHT - 7.25)])
        np.testing.assert_allclose(self.found("syy_Pa", "grouted", "ground", "fill"), expected, rtol=1e-6)

    def test_a_fill_settles_with_what_it_lies_on_and_by_its_own_weight(self):
        """In two layers, on places that were never ground or that were excavated at once or in parts: each layer is strained by its own
        weight and by what comes later, and moves from where it was placed."""
        top = {"y_min": 8.0}
        for dug in ([(0, ABOVE)], [(1, ABOVE)], [(1, top), (2, ABOVE)]):
            with self.subTest(dug=dug):
                told = column([{"where": where, "stage": stage} for stage, where in dug], [area(3, LIGHT, GROUND, 8.0), area(4, LIGHT, 8.0, HEIGHT)])
                told["statics"]["count_from_stage"] = dug[0][0] or 3
                self.computed(told)
                layer = 2.0 * GRAVITY * LIGHT["density"]
                ground, fill = GROUND / confined({"young_modulus": YOUNG}), 2.0 / confined(LIGHT)
                swelling = 4.0 * GRAVITY * DENSITY * ground if dug[0][0] else 0.0
                surface = swelling - 2 * layer * ground
                middle = -2 * layer * ground - (layer / 2 + layer) * fill
                upper = -layer * ground - layer * fill - layer / 2 * fill
                np.testing.assert_allclose(self.found("uy_m", "top", "middle", "upper"), [surface, middle, upper], rtol=1e-6, atol=1e-9)

    def test_grouted_ground_stays_where_it_is_and_is_stiffer_from_then_on(self):
        """Nothing moves when zones under stress change; a fill then finds the new modulus, whichever law has it."""
        for grout in (GROUTED, PLASTIC):
            for fills in (False, True):
                with self.subTest(law=sorted(grout), fills=fills):
                    fill = [area(2, LIGHT, GROUND, HEIGHT)] if fills else [area(2, LIGHT, 9.9, HEIGHT)]
                    told = column([{"where": ABOVE, "stage": 0}], [area(1, grout, 2.0, 4.0), *fill])
                    if not fills:
                        told["continuum"]["materials"].pop()
                        told["continuum"]["histories"] = [history for history in told["continuum"]["histories"]
                                                          if history["name"] in ("top", "grouted", "ground")]
                    self.computed(told)
                    load = 4.0 * GRAVITY * LIGHT["density"] if fills else 0.0
                    moved = -load * (4.0 / confined({"young_modulus": YOUNG}) + 2.0 / confined(grout))
                    np.testing.assert_allclose(self.found("uy_m", "top"), moved, rtol=1e-6, atol=1e-11)
                    np.testing.assert_allclose(self.found("syy_Pa", "grouted"), -load - GRAVITY * DENSITY * (GROUND - 2.75), rtol=1e-6)

    def test_what_is_shaken_after_changes_keeps_its_energy(self):
        """The ledger of a shaken column that was grouted and filled closes to rounding."""
        told = column([{"where": ABOVE, "stage": 1, "released": 0.4}], [area(1, PLASTIC, 2.0, 4.0), area(2, LIGHT, GROUND, 8.0)])
        told["continuum"]["histories"] = told["continuum"]["histories"][:1]
        told["time"]["duration"] = 0.2
        told["continuum"]["motions"] = []
        told["continuum"]["base"] = {"kind": "rigid", "direction": "x", "acceleration": {"ricker": {"frequency": 10.0, "time": 0.1}, "peak": 5.0}}
        self.computed(told)
        self.assertLess(np.abs(self.run.histories["energy_drift"]).max(), 1e-12)


class Threads(ResumeTest):
    def test_results_do_not_depend_on_threads(self):
        scene, _ = self.scene_of("ground that is filled")
        runs = [self.run_scene(scene, "--fdm-threads", threads, out=f"threads_{threads}") for threads in ("1", "3")]
        self.assert_same(*runs)


if __name__ == "__main__":
    unittest.main()
