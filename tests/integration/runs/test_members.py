"""Members between linings: columns and frames against closed forms, per member and over the plane."""

import json
import math
import unittest

import numpy as np

from figures.computed import ComputedTest

from programs import coupler

HEIGHT, SPACING, WIDTH, DEPTH, YOUNG, NU = 3.0, 3.5, 1.0, 0.4, 30e9, 0.2
AREA, INERTIA = WIDTH * DEPTH, WIDTH * DEPTH**3 / 12
SOFT = {"young_modulus": 1e3, "poisson_ratio": 0.0, "density": 10.0}  # ground that bears nothing


def line(*points):
    return {"line": {"points": [{"x": float(x), "y": float(y)} for x, y in points]}}


def column(**keys):
    return {"name": "column", "from": {"x": 0.0, "y": 0.0}, "to": {"x": 0.0, "y": HEIGHT}, "spacing": SPACING, "width": WIDTH,
            "thickness": DEPTH, "young_modulus": YOUNG, "poisson_ratio": NU, **keys}


def stub(name, y):
    """A beam at the end of the column that does not turn."""
    return {"name": name, "along": line((0, y), (0.5, y)), "thickness": 0.5, "young_modulus": YOUNG, "first_end_fixed": True}


def moved(displacement, **keys):
    """A column between two stubs in soft ground, of which the upper one moves by this in half a second."""
    times = [0.5 * k / 40 for k in range(41)]
    return {"material": SOFT, "time": {"duration": 0.55, "dt": 1e-4}, "continuum": {
        "block": {"x_min": -0.5, "x_max": 0.5, "y_min": 0.0, "y_max": HEIGHT, "zones_x": 2, "zones_y": 3},
        "linings": [stub("floor", 0.0), stub("roof", HEIGHT)],
        "members": [column(**keys)],
        "motions": [{"where": {"y_max": 0.0}, "velocity": {"x": 0.0, "y": 0.0}},
                    {"where": {"y_min": HEIGHT}, "velocity": displacement,
                     "time": {"table": {"time": times + [1.0], "value": [math.pi * math.sin(2 * math.pi * t) for t in times] + [0.0]}}}],
        "histories": [{"name": "foot", "quantity": quantity, "member": "column", "at": {"x": 0.0, "y": 0.0}}
                      for quantity in ("thrust", "moment", "shear_force")]
        + [{"name": "top", "quantity": quantity, "at": {"x": 0.0, "y": HEIGHT}} for quantity in ("displacement_x", "displacement_y")]},
        "output": {"history_interval": 1e-3}}


