"""Intervals hold the limit, and only what the error comes from is refined."""
import contextlib
import io
import itertools
import json
import math
import tempfile
import unittest
from pathlib import Path

from adit import Unusable
from adit.accuracy.choices import Choices, softens
from adit.accuracy.dimensions import Dimension, choices, name_of, refining, rest
from adit.accuracy.estimate import error_of
from adit.accuracy.page import csv_rows, markdown, verdict
from adit.accuracy.runs import Computed, Runs, is_size
from adit.accuracy.scatter import Scatter
from adit.accuracy.search import Search, coarsest, median_change
from adit.trade.own.rungs import Ladder


def changes(values):
    return [after - before for before, after in zip(values, values[1:])]


class Errors(unittest.TestCase):
    def test_the_limit_lies_inside(self):
        """Of results that approach it by an order of 0.5, or of 1 to 3, also mixed: two terms of two orders of either sign."""
        mixed = itertools.product(itertools.combinations_with_replacement((1, 2, 3), 2), (-0.3, 0.0, 0.3))
        for ((p, q), b), finest in itertools.product([((0.5, 1), 0.0), *mixed], (4, 8, 16)):
            steps = [2.0**-level for level in range(finest.bit_length())]
            values = [1 + 0.1 * h**p + 0.1 * b * h**q for h in steps]
            error = error_of(changes(values))
            self.assertGreaterEqual(error.size, abs(values[-1] + error.shift - 1), (p, q, b, finest))
            if q <= 2:
                self.assertLess(error.size, 8 * abs(values[-1] - 1), (p, q, b, finest))

    def test_the_order_is_found(self):
        for p in (0.75, 1, 2, 3):
            self.assertAlmostEqual(error_of(changes([1 + h**p for h in (1, 1 / 2, 1 / 4)])).order, p)

    def test_two_changes_tell_no_order_above_the_first_and_three_do(self):
        values = [1 + 0.1 * h**2 for h in (1, 1 / 2, 1 / 4, 1 / 8)]
        self.assertAlmostEqual(error_of(changes(values[:3])).size, abs(values[1] - values[0]) / 2)  # as if it came from the first
        error = error_of(changes(values))
        self.assertAlmostEqual(error.size, values[3] - 1)
        self.assertAlmostEqual(error.shift, -error.size / 3)

    def test_the_smaller_of_two_orders_is_taken(self):
        error = error_of([0.15, 0.06, 0.02])  # 2.5 and 3 times smaller
        self.assertAlmostEqual(error.size, 0.06 / 2.5 / (2.5 - 1))
        self.assertAlmostEqual(error.shift, 0.02 / (2.5 - 1) / 3)

    def test_an_order_below_the_first_leaves_more(self):
        self.assertAlmostEqual(error_of([0.05 * 2**0.5, 0.05]).size, 0.05 / (2**0.5 - 1))

    def test_a_small_change_after_a_large_one_is_chance(self):
        """What the large one leaves, by the first order, counts: for one change more, a half; where signs differ, with half as much more."""
        for last, more in ((1e-6, 1.0), (-1e-6, 1.5), (0.0, 1.5)):
            self.assertAlmostEqual(error_of([0.08, last]).size, more * 0.04)
            self.assertAlmostEqual(error_of([0.08, 1e-6, last]).size, more * 0.02)

    def test_changes_of_different_signs_have_no_order(self):
        error = error_of([0.2, -0.15])
        self.assertIsNone(error.order)
        self.assertAlmostEqual(error.size, 1.5 * 0.15)
        self.assertEqual(error.shift, 0)
        self.assertEqual(error_of([0.0, 0.0]).size, 0)

    def test_changes_that_do_not_shrink_leave_much(self):
        for given in ([0.1, 0.1], [-0.1, -0.2], [0.1, 0.095]):
            self.assertGreater(error_of(given).size, 6 * abs(given[-1]))

    def test_one_change_counts_three_times(self):
        self.assertAlmostEqual(error_of([-0.1]).size, 0.3)


