"""Pictures of results stay readable: titles, legends, scales and marks, for models that had spoiled them."""

import pathlib
import re
import types
import unittest

import numpy as np
from matplotlib.colors import to_rgb

from adit import Table
from adit.plots import (colour_pictures, deformation, lining_pictures, model_pictures, particle_groups, png, spectra_pictures, style,
                        time_pictures, tunnel_pictures)
from adit.plots.colour_scale import Scale
from adit.plots.drawing import Drawing, Panels, legend
from adit.plots.particle_shapes import Shapes
from adit.plots.setup import conditions, sheets
from adit.plots.setup.checked import Member
from adit.report import around, computed, model, overview, pictures, response

from pieces import PictureTest, piece


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


def run_named(name, *models):
    return types.SimpleNamespace(name=name, overlap=lambda: None, models=[("particles", model) for model in models])


def texts_of(legend):
    return [text.get_text() for text in legend.get_texts()]


def box_of(figure, artist):
    figure.canvas.draw()
    return artist.get_window_extent()


class WholeTunnels(PictureTest):
    def test_of_ground_that_liquefies_the_pressure_and_the_uplift_are_shown(self):
        columns = ["axial_force_{}_N", "moment_lateral_{}_N_m", "moment_vertical_{}_N_m", "shear_lateral_{}_N", "uplift_{}_m", "pressure_ratio_{}"]
        values = {"chainage_m": np.arange(3.0), **{name.format(end): np.full(3, 0.5) for name in columns for end in ("min", "max")}}

        def labels(table):
            run = types.SimpleNamespace(name="tube", folder="tube", has=lambda name: name == "envelopes.csv", table=lambda name: table)
            return [axes.get_ylabel() for axes in png.figure(tunnel_pictures.envelopes(run)).axes[1:]]

        self.assertEqual(labels(values), ["axial force [N]", "vertical moment [N m]", "uplift [m]", "pressure ratio"])
        sound = {name: column for name, column in values.items() if not name.startswith(("uplift", "pressure"))}
        self.assertEqual(labels(sound), ["axial force [N]", "lateral moment [N m]", "lateral shear [N]"])


class Titles(PictureTest):
    def test_a_title_stays_on_the_sheet_of_a_tall_model(self):
        grid = column(lambda points: 0.075 + 1e-3 * points[:, 1:] ** 2)
        for drawing in (model_pictures.deformed(run_named("hysteretic"), 25.0, {"grid": grid}, 10),
                        colour_pictures.displacement(run_named("a_scene_of_a_rather_long_name"), 25.0, {"grid": grid})):
            figure = png.figure(drawing)
            title = figure.axes[0].get_title(loc="left")
            box = box_of(figure, next(text for text in figure.axes[0].get_children() if getattr(text, "get_text", str)() == title))
            self.assertLess(box.x1, figure.bbox.x1)
            self.assertLess(box.y1, figure.bbox.y1)


class Sizes(PictureTest):
    """A drawing has no size: files and pages choose it."""

    def test_a_file_and_a_page_show_the_same_data(self):
        grid = column(lambda points: 1e-3 * points[:, 1:] ** 2, width=50.0)
        discs = cloud([(1, -1), (2, -2)], np.array([(1e-3, 0), (2e-3, 0)]))
        drawing = colour_pictures.displacement(run_named("site"), 1.0, {"grid": grid, "particles": discs})
        wide, (narrow, _) = png.figure(drawing), pictures.painted(drawing)
        self.assertGreater(wide.get_figwidth(), 1.5 * narrow.get_figwidth())
        for axes, other in zip(wide.axes[:1], narrow.axes[:1]):
            self.assertEqual((axes.get_xlim(), axes.get_ylim()), (other.get_xlim(), other.get_ylim()))
            self.assertEqual(len(axes.collections), len(other.collections))
            for one, same in zip(axes.collections, other.collections):
                np.testing.assert_array_equal(one.get_array(), same.get_array())
            np.testing.assert_array_equal(axes.get_lines()[0].get_xydata(), other.get_lines()[0].get_xydata())

    def test_a_model_has_equal_scales_in_both_sizes(self):
        """A flat model and a tall one, whose sheets are wider than they are."""
        for width, height in ((50.0, 2.0), (2.0, 50.0)):
            drawing = colour_pictures.displacement(run_named("site"), 1.0, {"grid": column(
                lambda points: 1e-3 * points[:, 1:], width=width, height=height)})
            for figure in (png.figure(drawing), pictures.painted(drawing)[0]):
                figure.canvas.draw()
                axes, bar = figure.axes
                box = axes.get_window_extent()
                self.assertAlmostEqual(box.width / np.ptp(axes.get_xlim()) / (box.height / np.ptp(axes.get_ylim())), 1)
                self.assertAlmostEqual(bar.get_window_extent().height, box.height)
                self.assertGreater(bar.get_window_extent().x0, box.x1)

    def test_a_page_writes_title_legends_and_notes_as_text(self):
        def paint(axes):
            axes.plot([0, 1, 2], [0, 1, 4], "--", lw=2, label=r"top\$1")
            axes.set(xlabel="t [s]", ylabel="force [N]")
            return [legend(axes)]

        drawing = Drawing("bar", "forces of a$b", Panels(1, 1, (8, 3)), paint, (("○ 4 N", style.RED), ("", style.BLACK)))
        written = pictures.figure(drawing)
        self.assertIn("<strong>Forces of a$b</strong>", written)
        self.assertIn("<strong>bar: Forces of a$b</strong>", pictures.figure(drawing, names_run=True))
        self.assertIn('<p class="note">○ 4 N</p></figcaption>', written)
        self.assertRegex(written, r'stroke-width="2.8" stroke-dasharray="14.8,6.4"/></svg> top\$1')  # 3.7 and 1.6 widths of 2 points, twice as large
        figure, _ = pictures.painted(drawing)
        self.assertEqual([figure.axes[0].get_title(loc="left"), figure.axes[0].get_legend(), figure.texts], ["", None, []])
        filed = png.figure(drawing)
        self.assertEqual(filed.axes[0].get_title(loc="left"), r"bar: forces of a\$b")
        self.assertEqual(texts_of(filed.axes[0].get_legend()), [r"top\$1"])


