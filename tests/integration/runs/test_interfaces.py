"""Interfaces in zones and between a lining and the ground, against closed forms."""

import json
import math
import unittest

import numpy as np

from figures.computed import ComputedTest
from programs import coupler

GRAVITY = 9.81
ROCK = {"young_modulus": 10e9, "poisson_ratio": 0.0, "density": 2500.0}
DAMPED = {"maxwell": {"ratio": 0.05, "low_frequency": 20.0, "high_frequency": 1000.0}}


def rectangle(name, x, y, zones):
    return {"name": name, "rectangle": {"x_min": x[0], "x_max": x[1], "y_min": y[0], "y_max": y[1]},
            "along": {"zones": zones[0]}, "across": {"zones": zones[1]}}


class Incline(ComputedTest):
    """A block on its base, under gravity whose part along the base grows beyond friction at once."""

    def slide(self, law, along=7.0, damping=DAMPED, water=None):
        continuum = {
            "blocks": [rectangle("base", (0.0, 4.0), (-1.0, 0.0), (8, 2)), rectangle("block", (0.0, 4.0), (0.0, 2.0), (8, 4))],
            "motions": [{"where": {"y_max": -1.0}, "velocity": {"x": 0.0, "y": 0.0}}],
            "body_loads": [{"acceleration": {"x": along, "y": -GRAVITY}}],
            "interfaces": [{"name": "foot", "between": {"left": "block", "right": "base"}, "law": law}],
            "histories": [{"name": "block", "quantity": "velocity_x", "at": {"x": 2.0, "y": 1.0}}]
            + [{"name": "foot", "quantity": quantity, "interface": "foot", "at": {"x": 2.0, "y": 0.0}}
               for quantity in ("offset", "opening", "normal_stress", "shear_stress")],
            **({"damping": damping} if damping else {})}
        ground = {"material": ROCK} if water is None else {"material": {**ROCK, "pores": {"porosity": 0.3}}, "water": water}
        run = self.computed({**ground, "time": {"duration": 0.4}, "continuum": continuum,
                             "initial_stress": {"yy": -2 * 2500 * GRAVITY, "yy_per_metre": 2500 * GRAVITY}})
        self.assertLess(run.summary["max_energy_drift"], 1e-10)
        return run

    def test_a_block_slides_as_friction_lets_it(self):
        h = self.slide({"friction_angle": math.radians(30)}).histories
        late = self.time > 0.2
        acceleration = np.polyfit(self.time[late], h["block_vx_m_per_s"][late], 1)[0]
        self.assertAlmostEqual(acceleration / (7 - GRAVITY * math.tan(math.radians(30))), 1, delta=1e-3)
        # From then on the distance is that of this acceleration and the velocity reached.
        t, velocity, offset = (values[late] - values[late][0] for values in (self.time, h["block_vx_m_per_s"], h["foot_offset_m"]))
        expected = h["block_vx_m_per_s"][late][0] * t[-1] + acceleration * t[-1]**2 / 2
        self.assertAlmostEqual(offset[-1] / expected, 1, delta=1e-3)
        np.testing.assert_allclose(h["foot_shear_stress_Pa"][late], -h["foot_normal_stress_Pa"][late] * math.tan(math.radians(30)), rtol=1e-3)

    def test_water_in_the_gap_bears_its_part_of_the_block(self):
        friction, total, pressure = math.tan(math.radians(30)), 2 * 2500 * GRAVITY, 2 * 1000 * 9.80665
        h = self.slide({"friction_angle": math.radians(30)}, water={"level": 2.0}).histories
        late = self.time > 0.2
        acceleration = np.polyfit(self.time[late], h["block_vx_m_per_s"][late], 1)[0]
        self.assertAlmostEqual(acceleration / (7 - (total - pressure) * friction / (2 * 2500)), 1, delta=1e-3)
        np.testing.assert_allclose(h["foot_shear_stress_Pa"][late], -(h["foot_normal_stress_Pa"][late] + pressure) * friction, rtol=1e-3)

    def test_energy_is_kept_while_faces_chatter_in_stiff_water(self):
        self.slide({"friction_angle": math.radians(30)}, damping=None, water={"level": 2.0, "bulk_modulus": 2.2e9})

    def test_a_block_below_its_friction_stays(self):
        # A load that comes at once counts twice, and friction bears 2.5 times the load.
        h = self.slide({"friction_angle": math.radians(60)}).histories
        self.assertLess(abs(h["block_vx_m_per_s"][-1]), 1e-3)  # what is left of its vibration
        self.assertLess(abs(h["foot_offset_m"]).max(), 1e-4)

    def test_energy_is_kept_while_faces_chatter(self):
        self.slide({"friction_angle": math.radians(30)}, damping=None)

    def test_cohesion_that_slips_away_lets_the_block_go(self):
        # Friction alone does not hold it, cohesion does until it has slipped.
        held = self.slide({"friction_angle": math.radians(30), "cohesion": 80e3}).histories
        self.assertLess(abs(held["foot_offset_m"]).max(), 1e-4)
        freed = self.slide({"friction_angle": math.radians(30), "cohesion": 20e3, "residual": {"cohesion": 0.0, "slip": 1e-5}}).histories
        self.assertGreater(freed["foot_offset_m"][-1], 0.01)