SCENE = {"time": {"duration": 1.0, "dt_factor": 0.6, "substeps": 4},
         "continuum": {"block": {"x_min": 0.0, "zones_x": 8, "zones_y": 4}, "damping": {"zones": 3}},
         "particles": {"cells": {"size": 1, "seed": 7, "finer": [{"where": {"circle": {"radius": 2.0}}, "size": 0.05}]}},
         "interface": {"overlap": {"particles_begin": {"x": 4}, "continuum_ends": {"x": 6}}},
         "tunnels": [{"circle": {"radius": 3.0}, "lining": {"as": "particles"}, "particles": {"size": 0.2, "ground": 2.0, "overlap": 1.0}}],
         "regions": [{"name": "east", "continuum": {"blocks": [{"along": {"zones": 6, "ratio": 1.21}, "across": {"zones": 2}}]}}]}


class Dimensions(unittest.TestCase):
    def test_zones_and_particles_are_found_wherever_they_are_stated(self):
        zones, particles = refining(SCENE)
        self.assertEqual(zones.values, {"continuum.block.zones_x": 8, "continuum.block.zones_y": 4, "regions[0].continuum.blocks[0].along.zones": 6,
                                        "regions[0].continuum.blocks[0].across.zones": 2})
        self.assertEqual(particles.values, {"particles.cells.size": 1, "particles.cells.finer[0].size": 0.05, "tunnels[0].particles.size": 0.2})

    def test_levels_halve_and_double(self):
        zones, particles = refining(SCENE)
        self.assertEqual(zones.settings(-1)["regions[0].continuum.blocks[0].along.zones"], "3")
        self.assertEqual(zones.settings(-2)["regions[0].continuum.blocks[0].along.zones"], "2")  # 6 cannot be halved twice
        self.assertEqual(zones.settings(2)["continuum.block.zones_x"], "32")
        self.assertEqual(particles.settings(1)["particles.cells.finer[0].size"], "0.025")
        self.assertEqual(particles.settings(1)["particles.cells.size"], "0.5")  # a length, though written as a whole number

    def test_finer_zones_lie_within_the_coarser_where_sizes_grow(self):
        """Two zones of ratio r' have the sizes of one of ratio r where r' is its root."""
        ratio = float(refining(SCENE)[0].settings(1)["regions[0].continuum.blocks[0].along.ratio"])
        self.assertAlmostEqual((ratio**2 + ratio**3) / (1 + ratio), 1.21)

    def test_whole_tunnels_have_elements_columns_and_two_models(self):
        scene = {"time": {"dt": 0.005}, "simplified": {"model": "beam", "ground": {"profiles": []},
                                                       "tunnel": {"sections": [{"element_length": 10.0}, {"element_length": 20.0}]}}}
        elements, columns = refining(scene)
        self.assertEqual(elements.settings(1), {f"simplified.tunnel.sections[{n}].element_length": length for n, length in ((0, "5"), (1, "10"))})
        self.assertEqual(columns.settings(-1), {"simplified.ground.column_spacing": "200"})
        step, model = choices(scene)
        self.assertEqual(step.settings(1), {"time.dt": "0.0025"})
        self.assertEqual(model.settings(1), {"simplified.model": "chain"})
        self.assertEqual(model.words(1), "the chain")

    def test_choices_are_those_that_the_scene_has(self):
        found = {each.name: each for each in choices(SCENE)}
        self.assertEqual(list(found), ["step", "substeps", "overlap", "reach", "lining"])
        self.assertEqual(found["step"].settings(1), {"time.dt_factor": "0.3"})
        self.assertIsNone(found["step"].settings(-1))  # beyond the critical one
        self.assertEqual(found["substeps"].settings(1), {"time.substeps": "2"})
        self.assertEqual(found["overlap"].settings(1), {"tunnels[0].particles.overlap": "2", "interface.overlap.continuum_ends.x": "8"})
        self.assertEqual(found["reach"].settings(-1), {"tunnels[0].particles.ground": "1"})
        self.assertEqual(found["lining"].settings(-2), {"tunnels[0].lining.as": "beam", "tunnels[0].particles": "null"})
        self.assertEqual([each.name for each in choices({"time": {"dt": 1e-3}})], [])

    def test_a_scene_with_statics_may_come_nearer_to_rest_and_by_another_way(self):
        nearer, = rest({"time": {}, "statics": {"unbalanced_ratio": 8e-5}})
        self.assertEqual(nearer.settings(1), {"statics.unbalanced_ratio": "1e-05"})
        self.assertEqual(rest(SCENE), [])
        for stated, other in (({}, "adaptive"), ({"damping": "adaptive"}, "kinetic")):
            way, = (each for each in choices({"time": {}, "statics": stated}) if each.name == "damping")
            self.assertEqual(way.settings(1), {"statics.damping": other})

    def test_particles_are_not_made_up_for_a_lining_that_has_none(self):
        lining, = (each for each in choices({"tunnels": [{"lining": {"as": "beam"}}]}) if each.name == "lining")
        self.assertEqual(lining.settings(1), {"tunnels[0].lining.as": "zones"})
        self.assertIsNone(lining.settings(2))

    def test_runs_are_named_by_what_differs(self):
        self.assertEqual(name_of({"zones": 1, "particles": 0}), "zones_x2")
        self.assertEqual(name_of({"zones": -1, "particles": 1}), "zones_x0.5,particles_x2")
        self.assertEqual(name_of({"zones": 0}), "stated")