class Displacements(PictureTest):
    def test_a_motion_that_all_points_share_is_taken_off(self):
        bent = lambda points: 1e-3 * (points[:, 1:] / 50) ** 2  # noqa: E731
        at_rest, shaken = column(bent), column(lambda points: 4 + bent(points))
        self.assertGreaterEqual(deformation.largest_factor({"grid": shaken}), deformation.largest_factor({"grid": at_rest}))
        self.assertAlmostEqual(deformation.common_motion({"grid": shaken})[0], 4, delta=1e-3)
        drawing = model_pictures.deformed(run_named("shaken"), 1.0, {"grid": shaken}, 1000)
        left, right, _, _ = drawing.layout.bounds
        self.assertLess(right - left, 20, "4 m times the scale would be kilometres")
        self.assertIn("without the common (4000, 0) mm", drawing.title)

    def test_a_model_that_is_held_shows_all_of_its_displacement(self):
        held = column(lambda points: 1e-2 * (points[:, 1:] + 50) / 50)
        np.testing.assert_array_equal(deformation.common_motion({"grid": held}), (0, 0))

    def test_a_loose_grain_does_not_set_the_scale(self):
        places = np.array([(x, y) for x in range(30) for y in range(30)], float) / 10
        displacement = np.column_stack([1e-3 * places[:, 0], np.zeros(900)])
        whole = cloud(places, displacement)
        displacement[450] = 0, -5.2
        loose = cloud(places, displacement)
        self.assertEqual(deformation.largest_factor({"particles": loose}), deformation.largest_factor({"particles": whole}))
        figure = png.figure(model_pictures.deformed(run_named("ring"), 1.0, {"particles": loose}, 100))
        self.assertLess(np.ptp(figure.axes[0].get_ylim()), 4)
        self.assertIn("1 loose particle", " ".join(text.get_text() for text in figure.legends[0].get_texts()))


