"""Cells are drawn as the polygons that they are, and their cracks as wide as they stand open."""

import types
import unittest

import numpy as np

from adit import Piece
from adit.plots import colour_pictures, crack_pictures, model_pictures, png, style
from adit.plots.particle_shapes import Shapes
from adit.results.pieces import _cells

from pieces import PictureTest, piece

# A triangle, a square and a pentagon side by side; the second particle of four was taken away.
TRIANGLE, SQUARE, PENTAGON = [(0, 0), (1, 0), (0, 1)], [(1, 0), (2, 0), (2, 1), (1, 1)], [(2, 0), (3, 0), (3.5, 0.5), (3, 1), (2, 1)]
RUN = types.SimpleNamespace(name="wall", overlap=lambda: None, models=[("particles", {"groups": [{"name": "lining"}]})])


def pieces(displacement=(0, 0)):
    corners = np.array(TRIANGLE + SQUARE + PENTAGON, float)
    cells = piece(corners, _cells(np.arange(12), np.array([3, 7, 12])), {
        "displacement_m": np.tile([*displacement, 0], (12, 1))})
    discs = piece([(0.3, 0.3), (1.2, 0.9), (1.5, 0.5), (2.7, 0.5)], [[0], [2], [3]], {
        "displacement_m": np.tile([*displacement, 0], (4, 1)), "radius_m": np.full(4, 0.2), "weight": np.ones(4), "group": np.array([0, 1, 0, 1]),
        "stress_Pa": np.array([(1e6, 0, 0), (9e6, 0, 0), (2e6, 0, 0), (3e6, 0, 0)])})
    bonds = piece(discs.points, [(0, 2), (2, 3)], {}, {"state": np.array([1, 2]), "normal_force_N": np.ones(2)})
    return {"particles": discs, "cells": cells, "bonds": bonds}


def outlines(collection):
    """The corners of each polygon, each once."""
    return [list(dict.fromkeys(map(tuple, path.vertices.tolist()))) for path in collection.get_paths()]


class Polygons(PictureTest):
    def test_polygons_of_different_numbers_of_corners_repeat_their_last(self):
        np.testing.assert_array_equal(_cells(np.array([5, 6, 7, 1, 2, 3, 4]), np.array([3, 7])), [(5, 6, 7, 7), (1, 2, 3, 4)])
        np.testing.assert_array_equal(_cells(np.array([5, 6, 7, 8]), np.array([2, 4])), [(5, 6), (7, 8)])

    def test_polygons_of_several_regions_are_joined(self):
        three = piece(TRIANGLE, [(0, 1, 2)])
        whole = Piece.joined([three, pieces()["cells"]])
        self.assertEqual(whole.cells.shape, (4, 5))
        np.testing.assert_array_equal(whole.points[whole.cells[0]], [*TRIANGLE, TRIANGLE[-1], TRIANGLE[-1]])
        np.testing.assert_array_equal(whole.points[whole.cells[3]], PENTAGON)

    def test_a_deformed_model_has_its_polygons_where_they_are(self):
        figure = png.figure(model_pictures.deformed(RUN, 1.0, pieces((0.1, 0.2)) | {"grid": piece([(0, -1), (3, -1), (3, 0), (0, 0)], [(0, 1, 2, 3)])}, 2))
        polygons = next(each for each in figure.axes[0].collections if len(each.get_paths()) == 3)
        np.testing.assert_allclose(outlines(polygons)[2], np.array(PENTAGON) + (0.2, 0.4))
        self.assertIn("particles: lining", [text.get_text() for text in figure.legends[0].get_texts()])

    def test_each_polygon_has_the_colour_of_its_particle(self):
        figure = png.figure(colour_pictures.principal_stress(RUN, 1.0, pieces()))
        drawn = figure.axes[0].collections[0]
        self.assertEqual(outlines(drawn), [[tuple(map(float, corner)) for corner in shape] for shape in (TRIANGLE, SQUARE, PENTAGON)])
        np.testing.assert_allclose(drawn.get_array(), (1, 2, 3))

    def test_where_some_regions_have_no_polygons_all_are_discs(self):
        shapes = Shapes(Piece.joined([pieces()["particles"]] * 2), pieces()["cells"])
        _, axes = style.plt.subplots()
        self.assertEqual(len(shapes.add(axes, shapes.there).get_offsets()), 6)


class Cracks(PictureTest):
    def drawn(self, opening, state=(1, 2), debonded=(0, 0)):
        found = pieces()
        found["cracks"] = piece([(1, 0), (1, 1), (2, 0), (2, 1)], [(0, 1), (2, 3)], {}, {
            "state": np.array(state), "opening_m": 1e-3 * np.array(opening), "debonded": np.array(debonded)})
        drawing = crack_pictures.cracks(RUN, 1.0, found)
        figure = png.figure(drawing)
        lines = {tuple(line.get_xdata()[:1]): line for line in figure.axes[0].lines if len(line.get_xdata()) > 1}
        return drawing.title, [text.get_text() for text in figure.legends[0].get_texts()], [lines[x,] for x in (1, 2)]

    def test_a_crack_is_as_wide_as_its_class(self):
        title, legend, (fine, wide) = self.drawn((0.05, 0.3))
        self.assertEqual(title, "2 cracks, open by 0.3 mm at most, at t = 1 s")
        self.assertEqual((fine.get_linewidth(), wide.get_linewidth()), (crack_pictures.WIDTHS[0], crack_pictures.WIDTHS[2]))
        self.assertEqual(legend[-5:], ["1 tensile crack", "1 shear crack", "open by less than 0.1 mm", "0.2 to 0.5 mm", "widest: 0.3 mm at (2, 0.5) m"])
        self.assertEqual((fine.get_color(), wide.get_color()), (style.RED, style.BLUE))
        self.assertGreater(wide.get_zorder(), fine.get_zorder())

    def test_the_widest_class_has_no_end(self):
        _, legend, (_, wide) = self.drawn((0.05, 300))
        self.assertIn("more than 10 mm", legend)
        self.assertEqual(wide.get_linewidth(), crack_pictures.WIDTHS[-1])

    def test_debonded_facets_are_no_cracks(self):
        title, legend, (_, debonded) = self.drawn((0, 0), debonded=(0, 1))
        self.assertEqual(title, "1 crack at t = 1 s")
        self.assertIn("1 debonded facet", legend)
        self.assertEqual(debonded.get_color(), style.ORANGE)

    def test_a_body_without_cracks_says_so(self):
        self.assertEqual(crack_pictures.cracks(RUN, 1.0, pieces()).title, "no cracks at t = 1 s")

    def test_bonds_of_cells_are_drawn_as_cracks_and_those_of_discs_as_bonds(self):
        found = pieces()
        self.assertIsNone(model_pictures.bonds(RUN, 1.0, found))
        del found["cells"]
        self.assertIsNone(crack_pictures.cracks(RUN, 1.0, found))
        self.assertIsNotNone(model_pictures.bonds(RUN, 1.0, found))


if __name__ == "__main__":
    unittest.main()
