"""Numbers that are 0 but for rounding are written 0, in every text of a picture or a page."""

import re
import types
import unittest

import numpy as np

from adit.compare import differences
from adit.plots import colour_pictures, deformation, lining_pictures, model_pictures, png, time_pictures
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

    def test_of_histories(self):
        """Beside the largest of the same dimension at any place, a moment beside a force."""
        time = np.linspace(0, 1, 50)
        series = {"face_opening_m": 5e-4, "wall_ux_m": 1e-17, "top_ux_m": 1e-9, "wall_sxx_Pa": -5e5, "wall_effective_sxx_Pa": 1e-10,
                  "l_thrust_N": -1e6, "l_moment_Nm": 1e-9, "l_exx": 1e-4, "l_eyy": 1e-18, "l_vx_m_per_s": 1e-12}
        histories = {"time_s": time} | {name: size * np.sin(9 * time) for name, size in series.items()}
        run = types.SimpleNamespace(name="ring", models=[], histories=histories)
        lines = {name: values for _, lines in time_pictures.quantities_of(run).values() for name, values in lines}
        zero = {name for name, values in lines.items() if not values.any()}
        self.assertEqual(zero, {"wall_ux_m", "wall_effective_sxx_Pa", "l_moment_Nm", "l_eyy"})
        for name in ("top_ux_m", "l_vx_m_per_s", "wall_sxx_Pa"):
            np.testing.assert_array_equal(lines[name], run.histories[name])

        for size, moves in ((8e-17, False), (1e-13, True)):  # alone: beside a coordinate of 1 m
            run.histories = {"time_s": time, "wall_ux_m": size * time}
            (_, ((_, values),)), = time_pictures.quantities_of(run).values()
            self.assertEqual(values.any(), moves)

    def test_of_interfaces(self):
        """An offset beside the opening, and both beside the displacements of the zones; stresses likewise."""
        names = [name for name, *_ in lining_pictures.OF_INTERFACES]
        fields = dict(zip(names, ([-5e5, -5e5], [1e-10, -2e-10], [4.8e-4, 4.8e-4], [-1.7e-17, 8e-18])))
        tiny = dict(zip(names, ([1e-10, 2e-10], [1e-10, 2e-10], [1e-17, 2e-17], [1e-17, 2e-17])))
        grid = piece([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2, 3)], {"displacement_m": np.full((4, 3), 1e-3)},
                     {"stress_Pa": np.full((1, 3), -1e5)})
        run = types.SimpleNamespace(name="ring", models=[])
        for values, drawn in ((fields, [True, False, True, False]), (tiny, 4 * [False])):
            faces = piece([(0, 0), (3, 0)], [(0, 1)], {name: np.array(each) for name, each in values.items()},
                          {"interface": np.zeros(1)})
            figure = png.figure(lining_pictures.interfaces(run, 1.0, {"interfaces": faces, "grid": grid}))
            curves = [axes.collections[1].get_paths()[0].vertices[:, 1] for axes in figure.axes]
            self.assertEqual([np.abs(curve).max() > 0.1 for curve in curves], drawn)
            self.assert_settled(*(axes.get_title(loc="left") for axes in figure.axes))

    def test_of_fields(self):
        """A principal stress beside the other one, displacements beside the common motion, a ratio beside 1: all are 0 everywhere."""
        turn = np.linspace(0, np.pi, 60)
        axis = np.column_stack([np.cos(turn) ** 2, np.sin(turn) ** 2, np.cos(turn) * np.sin(turn)])
        places = np.column_stack([np.arange(60.0), np.zeros(60)])
        moved = np.column_stack([4 + 4e-16 * np.arange(60), np.zeros((60, 2))])
        discs = piece(places, np.arange(60)[:, None], {
            "displacement_m": moved, "stress_Pa": -3e6 * axis, "pressure_ratio": 1e-15 * np.sin(turn), "radius_m": np.ones(60), "weight": np.ones(60)})
        run = types.SimpleNamespace(name="ring", models=[], overlap=lambda: None)
        for size, told in ((1e-16, "0 mm everywhere"), (1e-10, "○ 1e-07 mm at x = 59 m, y = 0 m")):  # the latter of a small wave
            rest = piece(places, np.arange(60)[:, None], {
                "displacement_m": size * np.outer(places[:, 0] / 59, (1, 0, 0)), "radius_m": np.ones(60), "weight": np.ones(60)})
            self.assertEqual(colour_pictures.displacement(run, 1.0, {"particles": rest}).notes[0][0], told)
        for draw, told in ((colour_pictures.principal_stress, "0 MPa"), (colour_pictures.displacement, "0 mm"),
                           (colour_pictures.pressure_ratio, "0 of the effective vertical pressure")):
            self.assertEqual(draw(run, 1.0, {"particles": discs}).notes[0][0], f"{told} everywhere")

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