class Colours(PictureTest):
    def marked(self, drawing):
        return next(text for text, _ in drawing.notes if "○" in text)

    def test_tension_is_marked_and_not_the_largest_magnitude(self):
        stress = np.zeros((25, 3))
        stress[:, :2] = -0.228e6  # compression everywhere but in one zone
        stress[7, 0] = 0.17e6
        drawing = colour_pictures.principal_stress(run_named("ring"), 1.0, {"grid": column(lambda p: 0 * p[:, :1], stress_Pa=stress)})
        self.assertRegex(self.marked(drawing), r"^○ 0\.17 MPa at x = 1 m, y = -35 m$")

    def test_light_zones_set_no_scale_and_no_mark(self):
        weight, strain = np.ones(25), np.linspace(0.006, 0.012, 25)
        weight[3], strain[3] = 0.002, 0.67
        grid = column(lambda p: 0 * p[:, :1], peak_shear_strain=strain)
        grid.cell_fields["weight"] = weight
        (_, drawing), = colour_pictures.peaks(run_named("fault"), 1.0, {"grid": grid})
        self.assertIn("○ 12 10⁻³", self.marked(drawing))

    def test_a_field_of_zeros_has_a_scale_of_one_tick(self):
        drawing = colour_pictures.displacement(run_named("rest"), 1.0, {"grid": column(lambda points: 0 * points[:, :1])})
        self.assertEqual(list(png.figure(drawing).axes[1].get_yticks()), [0])

    def test_a_field_that_is_the_same_everywhere_has_no_largest_place(self):
        for value, told in ((0, "0 mm everywhere"), (3e-3, "3 mm everywhere")):
            moved = np.column_stack([np.full(52, value) * (1 + 1e-15 * np.arange(52)), np.zeros(52)])
            moved[0, 0], moved[1, 0] = value, value  # at rest it would be the common motion
            grid = column(lambda points: moved)
            grid.point_fields["peak_displacement_m"] = moved[:, 0]
            (_, drawing), = colour_pictures.peaks(run_named("rest"), 1.0, {"grid": grid})
            self.assertEqual([text for text, _ in drawing.notes], [told, ""])
            axes, bar = png.figure(drawing).axes
            self.assertEqual((len(axes.get_lines()), list(bar.get_yticks())), (0, [moved[:, 0].min() * 1e3]))

    def test_shares_have_the_same_scale_in_every_run(self):
        """0 to 1, whatever the values are; those outside are told, unless no colour can show how far."""
        def of(field, values):
            grid = column(lambda points: 0 * points[:, :1], **{field: np.resize(values, 25)})
            return colour_pictures.pressure_ratio(run_named("sand"), 1.0, {"grid": grid}) if field == "pressure_ratio" else next(
                drawing for _, drawing in colour_pictures.peaks(run_named("sand"), 1.0, {"grid": grid}))

        looks = set()
        for field in ("pressure_ratio", "peak_pressure_ratio", "peak_demand"):
            for values, told in (([0.0], ""), ([-1e-17, 1e-17], ""), ([0.02, 0.1], ""), ([-2e-6, 1.002], ""),
                                 ([0.97] * 24 + [-0.36], "1 below, down to -0.36"), ([0.4, 0, 0, 0, 1.2], "5 above, up to 1.2")):
                drawing = of(field, values)
                self.assertIn(told, drawing.notes[1][0])
                self.assertEqual(bool(drawing.notes[1][0]), bool(told))
                zones = next(each for each in png.figure(drawing).axes[0].collections if each.get_array() is not None)
                looks.add((zones.cmap.name, zones.norm.vmin, zones.norm.vmax))
                self.assertEqual(zones.to_rgba(-0.36), zones.to_rgba(0.0))
        self.assertEqual([look[1:] for look in looks], [(0, 1)])

    def test_stresses_of_wet_ground_are_total_and_the_pressure_of_its_water_is_drawn(self):
        def grid(pressure):
            wet = {} if pressure is None else {"pore_pressure_Pa": np.full(25, pressure) * np.arange(25)}
            stress = {"stress_Pa": np.outer(np.arange(1, 26), (-2e3, -4e3, 0)), "peak_largest_principal_stress_Pa": np.arange(25)}
            return {"grid": column(lambda points: 0 * points[:, :1], **stress, **wet)}

        for pressure, total, drawn in ((None, "", False), (0, "total ", False), (2e3, "total ", True)):
            run, pieces, what = run_named("sand"), grid(pressure), f"largest {total}principal stress (tension)"
            self.assertTrue(colour_pictures.principal_stress(run, 1.0, pieces).title.startswith(what))
            self.assertIn(f"{what} until", next(drawing.title for _, drawing in colour_pictures.peaks(run, 1.0, pieces)))
            shown = colour_pictures.pore_pressure(run, 1.0, pieces)
            self.assertEqual(shown is not None, drawn)
        self.assertEqual((shown.title, self.marked(shown)), ("pore pressure at t = 1 s", "○ 48 kPa at x = 1 m, y = -1 m"))

    def test_a_few_peaks_do_not_rule_the_scale_and_are_told(self):
        stress = np.zeros((400, 3))
        stress[:, 0] = np.linspace(0.1e6, 0.2e6, 400)
        stress[7, 0] = 5.2e6
        places = np.array([(x, y) for x in range(20) for y in range(20)], float)
        cracked = cloud(places, np.zeros((400, 2)))
        cracked.point_fields["stress_Pa"] = stress
        drawing = colour_pictures.principal_stress(run_named("ring"), 1.0, {"particles": cracked})
        self.assertLess(drawing.colours[0].high, 0.21)
        self.assertEqual(Scale(stress[:, 0] / 1e6).extend(), "max")
        self.assertIn("○ 5.2 MPa at x = 0 m, y = 7 m", self.marked(drawing))
        told = [text.get_text() for text in png.figure(drawing).texts]
        self.assertIn("Beyond the scale of colours: 2 above, up to 5.2 MPa", told)  # 0.5 % of 400

    def test_a_roof_that_fell_by_metres_is_told_in_plain_numbers(self):
        scale = Scale(np.append(np.linspace(1, 2, 999), 10670.4))
        self.assertIn("up to 10,670 mm", scale.beyond("mm"))

    def test_all_values_lie_in_the_scale_where_none_is_far_from_the_others(self):
        values = np.sin(np.linspace(0, 3, 1000))
        scale = Scale(values)
        self.assertEqual((scale.low, scale.high, scale.beyond("mm")), (values.min(), values.max(), ""))

    def test_ground_can_be_told_apart_beside_a_cracking_lining(self):
        """Ground shaken by 1 to 3 m/s^2 and particles that crack by thousands: a linear scale shows one colour."""
        scale = Scale(np.concatenate([np.linspace(1, 3, 500), np.geomspace(5, 2000, 100)]))
        shown = scale.look()["norm"]([1.0, 3.0])
        self.assertGreater(shown[1] - shown[0], 0.1)

    def test_the_smaller_sign_is_pale_where_it_is_much_smaller(self):
        """Compression of 0.2 MPa beside tension of 19 MPa is nearly nothing, and is drawn nearly white."""
        norm = Scale(np.linspace(-0.2, 19, 200)).look()["norm"]
        self.assertAlmostEqual(norm(0), 0.5)
        self.assertGreater(norm(-0.2), 0.45)
        self.assertEqual(norm(19), 1)

    def test_a_sign_that_cannot_be_seen_beside_the_other_does_not_change_the_colours(self):
        for least, greatest, map_ in ((0, 34, "viridis"), (-8e-6, 34, "viridis"), (-34, 0, "viridis_r"), (-34, 8e-6, "viridis_r"),
                                      (-1, 34, "RdBu_r"), (-34, 1, "RdBu_r"), (2, 34, "viridis"), (-34, -2, "viridis_r")):
            self.assertEqual(Scale(np.linspace(least, greatest, 50)).look()["cmap"], map_, (least, greatest))

    def test_displacement_is_that_beside_the_common_motion(self):
        grid = column(lambda points: 4 + 1e-3 * (points[:, 1:] / 50) ** 2)
        drawing = colour_pictures.displacement(run_named("shaken"), 1.0, {"grid": grid})
        self.assertIn("without the common (4000, 0) mm", drawing.title)
        self.assertRegex(self.marked(drawing), r"^○ 0\.7\d* mm")

    def test_rounding_of_the_weight_is_no_overlap(self):
        grid = column(lambda points: 0 * points[:, :1])
        grid.cell_fields["weight"] = np.full(25, 1 - 2.2e-16)
        figure = png.figure(model_pictures.deformed(run_named("hzm"), 1.0, {"grid": grid}, 1))
        self.assertNotIn("overlap", [text.get_text() for text in figure.legends[0].get_texts()])


