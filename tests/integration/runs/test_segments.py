"""Linings of segments: a joint against the closed form of Janssen, a shaken ring whose joints open and close, and dowels to the
ring beside it."""

import math
import unittest

import numpy as np

from figures.computed import ComputedTest

THICKNESS, HEIGHT, YOUNG = 0.35, 0.2, 35e9
LINING = {"thickness": THICKNESS, "young_modulus": YOUNG, "density": 2500.0}
SPAN = 8.0


def janssen(thrust, moment):
    """The rotation of a joint under a thrust N < 0."""
    if moment <= -thrust * HEIGHT / 6:
        return 12 * moment / (YOUNG * HEIGHT**2)
    return -8 * thrust / (9 * HEIGHT * YOUNG * (2 * moment / (-thrust * HEIGHT) - 1)**2)


def bent(thrust, rotation):
    """The moment of a joint that turned by so much."""
    least = -2 * thrust / (YOUNG * HEIGHT)  # at which it opens
    if abs(rotation) <= least:
        return YOUNG * HEIGHT**2 / 12 * rotation
    return math.copysign(-thrust * HEIGHT / 2 * (1 - math.sqrt(-8 * thrust / (9 * HEIGHT * YOUNG * abs(rotation)))), rotation)


def point(x, y):
    return {"x": x, "y": y}


def near(x, y):
    return {"x_min": x - 0.01, "x_max": x + 0.01, "y_min": y - 0.01, "y_max": y + 0.01}


class Beam(ComputedTest):
    """On two supports, pressed along and loaded in the middle, where its joint is. The ground on it is too soft to help."""

    THRUST = -1e6

    REINFORCED = {"section": {"thickness": THICKNESS, "cover": 0.04, "concrete": {"class": "C40/50"}, "steel": {"class": "B500B"},
                              "inner": {"diameter": 0.016, "spacing": 0.15}, "outer": {"diameter": 0.012, "spacing": 0.15}}}

    def pressed(self, load, joints, lining=LINING):
        return self.computed({
            "material": {"young_modulus": 1e4, "poisson_ratio": 0.2, "density": 2000.0},
            "time": {"duration": 1e-3},
            "statics": {"unbalanced_ratio": 1e-5},
            "continuum": {
                "block": {"x_min": 0, "x_max": SPAN, "y_min": 0, "y_max": 0.2, "zones_x": 16, "zones_y": 1},
                "motions": [{"where": near(0, 0), "velocity": point(0, 0)}, {"where": near(SPAN, 0), "velocity": {"y": 0}}],
                "point_loads": [{"where": near(SPAN / 2, 0), "force": {"y": -load}}, {"where": near(SPAN, 0), "force": {"x": self.THRUST}}],
                "linings": [{"name": "beam", "along": {"line": {"points": [point(0, 0), point(SPAN, 0)]}}, **lining, "joints": joints}],
                "histories": [{"name": "joint", "quantity": quantity, "lining": "beam", "at": point(SPAN / 2, 0)}
                              for quantity in ("thrust", "moment", *(("rotation", "outer_opening", "inner_opening") if joints else ()))],
            }})

    def test_a_joint_turns_as_janssen_says(self):
        for share, lining in ((0.1, LINING), (0.25, LINING), (0.42, LINING), (0.1, self.REINFORCED), (0.42, self.REINFORCED)):
            moment = share * HEIGHT * -self.THRUST
            run = self.pressed(4 * moment / SPAN, [{"at": point(SPAN / 2, 0), "contact": {"height": HEIGHT, "young_modulus": YOUNG}}], lining)
            found = {name: values[-1] for name, values in run.histories.items()}
            self.assertAlmostEqual(found["joint_moment_Nm"] / moment, 1, delta=1e-3)
            self.assertAlmostEqual(found["joint_thrust_N"] / self.THRUST, 1, delta=1e-3)
            self.assertAlmostEqual(found["joint_rotation_rad"] / janssen(self.THRUST, moment), 1, delta=0.01)
            # The right-hand side of the path, below, opens.
            self.assertAlmostEqual(found["joint_outer_opening_m"] - found["joint_inner_opening_m"], found["joint_rotation_rad"] * THICKNESS, delta=1e-12)
            self.assertAlmostEqual(run.summary["lining_beam_largest_joint_opening_m"], found["joint_outer_opening_m"], delta=1e-3 * found["joint_outer_opening_m"])


