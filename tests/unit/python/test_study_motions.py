"""The motions of a study: factors give them their intensity, all components have the same one, and a search finds that of a level in
ground that answers nonlinearly."""
import json
import math
import unittest
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace
from unittest import mock

from adit.results.files import Unusable
from adit.study import component, design, motions, search, table
from adit.study.pictures.fragility import on_levels
from adit.study.study import Levels, Study


def motion(name="m", **measures):
    return motions.Motion(name, (component.Component("base", {"ricker": {}}, 3.0),), measures or {"pga": 3.0, "arias": 0.9})


def study(levels=None, **changes):
    given = {"path": Path("s.yaml"), "samples": 1, "levels": levels, "climbs": levels and levels.how == "increments", "damage": [],
             "searches": levels and levels.at != "", "largest_factor": math.inf, "motions": {}, "intensity": ("pga", None, "")}
    return SimpleNamespace(**(given | changes))


class Motions(unittest.TestCase):
    def test_grow_with_their_measure_and_the_arias_intensity_with_its_root(self):
        self.assertEqual(motion().factor_at("pga", 6.0), 2)
        self.assertAlmostEqual(motion().factor_at("arias", 3.6), 2)
        self.assertEqual(motion().settings_at(2.0), {"base": '{"ricker": {}, "peak": 6.0}'})
        self.assertEqual(motion().measures_at(2.0), {"pga": 6.0, "arias": 3.6})

    def test_scaled_too_far_up_or_down_are_excessive(self):
        self.assertEqual([motions.excessive(factor, 4.0) for factor in (0.2, 0.25, 1, 4, 5)], [True, False, False, False, True])

    def test_of_a_cloud_take_turns_in_the_samples_and_each_has_a_run(self):
        several = [motion(name) for name in "abc"]
        for samples, turns in ((1, "abc"), (2, "abc"), (5, "abcab")):
            found = design.with_motions(study(samples=samples), several)
            self.assertEqual("".join(row.motion for (row,) in found.climbs), turns)

    def test_names_tell_them_apart(self):
        given = [{"file": {"path": "/a/KOBE.AT2"}}, {"file": {"path": "/b/KOBE.AT2"}}, {"synthetic": {"spectrum": "ec8_type_1", "ground": "b", "seed": 3}},
                 {"sine": {"frequency": 2}}]
        self.assertEqual(motions._names(given), ["KOBE_1", "KOBE_2", "ec8_type_1_b_3", "sine_2Hz"])


