"""Tunnels that become particles: the demand of their linings, how far the particles reach, and what the scene states then."""
import unittest
from types import SimpleNamespace

import numpy as np

from adit import Unusable
from adit.zoom.command import AT_EDGES, merged, staying_zones, steps
from adit.zoom.contours import Contour
from adit.zoom.linings import Tunnel, Use, edge_demand, material_of
from adit.zoom.outlines import Zones
from adit.zoom.places import places
from adit.zoom.scene import differences
from adit.zoom.tunnel_scene import as_particles, without_lost
from adit.zoom.tunnels import reaches

CIRCLE, BOX, HORSESHOE = {"circle": {"radius": 2.0}}, {"box": {"width": 6.0, "height": 4.0}}, {"horseshoe": {"width": 4.0, "height": 5.0}}
FRACTURE = {"tensile_strength": 3e6, "compressive_strength": 30e6, "fracture_energy": 120.0}
CONCRETE = {"young_modulus": 30e9, "poisson_ratio": 0.2, "density": 2400, "fracture": FRACTURE}
WIDTH = 40  # of the ground, in zones of a metre


class Contours(unittest.TestCase):
    def test_offsets(self):
        points = np.array([[10.0, 5.0], [14.0, 5.0], [10.0, 0.0], [13.0, 9.0]])
        for shape, expected in ((CIRCLE, [-2, 2, 3, 3]), (BOX, [-2, 1, 3, 2]), (HORSESHOE, [-2, 2, 2, 3])):
            with self.subTest(shape=shape):
                np.testing.assert_allclose(Contour({"centre": {"x": 10, "y": 5}} | shape).away(points), expected)

    def test_areas(self):
        for shape, expected in ((CIRCLE, 9 * np.pi), (BOX, 8 * 6), (HORSESHOE, 9 * np.pi / 2 + 6 * 4)):
            self.assertAlmostEqual(Contour({"centre": {}} | shape).area(1), expected, places=12)

    def test_area_is_that_of_the_points_within(self):
        x, y = (each.ravel() for each in np.meshgrid(*[np.arange(-6, 6, 0.02)] * 2))
        for shape in (CIRCLE, BOX, HORSESHOE):
            contour = Contour({"centre": {"x": 0.3, "y": 0.1}} | shape)
            self.assertAlmostEqual((contour.away(np.column_stack([x, y])) < 0.7).sum() * 0.02**2 / contour.area(0.7), 1, delta=5e-3)


class Demand(unittest.TestCase):
    def nodes(self, thrust, moment):
        return {"peak_largest_thrust_N": np.array([thrust]), "peak_least_thrust_N": np.array([thrust]),
                "peak_largest_moment_Nm": np.array([moment]), "peak_least_moment_Nm": np.array([-0.5 * moment])}

    # A wall of 0.4 m: W = 0.4^2/6 m^2, so that 40 kNm bend it with 1.5 MPa at its edges, and 400 kN press with 1 MPa.
    def test_stress_at_the_edges(self):
        for thrust, moment, expected in ((0, 40e3, 1.5 / 3), (-400e3, 80e3, (3 - 1) / 3), (-400e3, -80e3, (3 - 1) / 3), (-8e6, 40e3, 21.5 / 30)):
            self.assertAlmostEqual(edge_demand(self.nodes(thrust, moment), 0.4, FRACTURE)[0], expected, places=12)

    def test_strength_of_a_section_stated_by_numbers(self):
        numbers = {"young_modulus": 33e9, "compressive_strength": 38e6, "tensile_strength": 2.9e6}
        self.assertAlmostEqual(material_of({"section": {"concrete": numbers}})["fracture"]["fracture_energy"], 140.5, delta=0.1)  # of C30/37
        self.assertIs(material_of({"section": {"concrete": {"class": "C30/37"}}, "material": CONCRETE}), CONCRETE)


class Piece(dict):
    """Fields of square zones of a metre, with those in the tunnels."""
    points = np.array([[x, y] for y in range(31) for x in range(WIDTH + 1)], float)
    cells = np.array([[(WIDTH + 1) * y + x + k for k in (0, 1, WIDTH + 2, WIDTH + 1)] for y in range(30) for x in range(WIDTH)])


def run(*tunnels, **continuum):
    block = {"x_min": 0, "x_max": WIDTH, "y_min": 0, "y_max": 30, "zones_x": WIDTH, "zones_y": 30}
    piece = Piece({field: np.zeros(len(Piece.cells)) for field in ("material", "group")})
    scene = {"material": {"young_modulus": 1e9, "poisson_ratio": 0.25, "density": 2000}, "tunnels": list(tunnels), "continuum": {"block": block, **continuum}}
    return SimpleNamespace(folder="run", scene=scene, scene_as_written=scene, summary={}, fields=lambda: {"grid": piece})


def tunnel(x=20, lining=None, **others):
    return {"name": f"at_{x}", "centre": {"x": x, "y": 15}, **CIRCLE, "lining": lining or {"as": "beam", "thickness": 0.4, "material": CONCRETE}, **others}