class Scatters(unittest.TestCase):
    def test_packings_have_other_seeds_until_their_results_are_found_alike(self):
        scatter = Scatter(SCENE, 0.01)
        others = scatter.others(cracked=False)
        self.assertEqual([each["particles.cells.seed"] for each in others], ["8", "9", "10", "11"])
        self.assertEqual([each["tunnels[0].particles.seed"] for each in others], ["2", "3", "4", "5"])
        self.assertFalse(scatter.counts({"q": [1.0, 1.001, 1.002, 0.999, 1.0]}, cracked=False))
        self.assertEqual(scatter.others(cracked=False), [])
        self.assertEqual(len(scatter.others(cracked=True)), 4)  # which may scatter all the same
        self.assertTrue(scatter.counts({"q": [1.0, 1.3, 1.1, 0.9, 1.0]}, cracked=True))
        self.assertEqual(len(scatter.others(cracked=True)), 4)

    def test_what_cracks_without_seeds_differs_in_the_last_digits_of_its_step(self):
        scatter = Scatter({"time": {"dt": 1e-3}}, 0.01)
        self.assertEqual(scatter.others(cracked=False), [])
        steps = [float(each["time.dt"]) for each in scatter.others(cracked=True)]
        self.assertEqual(len({1e-3, *steps}), 5)
        self.assertTrue(all(abs(step / 1e-3 - 1) < 1e-11 for step in steps))


class Model:
    """A result with an error of second order by zones and of first order by particles; `most`: the finest level that can be computed;
    `spread`: of its five runs, relative; `company`: what other figures change by, in the first halving."""

    def __init__(self, zones, particles, most=9, spread=0.0, company=0.0):
        self.zones, self.particles, self.most, self.spread, self.company, self.asked = zones, particles, most, spread, company, []

    def __call__(self, levels):
        if not all(level <= self.most for level in levels.values()):
            return None
        self.asked.append(dict(levels))
        value = 1 + self.zones / 4**levels["zones"] + self.particles / 2**levels["particles"]
        ranges = {"q": (value * (1 - self.spread), value * (1 + self.spread))}
        figures = {key: 1 + (self.company + share * 1e-9) * levels["zones"] for share, key in enumerate("abc", 1)}
        return Computed(dict(levels), {"q": value}, 8.0**levels["zones"] + 8.0**levels["particles"], ranges, {"q": value} | figures)

    def searched(self, within, budget=math.inf, lowest=-3):
        search = Search(self, within, budget)
        return search, search.run(self({"zones": lowest, "particles": lowest}))


