"""Places of particles on a grid: outlines, margins, overlaps, what joins and what stays."""
import unittest
from types import SimpleNamespace

import numpy as np

from adit.cases.zoom_clusters import clusters
from adit.zoom.outlines import Zones, hull, inside, loops
from adit.zoom.places import ACROSS, MARGIN, conditioned, places


def grid(columns, rows, hole=()):
    """Square zones of 1 m from (0, 0), without those in the hole, given as (column, row)."""
    points = np.array([[x, y] for y in range(rows + 1) for x in range(columns + 1)], float)
    cells = [[(columns + 1) * y + x + k for k in (0, 1, columns + 2, columns + 1)] for y in range(rows) for x in range(columns) if (x, y) not in hole]
    return SimpleNamespace(points=points, cells=np.array(cells))


def flags(zones, *chosen):
    """The zones with these lower left corners."""
    return np.array([tuple(corner) in chosen for corner in (zones.centres - 0.5).astype(int).tolist()])


class Outlines(unittest.TestCase):
    def test_outline_has_the_area_of_its_zones_and_only_corners(self):
        zones = Zones(grid(6, 5))
        chosen = flags(zones, (1, 1), (2, 1), (3, 1), (1, 2))
        (loop,) = loops(zones, chosen)
        self.assertEqual((loop.area, len(loop.points), loop.outer), (4, 6, True))
        np.testing.assert_array_equal(inside(loop.points, zones.centres), chosen)

    def test_holes_run_the_other_way(self):
        zones = Zones(grid(5, 5))
        outer, hole = loops(zones, ~flags(zones, (2, 2)))
        self.assertEqual((outer.area, hole.area, hole.outer), (25, -1, False))

    def test_zones_that_meet_in_a_point_are_two_outlines(self):
        zones = Zones(grid(4, 4))
        self.assertEqual([loop.area for loop in loops(zones, flags(zones, (1, 1), (2, 2)))], [1, 1])

    def test_closing_leaves_no_pinch_and_no_hole_of_ground(self):
        zones = Zones(grid(7, 7, hole={(5, 5)}))
        everywhere = np.ones(len(zones.cells), bool)
        pinched = zones.closed(flags(zones, (1, 1), (2, 2)), everywhere)
        np.testing.assert_array_equal(pinched, flags(zones, (1, 1), (2, 2), (1, 2), (2, 1)))
        ring = flags(zones, *((x, y) for x in (1, 2, 3) for y in (1, 2, 3) if (x, y) != (2, 2)))
        self.assertEqual(zones.closed(ring, everywhere).sum(), 9)
        self.assertEqual(len(loops(zones, everywhere)), 2)  # an opening stays one

    def test_hull(self):
        corners = hull(np.array([[0, 0], [2, 0], [1, 1], [2, 2], [0, 2], [1, 0]], float))
        self.assertEqual({tuple(corner) for corner in corners}, {(0, 0), (2, 0), (2, 2), (0, 2)})


class Places(unittest.TestCase):
    def found(self, zones, *near, kept=None):
        kept = np.zeros(len(zones.points), bool) if kept is None else kept
        return places(zones, flags(zones, *near), kept)

    def test_margin_and_overlap(self):
        zones = Zones(grid(20, 20))
        (place,), staying = self.found(zones, (10, 10))
        self.assertEqual((place.core.sum(), place.width, staying.any()), ((1 + 2 * MARGIN) ** 2, ACROSS, False))
        self.assertEqual(place.filled.sum(), (1 + 2 * MARGIN + 2 * ACROSS) ** 2)

    def test_far_apart_they_are_two_places(self):
        zones = Zones(grid(40, 12))
        reach = 2 * (MARGIN + ACROSS)
        for distance, count in ((reach + 2, 2), (reach + 1, 1), (reach - 2, 1)):
            found, _ = self.found(zones, (12, 5), (12 + distance, 5))
            self.assertEqual(len(found), count, distance)
            self.assertFalse(sum(place.filled.astype(int) for place in found).max() > 1)
            for place in found:
                self.assertEqual(len(zones.pieces(place.core)), 1)

    def test_at_a_free_face_the_core_ends_with_the_ground(self):
        zones = Zones(grid(20, 12))
        (place,), staying = self.found(zones, (10, 11))
        self.assertTrue(place.core[flags(zones, (10, 11))].all())
        self.assertFalse(staying.any())

    def test_zones_near_a_held_side_stay(self):
        piece = grid(20, 12)
        zones = Zones(piece)
        kept = conditioned({"base": {}, "free_field": {"left": True}}, piece)
        self.assertEqual(kept.sum(), 21 + 12)
        found, staying = self.found(zones, (10, 3), (10, 1), kept=kept)
        np.testing.assert_array_equal(staying, flags(zones, (10, 1)))
        self.assertFalse((found[0].filled & zones.at(kept)).any())
        self.assertEqual(self.found(zones, (0, 1), kept=kept)[0], [])

    def test_load_on_a_part_of_the_boundary(self):
        piece = grid(10, 10)
        kept = conditioned({"edge_loads": [{"where": {"x_max": 3, "y_min": 10}}], "motions": [{"where": {"x_min": 4, "x_max": 5, "y_min": 4, "y_max": 5}}]}, piece)
        self.assertEqual({tuple(point) for point in piece.points[kept]}, {(x, 10) for x in range(4)} | {(x, y) for x in (4, 5) for y in (4, 5)})


class Clusters(unittest.TestCase):
    def test_cracks_that_follow_one_another_are_one(self):
        chain, other = np.array([[0.9 * k, 0] for k in range(8)]), np.array([[20.0, 3.0], [20.5, 3.0]])
        self.assertEqual([len(cluster) for cluster in clusters(np.concatenate([other, chain]))], [8, 2])


if __name__ == "__main__":
    unittest.main()