class OfTunnels(unittest.TestCase):
    zones = Zones(Piece)

    def reaches(self, given, demands, *near):
        flags = np.array([tuple(corner) in near for corner in (self.zones.centres - 0.5).astype(int).tolist()])
        uses = [(Tunnel(number, each), Use(demand, 0, 0)) for number, (each, demand) in enumerate(zip(given.scene["tunnels"], demands))]
        return reaches(given, self.zones, flags, uses, 0.8, np.zeros(len(self.zones.points), bool))


class Reaching(OfTunnels):
    def test_only_tunnels_near_their_strength(self):
        found = self.reaches(run(tunnel(10), tunnel(30)), [0.5, 0.9])
        self.assertEqual([(reach.tunnel.name, reach.ground, reach.overlap) for reach in found], [("at_30", 4, 2)])

    def test_ground_beside_reaches_farther(self):
        near = (24, 15)  # its farthest corner lies 2.7 m outside the lining
        (reach,) = self.reaches(run(tunnel()), [0.1], near)
        self.assertAlmostEqual(reach.ground, np.hypot(5, 1) - 2.4 + 4, delta=1e-3)
        self.assertEqual(reach.near.sum(), 1)
        self.assertEqual(self.reaches(run(tunnel()), [0.1], (28, 15)), [])  # five zones away
        (chain,) = self.reaches(run(tunnel()), [0.1], near, (28, 15))
        self.assertAlmostEqual(chain.ground, np.hypot(9, 1) - 2.4 + 4, delta=6e-3)  # four digits are told

    def test_ground_ends_before_the_edge(self):
        (reach,) = self.reaches(run(tunnel()), [0.9], (20, 20), (20, 24), (20, 26))
        self.assertAlmostEqual(reach.ground, 15 - 2.4 - 1, delta=1e-3)
        with self.assertRaisesRegex(Unusable, r"`at_5` needs particles in 4 m of ground around it, four zones, but at \(0, 15\) m, within five, is the edge of the ground"):
            self.reaches(run(tunnel(5)), [0.9])

    def test_particles_that_would_meet(self):
        with self.assertRaisesRegex(Unusable, "tunnels `at_14` and `at_26` both need particles, which would meet between them"):
            self.reaches(run(tunnel(14), tunnel(26)), [0.9, 0.9])
        self.assertEqual(len(self.reaches(run(tunnel(12), tunnel(28)), [0.9, 0.9])), 2)

    def test_what_particles_do_not_have(self):
        fibres = {"thickness": 0.4, "concrete": {"class": "C30/37", "fibres": {}}}
        for lining, key in (({"interface": {}}, "interface"), ({"contact": {"height": 0.2}}, "contact"), ({"second_ring": {}}, "second_ring")):
            with self.assertRaisesRegex(Unusable, rf"`at_20` comes near its strength, but it has tunnels\[0\].lining.{key}, which particles do not; leave it out"):
                self.reaches(run(tunnel(lining={"as": "beam", "thickness": 0.4, "material": CONCRETE} | lining)), [0.9])
        with self.assertRaisesRegex(Unusable, r"tunnels\[0\].lining.section.concrete.fibres"):
            self.reaches(run(tunnel(lining={"as": "beam", "section": fibres})), [0.9])
        with self.assertRaisesRegex(Unusable, r"lining.material says when its zones fail, but not how cells of it break"):
            self.reaches(run(tunnel(lining={"as": "zones", "thickness": 0.4, "material": {"mohr_coulomb": {}}})), [0.9])