class Column(ComputedTest):
    SHEAR = 12 * YOUNG * INERTIA / (5 / 6 * YOUNG / (2 * (1 + NU)) * AREA * HEIGHT**2)  # phi of Timoshenko's column

    def foot(self, displacement, **keys):
        """At the end: how far the top has moved; thrust, moment and shear force at the foot; the work done on the plane."""
        h = self.computed(moved(displacement, **keys)).histories
        late = self.time > 0.51
        return [np.mean(h[name][late]) for name in ("top_ux_m", "top_uy_m", "foot_thrust_N", "foot_moment_Nm", "foot_shear_N",
                                                    "continuum_external_work_J")]

    def test_a_clamped_column_is_as_stiff_as_its_closed_form(self):
        moved, _, thrust, moment, shear, work = self.foot({"x": 1e-3})
        stiffness = 12 * YOUNG * INERTIA / HEIGHT**3 / (1 + self.SHEAR)
        self.assertAlmostEqual(abs(shear) / (stiffness * moved), 1, delta=1e-4)
        self.assertAlmostEqual(abs(moment) / (stiffness * moved * HEIGHT / 2), 1, delta=1e-4)
        # The plane has one column in each spacing.
        self.assertAlmostEqual(work / (stiffness * moved**2 / 2 / SPACING), 1, delta=1e-3)

    def test_a_column_hinged_at_an_end_or_at_both(self):
        moved, _, _, moment, shear, _ = self.foot({"x": 1e-3}, last_end_hinged=True)
        stiffness = 3 * YOUNG * INERTIA / HEIGHT**3 / (1 + self.SHEAR / 4)
        self.assertAlmostEqual(abs(shear) / (stiffness * moved), 1, delta=1e-4)
        self.assertAlmostEqual(abs(moment) / (stiffness * moved * HEIGHT), 1, delta=1e-4)
        *_, free, _ = self.foot({"x": 1e-3}, first_end_hinged=True, last_end_hinged=True)
        self.assertLess(abs(free), 1e-3 * abs(shear))

    def test_thrust_is_that_of_one_column(self):
        _, moved, thrust, *_ = self.foot({"y": 1e-3})
        self.assertAlmostEqual(thrust / (YOUNG * AREA / HEIGHT * moved), 1, delta=1e-4)
        # A wall as wide as its spacing cannot strain across the plane.
        _, moved, wall, *_ = self.foot({"y": 1e-3}, spacing=WIDTH)
        self.assertAlmostEqual(wall / (YOUNG / (1 - NU**2) * AREA / HEIGHT * moved), 1, delta=1e-4)

    def test_a_reinforced_column_is_told_as_one(self):
        """Its stiffness is that of its concrete and bars, its shear strength that of EN 1992-1-1, 6.2.2, over its own width."""
        section = {"thickness": DEPTH, "cover": 0.04, "concrete": {"class": "C30/37"}, "steel": {"class": "B500B"},
                   "inner": {"diameter": 0.02, "spacing": 0.1}, "outer": {"diameter": 0.02, "spacing": 0.1}}
        scene = moved({"y": -2e-5}, section=section)
        for plain in ("thickness", "young_modulus"):
            del scene["continuum"]["members"][0][plain]
        scene["continuum"]["histories"].append({"name": "foot", "quantity": "shear_strength", "member": "column", "at": {"x": 0.0, "y": 0.0}})
        h = self.computed(scene).histories
        concrete, bars = 1.05 * 22e9 * 3.8**0.3, 2 * math.pi / 4 * 0.02**2 / 0.1 * WIDTH
        stiffness = (concrete * AREA + (200e9 - concrete) * bars) / HEIGHT
        late = self.time > 0.51
        # The curve of concrete has lost 0.2 % of its slope at this strain, and the column has not moved quite so far.
        self.assertAlmostEqual(np.mean(h["foot_thrust_N"][late]) / np.mean(h["top_uy_m"][late]) / stiffness, 1, delta=5e-3)
        depth = DEPTH - 0.05
        stress = 0.18 * (1 + math.sqrt(0.2 / depth)) * (100 * bars / 2 / (WIDTH * depth) * 38) ** (1 / 3)
        pressure = -np.mean(h["foot_thrust_N"][late]) / AREA
        self.assertAlmostEqual(np.mean(h["foot_shear_strength_N"][late]) / ((stress * 1e6 + 0.15 * pressure) * WIDTH * depth), 1, delta=1e-3)

    def test_thrust_bends_a_leaning_column(self):
        """Clamped at both ends and leaning by d under a compression P, with k^2 = P/EI: the force across it is
        H = P d/((2/k) tan(k h/2) - h), the moments at its ends are (H h + P d)/2 (Timoshenko and Gere 1961, 1.11)."""
        euler = math.pi**2 * YOUNG * 0.05**3 / 12 / HEIGHT**2  # clamped, it buckles at four times this
        lean, _, thrust, moment, *_ = self.foot({"x": 0.01, "y": -2 * euler * HEIGHT / (YOUNG * 0.05)}, thickness=0.05, shear_flexible=False)
        k = math.sqrt(-thrust / (YOUNG * 0.05**3 / 12))
        across = -thrust * lean / (2 * math.tan(k * HEIGHT / 2) / k - HEIGHT)
        self.assertGreater(-thrust, euler)
        self.assertLess(across, 0)  # beyond the load at which it sways by itself
        self.assertAlmostEqual(abs(moment) / abs((across * HEIGHT - thrust * lean) / 2), 1, delta=2e-3)