class Wave(ComputedTest):
    def test_a_part_flies_off_with_the_momentum_of_the_pulse(self):
        """A pressure pulse runs along a bar, is thrown back by the free end as tension and opens an interface as far from the
        end as half the pulse is long: what lies beyond has taken the whole impulse."""
        speed, end, length = math.sqrt(10e9 / 2500), 40.0, 8.0
        duration, stress = length / speed, 1e6
        run = self.computed({
            "material": ROCK, "time": {"duration": 1.3 * end / speed, "dt_factor": 0.5},
            "continuum": {
                "block": {"x_min": 0.0, "x_max": end, "y_min": 0.0, "y_max": 0.5, "zones_x": 160, "zones_y": 2},
                "edge_loads": [{"where": {"x_max": 0.0}, "force": {"x": stress * 0.5},
                                "time": {"sine": {"frequency": 1 / (2 * duration), "end": duration}}}],
                "interfaces": [{"name": "joint", "along": {"line": {"points": [{"x": end - length / 2, "y": 0.0}, {"x": end - length / 2, "y": 0.5}]}},
                                "law": {"friction_angle": 0.5}}],
                "histories": [{"name": f"part_{k}", "quantity": "velocity_x", "at": {"x": end - length / 2 + 0.25 * k + 0.125, "y": 0.25}} for k in range(16)]
                + [{"name": "joint", "quantity": quantity, "interface": "joint", "at": {"x": end - length / 2, "y": 0.25}}
                   for quantity in ("opening", "normal_stress")]}})
        self.assertLess(run.summary["max_energy_drift"], 1e-10)
        h = run.histories
        impulse = stress * 2 / math.pi * duration
        mean = np.mean([h[f"part_{k}_vx_m_per_s"] for k in range(16)], axis=0)
        self.assertAlmostEqual(mean[-1] / (impulse / (2500 * length / 2)), 1, delta=0.01)
        opened = self.time[np.argmax(h["joint_opening_m"] > 1e-6)]
        self.assertAlmostEqual(opened * speed, end + length / 2, delta=0.5)  # when the end of the pulse has passed
        self.assertAlmostEqual(h["joint_normal_stress_Pa"].min() / -stress, 1, delta=0.02)
        # The faces met nothing again and rubbed nowhere.
        self.assertLess(abs(h["continuum_dissipated_J"][-1]), 1e-3 * h["continuum_external_work_J"][-1])