class RingsBeside(ComputedTest):
    """Two straight strips on ground too soft to help, each with half of the plane. The first is hinged in the middle and so bears
    nothing; the second bears what acts on the first through the dowels. A third of the load acts on the ground, which is glued to
    the first, one on the first and one on the second, because their points lie at one place."""

    LOAD, STIFFNESS, WIDTH = 40e3, 50e6, 1.5
    GLUE = {"normal_stiffness": 1e12, "shear_stiffness": 1e12, "cohesion": 1e12, "tension": 1e12, "friction_angle": 0.5}
    LOOSE = {"normal_stiffness": 10.0, "shear_stiffness": 10.0}

    def test_dowels_carry_the_load_of_a_hinged_ring_to_the_one_beside_it(self):
        run = self.computed({
            "material": {"young_modulus": 1e3, "poisson_ratio": 0.2, "density": 2000.0},
            "time": {"duration": 1e-3},
            "statics": {"unbalanced_ratio": 1e-6},
            "continuum": {
                "block": {"x_min": 0, "x_max": SPAN, "y_min": 0, "y_max": 0.2, "zones_x": 16, "zones_y": 1},
                "motions": [{"where": near(0, 0), "velocity": point(0, 0)}, {"where": near(SPAN, 0), "velocity": {"y": 0}}],
                "point_loads": [{"where": near(SPAN / 2, 0), "force": {"y": -self.LOAD}}],
                "linings": [
                    {"name": "first", "along": {"line": {"points": [point(0, 0), point(SPAN, 0)]}}, **LINING, "interface": self.GLUE,
                     "joints": [{"at": point(SPAN / 2, 0)}]},
                    {"name": "second", **LINING, "interface": self.LOOSE,
                     "beside": {"lining": "first", "ring_width": self.WIDTH,
                                "dowels": [{"at": point(SPAN / 2, 0), "stiffness": self.STIFFNESS}]}}],
                "histories": [{"name": "dowel", "quantity": quantity, "lining": "second", "at": point(SPAN / 2, 0)}
                              for quantity in ("dowel_force", "ring_offset")]
                + [{"name": name, "quantity": "moment", "lining": name, "at": point(SPAN / 2, 0)} for name in ("first", "second")],
            }})
        found = {name: values[-1] for name, values in run.histories.items()}
        # In each metre of the plane are 1/WIDTH dowels, and half a metre of each strip.
        carried = 2 / 3 * self.LOAD * self.WIDTH
        self.assertAlmostEqual(found["dowel_dowel_force_N"] / carried, 1, delta=1e-5)
        self.assertAlmostEqual(found["dowel_ring_offset_m"] * self.STIFFNESS / carried, 1, delta=1e-5)
        self.assertAlmostEqual(found["second_moment_Nm"] / (self.LOAD * SPAN / 4 / 0.5), 1, delta=1e-5)
        self.assertLess(abs(found["first_moment_Nm"]), 1e-6 * self.LOAD * SPAN)
        self.assertAlmostEqual(run.summary["lining_second_largest_dowel_force_N"] / carried, 1, delta=1e-5)
        self.assertAlmostEqual(run.summary["lining_second_largest_dowel_force_x_m"], SPAN / 2, delta=1e-9)


