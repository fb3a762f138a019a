"""Cracks between cells are as wide as the halves of a torn specimen are apart, in every file, picture and page that tells of them."""

import unittest

import numpy as np

from figures.computed import ComputedTest, told_report
from adit.plots import crack_pictures, png, style

WIDTH, HEIGHT, SIZE = 0.1, 0.2, 0.02  # [m]
SPEED, DURATION = 0.04, 20e-3  # of the upper platen [m/s], [s]
APART = SPEED * DURATION  # twenty times the width G_f / f_t by which the strength decays
PLATENS = {"lower": {"y_max": 0.0}, "upper": {"y_min": HEIGHT}}
GLUE = {"fracture": {"tensile_strength": 100e6, "fracture_energy": 1e6, "compressive_strength": 1e9}}
SPECIMEN = {
    "plane": "plane_stress",
    "material": {"young_modulus": 30e9, "poisson_ratio": 0.2, "density": 2400.0,
                 "fracture": {"tensile_strength": 2.5e6, "fracture_energy": 100.0, "compressive_strength": 39e6}},
    "time": {"duration": DURATION},
    "particles": {
        "cells": {"x_min": 0.0, "x_max": WIDTH, "y_min": -SIZE, "y_max": HEIGHT + SIZE, "size": SIZE},
        "groups": [{"name": "body", "where": {"y_min": 0.0, "y_max": HEIGHT}}, *({"name": name, "where": where} for name, where in PLATENS.items())],
        "between": [{"first": "body", "second": name, "bonds": GLUE} for name in PLATENS],
        "motions": [{"where": where, "velocity": {"x": 0.0, "y": SPEED if name == "upper" else 0.0}} for name, where in PLATENS.items()],
        "damping": {"viscous": 200.0},
        "histories": [{"name": "all", "quantity": "crack_width", "at": {"x": WIDTH / 2, "y": HEIGHT / 2}, "radius": HEIGHT},
                      {"name": "upper", "quantity": "crack_width", "group": "upper"}]},
    "output": {"field_times": [DURATION], "history_interval": 1e-4}}
NEAR = 0.02 * APART  # the halves turn a little against each other, and bear what is left of the strength


class CrackWidths(ComputedTest):
    def setUp(self):
        super().setUp()
        self.computed(SPECIMEN)
        self.fields = self.run.fields()
        self.cracks = self.fields["cracks"]
        cells = self.fields["cells"]
        middle = cells.points[cells.cells].mean(axis=1)
        body = [cells["fragment"][np.argmax(sign * middle[:, 1])] for sign in (-1, 1)]
        self.assertNotEqual(*body, "the specimen is torn")

    def across(self):
        """Which cracks lie between the halves: their two cells have left each other."""
        return np.hypot(self.cracks["opening_m"], self.cracks["slip_m"]) > APART / 2

    def test_faces_are_as_far_apart_as_the_platens(self):
        """A facet across the way of the halves opens by the cosine of its inclination, and slips by the sine."""
        across = self.across()
        self.assertGreaterEqual(across.sum(), WIDTH / SIZE)
        ends = self.cracks.points[self.cracks.cells[across]]
        along = ends[:, 1] - ends[:, 0]
        cosine, sine = np.abs(along.T) / np.hypot(*along.T)
        np.testing.assert_allclose(self.cracks["opening_m"][across], APART * cosine, atol=NEAR)
        np.testing.assert_allclose(np.abs(self.cracks["slip_m"][across]), APART * sine, atol=NEAR)

    def test_the_longest_path_crosses_the_specimen(self):
        paths, path = self.run.crack_paths, self.cracks["path"]
        self.assertEqual(set(path[self.across()]), {1})
        first = path == 1
        x = self.cracks.points[self.cracks.cells[first], 0]
        self.assertAlmostEqual(x.min(), 0, delta=1e-12)
        self.assertAlmostEqual(x.max(), WIDTH, delta=1e-12)
        self.assertEqual(list(paths["path"]), list(range(1, len(paths["path"]) + 1)))
        for number, row in enumerate(paths["path"]):
            ends = self.cracks.points[self.cracks.cells[path == row]]
            told = {"cracks": np.sum(path == row), "length_m": np.hypot(*(ends[:, 1] - ends[:, 0]).T).sum(),
                    "opening_m": self.cracks["opening_m"][path == row].max(), "slip_m": np.abs(self.cracks["slip_m"][path == row]).max()}
            for name, value in told.items():
                self.assertAlmostEqual(paths[name][number], value, delta=1e-9 * value, msg=name)
        self.assertEqual(paths["mode"][0], "tensile")

    def test_histories_and_summary_tell_the_widest(self):
        widest = self.cracks["opening_m"].max()
        self.assertAlmostEqual(widest, APART, delta=NEAR)
        width, summary = self.run.histories["all_crack_width_m"], self.run.summary
        self.assertEqual(width[-1], widest)
        self.assertEqual(width[0], 0)
        self.assertLessEqual(self.run.histories["upper_crack_width_m"].max(), NEAR, "the platen's own cells stay together")
        largest, row = width.max(), width.argmax()
        self.assertEqual((summary["largest_crack_width_m"], summary["largest_crack_width_time_s"]), (largest, self.time[row]))
        place = self.cracks.points[self.cracks.cells].mean(axis=1)[self.cracks["opening_m"].argmax()]
        np.testing.assert_allclose([summary["largest_crack_width_x_m"], summary["largest_crack_width_y_m"]], place, atol=1e-12)
        paths = self.run.crack_paths
        self.assertEqual(summary["crack_path_count"], len(paths["path"]))
        for name, column in (("m", "length_m"), ("opening_m", "opening_m"), ("slip_m", "slip_m"), ("mode", "mode"), ("x_m", "x_m"), ("y_m", "y_m")):
            self.assertEqual(summary[f"longest_crack_path_{name}"], paths[column][0], name)

    def test_bonds_and_cracks_tell_the_same(self):
        bonds = self.fields["bonds"]
        broken = bonds["state"] > 0
        self.assertEqual((broken.sum(), len(self.cracks.cells)), (self.run.summary["crack_count"] + self.run.summary["debonded_count"],) * 2)
        for name in ("opening_m", "slip_m"):
            np.testing.assert_array_equal(np.sort(bonds[name][broken]), np.sort(self.cracks[name]))

    def test_a_picture_shows_cells_and_widths(self):
        drawing = crack_pictures.cracks(self.run, DURATION, self.fields)
        self.assertIn(f"open by {1e3 * self.cracks['opening_m'].max():.3g} mm at most", drawing.title)
        figure = png.figure(drawing)
        self.addCleanup(style.plt.close, figure)
        axes = figure.axes[0]
        drawn = [path.vertices for path in axes.collections[0].get_paths()]
        self.assertEqual(len(drawn), self.run.summary["particles"])
        self.assertAlmostEqual(max(corners[:, 0].max() for corners in drawn), WIDTH, delta=1e-12)
        legend = [text.get_text() for text in figure.legends[0].get_texts()]
        self.assertIn("0.5 to 1 mm", legend)
        widths = sorted({line.get_linewidth() for line in axes.lines if len(line.get_xdata()) > 1})
        self.assertEqual(widths[-1], crack_pictures.WIDTHS[3])
        text, _ = told_report(self, self.run)
        self.assertIn("crack_paths.csv", text)


if __name__ == "__main__":
    unittest.main()
