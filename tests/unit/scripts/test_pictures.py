"""Pictures of results stay readable: titles, legends, scales and marks, for models that had spoiled them."""

import pathlib
import sys
import types
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "scripts"))

from adit import Piece, Table  # noqa: E402
from adit_plots import colour_pictures, deformation, model_pictures, style, time_pictures  # noqa: E402
from adit_report import pictures  # noqa: E402


def piece(points, cells, point_fields=None, cell_fields=None):
    found = object.__new__(Piece)
    found.points, found.cells = np.array(points, float), np.array(cells)
    found.point_fields, found.cell_fields = Table(point_fields or {}, "piece"), Table(cell_fields or {}, "piece")
    return found


def column(displacement, width=2.0, height=50.0, zones=25, **cell_fields):
    """A grid of one zone by many, with a displacement (n, 2) that follows from the points."""
    y = np.linspace(-height, 0, zones + 1)
    points = np.column_stack([np.tile([0, width], zones + 1), np.repeat(y, 2)])
    cells = [(2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2) for k in range(zones)]
    moved = np.column_stack([displacement(points), np.zeros(len(points))])
    return piece(points, cells, {"displacement_m": moved}, {"weight": np.ones(zones), **cell_fields})


def cloud(points, displacement):
    """Particles with their displacements."""
    count = len(points)
    return piece(points, np.arange(count)[:, None], {
        "displacement_m": np.column_stack([displacement, np.zeros(count)]), "radius_m": np.full(count, 0.05), "weight": np.ones(count)})


def run_named(name):
    return types.SimpleNamespace(name=name, overlap=lambda: None)


def box_of(figure, artist):
    figure.canvas.draw()
    return artist.get_window_extent()


class Titles(unittest.TestCase):
    def test_a_title_stays_on_the_sheet_of_a_tall_model(self):
        grid = column(lambda points: 0.075 + 1e-3 * points[:, 1:] ** 2)
        for figure in (model_pictures.deformed(run_named("hysteretic"), 25.0, {"grid": grid}),
                       colour_pictures.displacement(run_named("a_scene_of_a_rather_long_name"), 25.0, {"grid": grid})):
            title = figure.axes[0].title if figure.axes[0].get_title() else figure.axes[0]._left_title
            box = box_of(figure, title)
            self.assertLess(box.x1, figure.bbox.x1)
            self.assertLess(box.y1, figure.bbox.y1)


class Displacements(unittest.TestCase):
    def test_a_motion_that_all_points_share_is_taken_off(self):
        bent = lambda points: 1e-3 * (points[:, 1:] / 50) ** 2  # noqa: E731
        at_rest, shaken = column(bent), column(lambda points: 4 + bent(points))
        self.assertGreaterEqual(deformation.scale_of({"grid": shaken}), deformation.scale_of({"grid": at_rest}))
        self.assertAlmostEqual(deformation.common_motion({"grid": shaken})[0], 4, delta=1e-3)
        figure = model_pictures.deformed(run_named("shaken"), 1.0, {"grid": shaken})
        left, right = figure.axes[0].get_xlim()
        self.assertLess(right - left, 20, "4 m times the scale would be kilometres")
        self.assertIn("without the common (4000, 0) mm", figure.axes[0].get_title(loc="left").replace("\n", " "))

    def test_a_model_that_is_held_shows_all_of_its_displacement(self):
        held = column(lambda points: 1e-2 * (points[:, 1:] + 50) / 50)
        np.testing.assert_array_equal(deformation.common_motion({"grid": held}), (0, 0))

    def test_a_loose_grain_does_not_set_the_scale(self):
        places = np.array([(x, y) for x in range(30) for y in range(30)], float) / 10
        displacement = np.column_stack([1e-3 * places[:, 0], np.zeros(900)])
        whole = cloud(places, displacement)
        displacement[450] = 0, -5.2
        loose = cloud(places, displacement)
        self.assertEqual(deformation.scale_of({"particles": loose}), deformation.scale_of({"particles": whole}))
        figure = model_pictures.deformed(run_named("ring"), 1.0, {"particles": loose})
        self.assertLess(np.ptp(figure.axes[0].get_ylim()), 4)
        self.assertIn("1 loose particle", " ".join(text.get_text() for text in figure.legends[0].get_texts()))


