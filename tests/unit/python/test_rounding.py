"""Numbers that are 0 but for rounding are written 0, in every text of a picture or a page."""

import re
import types
import unittest

import numpy as np

from adit.compare import differences
from adit.plots import colour_pictures, deformation, lining_pictures, model_pictures, png
from adit.plots.drawing import Drawing, Panels
from adit.report import curves, overview, pictures, response
from adit.report.quantities import figure, place

from pieces import PictureTest, piece

TINY = re.compile(r"e-1\d|10⁻¹[⁰¹²³⁴-⁹]|[-−]0(\.0*)?\b(?!\.)")  # 4.441e-16, 4.441 × 10⁻¹⁶, -0.00


class Rounding(PictureTest):
    def assert_settled(self, *texts):
        for text in texts:
            self.assertNotRegex(str(text), TINY)

    def test_of_places_in_pictures(self):
        """A ring in a wide model, whose largest value is at x = 4.4e-16 m."""
        points = np.array([(4.441e-16, 5), (-1.332e-15, -5), (100, 0), (-100, -4e-16)])
        discs = piece(points, np.arange(4)[:, None], {"displacement_m": np.array([(0, 2e-3, 0), (0, 0, 0), (0, 1e-3, 0), (0, 0, 0)]),
                                                      "radius_m": np.ones(4), "weight": np.ones(4)})
        bonds = piece(points, [(0, 1), (2, 3)], {}, {"normal_force_N": np.array([-5e3, 1e3]), "state": np.zeros(2)})
        run = types.SimpleNamespace(name="ring", models=[], overlap=lambda: None)
        shown = colour_pictures.displacement(run, 1.0, {"particles": discs})
        self.assertIn("x = 0 m, y = 5 m", shown.notes[0][0])
        chains = png.figure(model_pictures.force_chains(run, 1.0, {"particles": discs, "bonds": bonds}))
        self.assert_settled(*(text for text, _ in shown.notes), *(text.get_text() for text in chains.legends[0].get_texts()))

    def test_of_motions_and_ranges(self):
        self.assert_settled(deformation.told(np.array([4.0, -1e-15])), lining_pictures._range(np.array([-3e-12, 5e3])))
        self.assertEqual(deformation.told(np.array([4.0, -1e-15])), ", without the common (4000, 0) mm")

    def test_of_curves_and_scales(self):
        def paint(axes):
            axes.plot([-1e-16, 1, 2], [-1.3e-15, 1, 2], label="top")
            axes.plot([0, 1, 2], [1e-16, 2e-16, -3e-16], label="bottom")
            axes.set(xlabel="t [s]", ylabel="displacement [mm]")
            return []

        drawn, _ = pictures.painted(Drawing("", "motion", Panels(1, 1, (8, 3)), paint))
        self.assert_settled(curves.as_table(drawn, "motion"))

    def test_of_figures_and_cracks(self):
        s = {"first_crack_x_m": 4.441e-16, "first_crack_y_m": -7.5, "peak_bond_force_x_m": 0.5, "peak_bond_force_y_m": -1.332e-15}
        self.assert_settled(place(4.441e-16, -1.332e-15), *(figure(s, key) for key in s), response._said("x_m", -1e-15))
        self.assertIn(">4.441 × 10⁻¹⁶ m<", figure({"opening_m": 4.441e-16}, "opening_m"))  # a result is no place
        run = types.SimpleNamespace(name="ring", summary=s, figures=s, number=s.get)
        self.assert_settled(*overview.lines([run]))

    def test_of_energies(self):
        table = {"time_s": np.array([0.0, 1.0]), "strain_J": np.array([0, 2e5]), "time_step_J": np.array([0, -5.8e-11])}
        told = response.energy(types.SimpleNamespace(figures={}, is_simplified=True, table=lambda name: table))
        self.assertIn("200 kJ", told)
        self.assertNotIn("time step", told)

    def test_of_differences(self):
        runs = [types.SimpleNamespace(name=name, summary=s, figures=s, number=s.get) for name, s in (
            ("one", {"first_crack_x_m": 4e-16, "peak_bond_force_N": 1e3}), ("other", {"first_crack_x_m": -4e-16, "peak_bond_force_N": 1e3 + 2e-13}))]
        self.assert_settled(*re.findall(r"<td[^>]*>(.*?)</td>", differences.chapter(runs)))


if __name__ == "__main__":
    unittest.main()