class AtRest(ComputedTest):
    """A tunnel whose lining slips, below a water table and in dry ground: the contacts bear the weight of the lining."""

    def missing(self, pores, water):
        """What the forces of the contacts lack of the weight, over the sum of their sizes."""
        sides, radius, centre = 48, 3.0, np.array([0.0, -9.0])
        run = self.computed({
            "time": {"duration": 0.002}, "statics": {"unbalanced_ratio": 1e-12}, "output": {"field_times": [0.0]}, **water,
            "material": {"young_modulus": 80e6, "poisson_ratio": 0.3, "density": 1800.0, "mohr_coulomb": {"cohesion": 10e3, "friction_angle": 0.576}, **pores},
            "initial_stress": {"layers": [{"bottom": -1.0, "density": 1800.0, "k0": 0.5}, {"bottom": -18.0, "density": 2000.0, "k0": 0.5}]},
            "continuum": {
                "blocks": [{"ring": {"centre": {"x": 0.0, "y": -9.0}, "inner_radius": radius, "outer_side": 18.0}, "along": {"zones": sides},
                            "across": {"zones": 12, "ratio": 1.1}}],
                "linings": [{"name": "ring", "along": {"circle": {"centre": {"x": 0.0, "y": -9.0}, "radius": radius}}, "thickness": 0.3,
                             "young_modulus": 30e9, "density": 2500.0, "interface": {"friction_angle": 0.35}}],
                "body_loads": [{"acceleration": {"y": -9.80665}}],
                "motions": [{"where": {"y_max": -18.0}, "velocity": {"x": 0.0, "y": 0.0}}]
                + [{"where": {key: at}, "velocity": {"x": 0.0}} for key, at in (("x_max", -9.0), ("x_min", 9.0))]}})
        contacts = run.fields()["interfaces"]
        normal, shear = (np.array(contacts[name]) for name in ("normal_stress_Pa", "shear_stress_Pa"))
        outwards = np.array(contacts.points)[:, :2] - centre
        outwards /= np.linalg.norm(outwards, axis=1)[:, None]
        side = 2 * radius * math.sin(math.pi / sides)
        # The normal of a contact is the mean of its two sides', whose length is shorter than theirs.
        forces = side * math.cos(math.pi / sides) * (normal[:, None] * outwards + shear[:, None] * outwards[:, ::-1] * [1, -1])
        weight = sides * side * 0.3 * 2500 * 9.80665
        return np.linalg.norm(forces.sum(axis=0) - [0, weight]) / np.linalg.norm(forces, axis=1).sum()

    def test_contact_forces_bear_the_lining_with_and_without_water(self):
        wet = self.missing({"pores": {"porosity": 0.4, "saturated_density": 2000.0}}, {"water": {"level": -1.0}})
        self.assertLess(wet, 1e-10)
        self.assertLess(self.missing({}, {}), 1e-10)


class Staged(ComputedTest):
    def crown(self, interface):
        """Thrust and moment of a box at rest that was installed when half of the ground's forces were released."""
        corners = ((2, -8), (2, -4), (-2, -4), (-2, -8), (2, -8))
        lining = {"name": "box", "along": {"line": {"points": [{"x": float(x), "y": float(y)} for x, y in corners]}}, "thickness": 0.4,
                  "young_modulus": 30e9, "stage": 2, **interface}
        run = self.computed({
            "material": {"young_modulus": 100e6, "poisson_ratio": 0.3, "density": 2000.0}, "time": {"duration": 0.002},
            "statics": {"unbalanced_ratio": 1e-5}, "initial_stress": {"layers": [{"bottom": -16.0, "density": 2000.0, "k0": 0.5}]},
            "continuum": {
                "block": {"x_min": -12.0, "x_max": 12.0, "y_min": -16.0, "y_max": 0.0, "zones_x": 24, "zones_y": 16},
                "body_loads": [{"acceleration": {"y": -GRAVITY}}],
                "motions": [{"where": {"y_max": -16.0}, "velocity": {"x": 0.0, "y": 0.0}}]
                + [{"where": {key: at}, "velocity": {"x": 0.0}} for key, at in (("x_max", -12.0), ("x_min", 12.0))],
                "excavations": [{"where": {"x_min": -2.0, "x_max": 2.0, "y_min": -8.0, "y_max": -4.0}, "stage": 1, "released": 0.5}],
                "linings": [lining],
                "histories": [{"name": place, "quantity": quantity, "lining": "box", "at": {"x": x, "y": y}}
                              for place, x, y in (("roof", 0.0, -4.0), ("wall", 2.0, -6.0)) for quantity in ("thrust", "moment")]}})
        return np.array([run.histories[name][0] for name in run.histories if name.startswith(("roof", "wall"))])

    def test_a_lining_that_sticks_bears_what_a_tied_one_does(self):
        tied, stuck = self.crown({}), self.crown({"interface": {"cohesion": 1e9, "tension": 1e9}})
        # The springs are as soft as a tenth of a zone of 1 m.
        np.testing.assert_allclose(stuck, tied, rtol=0.02, atol=0.02 * abs(tied[1::2]).max())
        # By hand: half of the overburden, 80 kPa at the roof, over half the span and a little more beside.
        self.assertTrue(60e3 < -tied[2] < 160e3, tied)