class Frame(ComputedTest):
    """A portal of two columns under a heavy beam, on ground that is shaken; ground that bears nothing is around it."""

    SECTION = {"thickness": 0.3, "cover": 0.04, "concrete": {"class": "C25/30"}, "steel": {"class": "B500B"},
               "inner": {"diameter": 0.025, "spacing": 0.1}, "outer": {"diameter": 0.025, "spacing": 0.1}}

    def shaken(self, acceleration=4.0, mirrored=False, failure=None, duration=1.2, elastic=False):
        sign = -1.0 if mirrored else 1.0

        def place(x, y):
            return {"x": sign * x, "y": y}

        def standing(name, x):
            section = {"thickness": 0.3, "young_modulus": YOUNG} if elastic else {"section": self.SECTION}
            stated = {"name": name, "from": place(x, 0.0), "to": place(x, HEIGHT), "spacing": 4.0, "width": 0.5, "elements": 6, **section}
            return {**stated, "failure": failure} if failure is not None else stated

        velocity = {"x": sign * acceleration / (2 * math.pi * 2.5)}
        return self.computed({"material": SOFT, "time": {"duration": duration, "dt": 1e-4}, "continuum": {
            "block": {"x_min": -3.0, "x_max": 3.0, "y_min": 0.0, "y_max": HEIGHT, "zones_x": 6, "zones_y": 3},
            "linings": [{"name": "floor", "along": line((-3, 0), (3, 0)), "thickness": 1.0, "young_modulus": YOUNG}],
            "members": [standing("west", -2.0), standing("east", 2.0),
                        {"name": "beam", "from": place(-2.0, HEIGHT), "to": place(2.0, HEIGHT), "spacing": 4.0, "thickness": 0.8,
                         "width": 0.5, "young_modulus": YOUNG, "density": 60e3}],
            "body_loads": [{"acceleration": {"y": -9.81}, "time": {"table": {"time": [0.0, 0.2], "value": [0.0, 1.0]}}}],
            "motions": [{"where": {"y_max": 0.0}, "velocity": {"y": 0.0}},
                        {"where": {"y_max": 0.0}, "velocity": velocity, "time": {"sine": {"frequency": 2.5}}}],
            "histories": [{"name": name, "quantity": quantity, "member": name, "at": place(x, 0.0)}
                          for name, x in (("west", -2.0), ("east", 2.0))
                          for quantity in ("thrust", "moment", "shear_force") + (() if elastic else ("shear_strength", "utilisation"))]
            + [{"name": "top", "quantity": "displacement_x", "at": place(0.0, HEIGHT), "relative_to": place(0.0, 0.0)}]},
            "output": {"history_interval": 1e-3}})

    def test_energy_is_kept_while_columns_yield(self):
        run = self.shaken(acceleration=12.0)
        self.assertLess(run.summary["max_energy_drift"], 1e-10)
        h = run.histories
        self.assertGreater(max(h["west_utilisation"].max(), h["east_utilisation"].max()), 0.9)
        self.assertGreater(h["continuum_dissipated_J"][-1], 0)
        self.assertNotIn("member_west_failed_time_s", run.summary)

    def test_an_elastic_frame_dissipates_nothing(self):
        """What the ledger misses of paths that curve, as columns lean under their thrust by 0.03, is next to nothing."""
        h = self.shaken(elastic=True).histories
        self.assertGreater(abs(h["top_ux_m"]).max(), 0.02 * HEIGHT)
        peak = (h["continuum_kinetic_J"] + h["continuum_strain_J"]).max()
        self.assertLess(abs(h["continuum_dissipated_J"]).max(), 1e-7 * peak)

    def test_the_mirrored_frame_bears_the_same(self):
        one, other = (self.shaken(mirrored=mirrored, duration=0.5).histories for mirrored in (False, True))
        for name in ("west", "east"):
            for force, sign in (("thrust_N", 1), ("moment_Nm", -1), ("shear_N", -1), ("shear_strength_N", 1)):
                size = abs(one[f"{name}_{force}"]).max()
                np.testing.assert_allclose(other[f"{name}_{force}"], sign * one[f"{name}_{force}"], rtol=0, atol=1e-6 * size)

    def test_a_column_that_fails_in_shear_slides_and_is_lost(self):
        run = self.shaken(acceleration=9.0, failure={"residual": 0.2, "sliding": 0.01})
        self.assertLess(run.summary["max_energy_drift"], 1e-10)
        summary, h = run.summary, run.histories
        failed = [name for name in ("west", "east") if f"member_{name}_shear_failed_time_s" in summary]
        self.assertTrue(failed)
        for name in failed:
            when = summary[f"member_{name}_shear_failed_time_s"]
            self.assertEqual(summary[f"member_{name}_failed_time_s"], when)
            before, after = self.time < when, self.time > when + 2e-3
            # It never bears more than its section resists, and from then on no more than what is left of it.
            shear, strength = abs(h[f"{name}_shear_N"]), h[f"{name}_shear_strength_N"]
            self.assertLess((shear[before] / strength[before]).max(), 1.02)
            self.assertTrue((np.diff(strength[after]) <= 0).all())
            lost = summary.get(f"member_{name}_axial_failed_time_s")
            self.assertIsNotNone(lost)
            self.assertGreaterEqual(lost, when)
            gone = self.time > lost + 1e-3
            self.assertEqual(abs(strength[gone]).max(), 0)