class Searches(unittest.TestCase):
    def test_all_dimensions_are_halved_together_until_the_limit_is_as_near_as_asked(self):
        for zones, particles in ((0.001, 0.1), (0.1, 0.001), (0.03, -0.03)):
            model = Model(zones, particles)
            search, reached = model.searched(0.03)
            self.assertTrue(reached)
            self.assertTrue(all(levels["zones"] == levels["particles"] for levels in model.asked))
            self.assertGreaterEqual(search.interval("q"), abs(search.value("q") - 1))
            self.assertLessEqual(search.interval("q"), 0.03 * search.value("q"))

    def test_no_model_is_finer_than_it_must_be(self):
        search, reached = Model(zones=0.001, particles=0.001).searched(0.05)
        self.assertTrue(reached)
        before = Search(None, 0.05, 0.0, models=search.models[:-1])
        self.assertTrue(before.lacking("q"))
        self.assertLess(search.best.levels["zones"], 0)

    def test_one_change_is_enough_where_all_figures_change_as_little(self):
        search, reached = Model(zones=1e-5, particles=0.0, company=0.002).searched(0.1, lowest=0)
        self.assertTrue(reached)
        self.assertEqual(search.best.levels, {"zones": 1, "particles": 1})
        self.assertGreaterEqual(search.interval("q"), 3 * 0.9 * 0.002)  # not less than what they do

    def test_one_change_that_is_small_by_chance_is_not(self):
        search, reached = Model(zones=1e-5, particles=0.0, company=0.1).searched(0.1, lowest=0)
        self.assertTrue(reached)
        self.assertEqual(search.best.levels, {"zones": 2, "particles": 2})

    def test_too_few_figures_tell_no_chance(self):
        one = [Computed({}, {}, 1.0, figures={"q": value, "constant": 5.0}) for value in (1.0, 1.001)]
        self.assertEqual(median_change(*one), math.inf)

    def test_the_coarsest_model_is_the_first_that_can_be_computed(self):
        model = Model(zones=0.1, particles=0.1)
        found = coarsest(lambda levels: model(levels) if levels["zones"] > -2 else None, ["zones", "particles"], -3)
        self.assertEqual(found.levels, {"zones": -1, "particles": -1})
        self.assertIsNone(coarsest(lambda levels: None, ["zones"], -3))

    def test_the_budget_is_kept(self):
        search, reached = Model(zones=0.1, particles=0.1).searched(1e-4, budget=100)
        self.assertFalse(reached)
        self.assertTrue(search.unfinished())
        self.assertLess(sum(run.seconds for run in search.runs), 100)
        self.assertGreater(sum(run.seconds for run in search.runs) + search.next_seconds(), 100)

    def test_a_budget_for_one_model_tells_no_error(self):
        search, reached = Model(zones=0.1, particles=0.1).searched(0.5, budget=1e-9)
        self.assertFalse(reached)
        self.assertTrue(search.unfinished())
        self.assertEqual(search.interval("q"), math.inf)

    def test_no_answer_is_told_more_accurately_than_the_model_is_at_rest(self):
        model = Model(zones=0.0, particles=0.0)
        begun = []

        def resting(levels):
            found = model({name: levels[name] for name in ("zones", "particles")})
            found.values["q"] += 0.01 * levels.get("rest", 0)
            return found

        search = Search(resting, 0.05, math.inf, rest="rest", ahead=lambda *levels: begun.extend(levels))
        self.assertTrue(search.run(resting({"zones": -3, "particles": -3})))
        self.assertAlmostEqual(search.interval("q"), 3 * 0.01, 6)  # one change counts three times
        self.assertEqual(begun, [{"zones": -3, "particles": -3, "rest": 1}])
        search = Search(resting, 0.01, 1e3, rest="rest")
        self.assertFalse(search.run(resting({"zones": -3, "particles": -3})))

    def test_what_cannot_be_finer_ends_the_search(self):
        search, reached = Model(zones=0.1, particles=0.1, most=1).searched(1e-4)
        self.assertFalse(reached)
        self.assertTrue(search.stuck)
        self.assertEqual(max(search.best.levels.values()), 1)

    def test_a_scatter_counts_and_no_refinement_chases_it(self):
        search, reached = Model(zones=0.001, particles=0.001, spread=0.02).searched(0.05)
        self.assertTrue(reached)
        self.assertGreaterEqual(search.interval("q"), 0.02)
        search, reached = Model(zones=0.001, particles=0.001, spread=0.08).searched(0.05)
        self.assertFalse(reached)
        self.assertFalse(search.unfinished())
        self.assertTrue(search.scatters("q"))
        self.assertEqual(search.best.levels, {"zones": -2, "particles": -2})