class Joint(ComputedTest):
    def test_a_joint_that_sticks_yields_as_goodman_says(self):
        """Goodman, Taylor and Brekke 1968: a joint closes and slips by the stresses over its stiffnesses, which adds to the
        compliance of the block. In a block loaded along its height the stress is the same everywhere."""
        pressure, slope = 1e6, 0.5
        along_x, along_y = np.array([1, slope]) / math.hypot(1, slope)

        def points(*places):
            return [{"x": float(x), "y": float(y)} for x, y in places]

        lower, upper = ((0, 0), (2, 0), (2, 1.5), (0, 0.5)), ((0, 0.5), (2, 1.5), (2, 2), (0, 2))
        stiffness = {"normal_stiffness": 200e9, "shear_stiffness": 80e9}
        run = self.computed({
            "material": {**ROCK, "poisson_ratio": 0.2}, "time": {"duration": 0.4},
            "continuum": {
                "damping": {"maxwell": {"ratio": 0.05, "low_frequency": 100.0, "high_frequency": 2000.0}},
                "blocks": [{"name": name, "quadrilateral": {"corners": points(*corners)}, "along": {"zones": 12}, "across": {"zones": 6}}
                           for name, corners in (("lower", lower), ("upper", upper))],
                "motions": [{"where": {"y_max": 0.0}, "velocity": {"y": 0.0}}, {"where": {"x_max": 0.0, "y_max": 0.0}, "velocity": {"x": 0.0}}],
                "edge_loads": [{"where": {"y_min": 2.0}, "force": {"y": -pressure * 2}, "time": {"sine": {"frequency": 0.625}}}],
                "interfaces": [{"name": "joint", "between": {"left": "upper", "right": "lower"}, "law": {**stiffness, "cohesion": 1e9}}],
                "histories": [{"name": "joint", "quantity": quantity, "interface": "joint", "at": {"x": 1.0, "y": 1.0}}
                              for quantity in ("offset", "normal_stress", "shear_stress")]
                + [{"name": "top", "quantity": quantity, "at": {"x": 0.0, "y": 2.0}} for quantity in ("displacement_x", "displacement_y")]}})
        found = {name: values[-1] for name, values in run.histories.items()}
        normal, shear = -pressure * along_x**2, -pressure * along_x * along_y  # of the upper face along the path
        self.assertAlmostEqual(found["joint_normal_stress_Pa"] / normal, 1, delta=1e-4)
        self.assertAlmostEqual(abs(found["joint_shear_stress_Pa"] / shear), 1, delta=1e-4)
        closing, slip = -normal / stiffness["normal_stiffness"], -shear / stiffness["shear_stiffness"]
        self.assertAlmostEqual(abs(found["joint_offset_m"]) / slip, 1, delta=1e-4)
        # The load comes slowly; what is left of its inertia is 0.1 % of the way aside.
        shortening = pressure * 2 * (1 - 0.2**2) / ROCK["young_modulus"]
        self.assertAlmostEqual(-found["top_uy_m"] / (shortening + closing * along_x + slip * along_y), 1, delta=1e-4)
        self.assertAlmostEqual(found["top_ux_m"] / (closing * along_y - slip * along_x), 1, delta=2e-3)