class Joints(PictureTest):
    def test_joints_of_a_lining_are_drawn_over_its_bonds(self):
        state = {"state": np.zeros(2), "normal_force_N": np.array([1e3, -2e3])}
        segments = piece([(0, 0), (1, 0), (2, 0)], [(0, 1), (1, 2)], {}, state)
        joint = {"from": {"x": 1.5, "y": -0.2}, "to": {"x": 1.5, "y": 0.2}, "open": True}
        for draw in (model_pictures.bonds, model_pictures.force_chains):
            figure = png.figure(draw(run_named("ring", {"joints": [joint]}), 1.0, {"bonds": segments}))
            self.assertIn("open joint", texts_of(figure.legends[0]))
            lines = [path.vertices.tolist() for drawn in figure.axes[0].collections for path in drawn.get_paths()]
            self.assertIn([[1.5, -0.2], [1.5, 0.2]], lines)

    def test_a_close_up_shows_a_long_thin_region_of_particles(self):
        grid = piece([(-80, -40), (80, -40), (80, 40), (-80, 40)], [(0, 1, 2, 3)])
        lining = piece([(-54, -9), (54, 9)], [(0, 1)])
        self.assertEqual(model_pictures.close_up({"grid": grid, "bonds": lining}), style.bounds_of(lining.points))

    def test_groups_of_particles_are_told_apart_from_the_ground(self):
        """Also where they lie in several regions, and where particles were taken away."""
        discs = cloud([(0, 0), (1, 0), (2, 0), (3, 0)], np.zeros((4, 2)))
        discs.point_fields["group"], discs.cells = np.array([0, 1, 2, 1]), discs.cells[:3]
        bonds = piece(discs.points, [(0, 1), (1, 2)], {}, {"state": np.zeros(2), "normal_force_N": np.ones(2)})
        run = run_named("tunnels", {"groups": [{"name": "west"}, {"name": "gouge"}]}, {"groups": [{"name": "east"}]})
        for draw, more in ((model_pictures.bonds, ()), (model_pictures.force_chains, ()), (model_pictures.deformed, (1,))):
            figure = png.figure(draw(run, 1.0, {"particles": discs, "bonds": bonds}, *more))
            self.assertEqual([text for text in texts_of(figure.legends[0]) if ": " in text and "part" in text],
                             ["particles: west, east", "particles: gouge"], draw)
            toned = [drawn.get_offsets().tolist() for drawn in figure.axes[0].collections
                     if tuple(np.round(drawn.get_facecolor()[:1, :3].ravel(), 3)) in {
                         tuple(np.round(to_rgb(tone), 3)) for tone in particle_groups.TONES}]
            self.assertEqual(toned, [[[1, 0]], [[2, 0]]], draw)

    def test_a_picture_of_a_part_says_so(self):
        grid = piece([(0, 0), (40, 0), (40, 8), (0, 8)], [(0, 1, 2, 3)], {"displacement_m": np.zeros((4, 3))},
                     {"stress_Pa": np.zeros((1, 3)), "weight": np.ones(1)})
        for width, told in ((1, True), (40, False)):
            places = [(0, 0), (width, 0), (width, 8), (0, 8)]
            discs = cloud(places, np.zeros((4, 2)))
            discs.point_fields["stress_Pa"] = np.zeros((4, 3))
            bonds = piece(places, [(0, 1), (1, 2)], {}, {"state": np.zeros(2), "normal_force_N": np.ones(2)})
            pieces = {"grid": grid, "particles": discs, "bonds": bonds}
            for draw in (colour_pictures.principal_stress, model_pictures.bonds, model_pictures.force_chains):
                self.assertEqual("only the part with particles is drawn" in draw(run_named("beam"), 1.0, pieces).title, told, draw)

    def test_bonds_between_two_groups_that_broke_are_no_cracks(self):
        bonds = piece([(0, 0), (1, 0), (2, 0), (3, 0)], [(0, 1), (1, 2), (2, 3)], cell_fields={"state": np.array([1, 2, 0])})
        discs = piece(bonds.points, np.arange(4)[:, None], {
            "displacement_m": np.zeros((4, 3)), "radius_m": np.full(4, 0.5), "weight": np.ones(4), "group": np.array([0, 0, 1, 1])})
        drawing = model_pictures.bonds(run_named("ring"), 1.0, {"bonds": bonds, "particles": discs})
        self.assertEqual(drawing.title, "1 crack at t = 1 s")
        self.assertEqual(texts_of(png.figure(drawing).legends[0])[-3:], ["1 intact bond", "1 tensile crack", "1 debonded bond"])