class Components(unittest.TestCase):
    """Of records whose whole curves have the peaks PEAKS, of which the run takes a part with 0.8 of that."""
    PEAKS = {"A_H1.AT2": 2.0, "A_UP.AT2": 0.5}

    def setUp(self):
        self.folder = Path(self.enterContext(TemporaryDirectory()))
        for name in self.PEAKS:
            (self.folder / name).touch()
        self.enterContext(mock.patch.object(component, "variants", self.variants))

    def variants(self, study, rows, *options):
        """What `coupler variants --motion` tells of these records."""
        told = []
        for row in rows:
            given = json.loads(*row.values())
            told.append({"motion": {"pga": 0.8 * given.get("peak", self.PEAKS[Path(given["file"]["path"]).name]), "arias": 0.1}})
        return told

    def read(self, key="continuum.base.across", instead_of="_H1", name="_UP", motion="A_H1.AT2", **given):
        asked = {"key": key, "instead_of": instead_of, "name": name}
        given = {"file": {"path": str(self.folder / motion), "time_step": 0.01}, "low_corner": 0.1} | given
        stated = {"of": [given], "key": "continuum.base.acceleration", "components": [asked]}
        return motions.read(study(folder=self.folder, motions=stated), 0)[0]

    def test_have_the_factor_and_the_processing_of_the_record(self):
        found = {key: json.loads(text) for key, text in self.read().settings_at(3.0).items()}
        self.assertEqual(list(found), ["continuum.base.acceleration", "continuum.base.across"])
        self.assertEqual(found["continuum.base.across"]["file"], {"path": str(self.folder / "A_UP.AT2"), "time_step": 0.01})
        for (key, each), peak in zip(found.items(), (3 * 2.0, 3 * 0.5)):
            self.assertAlmostEqual(each["peak"], peak, 12, key)
            self.assertEqual(each["low_corner"], 0.1, key)

    def test_are_as_recorded_where_the_record_is_and_follow_a_peak_that_is_stated(self):
        found = {key: json.loads(text) for key, text in self.read().as_stated.items()}
        self.assertNotIn("peak", found["continuum.base.across"])
        twice = self.read(peak=4.0)
        self.assertAlmostEqual(json.loads(twice.as_stated["continuum.base.across"])["peak"], 2 * 0.5, 12)
        self.assertAlmostEqual(json.loads(twice.settings_at(3.0)["continuum.base.across"])["peak"], 3 * 2 * 0.5, 12)

    def test_that_a_motion_lacks_are_told(self):
        for changed, said in (({"name": "_V"}, "A_H1.AT2 has no A_V.AT2 beside it"),
                              ({"instead_of": "_EW"}, "A_H1.AT2 has no _EW in its name"),
                              ({"key": "continuum.base.acceleration"}, "stands another component already")):
            with self.subTest(said), self.assertRaisesRegex(Unusable, rf"s\.yaml: motions\.components\[0\].*{said}"):
                self.read(**changed)
        with mock.patch.object(component, "variants", lambda study, rows, *options: [{"motion": {"pga": 1.0}}] * len(rows)):
            synthetic = {"of": [{"synthetic": {}}], "key": "base", "components": [{"key": "across", "instead_of": "_H1", "name": "_UP"}]}
            with self.assertRaisesRegex(Unusable, "motion gb_18306_1 is no record"):
                motions.read(study(motions=synthetic), 0)

    def test_that_do_not_move_the_ground_are_refused(self):
        self.PEAKS = self.PEAKS | {"A_UP.AT2": 0.0}
        with self.assertRaisesRegex(Unusable, r"components\[0\]: motion A_H1: does not move the ground"):
            self.read()


class Stated(unittest.TestCase):
    def read(self, how="stripes", **changes):
        levels = {"sa": [1.0, 2.0], "period": 0.5, "at": "surface"}
        damage = [{"of": "drift", "states": [{"name": "broken", "above": 1.0}]}]
        motions = {"of": [{}], how: levels, **changes}
        return Study(Path("s.yaml"), {"scene": "a.yaml", "questions": ["drift"], "damage": damage, "motions": motions})

    def test_a_place_of_levels_is_that_of_curves_unless_they_are_told_over_another_intensity(self):
        self.assertEqual(self.read().intensity, ("sa", 0.5, "surface"))
        other = self.read(intensity={"measure": "pgv"})
        self.assertEqual(other.intensity, ("pgv", None, ""))
        self.assertEqual([on_levels(SimpleNamespace(study=each)) for each in (self.read(), other)], [True, False])

    def test_the_table_has_what_was_reached_beside_another_intensity(self):
        with mock.patch.object(table, "measured", lambda folder, place, measure, period: {"sa": 2.5, "pga": 1.5}[measure]):
            computed = [(design.Row("m", level=2.0), {"answers": {"drift": 0.0}})]
            rows = table.rows_of(self.read(intensity={"at": "crown"}), computed, Path("out"))
        self.assertEqual((rows[0]["surface_sa(0.5s)_m_per_s2"], rows[0]["crown_pga_m_per_s2"]), (2.5, 1.5))

    def test_stripes_at_a_place_go_from_level_to_level(self):
        found = design.with_motions(self.read(), [motion(**{"sa(0.5s)": 1.0})])
        self.assertEqual([[row.level for row in climb] for climb in found.climbs], [[1.0, 2.0]])