def searched(*values, sizes=frozenset(), **last):
    """A search that ended with models whose answers were these, each with half as large lengths, the last one with more fields."""
    models = [Computed({"zones": level}, {"q": value}, 1.0, sizes=sizes, **(last if level == len(values) - 1 else {}))
              for level, value in enumerate(values)]
    return Search(None, 0.05, 0.0, models=models)


class NotNegative(unittest.TestCase):
    def test_an_interval_ends_at_zero_and_keeps_its_other_end(self):
        """The changes 1, 2 and 4 grow; of what may be negative the interval reaches below 0."""
        free, size = searched(10.0, 9.0, 7.0, 3.0), searched(10.0, 9.0, 7.0, 3.0, sizes=frozenset("q"))
        self.assertLess(free.value("q") - free.interval("q"), 0)
        self.assertEqual(size.value("q") - size.interval("q"), 0)
        self.assertAlmostEqual(size.value("q") + size.interval("q"), free.value("q") + free.interval("q"))
        self.assertTrue(size.lacking("q"))

    def test_intervals_above_zero_and_unknown_ones_stay(self):
        for values in ((10.0, 9.0, 8.5), (10.0,)):
            free, size = searched(*values), searched(*values, sizes=frozenset("q"))
            self.assertEqual((size.value("q"), size.interval("q")), (free.value("q"), free.interval("q")))

    def test_sizes_times_and_numbers_are_not_negative(self):
        class Told:
            summary = {"crack_count": 3, "particles_began_s": 0.1, "ring_largest_thrust_N": 2.0, "drift_m_per_s": 1.0, "top_uy_m": 0.3,
                       "largest_ax_m_per_s2": 1.0}

        found = {question for question in [*Told.summary, "column_of_histories_m"] if is_size(Told, question)}
        self.assertEqual(found, {"crack_count", "particles_began_s", "ring_largest_thrust_N", "column_of_histories_m"})


class Pages(unittest.TestCase):
    """The page and the table say what the terminal says."""
    scatter = Scatter({"time": {"dt": 1.0}, "particles": {"cells": {}}}, 0.005)

    def told(self, search):
        first, *_, last = verdict(search, search.reached(), self.scatter, Choices(None, [], [], None, 0.05))
        return first, last, [line for line in markdown(search) if line.startswith("| q")], csv_rows(search)

    def test_of_what_scatters_the_median_is_told_with_the_range(self):
        sentence, _, (row,), (before, last) = self.told(searched(89.0, 153.0, ranges={"q": (123.0, 161.0)}, runs=4, tried=5))
        self.assertEqual(sentence, "q = 153, from 123 to 161: it scatters, and this is the median of four packings")
        self.assertEqual(row, "| q | 153 | it scatters, from 123 to 161 | – | – | – | 12 |")
        self.assertEqual({key: last[key] for key in last if key.startswith("q")}, {"q": 153, "q_from": 123, "q_to": 161, "q_told": 153, "q_interval": ""})
        self.assertEqual((before["q_from"], before["q_told"], list(before)), ("", "", list(last)))

    def test_of_others_the_interval_is_told(self):
        search = searched(1.0, 1.1, 1.15, ranges={"q": (1.149, 1.151)}, runs=5, tried=5)
        sentence, _, (row,), (*_, last) = self.told(search)
        self.assertRegex(sentence, r"^q = 1\.1667 ± 4\.4 %, the median of five packings \(from 1\.149 to 1\.151\)$")
        self.assertTrue(row.startswith("| q | 1.1667 | 4.4 |"), row)
        self.assertEqual((last["q_told"], last["q_interval"]), (search.value("q"), search.interval("q")))

    def test_one_packing_alone_tells_no_scatter(self):
        sentence, *_ = self.told(searched(1.0, 1.1, 1.15, tried=5))
        self.assertTrue(sentence.endswith("of one alone of five packings, so that it is not known how it scatters"), sentence)

    def test_one_model_is_one(self):
        for values, counted in (((1.0,), ": 1 model, 1 s"), ((1.0, 1.1), ": 2 models, 2 s")):
            self.assertIn(counted, "\n".join(verdict(searched(*values), False, self.scatter, Choices(None, [], [], None, 0.05))))