class Models(PictureTest):
    def test_particles_that_were_taken_away_are_not_drawn(self):
        discs = cloud([(0, 0), (1, 0), (2, 0)], np.zeros((3, 2)))
        discs.cells = discs.cells[1:]
        _, axes = style.plt.subplots()
        sheets._draw_particles(axes, Member("", "particles", {}, {}), Shapes(discs))
        self.assertEqual(axes.collections[0].get_offsets().tolist(), [[1, 0], [2, 0]])

    def test_edges_that_move_as_a_body_are_drawn_as_moved(self):
        grid = piece([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 1, 2, 3)])
        motion = {"where": {"x_max": 0}, "body": {"centre": {"x": 0, "y": 0.5}, "path": "edge.csv"}}
        member = Member("", "continuum", {"motions": [motion]}, {})
        _, axes = style.plt.subplots()
        handles, notes = conditions.draw(axes, [member], {"grid": grid}, 1.0)
        self.assertEqual([handle.get_label() for handle in handles], ["boundary: moved"])
        self.assertEqual(notes, [])

    def test_hysteretic_zones_do_not_yield(self):
        still = column(lambda points: 0 * points[:, :1], yield_state=np.full(25, 256))
        self.assertIsNone(colour_pictures.yield_state(run_named("site"), 1.0, {"grid": still}))
        state = np.full(25, 256)
        state[:10] = 0
        partly = column(lambda points: 0 * points[:, :1], yield_state=np.array(state))
        for law, drawn in (("hysteretic", False), ("mohr_coulomb", True)):
            run = run_named("site", {"materials": [{"material": {law: {}}}]})
            run.scene = {"material": {}}
            self.assertEqual(colour_pictures.yield_state(run, 1.0, {"grid": partly}) is not None, drawn)
        state[:10] = [0, 0, 0, 0, 1 | 4, 1 | 4, 4, 8, 8, 8]
        mixed = column(lambda points: 0 * points[:, :1], yield_state=state)
        figure = png.figure(colour_pictures.yield_state(run_named("site"), 1.0, {"grid": mixed}))
        self.assertEqual(texts_of(figure.legends[0]), [
            "shear now: 2 zones", "shear before: 1 zones", "tension before: 3 zones", "hysteretic, which does not yield: 15 zones",
            "elastic: 4 zones"])