class Search(unittest.TestCase):
    """In ground whose free surface has the intensity `ground(factor)`; each run is known by its factor."""
    LEVELS = [0.5, 1.0, 2.0, 4.0]

    def climb(self, ground, how="stripes", measure="pga", failing=math.inf, **changes):
        """([(row, result)] that are found, factors of all runs, progress)."""
        asked = study(Levels(how, measure, self.LEVELS, None, "surface"), **changes)
        (rows,) = design.with_motions(asked, [motion(pga=1.0, arias=1.0)]).climbs
        progress = mock.Mock()
        factors = []

        def identify(study, rows):
            for row in rows:
                row.hash = repr(row.factor)

        with mock.patch.object(design, "identify", identify), \
                mock.patch.object(search.table, "measured", lambda folder, *of: ground(float(folder.name))):
            way = search.climb(asked, rows, Path("out"), progress)
            result = None
            while True:
                try:
                    factors.append(way.send(result).factor)
                except StopIteration as end:
                    return end.value, factors, progress
                result = {"failed": "unstable"} if factors[-1] >= failing else {"answers": {"drift": ground(factors[-1])}}

    def assert_reached(self, found, ground, levels=None):
        self.assertEqual([row.level for row, _ in found], levels or self.LEVELS)
        for row, _ in found:
            self.assertAlmostEqual(ground(row.factor) / row.level, 1, delta=search.WITHIN)

    def test_takes_two_runs_in_linear_ground_and_one_for_each_further_level(self):
        found, factors, _ = self.climb(lambda factor: 1.7 * factor)
        self.assertEqual(len(factors), 2 + 3)
        for row, _ in found:
            self.assertAlmostEqual(row.factor / (row.level / 1.7), 1, delta=1e-5)
            self.assertEqual(row.measures["pga"], row.factor)
            self.assertEqual(json.loads(row.settings["base"])["peak"], 3 * row.factor)

    def test_knows_that_the_arias_intensity_grows_with_the_square(self):
        found, factors, _ = self.climb(lambda factor: 1.7 * factor**2, measure="arias")
        self.assertEqual(len(factors), 2 + 3)
        for row, _ in found:
            self.assertAlmostEqual(row.factor / math.sqrt(row.level / 1.7), 1, delta=1e-5)

    def test_finds_every_level_that_ground_reaches_however_it_softens_or_hardens(self):
        def weakens_at_once(factor):
            return 3 * factor if factor < 0.5 else 1.2 + 0.6 * factor
        for name, ground in (("softens", lambda factor: 2 * factor**0.7), ("yields", lambda factor: 5 * math.tanh(factor / 2)),
                             ("hardens", lambda factor: factor**1.4), ("weakens at once", weakens_at_once)):
            with self.subTest(name):
                found, factors, _ = self.climb(ground)
                self.assert_reached(found, ground)
                self.assertLessEqual(len(factors), 3.5 * len(self.LEVELS))

    def test_takes_the_exponent_of_the_level_before_to_the_next_one(self):
        _, factors, _ = self.climb(lambda factor: 2 * factor**0.7)
        self.assertEqual(len(factors), 3 + 3)

    def test_follows_the_line_through_the_runs_about_the_level(self):
        for reached, level, expected in (({1.0: 1.0, 2.0: 1.1}, 1.05, (1.0, 2.0)), ({1.0: 1.0, 1.01: 3.0}, 2.0, (1.0, 1.01)),
                                         ({1.0: 1.0, 2.0: 3.0, 4.0: 2.0, 8.0: 9.0}, 2.5, (1.0, 2.0))):
            self.assertTrue(expected[0] < search.line(reached, level, 1, 1).factor_at(level) < expected[1])
        through = search.line({1.0: 1.0, 4.0: 2.0}, 1.5, 1, 1)
        self.assertAlmostEqual(through.exponent, 0.5)
        self.assertAlmostEqual(through.factor_at(1.5), 1.5**2, 4)

    def test_goes_on_from_the_last_run_beyond_all_by_an_exponent_within_bounds(self):
        for reached, level, expected in (({1.0: 1.0, 2.0: 0.9}, 1.8, 2 * 2**2), ({1.0: 1.0, 2.0: 9.0}, 18, 2 * 2**0.5),
                                         ({1.0: 1.0, 2.0: 0.9}, 0.5, 0.5**2), ({3.0: 1.0}, 2.0, 6.0)):
            self.assertAlmostEqual(search.line(reached, level, 1, 1).factor_at(level), expected, 4)

    def test_ends_where_ground_yields_with_the_run_that_is_nearest(self):
        def ground(factor):
            return 1.5 * math.tanh(factor / 1.5)
        found, factors, _ = self.climb(ground)
        self.assertLessEqual(len(factors), 2 + 3 + 2 * 2)
        self.assert_reached(found[:2], ground, self.LEVELS[:2])
        for row, _ in found[2:]:
            self.assertAlmostEqual(ground(row.factor), 1.5, delta=0.03)
        good = [{"level": row.level, "surface_pga_m_per_s2": ground(row.factor)} for row, _ in found]
        asked = study(Levels("stripes", "pga", self.LEVELS, None, "surface"))
        self.assertEqual([row["level"] for row in search.missed(asked, good)], [2.0, 4.0])

    def test_takes_six_runs_for_a_level_at_most(self):
        found, factors, _ = self.climb(lambda factor: 0.9 if factor < 1 else 3.0)  # no factor reaches 0.5, 1, 2 or 4
        self.assertEqual([result["answers"]["drift"] for _, result in found], [0.9, 0.9, 3.0, 3.0])  # the nearest ones
        self.assertLessEqual(len(factors), search.MOST * 4)
        self.assertGreater(len(factors), search.MOST)

    def test_leaves_out_what_no_allowed_factor_reaches(self):
        found, factors, progress = self.climb(lambda factor: 0.5 * factor, largest_factor=3.0)
        self.assert_reached(found, lambda factor: 0.5 * factor, [0.5, 1.0])
        self.assertLessEqual(max(factors), 3)
        self.assertEqual([(each.args[0].level, each.args[1]) for each in progress.leave_out.call_args_list], [(2.0, 4.0), (4.0, 8.0)])
        found, _, _ = self.climb(lambda factor: 2 * factor, largest_factor=3.0)  # whose factors are allowed, though not by the outcrop
        self.assert_reached(found, lambda factor: 2 * factor, [1.0, 2.0, 4.0])

    def test_of_a_climb_ends_with_the_last_damage_state_or_a_failure_and_that_of_stripes_does_not(self):
        damage = [SimpleNamespace(of="drift", states=[None], reached=lambda drift: int(drift > 0.9))]
        for how, found, failing in (("increments", 2, math.inf), ("increments", 3, 1.0), ("stripes", 4, math.inf), ("stripes", 4, 1.0)):
            with self.subTest(how, failing=failing):
                rows, _, progress = self.climb(lambda factor: 2 * factor, how, failing=failing, damage=damage if math.isinf(failing) else [
                    SimpleNamespace(of="drift", states=[None], reached=lambda drift: 0)])
                self.assertEqual(len(rows), found)
                self.assertEqual(["failed" in result for _, result in rows], [row.factor >= failing for row, _ in rows])

    def test_tells_progress_how_many_runs_come(self):
        for how, damage in (("stripes", []), ("increments", [SimpleNamespace(of="drift", states=[None], reached=lambda drift: int(drift > 0.9))])):
            _, factors, progress = self.climb(lambda factor: 2 * factor**0.7, how, damage=damage)
            self.assertEqual(len(self.LEVELS) + sum(each.args[0] for each in progress.expect.call_args_list), len(factors))

    def test_of_a_place_that_stays_at_rest_is_refused(self):
        with self.assertRaisesRegex(Unusable, r"s\.yaml: motions\.stripes\.at: surface stays at rest in m at 0\.5"):
            self.climb(lambda factor: 0.0)

    def test_counts_its_runs_before(self):
        climbs = [[None] * 3, [None] * 3]
        self.assertEqual(search.runs_of(study(Levels("stripes", "pga", [], None, "surface")), climbs), (6, 36))
        self.assertEqual(search.runs_of(study(Levels("increments", "pga", [], None, "surface")), climbs), (2, 36))


if __name__ == "__main__":
    unittest.main()
