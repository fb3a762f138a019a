"""Pictures of deformed models: one factor of all displacements of a run, with which nothing folds."""

import math
import types
import unittest

import numpy as np

from adit.plots import deformation

from pieces import piece


def annulus(inner, outer, displacement, slices=32, rings=12):
    """Zones around an opening, with a displacement (n, 2) that follows from the points."""
    radius, angle = np.geomspace(inner, outer, rings + 1), 2 * np.pi * np.arange(slices) / slices
    points = np.array([(r * math.cos(a), r * math.sin(a)) for r in radius for a in angle])
    cells = [(k * slices + i, (k + 1) * slices + i, (k + 1) * slices + (i + 1) % slices, k * slices + (i + 1) % slices)
             for k in range(rings) for i in range(slices)]
    moved = np.column_stack([displacement(points), np.zeros(len(points))])
    return piece(points, cells, {"displacement_m": moved}, {"weight": np.ones(len(cells))})


def signed_areas(points, cells):
    """Twice the area of the triangle at each corner of each zone."""
    corners = points[cells]
    after, before = np.roll(corners, -1, axis=1) - corners, np.roll(corners, 1, axis=1) - corners
    return after[..., 0] * before[..., 1] - after[..., 1] * before[..., 0]


def closing(points):
    """The convergence of an opening of 5 m radius by 7 mm in wide ground, all of which settles by 2 mm at its far edge."""
    return -7e-3 * 5 * points / np.sum(points**2, axis=1, keepdims=True)


class Factors(unittest.TestCase):
    def test_no_zone_folds_and_no_opening_turns_inside_out(self):
        """Ground far wider than its opening, whose size alone would give a factor of 1000."""
        ground = annulus(5, 50, closing)
        scale = deformation.scale_of([deformation.largest_factor({"grid": ground})])
        self.assertEqual(scale, 200)  # 0.4 / (7e-3 / 5) = 286
        moved = ground.moved(scale)
        self.assertGreater((signed_areas(moved, ground.cells) / signed_areas(ground.points, ground.cells)).min(), 0.3)
        self.assertGreater(np.hypot(*moved.T).min(), 0.5 * 5)

    def test_no_intact_bond_folds_and_broken_ones_do_not_count(self):
        along = np.arange(10.0)
        for state, expected in ((0, 20), (1, 50)):  # of 0.4 / 0.01 and of 90 cm / 1 cm
            moved = np.where(along < 5, 0, 1e-2)  # the fifth bond opens by 1 cm
            bonds = piece(np.column_stack([along, 0 * along]), [(k, k + 1) for k in range(9)],
                          {"displacement_m": np.column_stack([moved, 0 * along, 0 * along])},
                          {"state": np.where(np.arange(9) == 4, state, 0)})
            discs = piece(bonds.points, np.arange(10)[:, None], dict(bonds.point_fields))
            factor = deformation.largest_factor({"particles": discs, "bonds": bonds})
            self.assertEqual(deformation.scale_of([factor]), expected)

    def test_rotation_bounds_nothing(self):
        turned = annulus(5, 50, lambda points: 1e-4 * points[:, ::-1] * (-1, 1))
        self.assertAlmostEqual(deformation.largest_factor({"grid": turned}), deformation.REACH * 100 / (1e-4 * 50))

    def test_light_zones_bound_nothing(self):
        ground = annulus(5, 50, closing)
        ground.cell_fields["weight"] = np.where(np.hypot(*ground.points[ground.cells].mean(axis=1).T) < 10, 1e-3, 1.0)
        self.assertGreater(deformation.largest_factor({"grid": ground}), 2 * 286)

    def test_a_run_has_one_factor(self):
        """That of its largest deformation: an instant at rest does not count."""
        instants = [{"grid": annulus(5, 50, lambda points, share=share: share * closing(points))} for share in (0, 0.1, 1, 0.5)]
        run = types.SimpleNamespace(instants=instants, pieces_at=lambda number: instants[number])
        self.assertEqual(deformation.scale_of_run(run), 200)
        run.instants = instants[:1]
        self.assertEqual(deformation.scale_of_run(run), 1)

    def test_instants_that_are_read_are_not_read_again(self):
        instants = [{"grid": annulus(5, 50, lambda points, share=share: share * closing(points))} for share in (1, 0.5)]
        run = types.SimpleNamespace(instants=instants, pieces_at=lambda number: {1: instants[1]}[number])
        self.assertEqual(deformation.scale_of_run(run, {0: instants[0]}), 200)


if __name__ == "__main__":
    unittest.main()
