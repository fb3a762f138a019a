"""Areas of scenes in pictures select the same points and edges as the programs do."""

import pathlib
import re
import tempfile
import types
import unittest

import numpy as np

from adit.plots.setup import mesh_groups
from adit.plots.setup.areas import boundary, edges_in, inside, points_in, zones_in
from adit.plots.setup.checked import Member
from adit.plots.setup.stages import covering

MESH = pathlib.Path(__file__).resolve().parents[3] / "cases" / "excavation" / "tunnel.msh"

POINTS = np.array([(x, y) for y in range(5) for x in range(5)], float)
ZONES = np.array([(5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5) for j in range(4) for i in range(4)])
GRID = types.SimpleNamespace(points=POINTS, cells=ZONES)


def corners(*pairs):
    return {"corners": [{"x": x, "y": y} for x, y in pairs]}


class Areas(unittest.TestCase):
    def chosen(self, area):
        return {tuple(point) for point in POINTS[inside(area, POINTS)]}

    def test_an_absent_area_is_everywhere(self):
        self.assertEqual(len(self.chosen(None)), 25)

    def test_sides_belong_to_a_box(self):
        self.assertEqual(self.chosen({"x_max": 1, "y_min": 3}), {(0, 3), (1, 3), (0, 4), (1, 4)})

    def test_a_circle_and_an_annulus_hold_their_rims(self):
        centre = {"x": 2, "y": 2}
        cross = {(2, 2), (1, 2), (3, 2), (2, 1), (2, 3)}
        self.assertEqual(self.chosen({"circle": {"centre": centre, "radius": 1}}), cross)
        self.assertEqual(self.chosen({"annulus": {"centre": centre, "inner_radius": 1, "outer_radius": 1.2}}), cross - {(2, 2)})

    def test_a_band_ends_square(self):
        band = {"from": {"x": 1, "y": 2}, "to": {"x": 3, "y": 2}, "width": 1}
        self.assertEqual(self.chosen({"band": band}), {(1, 2), (2, 2), (3, 2)})

    def test_a_polygon_holds_its_sides_either_way_round_but_not_its_holes(self):
        square = ((1, 1), (3, 1), (3, 3), (1, 3))
        for order in (square, square[::-1]):
            self.assertEqual(len(self.chosen({"polygon": corners(*order)})), 9)
            hole = corners((1.5, 1.5), (2.5, 1.5), (2.5, 2.5), (1.5, 2.5))
            self.assertEqual(self.chosen({"polygon": {**corners(*order), "holes": [hole]}}),
                             self.chosen({"polygon": corners(*order)}) - {(2, 2)})

    def test_the_boundary_goes_around_the_grid_and_around_its_holes(self):
        self.assertEqual(len(boundary(GRID)), 16)
        holed = types.SimpleNamespace(points=POINTS, cells=np.delete(ZONES, 5, axis=0))
        self.assertEqual(len(boundary(holed)), 20)

    def test_an_edge_lies_in_an_area_with_both_ends(self):
        self.assertEqual(len(edges_in({"y_max": 0}, GRID, boundary(GRID), {})), 4)
        self.assertEqual(len(edges_in({"x_max": 1.5, "y_max": 0}, GRID, boundary(GRID), {})), 1)

    def test_a_zone_lies_in_an_area_with_its_centre(self):
        self.assertEqual(len(zones_in({"x_max": 1.5}, GRID, {})), 8)

    def test_groups_of_a_mesh_select_their_edges_and_zones(self):
        groups = mesh_groups.read(MESH)
        base = edges_in({"group": "base"}, GRID, boundary(GRID), groups)
        self.assertEqual(set(base[..., 1].ravel()), {-40})
        self.assertEqual((base[..., 0].min(), base[..., 0].max()), (-50, 50))
        heading, bench = (zones_in({"group": name}, GRID, groups) for name in ("heading", "bench"))
        self.assertTrue((heading.mean(axis=1)[:, 1] > 0).all() and (bench.mean(axis=1)[:, 1] < 0).all())
        # Half a disc of radius 5 m each, but for the chords of its rim.
        for zones in (heading, bench):
            x, y = np.moveaxis(zones, 2, 0)
            area = 0.5 * np.sum(x * np.roll(y, -1, axis=1) - np.roll(x, -1, axis=1) * y)
            self.assertAlmostEqual(abs(area) / (np.pi * 25 / 2), 1, delta=0.03)

    def test_a_mesh_may_number_its_groups(self):
        text = re.sub(r"\$PhysicalNames.*?\$EndPhysicalNames\n", "", MESH.read_text(), flags=re.S)
        with tempfile.NamedTemporaryFile("w", suffix=".msh") as file:
            file.write(text)
            file.flush()
            self.assertEqual(sorted(len(group.zones) for group in mesh_groups.read(file.name).values()),
                             sorted(len(group.zones) for group in mesh_groups.read(MESH).values()))

    def test_a_block_is_a_group_whose_zones_points_and_edges_an_area_may_name(self):
        grid = types.SimpleNamespace(points=POINTS, cells=ZONES, field=lambda name: np.repeat([1, 0, 2, 1], 4))
        blocks = [{"name": "deep"}, {}, {"name": "top"}, {"name": "deep"}]
        groups = Member("", "continuum", {"blocks": blocks}, {}).zone_groups(grid)
        self.assertEqual([len(zones_in({"group": name}, grid, groups)) for name in ("deep", "top")], [8, 4])
        self.assertEqual(len(zones_in({"group": "deep", "y_max": 1}, grid, groups)), 4)
        self.assertEqual(set(points_in({"group": "top"}, grid, groups)[:, 1]), {2, 3})
        self.assertEqual(len(edges_in({"group": "top"}, grid, boundary(grid), groups)), 2)

    def test_rows_of_squares_cover_points_and_leave_gaps_open(self):
        points = np.array([(0, 0), (1, 0), (2, 0), (5, 0), (0, 1)], float)
        self.assertEqual(sorted(map(tuple, covering(points, 1.0)[:, [0, 2]].reshape(-1, 4))),
                         [(-0.5, -0.5, 2.5, 0.5), (-0.5, 0.5, 0.5, 1.5), (4.5, -0.5, 5.5, 0.5)])


if __name__ == "__main__":
    unittest.main()