class Ring(ComputedTest):
    """Six segments, installed in soft ground that is shaken later, in steps of the ground."""

    ANGLES = [math.radians(30 + 60 * k) for k in range(6)]
    BOLTS = [{"stiffness": 60e6, "pretension": 80e3, "yield_force": 120e3, "spacing": 0.75}]
    GASKET = {"force": {"opening": [-1e-3, 0.0, 6e-3], "force": [-60e3, -30e3, 0.0]}, "position": 0.12, "width": 0.03, "water_pressure": 300e3}

    def shaken(self, quantities, interface=None, second=None, **parts):
        """`second`: the angle by which the joints of a ring beside this one are turned, and its dowels."""
        ring, density, gravity = {"centre": point(0, 0)}, 1900.0, 10.0
        places = [point(3 * math.cos(angle), 3 * math.sin(angle)) for angle in self.ANGLES]
        lining = {**LINING, "stage": 2, **({"interface": interface} if interface else {})}

        def joints(turned):
            return [{"angle": angle + turned, "contact": {"height": HEIGHT}, **parts} for angle in self.ANGLES]

        vertical = {"yy": -12 * density * gravity, "yy_per_metre": density * gravity}
        run = self.computed({
            "material": {"young_modulus": 40e6, "poisson_ratio": 0.35, "density": density},
            "time": {"duration": 0.8},
            "statics": {"unbalanced_ratio": 1e-4},
            "initial_stress": {**vertical, **{key.replace("yy", "xx"): 0.6 * value for key, value in vertical.items()}},
            "continuum": {
                "blocks": [
                    {"name": "core", "rectangle": {"x_min": -1.5, "x_max": 1.5, "y_min": -1.5, "y_max": 1.5}, "along": {"zones": 12}, "across": {"zones": 12}},
                    {"name": "core", "ring": {**ring, "inner_side": 3.0, "outer_radius": 3.0}, "along": {"zones": 48}, "across": {"zones": 2}},
                    {"name": "ground", "ring": {**ring, "inner_radius": 3.0, "outer_side": 24.0}, "along": {"zones": 48}, "across": {"zones": 10, "ratio": 1.15}}],
                "body_loads": [{"acceleration": {"y": -gravity}}],
                "excavations": [{"where": {"group": "core"}, "stage": 1, "released": 0.3}],
                "linings": [{"name": "ring", "along": {"circle": {**ring, "radius": 3.0}}, **lining, "joints": joints(0)},
                            *([{"name": "second", **lining, "joints": joints(second[0]),
                                "beside": {"lining": "ring", "ring_width": 1.5, "dowels": second[1]}}] if second else [])],
                "free_field": {"left": True, "right": True},
                "base": {"kind": "compliant", "acceleration": {"ricker": {"frequency": 4.0, "time": 0.3}, "peak": 5.0}},
                "histories": [{"name": f"j{k}", "quantity": quantity, "lining": "ring", "at": place}
                              for k, place in enumerate(places) for quantity in quantities],
            },
            "output": {"history_interval": 1e-9, "field_times": [0.4]}})
        self.assertLess(run.summary["max_energy_drift"], 1e-10)
        return run

    def rows(self, column):
        return np.array([self.run.histories[f"j{k}_{column}"] for k in range(6)])

    def largest(self, which, rows, unit):
        """Of the summary: the value, its time and its joint are those of the histories."""
        joint, instant = np.unravel_index(abs(rows).argmax(), rows.shape)
        name = f"lining_ring_{which}"
        self.assertEqual(self.run.summary[f"{name}{unit}"], rows[joint, instant])
        self.assertAlmostEqual(self.run.summary[f"{name}_time_s"], self.time[instant], delta=1e-12)
        self.assertAlmostEqual(self.run.summary[f"{name}_x_m"], 3 * math.cos(self.ANGLES[joint]), delta=1e-6)
        return joint, instant

    def test_joints_that_open_and_close_follow_janssen(self):
        run = self.shaken(("thrust", "moment", "rotation", "outer_opening", "inner_opening"))
        thrust, moment, rotation = (self.rows(column) for column in ("thrust_N", "moment_Nm", "rotation_rad"))
        # Forces and rotations are means of two beams, which bear a little more and less.
        np.testing.assert_allclose(np.vectorize(bent)(thrust, rotation), moment, atol=0.01 * abs(moment).max())
        is_open = abs(moment) > 1.1 * -thrust * HEIGHT / 6
        self.assertTrue((is_open.any(axis=1) & ~is_open.all(axis=1)).any())
        self.assertGreater(abs(moment / thrust).max(), 0.4 * HEIGHT)
        openings = np.maximum(self.rows("outer_opening_m"), self.rows("inner_opening_m"))
        self.largest("largest_joint_opening", openings, "_m")
        joint, instant = self.largest("largest_joint_rotation", rotation, "_rad")
        lining = run.fields()["linings"]
        self.assertEqual(lining["peak_joint_opening_m"].max(), openings.max())

    def test_bolts_pull_and_the_gasket_presses_as_the_joints_open(self):
        run = self.shaken(("outer_opening", "gasket_opening", "tightness", "bolt_force"), bolts=self.BOLTS, gasket=self.GASKET)
        curve = self.GASKET["force"]
        opening, tightness = self.rows("gasket_opening_m"), self.rows("tightness")
        np.testing.assert_allclose(tightness, -np.interp(opening, curve["opening"], curve["force"]) / (0.03 * 300e3), rtol=1e-9)
        self.assertEqual(run.summary["lining_ring_least_tightness"], tightness.min())
        force = self.rows("bolt_force_N")
        self.largest("largest_bolt_force", force, "_N")
        # In the axis, between the faces.
        axis = opening - (self.rows("outer_opening_m") - opening) * 0.12 / (THICKNESS / 2 - 0.12)
        grown = (force[:, 1:] - force[:, :-1]) / 60e6
        np.testing.assert_allclose(grown, np.diff(axis), atol=1e-12)

    ROUGH = {"friction_angle": math.radians(25), "cohesion": 10e3}

    def dowels(self, **given):
        return [{"angle": math.radians(7.5 * k), "stiffness": 2e9, **given} for k in range(48)]

    def test_rings_with_joints_in_the_same_places_are_one_ring(self):
        quantities = ("thrust", "moment", "rotation", "outer_opening", "tightness", "bolt_force")
        parts = {"interface": self.ROUGH, "bolts": self.BOLTS, "gasket": self.GASKET}
        alone = self.shaken(quantities, **parts)
        both = self.shaken(quantities, second=(0, self.dowels()), **parts)
        for name, values in alone.histories.items():
            if name[0] == "j":
                np.testing.assert_allclose(both.histories[name], values, atol=1e-7 * abs(values).max(), err_msg=name)
        self.assertLess(both.summary["lining_second_largest_dowel_force_N"], 1e-6 * abs(alone.summary["lining_ring_least_thrust_N"]))

    def test_dowels_between_staggered_rings_relieve_the_joints_and_yield(self):
        rotations, moments = [], []
        for dowels in ([], self.dowels(), self.dowels(strength=30e3)):
            run = self.shaken(("rotation", "moment"), interface=self.ROUGH, second=(math.radians(30), dowels))
            rotations.append(abs(run.summary["lining_ring_largest_joint_rotation_rad"]))
            moments.append(abs(run.summary["lining_second_largest_moment_Nm"]))
        # The segments beside a joint bear a part of the moment that it does not.
        self.assertLess(rotations[1], 0.7 * rotations[0])
        self.assertGreater(moments[1], 1.1 * moments[0])
        self.assertTrue(rotations[1] < rotations[2] < rotations[0], rotations)
        self.assertAlmostEqual(run.summary["lining_second_largest_dowel_force_N"], 30e3, delta=1e-6)
        self.assertGreater(run.summary["lining_second_largest_ring_offset_m"], 30e3 / 2e9)


if __name__ == "__main__":
    unittest.main()