class Spectra(PictureTest):
    def test_accelerations_are_drawn_in_g(self):
        table = Table({"period_s": np.array([0.1, 1.0]), "psa_5pct_m_per_s2": np.array([9.80665, 4.903325]),
                       "sv_5pct_m_per_s": np.ones(2), "sd_5pct_m": np.ones(2)}, "table")
        run = types.SimpleNamespace(name="site", number=lambda key: 4.903325 if key == "top_pga_m_per_s2" else None)
        axes = png.figure(spectra_pictures._response(run, "top", table, None, "input")).axes[0]
        spectrum, pga = axes.get_lines()
        self.assertEqual(axes.get_ylabel(), "pseudo acceleration [g]")
        np.testing.assert_allclose(spectrum.get_ydata(), (1, 0.5))
        np.testing.assert_allclose(pga.get_ydata(), 0.5)


class Times(PictureTest):
    def run_with(self, columns, end):
        time = np.linspace(0, end, 200)
        return types.SimpleNamespace(name="ring", models=[], histories={"time_s": time} | {name: np.sin(k + time) for k, name in enumerate(columns)})

    def test_legends_of_panels_do_not_print_over_each_other(self):
        names = [f"place_{k}_{ending}" for ending in ("ux_m", "vx_m_per_s", "sxx_Pa") for k in range(15)]
        figure = png.figure(time_pictures.histories(self.run_with(names, 30)))
        boxes = [box_of(figure, axes.get_legend()) for axes in figure.axes]
        self.assertEqual([len(axes.get_legend().get_texts()) for axes in figure.axes], [time_pictures.MOST_LINES] * 3)
        for upper, lower in zip(boxes, boxes[1:]):
            self.assertGreaterEqual(upper.y0, lower.y1)
        self.assertLessEqual(max(box.x1 for box in boxes), figure.bbox.x1)

    def test_long_runs_are_drawn_in_seconds_and_short_ones_in_milliseconds(self):
        for end, label, shown in ((30, "t [s]", 30), (0.05, "t [ms]", 50)):
            axes = png.figure(time_pictures.histories(self.run_with(["tip_ux_m"], end))).axes[0]
            self.assertEqual((axes.get_xlabel(), round(axes.get_xlim()[1], 9)), (label, shown))

    def test_histories_of_every_quantity_are_drawn_and_told_apart_in_whole_words(self):
        """Of all quantities of the protocol at one place: each has a line, and no two have the same text."""
        scene = (pathlib.Path(__file__).resolve().parents[3] / "protocol" / "messages" / "scene.proto").read_text()
        stated = scene.partition("enum Quantity {")[2].partition("\n}")[0]
        columns = re.findall(r'\[\(column\) = "(\w+)"\]', stated)
        self.assertEqual(len(columns), len(re.findall(r"^  [A-Z_]+ = \d+", stated, re.MULTILINE)))
        columns += ["uz_m", "axial_force_N"]  # and those of whole tunnels
        columns += ["moment_lateral_N_m", "moment_vertical_N_m", "shear_lateral_N", "shear_vertical_N"]
        figure = png.figure(time_pictures.histories(self.run_with([f"p_{column}" for column in columns], 30)))
        texts = [text for axes in figure.axes for text in texts_of(axes.get_legend())]
        self.assertEqual(sorted(texts), sorted({time_pictures.said(f"p_{column}") for column in columns}))
        self.assertEqual(len(texts), len(columns))
        for column in columns:
            words = set(column.split("_")) - {"m", "s", "s2", "N", "Nm", "Pa", "rad", "per"}
            self.assertLessEqual(words, set(time_pictures.said(f"p_{column}").split()), column)
        for name, text in (("effective_sxx_Pa", "p, effective sxx"), ("pressure_ratio", "p, pressure ratio"), ("ux_m", "p, ux"),
                           ("shear_strength_N", "p, shear strength"), ("moment_lateral_N_m", "p, lateral moment")):
            self.assertEqual(time_pictures.said(f"p_{name}"), text)

    def test_energies_that_are_small_beside_the_work_have_a_panel_of_their_own(self):
        run = self.run_with([], 30)
        rise = run.histories["time_s"]
        run.histories |= {"continuum_external_work_J": 5e6 * rise, "continuum_dissipated_J": 4.99e6 * rise,
                          "continuum_kinetic_J": 4e3 * rise, "continuum_strain_J": 1e3 * rise, "energy_drift": 0 * rise}
        work, stored, _ = png.figure(time_pictures.energy(run)).axes
        self.assertEqual((work.get_ylabel(), stored.get_ylabel()), ("put in and lost [MJ]", "stored [kJ]"))
        self.assertGreater(stored.get_ylim()[1], 100)