class Fault(ComputedTest):
    """A block between four smooth platens, shortened across an inclined fault with friction: as an interface of zones, and as a
    smooth joint of particles."""

    SIDE, FROM, TO, SHORTENED, FRICTION, DURATION = 2.0, (0.5, 0.0), (1.5, 2.0), 2e-3, 0.3, 0.05
    STIFFNESS = {"normal_stiffness": 200e9, "shear_stiffness": 80e9}
    SCENE = {"material": {**ROCK, "poisson_ratio": 0.2}, "time": {"duration": DURATION}}

    def platen(self):
        """Velocity that shortens the block."""
        return {"y": -self.SHORTENED * math.pi / 2 / self.DURATION}, {"sine": {"frequency": 1 / (2 * self.DURATION), "end": self.DURATION}}

    def of_zones(self):
        """(offset of the fault in the mean, thrust under the upper platen)."""
        point, (velocity, time) = self.point, self.platen()
        run = self.computed({**self.SCENE, "continuum": {
            "blocks": self.blocks(),
            "motions": [{"where": {"y_min": self.SIDE}, "velocity": velocity, "time": time}, {"where": {"y_max": 0.0}, "velocity": {"y": 0.0}},
                        {"where": {"x_max": 0.0}, "velocity": {"x": 0.0}}, {"where": {"x_min": self.SIDE}, "velocity": {"x": 0.0}}],
            "interfaces": [{"name": "fault", "along": {"line": {"points": [point(*self.FROM), point(*self.TO)]}},
                            "law": {**self.STIFFNESS, "friction_angle": math.atan(self.FRICTION)}}],
            "sections": [{"name": "upper", "from": point(0, 1.9), "to": point(self.SIDE, 1.9)}],
            "histories": [{"name": "upper", "quantity": "thrust", "section": "upper"}],
            "damping": {"maxwell": {"ratio": 0.05, "low_frequency": 100.0, "high_frequency": 2000.0}}}})
        fault = run.fields()["interfaces"]
        order = np.argsort(fault.points[:, 1])
        mean = np.trapz(fault.field("offset_m")[order], fault.points[order, 1]) / self.SIDE
        return mean, -run.histories["upper_thrust_N"][-1]

    def of_particles(self):
        rows = 30
        radius = self.SIDE / ((rows - 1) * math.sqrt(3) + 2)
        width = 2 * radius * round(self.SIDE / (2 * radius))  # of whole discs, 1 % from that of the zones
        velocity, time = self.platen()
        far, point = 2 * self.SIDE, self.point
        run = self.computed({**self.SCENE, "particles": {
            "packing": {"x_min": 0.0, "x_max": width + 1e-9, "y_min": 0.0, "y_max": self.SIDE + 1e-9, "radius": radius}, "bonds": {},
            "contacts": {"normal_stiffness": 100e9, "shear_stiffness": 1.0, "friction": 0.0},
            "joints": [{"name": "fault", "from": point(*self.FROM), "to": point(*self.TO), "smooth": {**self.STIFFNESS, "friction": self.FRICTION}}],
            "walls": [{"name": "upper", "from": point(-far, self.SIDE), "to": point(far, self.SIDE), "velocity": {**velocity, "time": time}},
                      {"name": "lower", "from": point(-far, 0), "to": point(far, 0)},
                      {"name": "left", "from": point(0, -far), "to": point(0, far)},
                      {"name": "right", "from": point(width, -far), "to": point(width, far)}],
            "damping": {"local": 0.3},
            "histories": [{"name": "upper", "quantity": "force_y", "wall": "upper"}, {"name": "fault", "quantity": "offset", "joint": "fault"}]}})
        return run.histories["fault_offset_m"][-1], run.histories["upper_fy_N"][-1]

    def blocks(self):
        corners = ((0, 0), self.FROM, self.TO, (0, self.SIDE)), (self.FROM, (self.SIDE, 0), (self.SIDE, self.SIDE), self.TO)
        return [{"name": name, "quadrilateral": {"corners": [self.point(*corner) for corner in of]}, "along": {"zones": 10}, "across": {"zones": 20}}
                for name, of in zip(("left", "right"), corners)]

    @staticmethod
    def point(x, y):
        return {"x": float(x), "y": float(y)}

    def test_a_fault_slips_in_zones_as_a_smooth_joint_does_in_particles(self):
        zones, particles = self.of_zones(), self.of_particles()
        np.testing.assert_allclose(zones, particles, rtol=0.05)
        # Without the fault the platen would bear M times the shortening over the height; slip takes some of it away.
        whole = ROCK["young_modulus"] * (1 - 0.2) / (1.2 * 0.6) * self.SHORTENED
        self.assertTrue(0.85 * whole < zones[1] < 0.98 * whole, zones)
        self.assertLess(zones[0], -0.1 * self.SHORTENED)  # the left face moves down the fault


