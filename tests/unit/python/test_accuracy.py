"""Intervals hold the limit, and only what the error comes from is refined."""
import itertools
import math
import unittest

from adit.accuracy.dimensions import dimensions_of, name_of
from adit.accuracy.estimate import error_of
from adit.accuracy.search import Computed, Search


def changes(values):
    return [after - before for before, after in zip(values, values[1:])]


class Errors(unittest.TestCase):
    def test_the_limit_lies_inside(self):
        """Of results that approach it by an order of 0.5, or of 1 to 3, also mixed: two terms of two orders of either sign."""
        mixed = itertools.product(itertools.combinations_with_replacement((1, 2, 3), 2), (-0.3, 0.0, 0.3))
        for (p, q), b in [((0.5, 1), 0.0), *mixed]:
            values = [1 + 0.1 * h**p + 0.1 * b * h**q for h in (1, 1 / 2, 1 / 4)]
            error = error_of(changes(values))
            self.assertGreaterEqual(error.size * 1.0001, abs(values[-1] - 1), (p, q, b))
            self.assertLess(error.size, 12 * abs(values[-1] - 1), (p, q, b))

    def test_the_order_is_found(self):
        for p in (0.75, 1, 2, 3):
            self.assertAlmostEqual(error_of(changes([1 + h**p for h in (1, 1 / 2, 1 / 4)])).order, p)

    def test_three_changes_tell_a_high_order_that_lasts(self):
        values = [1 + 0.1 * h**2 for h in (1, 1 / 2, 1 / 4, 1 / 8)]
        error = error_of(changes(values))
        self.assertAlmostEqual(error.order, 2)
        self.assertAlmostEqual(error.size, 1.25 * (values[-1] - 1))
        self.assertAlmostEqual(error_of(changes(values[:3])).size, 3 * 1.25 * (values[2] - 1))  # which two do not

    def test_a_change_before_the_order_shows_does_not_spoil_it(self):
        error = error_of([0.002, 0.011, 0.003])
        self.assertAlmostEqual(error.size, 1.25 * 0.003)
        self.assertAlmostEqual(error.order, math.log2(11 / 3))

    def test_what_has_no_order_keeps_its_larger_change(self):
        for given in ([0.2, -0.1], [-0.1, 0.3], [0.2, 0.0]):
            error = error_of(given)
            self.assertIsNone(error.order)
            self.assertAlmostEqual(error.size, 1.25 * max(map(abs, given)))
        self.assertEqual(error_of([0.0, 0.0]).size, 0)

    def test_a_small_change_after_a_large_one_is_chance(self):
        self.assertAlmostEqual(error_of([0.08, 1e-6]).size, 1.25 * 0.01)

    def test_changes_that_do_not_shrink_leave_much(self):
        for given in ([0.1, 0.1], [-0.1, -0.2], [0.1, 0.095]):
            error = error_of(given)
            self.assertIsNone(error.order)
            self.assertGreater(error.size, 8 * abs(given[-1]))

    def test_one_change_counts_three_times(self):
        self.assertAlmostEqual(error_of([-0.1]).size, 0.3)


SCENE = {"continuum": {"block": {"x_min": 0.0, "zones_x": 8, "zones_y": 4}, "damping": {"zones": 3}},
         "particles": {"cells": {"size": 0.1, "finer": [{"where": {"circle": {"radius": 2.0}}, "size": 0.05}]}},
         "tunnels": [{"circle": {"radius": 3.0}, "particles": {"size": 0.2, "ground": 2.0}}],
         "regions": [{"name": "east", "continuum": {"blocks": [{"zones_x": 6, "zones_y": 2}]}}]}


class Dimensions(unittest.TestCase):
    def test_zones_and_particles_are_found_wherever_they_are_stated(self):
        zones, particles = dimensions_of(SCENE)
        self.assertEqual(zones.values, {"continuum.block.zones_x": 8, "continuum.block.zones_y": 4, "regions[0].continuum.blocks[0].zones_x": 6,
                                        "regions[0].continuum.blocks[0].zones_y": 2})
        self.assertEqual(particles.values, {"particles.cells.size": 0.1, "particles.cells.finer[0].size": 0.05, "tunnels[0].particles.size": 0.2})

    def test_levels_halve_and_double(self):
        zones, particles = dimensions_of(SCENE)
        self.assertEqual(zones.settings(-1)["regions[0].continuum.blocks[0].zones_x"], "3")
        self.assertIsNone(zones.settings(-2))  # 6 cannot be halved twice
        self.assertEqual(zones.settings(2)["continuum.block.zones_x"], "32")
        self.assertEqual(particles.settings(1)["particles.cells.finer[0].size"], "0.025")

    def test_runs_are_named_by_what_differs(self):
        self.assertEqual(name_of({"zones": 1, "particles": 0}), "zones_x2")
        self.assertEqual(name_of({"zones": -1, "particles": 1}), "zones_x0.5,particles_x2")
        self.assertEqual(name_of({"zones": 0}), "stated")


class Model:
    """A result with an error of second order by zones and of first order by particles; `least`: the coarsest level that can be computed."""

    def __init__(self, zones, particles, least=-5, most=9):
        self.zones, self.particles, self.least, self.most, self.asked = zones, particles, least, most, []

    def __call__(self, levels):
        if not all(self.least <= level <= self.most for level in levels.values()):
            return None
        self.asked.append(dict(levels))
        value = 1 + self.zones / 4**levels["zones"] + self.particles / 2**levels["particles"]
        return Computed(dict(levels), {"q": value}, 8.0**levels["zones"] + 8.0**levels["particles"])

    def searched(self, within, budget=math.inf):
        search = Search(self, ["zones", "particles"], within, budget)
        return search, search.run(self({"zones": 0, "particles": 0}))


class Searches(unittest.TestCase):
    def test_only_what_the_error_comes_from_is_refined(self):
        model = Model(zones=0.001, particles=0.1)
        search, reached = model.searched(0.03)
        self.assertTrue(reached)
        self.assertEqual(search.best.levels["zones"], 0)
        self.assertGreaterEqual(search.best.levels["particles"], 2)
        self.assertGreaterEqual(search.interval("q"), abs(search.best.values["q"] - 1))
        self.assertLessEqual(search.interval("q"), 0.03 * search.best.values["q"])

    def test_a_scene_that_is_fine_enough_is_computed_coarser_only(self):
        model = Model(zones=0.001, particles=0.001)
        search, reached = model.searched(0.05)
        self.assertTrue(reached)
        self.assertTrue(all(level <= 0 for levels in model.asked for level in levels.values()))

    def test_where_nothing_coarser_can_be_it_is_made_finer(self):
        search, reached = Model(zones=0.01, particles=0.01, least=0).searched(0.1)
        self.assertTrue(reached)
        self.assertEqual(search.best.levels, {"zones": 2, "particles": 2})

    def test_the_budget_is_kept(self):
        search, reached = Model(zones=0.1, particles=0.1).searched(1e-4, budget=100)
        self.assertFalse(reached)
        self.assertLess(sum(run.seconds for run in search.runs), 100)
        self.assertGreater(sum(run.seconds for run in search.runs) + search.next_seconds, 100)

    def test_what_cannot_be_finer_ends_the_search(self):
        search, reached = Model(zones=0.1, particles=0.1, most=1).searched(1e-4)
        self.assertFalse(reached)
        self.assertLessEqual(max(search.best.levels.values()), 1)


if __name__ == "__main__":
    unittest.main()