class Failing(unittest.TestCase):
    """`_program` stands for the coupler: it writes a summary, or fails for some runs."""
    def computed(self, folder, failing=(), question="q", levels=0, **summary):
        class Told(Runs):
            def _program(self, name, settings):
                if name in failing:
                    return 2, "error: too tight", 1.0
                (self.out / name).mkdir()
                (self.out / name / "histories.csv").write_text("time_s,top_uy_m\n0,0\n1,-2\n")
                (self.out / name / "summary.json").write_text(json.dumps({"q": 3.0 + 0.5 * len(name), "plane": "plane_strain"} | summary))
                return 0, "", 1.0

        runs = Told(Path("scene.yaml"), {"time": {"dt": 1.0}, "particles": {"cells": {"seed": 1}}}, [question], Path(folder), (), 0.05)
        with contextlib.redirect_stdout(io.StringIO()) as told:
            return runs.compute([Dimension("zones", {"a": 4.0}, 1, ("", ""))], {"zones": levels}), told.getvalue()

    def test_a_packing_that_fails_is_told_and_not_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            found, told = self.computed(folder, failing=("stated_3",))
        self.assertEqual((found.runs, found.tried), (4, 5))
        self.assertIn("  stated_3 cannot be computed (exit code 2): too tight\n", told)
        self.assertIn("(4 of 5 packings)", told)

    def test_all_packings_are_counted_where_none_fails(self):
        with tempfile.TemporaryDirectory() as folder:
            found, told = self.computed(folder)
        self.assertEqual((found.runs, found.tried), (5, 5))
        self.assertIn("(5 packings)", told)

    def test_a_first_model_that_fails_is_not_told(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(self.computed(folder, failing=("stated",)), (None, ""))

    def test_questions_must_be_about_numbers(self):
        for question, value, what in (("plane", "plane_strain", "a text"), ("parts", [1.0], "a list"), ("inputs", {}, "a mapping"), ("completed", True, "true or false")):
            with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(
                    Unusable, rf"^{question} is {what} in \S+/stated/summary.json, not a number; (the nearest are|choose one of its) .*\.$"):
                self.computed(folder, question=question, **{question: value})

    def test_unknown_questions_are_refused(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(Unusable, r"^wall_thrust is no figure of .*; the nearest are wall_thrust_N\.$"):
            self.computed(folder, question="wall_thrust", wall_thrust_N=1.0)


class Begun(unittest.TestCase):
    def test_models_that_are_begun_ahead_tell_the_same(self):
        """Each program is run once, whether it was begun or not; `_program` stands for the coupler."""
        programs = []

        class Told(Runs):
            def _program(self, name, settings):
                programs.append(name)
                (self.out / name).mkdir()
                (self.out / name / "histories.csv").write_text("time_s,top_uy_m\n0,0\n1,-2\n")
                (self.out / name / "summary.json").write_text(json.dumps({"q": 3.0, "longest_m": len(settings), "tip_x_m": 1.0}))
                return 0, "", 1.0

        found = []
        for ahead in (False, True):
            with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(io.StringIO()):
                runs = Told(Path("scene.yaml"), {"time": {"dt": 1.0}}, ["q"], Path(folder), (), 0.05)
                dimension = Dimension("zones", {"a": 4.0}, 1, ("", ""))
                if ahead:
                    runs.ahead([dimension], {"zones": 1}, {"zones": -1})
                found.append([runs.compute([dimension], {"zones": level}) for level in (-1, 1)])
        self.assertEqual(found[0], found[1])
        self.assertEqual(found[0][0].figures, {"longest_m": 1.0, "top_uy_m": 2.0})
        self.assertEqual(sorted(programs), sorted(2 * ["zones_x0.5", "zones_x2"]))


class Ladders(unittest.TestCase):
    def climbed(self, budget=math.inf):
        model = Model(zones=0.04, particles=0.02)
        zones, particles = (Dimension(name, {name: 8.0}, power, ("finer", "coarser")) for name, power in (("zones", 1), ("particles", -1)))
        ladder = Ladder(lambda levels: model({"zones": 0, "particles": 0} | levels), [zones, particles], [], budget)
        self.assertTrue(ladder.climb())
        return ladder

    def test_each_dimension_is_changed_by_itself_and_has_its_order(self):
        ladder = self.climbed()
        self.assertEqual([name_of(rung.levels) for rung in ladder.rungs], [
            "stated", "zones_x0.25", "zones_x0.5", "zones_x2", "particles_x0.25", "particles_x0.5", "particles_x2", "zones_x2,particles_x2"])
        self.assertAlmostEqual(ladder.order("zones", "q"), 2)
        self.assertAlmostEqual(ladder.order("particles", "q"), 1)
        self.assertEqual(ladder.finest.levels, {"zones": 1, "particles": 1})
        self.assertAlmostEqual(ladder.difference(ladder.rungs[0], "q"), 1.06 / 1.02 - 1)

    def test_models_beyond_the_budget_are_named(self):
        ladder = self.climbed(budget=10)
        self.assertLess(sum(rung.computed.seconds for rung in ladder.rungs), 10)
        self.assertIn("zones_x2,particles_x2", ladder.left_out)
        self.assertEqual(ladder.finest.levels, {})


class Told(unittest.TestCase):
    def test_ground_that_softens_is_named(self):
        material = {"mohr_coulomb": {"cohesion": 1e3, "softening": [{"plastic_shear_strain": 0.02}]}}
        self.assertTrue(softens({"continuum": {"materials": [{"material": material}]}}))
        self.assertFalse(softens(SCENE))

    def test_choices_that_no_refinement_removes_are_named(self):
        """Of two choices, one changes the result by 4 % and one by less than half of the accuracy asked for."""
        first = Computed({"zones": -1}, {"q": -1.0}, 1.0)
        changed = {"overlap": -1.04, "step": -1.001}

        class Computing:
            def compute(self, dimensions, levels):
                return Computed(levels, {"q": changed[dimensions[-1].name]}, 1.0)

        found = [Dimension(name, {name: 1.0}, 1, ("twice as wide", "half as wide")) for name in changed]
        told = Choices(Computing(), [], found, first, 0.05)
        told.compute(100)
        sentence, = told.sentences()
        self.assertIn("q depends on the overlap: twice as wide changes it by -4 %", sentence)
        self.assertEqual(told.named(), ["q"])
        self.assertEqual(told.beside("q"), ", but -4 % by another overlap")
        self.assertEqual(told.beside("p"), "")
        told = Choices(Computing(), [], found, first, 0.05)
        told.compute(1)
        self.assertEqual(list(told.sentences()), ["the budget does not suffice to change the overlap, the step"])

    def test_a_choice_that_cannot_be_computed_is_told(self):
        class Failing:
            failure = "stated,overlap_x2 cannot be computed (exit code 2): too wide"

            def compute(self, dimensions, levels):
                return None

        told = Choices(Failing(), [], [Dimension("overlap", {"a": 1.0}, 1, ("", ""))], Computed({}, {"q": 1.0}, 1.0), 0.05)
        told.compute(100)
        self.assertEqual(list(told.sentences()), [f"the overlap could not be changed: {Failing.failure}"])
        self.assertEqual(told.named(), [])


if __name__ == "__main__":
    unittest.main()