class Pages(PictureTest):
    def test_a_motion_is_told_with_its_units_and_in_g(self):
        told = computed.motion({"synthetic": {"spectrum": "gb_18306", "corner_period": 0.65, "seed": 11}, "peak": 1.96133})
        self.assertEqual(told, "The motion is synthetic (spectrum gb_18306, corner period 0.65 s, seed 11), with a peak of "
                               "1.961 m/s² (0.2 g).")

    def test_joints_of_a_whole_tunnel_are_told_with_what_they_consist_of(self):
        joint = {"from": 222.0, "to": 5442.0, "at": [111.0], "gasket": {"installed_force": 171e6, "force": [0.0, 1e6]},
                 "lateral_keys": {"stiffness": 3e9, "clearance": 5e-3}, "seal_limit": 0.06}
        self.assertEqual(model._chainages(joint), "222 m to 5,442 m, 111 m")
        self.assertEqual(model._properties(joint), "gasket: installed force = 171 MN; lateral keys: stiffness = 3 GN/m, "
                                                   "clearance = 5 mm; limit of the seal = 60 mm")

    def test_forces_and_diameters_of_a_ring_are_main_figures(self):
        known = dict(overview.main_figures())
        self.assertEqual(known["greatest moment, per metre"], "sections_largest_moment_Nm")
        self.assertEqual(known["shortest diameter, change"], "ovals_smallest_diameter_change_m")
        self.assertEqual(known["peak bond force: y"], "peak_bond_force_y_m")

    def test_peaks_of_every_lining_are_main_figures(self):
        summary = {"lining_roof_largest_moment_Nm": -2e4, "lining_roof_thrust_at_largest_moment_N": -3e5,
                   "lining_roof_least_thrust_N": -4e5, "west_lining_floor_largest_moment_Nm": 1e3}
        run = types.SimpleNamespace(name="portal", summary=summary, figures=summary, number=summary.get)
        known = dict(overview.main_figures(run))
        self.assertEqual(known["lining roof: largest moment, per metre: thrust there"], "lining_roof_thrust_at_largest_moment_N")
        self.assertEqual(known["lining roof: largest moment, per metre: x"], "lining_roof_largest_moment_x_m")
        self.assertEqual(known["west_lining floor: least thrust, per metre"], "west_lining_floor_least_thrust_N")
        lines = [" ".join(line.split()) for line in overview.lines([run])]
        self.assertEqual(lines[1:], ["lining roof: least thrust, per metre [kN] -400", "lining roof: largest moment, per metre [kN m] -20",
                                     "thrust there [kN] -300", "west_lining floor: largest moment, per metre [kN m] 1"])

    def test_forces_of_linings_are_drawn_between_their_least_and_largest(self):
        angle = np.radians(range(0, 360, 45))
        points = np.column_stack([np.cos(angle), np.sin(angle)])
        fields = {f"{when}{force}": np.full(8, value) for force, _, _ in around.FORCES
                  for when, value in (("", -3e3), ("peak_least_", -9e3), ("peak_largest_", -2e3))}
        ring = piece(points, [(k, (k + 1) % 8) for k in range(8)], fields, {"lining": np.zeros(8)})
        envelopes, _ = pictures.painted(next(around.of_linings(run_named("ring"), ring)))
        least, greatest = (envelopes.axes[0].get_lines()[k].get_ydata() for k in (0, 1))
        np.testing.assert_allclose((least, greatest), ([-9] * 8, [-2] * 8))
        drawn = png.figure(lining_pictures.lining_forces(run_named("ring"), 1.0, {"linings": ring})).axes[0].collections
        radii = [np.hypot(*line.get_paths()[0].vertices.T).max() for line in drawn[-2:]]
        np.testing.assert_allclose(radii, [1 - 2 * lining_pictures.REACH * part for part in (1, 2 / 9)])

    def test_forces_of_walls_are_drawn_along_them_and_none_where_they_are_rounding(self):
        points = np.array([(2.0, 0), (2, 1), (2, 3)])
        forces = {"thrust_N": -4e6, "moment_Nm": 4e-8, "shear_N": 1e-8}
        fields = {f"{when}{force}": np.full(3, value) for force, value in forces.items() for when in ("", "peak_least_", "peak_largest_")}
        wall = piece(points, [(0, 1), (1, 2)], fields, {"lining": np.zeros(2)})
        envelopes, _ = pictures.painted(next(around.of_linings(run_named("wall"), wall)))
        np.testing.assert_allclose(envelopes.axes[0].get_lines()[0].get_xdata(), (0, 1, 3))
        figure = png.figure(lining_pictures.member_forces(run_named("wall"), 1.0, {"members": wall}))
        titles = [axes.get_title(loc="left") for axes in figure.axes]
        self.assertEqual(titles, ["thrust N: -4,000 to -4,000 kN", "moment M: 0 to 0 kN m", "shear force Q: 0 to 0 kN"])

    def test_interfaces_of_layers_have_a_row_each(self):
        run = run_named("layers", {"linings": [{"name": "shotcrete", "interface": {}}, {"name": "concrete", "on": "shotcrete", "interface": {}}]})
        fields = {name: np.array([-3.0, -3, 5, 5]) for name, *_ in lining_pictures.OF_INTERFACES}
        faces = piece([(0, 0), (1, 0), (0, 0), (1, 0)], [(0, 1), (2, 3)], fields, {"interface": np.array([0.0, 1])})
        figure = png.figure(lining_pictures.interfaces(run, 1.0, {"interfaces": faces}))
        self.assertEqual([axes.get_ylabel().partition("\n")[0] for axes in figure.axes[::4]], ["shotcrete", "concrete"])

    def test_joints_are_drawn_as_wide_as_they_stand_open(self):
        """Outwards where the outer face opens, inwards where the inner one does, the largest as far as forces reach."""
        angle = np.radians(range(0, 360, 45))
        points = np.column_stack([np.cos(angle), np.sin(angle)])
        outer, inner = np.zeros(8), np.zeros(8)
        outer[[0, 2]], inner[[0, 2]] = (2e-3, -1e-4), (-1e-3, 1e-3)
        ring = piece(points, [(k, (k + 1) % 8) for k in range(8)], {"outer_opening_m": outer, "inner_opening_m": inner}, {})
        axes = png.figure(lining_pictures.lining_joints(run_named("ring"), 1.0, {"linings": ring})).axes[0]
        reach = 2 * lining_pictures.REACH
        for drawn, radii in zip(axes.collections[1:], ([1 + reach, 1], [1, 1 - reach / 2])):
            np.testing.assert_allclose([np.hypot(*path.vertices[1]) for path in drawn.get_paths()], radii)
        self.assertEqual([text.get_text() for text in axes.texts], ["2.00", "1.00"])

    def test_pages_say_of_dashed_lines_what_the_legend_says(self):
        beam = piece([(0, 0), (1, 0)], [(0, 1)], {name: np.zeros(2) for name, *_ in lining_pictures.FORCES})
        figure = png.figure(lining_pictures.lining_forces(run_named("ring"), 1.0, {"linings": beam}))
        (told,) = [text for text in texts_of(figure.legends[0]) if "so far" in text]
        guide = (pathlib.Path(__file__).resolve().parents[3] / "docs" / "user_guide.md").read_text()
        self.assertIn(f"the dashed lines are the {told}.", guide)
        self.assertNotIn("largest value so far", guide)

    def test_cracks_and_debonded_bonds_are_told_apart(self):
        table = Table({name: np.array(values) for name, values in {
            "time_s": [0.5, 1.0, 2.0], "mode": ["shear", "tensile", "shear"], "x_m": [1.0, 2, 3], "y_m": [4.0, 5, 6],
            "group": ["lining-ground", "lining", "lining-ground"]}.items()}, "cracks.csv")
        told = response.cracks(types.SimpleNamespace(table={"cracks.csv": table}.get, summary={
            "crack_count": 1, "first_crack_time_s": 1.0, "first_crack_x_m": 2.0, "first_crack_y_m": 5.0,
            "debonded_count": 2, "first_debonding_time_s": 0.5, "first_debonding_x_m": 1.0, "first_debonding_y_m": 4.0}))
        self.assertIn("The only crack inside one body broke at 1 s", told)
        self.assertIn("The first of 2 debonded bonds between two groups broke at 500 ms", told)
        self.assertIn("The first 3 of 3 broken bonds", told)
        known = dict(overview.main_figures())
        self.assertEqual(known["cracks"], "crack_count")
        self.assertEqual(known["debonded bonds"], "debonded_count")

    def test_panels_stand_below_each_other_with_both_of_their_axes(self):
        def paint(left, right):
            left.set_ylabel("stress")
            right.twinx().set_ylabel("cracks")

        figure, _ = pictures.painted(Drawing("", "rock", Panels(1, 2, (10, 3)), paint))
        figure.canvas.draw()
        left, right, other = figure.axes
        self.assertEqual([axes.get_ylabel() for axes in figure.axes], ["stress", "stress", "cracks"])
        self.assertEqual(other.get_position().bounds, right.get_position().bounds)
        self.assertGreater(left.get_position().y0, right.get_position().y1)
        self.assertGreater(left.get_position().height, 0.3)


if __name__ == "__main__":
    unittest.main()