class Refused(ComputedTest):
    def refused(self, change, sentence):
        scene = {"material": ROCK, "time": {"duration": 0.01}, "continuum": {
            "blocks": [rectangle("lower", (0.0, 4.0), (0.0, 1.0), (8, 2)), rectangle("upper", (0.0, 4.0), (1.0, 2.0), (8, 2))],
            "interfaces": [{"name": "plane", "between": {"left": "upper", "right": "lower"}, "law": {"friction_angle": 0.5}}]}}
        change(scene["continuum"])
        result = self.coupler_refuses(scene)
        self.assertIn(sentence, result)

    def coupler_refuses(self, scene):
        result = coupler("run", self.scene(json.dumps(scene)), "--out", self.folder / "refused")
        self.assertEqual(result.returncode, 2, result.stderr)
        return result.stderr

    def test_what_cannot_be_is_said_in_one_sentence(self):
        def line(*points):
            return {"line": {"points": [{"x": float(x), "y": float(y)} for x, y in points]}}

        def with_interface(**keys):
            return lambda continuum: continuum["interfaces"][0].update(keys)

        def along(path):
            def change(continuum):
                del continuum["interfaces"][0]["between"]
                continuum["interfaces"][0]["along"] = path
            return change

        def lining(**keys):
            return lambda continuum: continuum.update(linings=[{"name": "wall", "along": line((0, 1.5), (4, 1.5)), "thickness": 0.2,
                                                                "young_modulus": 30e9, "interface": {}, **keys}])
        for change, sentence in (
                (along(line((0, 0.7), (4, 0.7))), "has no sides of zones along it"),
                (along(line((0, 2), (4, 2))), "has zones on one side only"),
                (with_interface(between={"left": "upper", "right": "upper"}), "name two groups that touch"),
                (with_interface(along=line((0, 1), (4, 1))), "give either `along` or `between`"),
                (with_interface(law={"friction_angle": 0.3, "dilation_angle": 0.4}), "larger than the friction angle"),
                (with_interface(law={"friction_angle": 0.3, "cohesion": 1e3, "tension": 1e6}), "above cohesion / tan(friction_angle)"),
                (with_interface(law={"cohesion": 1e3, "residual": {"cohesion": 2e3}}), "before it slips"),
                (lambda continuum: continuum.update(large_strain=True, excavations=[{"where": {"x_min": 0, "x_max": 1, "y_min": 0, "y_max": 1}}]),
                 "leave large_strain, the interfaces or the excavations out"),
                (lambda continuum: lining()(continuum) or continuum.update(large_strain=True), "keeps its partners, which `continuum.large_strain` moves away"),
                (lining(name="plane"), "is taken by another lining or an interface"),
                (lining(along=line((0, 1), (4, 1))), "is already; let only one of them run there"),
                (lambda continuum: continuum.update(histories=[{"name": "at", "quantity": "offset", "interface": "plain", "at": {"x": 1.0, "y": 1.0}}]),
                 "no interface of the continuum or of its linings has this name")):
            with self.subTest(sentence):
                self.refused(change, sentence)


if __name__ == "__main__":
    unittest.main()