class Colours(unittest.TestCase):
    def marked(self, figure):
        return next(text.get_text() for text in figure.texts if "○" in text.get_text())

    def test_tension_is_marked_and_not_the_largest_magnitude(self):
        stress = np.zeros((25, 3))
        stress[:, :2] = -0.228e6  # compression everywhere but in one zone
        stress[7, 0] = 0.17e6
        figure = colour_pictures.principal_stress(run_named("ring"), 1.0, {"grid": column(lambda p: 0 * p[:, :1], stress_Pa=stress)})
        self.assertRegex(self.marked(figure), r"^○ 0\.17 MPa at x = 1 m, y = -35 m$")

    def test_light_zones_set_no_scale_and_no_mark(self):
        weight, strain = np.ones(25), np.full(25, 0.012)
        weight[3], strain[3] = 0.002, 0.67
        grid = column(lambda p: 0 * p[:, :1], peak_shear_strain=strain)
        grid.cell_fields["weight"] = weight
        (_, figure), = colour_pictures.peaks(run_named("fault"), 1.0, {"grid": grid})
        self.assertIn("○ 12 10⁻³", self.marked(figure))

    def test_a_field_of_zeros_has_a_scale_of_one_tick(self):
        figure = colour_pictures.displacement(run_named("rest"), 1.0, {"grid": column(lambda points: 0 * points[:, :1])})
        self.assertEqual(list(figure.axes[1].get_yticks()), [0])

    def test_a_loose_grain_leaves_the_scale_to_the_others(self):
        values = np.append(np.linspace(0, 0.01, 999), 5.2)
        self.assertLess(colour_pictures._range(values)[1], 0.0101)

    def test_rounding_of_the_weight_is_no_overlap(self):
        grid = column(lambda points: 0 * points[:, :1])
        grid.cell_fields["weight"] = np.full(25, 1 - 2.2e-16)
        figure = model_pictures.deformed(run_named("hzm"), 1.0, {"grid": grid})
        self.assertNotIn("overlap", [text.get_text() for text in figure.legends[0].get_texts()])


class Times(unittest.TestCase):
    def run_with(self, columns, end):
        time = np.linspace(0, end, 200)
        return types.SimpleNamespace(name="ring", histories={"time_s": time} | {name: np.sin(k + time) for k, name in enumerate(columns)})

    def test_legends_of_panels_do_not_print_over_each_other(self):
        names = [f"place_{k}_{ending}" for ending in ("ux_m", "vx_m_per_s", "sxx_Pa") for k in range(15)]
        figure = time_pictures.histories(self.run_with(names, 30))
        boxes = [box_of(figure, axes.get_legend()) for axes in figure.axes]
        self.assertEqual([len(axes.get_legend().get_texts()) for axes in figure.axes], [time_pictures.MOST_LINES] * 3)
        for upper, lower in zip(boxes, boxes[1:]):
            self.assertGreaterEqual(upper.y0, lower.y1)
        self.assertLessEqual(max(box.x1 for box in boxes), figure.bbox.x1)

    def test_long_runs_are_drawn_in_seconds_and_short_ones_in_milliseconds(self):
        for end, label, shown in ((30, "t [s]", 30), (0.05, "t [ms]", 50)):
            axes = time_pictures.histories(self.run_with(["tip_ux_m"], end)).axes[0]
            self.assertEqual((axes.get_xlabel(), round(axes.get_xlim()[1], 9)), (label, shown))

    def test_energies_that_are_small_beside_the_work_have_a_panel_of_their_own(self):
        run = self.run_with([], 30)
        rise = run.histories["time_s"]
        run.histories |= {"continuum_external_work_J": 5e6 * rise, "continuum_dissipated_J": 4.99e6 * rise,
                          "continuum_kinetic_J": 4e3 * rise, "continuum_strain_J": 1e3 * rise, "energy_drift": 0 * rise}
        work, stored, _ = time_pictures.energy(run).axes
        self.assertEqual((work.get_ylabel(), stored.get_ylabel()), ("put in and lost [MJ]", "stored [kJ]"))
        self.assertGreater(stored.get_ylim()[1], 100)


class Pages(unittest.TestCase):
    def test_panels_stand_below_each_other_with_both_of_their_axes(self):
        figure, (left, right) = style.plt.subplots(1, 2, figsize=(10, 3))
        other = right.twinx()
        other.set_ylabel("cracks")
        pictures._fit(figure)
        figure.canvas.draw()
        self.assertEqual(other.get_position().bounds, right.get_position().bounds)
        self.assertGreater(left.get_position().y0, right.get_position().y1)
        self.assertGreater(left.get_position().height, 0.3)


if __name__ == "__main__":
    unittest.main()