class Written(OfTunnels):
    def written(self, lining, size=None, share=0.7, **others):
        given = run(tunnel(lining=lining, **others))
        (reach,) = self.reaches(given, [1.9])
        return as_particles(given, self.zones, reach, Tunnel(0, tunnel(lining=lining | {"material": CONCRETE})), share, size)

    # E' G_f / f_t^2 = 25 GPa x 120 N/m / (3 MPa)^2 = 0.333 m: a quarter of it is less than one of a lining 0.4 m thick.
    def test_sizes_of_cells(self):
        stated, _ = self.written({"as": "beam", "thickness": 0.4, "material": CONCRETE})
        self.assertEqual(stated["particles"], {"size": 0.0829, "ground": 4, "overlap": 2, "ground_size": 0.5, "begin": {"demand": 0.7}})
        stated, _ = self.written({"as": "beam", "thickness": 0.2, "material": CONCRETE})
        self.assertEqual(stated["particles"]["size"], 0.05)
        with self.assertRaisesRegex(Unusable, "--size 0.2 is not below half of the thickness of the lining of tunnel `at_20`, 0.4 m; give less."):
            self.written({"as": "beam", "thickness": 0.4, "material": CONCRETE}, 0.2)

    def test_particles_begin_before_anything_breaks(self):
        for share, demand in ((0.7, 0.7), (1.0, 1.0), (1.5, 1.0)):
            stated, _ = self.written({"as": "beam", "thickness": 0.4, "material": CONCRETE}, share=share)
            self.assertEqual(stated["particles"]["begin"], {"demand": demand})

    def test_cells_are_no_larger_than_zones(self):
        lining = {"as": "beam", "thickness": 3.0, "material": CONCRETE}
        self.assertEqual(self.written(lining, 1.0)[0]["particles"]["size"], 1)
        with self.assertRaisesRegex(Unusable, r"^--size 1.1 is above 1 m, the shorter side of the zones around \(20, 15\) m that become particles; give less\.$"):
            self.written(lining, 1.1)

    def test_linings_become_cells_tied_to_the_ground(self):
        stated, _ = self.written({"as": "zones", "thickness": 0.4, "material": CONCRETE | {"mohr_coulomb": {}}}, zones={"across": 2}, stage=1, released=0.4)
        self.assertEqual(stated["lining"], {"as": "particles", "thickness": 0.4, "material": CONCRETE, "to_ground": {}})
        self.assertEqual((stated["stage"], stated["released"], "zones" in stated), (1, 0.4, False))
        section = {"thickness": 0.4, "concrete": {"class": "C30/37"}, "steel": {"class": "B500B"}}
        stated, _ = self.written({"as": "beam", "section": section | {"elastic": True}})
        self.assertEqual(stated["lining"], {"as": "particles", "section": section, "to_ground": {}})
        self.assertNotIn("begin", stated["particles"])  # bars do not wait

    # Ground with cells of the lining's size: the area over 0.866 size^2, with the opening where it is excavated.
    def test_number_of_cells(self):
        lining = {"as": "beam", "thickness": 1.0, "material": CONCRETE}
        for stage, inner in ((0, 2), (1, 0)):
            _, count = self.written(lining, 0.49999, **({"stage": 1} if stage else {}))
            self.assertAlmostEqual(count / (np.pi * (7**2 - inner**2) / 0.866 / 0.25), 1, delta=0.01)

    def test_histories_among_the_particles_are_left_out(self):
        def history(name, **where):
            return {"name": name, "quantity": "acceleration_x", **where}

        given = run(tunnel(), sections=[{"name": "cut", "from": {"x": 20, "y": 18}, "to": {"x": 20, "y": 19}}], histories=[
            history("near", at={"x": 20, "y": 19}), history("overlap", at={"x": 20, "y": 20}), history("far", at={"x": 5}),
            history("beam", lining="at_20", at={"x": 20, "y": 17}), history("other", lining="else", at={"x": 20, "y": 17}),
            history("cut", section="cut"), history("between", at={"x": 5}, relative_to={"x": 20, "y": 18})])
        given.scene["output"] = {"spectra": [{"history": "near"}, {"history": "far"}, {"history": "far", "relative_to": "near"}]}
        changes, notes = without_lost(given.scene, self.reaches(given, [0.9]))
        self.assertEqual([each["name"] for each in changes["continuum"]["histories"]], ["overlap", "far", "other"])
        self.assertEqual((changes["continuum"]["sections"], changes["output"]), ([], {"spectra": [{"history": "far"}]}))
        self.assertEqual(len(notes), 5)
        self.assertEqual(without_lost(given.scene, []), ({}, []))

    def test_steps_and_changes(self):
        self.assertEqual(steps({"dt": 1e-4}), {"substeps": 0, "dt": None})
        self.assertEqual(steps({"substeps": 2}), {})
        self.assertEqual(merged({"time": {"dt": None}, "a": 1}, {"time": {"substeps": 0}, "b": 2}), {"time": {"dt": None, "substeps": 0}, "a": 1, "b": 2})


class InGround(OfTunnels):
    def written(self, share, size=None):
        given = run()
        given.scene |= {"material": CONCRETE, "time": {}}
        near = (self.zones.centres == (20.5, 15.5)).all(axis=1)
        found, _ = places(self.zones, near, np.zeros(len(self.zones.points), bool))
        return differences(given, self.zones, found, share, size)

    def test_particles_begin_before_anything_breaks(self):
        for share, demand in ((0.7, 0.7), (1.0, 1.0), (1.5, 1.0)):
            self.assertEqual(self.written(share)[0]["particles"]["begin"], {"demand": demand})

    def test_cells_are_no_larger_than_zones(self):
        self.assertEqual(self.written(0.8, 1.0)[0]["particles"]["cells"]["size"], 1)
        with self.assertRaisesRegex(Unusable, r"^--size 50 is above 1 m, the shorter side of the zones around \(20\.5, 15\.5\) m that become particles; give less\.$"):
            self.written(0.8, 50.0)

    def test_zones_that_stay_are_counted(self):
        for count, told in ((1, r"a zone near its strength, at \(0\.5, 0\.5\) m, stays a zone: "), (2, r"2 zones near their strength, .*, stay zones: ")):
            staying = np.arange(len(Piece.cells)) < count
            self.assertRegex(staying_zones(self.zones, np.ones(len(staying)), staying, AT_EDGES), told)


if __name__ == "__main__":
    unittest.main()
