"""The picture of a model before it runs shows what is dug and installed, and when."""

import types
import unittest

import numpy as np
from matplotlib.colors import to_hex

from adit.plots import png, style
from adit.plots.setup import sheets, supports, water
from adit.plots.setup.checked import Checked, Member

from pieces import PictureTest, piece


def block(zones, side=1.0, **cell_fields):
    """A square of zones by zones."""
    x, y = np.meshgrid(side * np.arange(zones + 1), side * np.arange(zones + 1))
    corner = lambda i, j: (zones + 1) * j + i  # noqa: E731
    cells = [(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)) for j in range(zones) for i in range(zones)]
    return piece(np.column_stack([x.ravel(), y.ravel()]), cells, {}, cell_fields)


def packing(count, radius):
    """A square of count by count discs, all of the first group."""
    x, y = np.meshgrid(2 * radius * np.arange(count), 2 * radius * np.arange(count))
    discs = piece(np.column_stack([x.ravel(), y.ravel()]), np.arange(count**2)[:, None],
                  {"radius_m": np.full(count**2, radius), "group": np.zeros(count**2)})
    return discs


def hatched(figure, hatch):
    """Areas of the cells with this hatch."""
    found = [path.vertices for drawn in figure.axes[0].collections if drawn.get_hatch() == hatch for path in drawn.get_paths()]
    return [0.5 * abs(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1])) for x, y in (corners.T for corners in found)]


def areas_of(axes, colour):
    """Areas of the shapes of this colour."""
    found = [path.vertices for drawn in axes.collections for face in drawn.get_facecolor()[:1] if to_hex(face) == colour.lower()
             for path in drawn.get_paths()]
    return [0.5 * abs(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)) for x, y in (corners.T for corners in found)]