class Fall(ComputedTest):
    def test_a_frame_that_falls_freely_bears_nothing(self):
        """Ground with a lining on it and a column in it, held by nothing, under gravity."""
        run = self.computed({"material": {**SOFT, "young_modulus": 1e6}, "time": {"duration": 0.2, "dt": 1e-4}, "continuum": {
            "block": {"x_min": -1.0, "x_max": 1.0, "y_min": 0.0, "y_max": HEIGHT, "zones_x": 2, "zones_y": 3},
            "linings": [{"name": "floor", "along": line((-1, 0), (1, 0)), "thickness": 0.5, "young_modulus": YOUNG}],
            "members": [column()],
            "body_loads": [{"acceleration": {"x": 2.0, "y": -9.81}}],
            "histories": [{"name": "column", "quantity": quantity, "member": "column", "at": {"x": 0.0, "y": 1.5}}
                          for quantity in ("thrust", "moment", "shear_force")]
            + [{"name": "top", "quantity": "displacement_y", "at": {"x": 0.0, "y": HEIGHT}}]}})
        h, weight = run.histories, 2500 * AREA * HEIGHT * 9.81
        self.assertAlmostEqual(h["top_uy_m"][-1] / (-9.81 * 0.2**2 / 2), 1, delta=1e-9)
        for name in ("thrust_N", "moment_Nm", "shear_N"):
            self.assertLess(abs(h[f"column_{name}"]).max(), 1e-9 * weight)


class Refused(ComputedTest):
    def test_what_cannot_be_is_said_in_one_sentence(self):
        section = {"thickness": 0.4, "cover": 0.04, "concrete": {"class": "C30/37"}, "steel": {"class": "B500B"},
                   "inner": {"diameter": 0.02, "spacing": 0.1}, "outer": {"diameter": 0.02, "spacing": 0.1}}

        def of_section(**keys):
            stated = column(section=section, **keys)
            del stated["thickness"], stated["young_modulus"]
            return stated
        unstated = column()
        del unstated["thickness"]
        for member, sentence in (
                (column(to={"x": 0.1, "y": 2.6}), "continuum.members[0].to: is (0.1, 2.6) m, where the member meets nothing"),
                (column(to={"x": 0.0, "y": 0.0}), "is the same place as `from`; give the member a length"),
                (column(width=4.0), "is 4 m, more than the spacing of 3.5 m; give at most that"),
                (column(name="roof"), "is taken by another part of the model"),
                (column(failure={}), "needs the strength of a `section` of reinforced concrete"),
                (column(section=section), "is given beside `section`, which states it; leave one out"),
                (column(area=0.4), "needs a section: give either `thickness`, or both `area` and `inertia`"),
                (unstated, "needs a section: give either `thickness`, or both `area` and `inertia`"),
                (column(stage=1), "stages begin when the ground is at rest"),
                (column(elements=0), "elements")):
            with self.subTest(sentence):
                scene = moved({"x": 1e-3})
                scene["continuum"]["members"] = [member]
                result = coupler("run", self.scene(json.dumps(scene)), "--out", self.folder / "refused")
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn(sentence, result.stderr)
                self.assertEqual(result.stderr.strip().count("\n"), 0, result.stderr)
        scene = moved({"x": 1e-3})
        scene["continuum"]["histories"] = [{"name": "at", "quantity": "thrust", "member": "colum", "at": {"x": 0.0, "y": 0.0}}]
        result = coupler("run", self.scene(json.dumps(scene)), "--out", self.folder / "refused")
        self.assertIn("no member of the continuum has this name; did you mean `column`", result.stderr.replace(" — ", "; "))


if __name__ == "__main__":
    unittest.main()