class Setup(PictureTest):
    def drawn(self, pieces, *members, **scene):
        checked = types.SimpleNamespace(name="model", scene=scene, pieces=lambda: pieces, members=lambda: members)
        (_, drawing), = sheets.model(checked)
        figure = png.figure(drawing)
        return figure, [text.get_text() for text in figure.legends[0].get_texts()]

    def test_what_is_dug_from_a_block_by_its_name(self):
        """A zone is taken by the first stage that names it."""
        grid = block(4, group=np.repeat([1, 2], 8), material=np.zeros(16))
        member = Member("", "continuum", {"blocks": [{"name": "bench"}, {"name": "heading"}], "excavations": [
            {"where": {"y_max": 4}, "stage": 3}, {"where": {"group": "heading"}, "stage": 1, "released": 0.4}]}, {})
        figure, legend = self.drawn({"grid": grid}, member)
        self.assertEqual([each for each in legend if "excavated" in each], ["excavated in stage 1, 40 % released", "excavated in stage 3"])
        self.assertEqual([sum(hatched(figure, hatch)) for hatch in ("////", "xx")], [8, 8])
        self.assertFalse(any("not drawn" in each for each in legend))

    def test_zones_that_change_have_their_last_material(self):
        """In the order of the stages, and without places that are no ground at first."""
        grid = block(4, group=np.ones(16), material=np.zeros(16))
        areas = [{"where": {"y_max": 2}, "stage": 5, "material": {"young_modulus": 3e9}}, {"where": {"x_max": 2}, "stage": 2, "material": {"young_modulus": 2e9}},
                 {"where": {"y_min": 9}, "stage": 3, "material": {"young_modulus": 4e9}}]
        figure, legend = self.drawn({"grid": grid}, Member("", "continuum", {"material": {"young_modulus": 1e9}, "materials": areas}, {}))
        self.assertEqual([each for each in legend if "zones" in each], ["zones: E = 1 GPa", "zones: E = 2 GPa, stage 2", "zones: E = 3 GPa, stage 5"])
        self.assertEqual([len(drawn.get_paths()) for drawn in figure.axes[0].collections[:3]], [16, 8, 8])

    def test_what_is_dug_from_particles_and_the_lining_that_is_installed_there(self):
        tunnel = {"circle": {"centre": {"x": 1, "y": 1}, "radius": 0.6}}
        ring = {"annulus": {"centre": {"x": 1, "y": 1}, "inner_radius": 0.4, "outer_radius": 0.6}}
        member = Member("", "particles", {"excavations": [{"where": tunnel, "stage": 1, "released": 0.5}], "groups": [
            {"name": "ring", "where": ring, "stage": 2, "material": {"young_modulus": 25e9}}]}, {"material": {"young_modulus": 1e9}})
        discs = packing(100, 0.01)
        figure, legend = self.drawn({"particles": discs}, member)
        self.assertEqual([each for each in legend if "particles" in each], ["particles: E = 1 GPa", "particles: ring, E = 25 GPa, stage 2"])
        self.assertIn("excavated in stage 1, 50 % released", legend)
        self.assertAlmostEqual(sum(hatched(figure, "////")) / (np.pi * 0.4**2), 1, delta=0.1)  # the opening inside the lining
        lining = figure.axes[0].collections[1].get_offsets()
        radii = np.hypot(*(np.asarray(lining) - 1).T)
        self.assertTrue(len(lining) > 100 and 0.39 < radii.min() and radii.max() < 0.61)

    def test_linings_have_their_names_and_stages_and_all_supports_colours_of_their_own(self):
        beams = piece([(0, 0), (1, 0), (1, 1)], [(0, 1), (1, 2)], {}, {"lining": np.array([0, 1])})
        member = Member("west", "continuum", {"linings": [{"name": "roof", "stage": 3}, {"name": "floor"}],
                                              "bolts": [{"stage": 2}, {"stage": 5}], "springs": [{}]}, {})
        _, axes = style.plt.subplots()
        handles = supports.draw(axes, [member], {"west_linings": beams, "west_bolts": beams, "west_springs": beams})
        self.assertEqual([each.get_label() for each in handles], ["lining roof, stage 3", "lining floor", "bolts, stages 2 and 5", "springs"])
        self.assertEqual(len({each.get_color() for each in handles}), 4)

    def test_layers_show_beside_those_below_and_interfaces_of_zones_have_their_own_line(self):
        beams = piece([(0, 0), (1, 0), (1, 0), (0, 0)], [(0, 1), (2, 3)], {}, {"lining": np.array([0, 1])})
        faces = piece([(0, 1), (1, 1), (0, 0)], [(0, 1), (1, 2)], {}, {"interface": np.array([0.0, 1.0])})
        member = Member("", "continuum", {"linings": [{"name": "shotcrete", "stage": 2}, {"name": "concrete", "on": "shotcrete", "section": {}, "interface": {}, "stage": 3}],
                                          "interfaces": [{"name": "fault"}]}, {})
        _, axes = style.plt.subplots()
        handles = supports.draw(axes, [member], {"linings": beams, "interfaces": faces})
        self.assertEqual([each.get_label() for each in handles],
                         ["lining shotcrete, stage 2", "lining concrete, reinforced, slips on shotcrete, stage 3", "interface fault"])
        widths = [each.get_linewidth() for each in handles]
        self.assertGreater(widths[0], widths[1])  # the one below is wider, and lies below
        self.assertEqual([len(each.get_segments()) for each in axes.collections], [1, 1, 1])  # of the interfaces, the one that is not the lining's

    def test_groups_of_several_regions_have_colours_of_their_own(self):
        regions = [{"name": name, "particles": {"groups": [{"name": "lining"}]}} for name in ("west", "east")]
        members = Checked.members(types.SimpleNamespace(scene={"continuum": {}, "regions": regions}))
        self.assertEqual([member.first_colour for member in members], [0, 0, 2])

    def test_water_stands_on_the_ground_up_to_its_level(self):
        """On a square of 4 by 4 m with an opening, which stays dry, and a slit of 1 by 2 m; drawn no deeper than the model is high."""
        grid = block(4, material=np.zeros(16))
        gone = [5, 10, 14]  # an opening, and a slit from the top
        grid.cells, grid.cell_fields["material"] = np.delete(grid.cells, gone, axis=0), np.zeros(13)
        member = Member("", "continuum", {}, {})
        for level, top, area, told in ((6.0, 6.0, 4 * 2 + 2, "water level: y = 6 m"), (3.0, 3.0, 1, "water level: y = 3 m"),
                                       (50.0, None, 4 * 46 + 2, "water level: y = 50 m, above the picture"),
                                       (-50.0, None, 0, "water level: y = -50 m, below the picture")):
            figure, legend = self.drawn({"grid": grid}, member, water={"level": level})
            axes = figure.axes[0]
            self.assertIn(told, legend)
            self.assertEqual("water above the ground" in legend, area > 0)
            self.assertAlmostEqual(sum(areas_of(axes, water.SEA)), area, delta=0.02 * area)
            levels = [line for line in axes.get_lines() if len(line.get_xdata()) == 2 and not np.ptp(line.get_ydata())]
            self.assertEqual([list(line.get_ydata()) for line in levels], [[top, top]] if top is not None else [])
            self.assertGreaterEqual(axes.get_ylim()[1], top or 0)
            self.assertLess(axes.get_ylim()[1], 10)
        self.assertFalse([each for each in self.drawn({"grid": grid}, member)[1] if "water" in each])

    def test_water_stands_on_particles(self):
        discs, zones = packing(4, 0.5), block(4, material=np.zeros(16))
        zones.points = zones.points - (5, 0)
        members = [Member("", kind, {}, {}) for kind in ("continuum", "particles")]
        figure, _ = self.drawn({"grid": zones, "particles": discs}, *members, water={"level": 4.5})
        self.assertAlmostEqual(sum(areas_of(figure.axes[0], water.SEA)), 4 * 0.5 + 4 * 1.0, delta=0.05)

    def test_ground_whose_place_has_a_lower_level_from_the_beginning_is_dry(self):
        member = Member("", "continuum", {}, {})
        for stage, area in (({}, 2 * 2), ({"stage": 1}, 4 * 2)):
            places = [{"where": {"x_max": 2}, "level": 1.0, **stage}]
            figure, _ = self.drawn({"grid": block(4, material=np.zeros(16))}, member, water={"level": 6.0, "places": places})
            self.assertAlmostEqual(sum(areas_of(figure.axes[0], water.SEA)), area, delta=0.05)

    def test_places_with_water_of_their_own_are_told_with_level_or_pressure_and_stage(self):
        grid = block(4, group=np.repeat([1, 2], 8), material=np.zeros(16))
        member = Member("", "continuum", {"blocks": [{"name": "bench"}, {"name": "heading"}]}, {})
        places = [{"where": {"x_max": 2}, "level": 1.0, "stage": 2}, {"where": {"group": "heading"}, "pressure": 2e4}]
        figure, legend = self.drawn({"grid": grid}, member, water={"level": 4.0, "places": places})
        self.assertEqual([each for each in legend if "level" in each or "water" in each],
                         ["water level: y = 4 m", "water of its own level", "its level, stage 2: y = 1 m", "water at 20 kPa"])
        self.assertEqual([sum(areas_of(figure.axes[0], colour)) for colour in water.PLACES[:2]], [8, 8])
        self.assertIn(([0, 2], [1, 1]), [(list(line.get_xdata()), list(line.get_ydata())) for line in figure.axes[0].get_lines()])


if __name__ == "__main__":
    unittest.main()
