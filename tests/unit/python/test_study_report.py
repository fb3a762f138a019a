"""Pictures and the page of a study show what its runs tell, from rows that are made by hand."""
import json
import pathlib
import re
import tempfile
import unittest
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
from pieces import piece
from scipy.stats import norm

from adit.plots import png, style
from adit.study import page, pictures
from adit.study.fragility.curves import Curve
from adit.study.fragility.measures import G
from adit.study.outcome import Outcome
from adit.study.pictures import answers, axes, chosen, fragility, inputs, linings, over_time
from adit.study.study import Study

LEVELS = [0.1 * G, 0.2 * G, 0.4 * G, 0.8 * G]
STATES = [{"name": "minor", "above": 0.01}, {"name": "major", "above": 0.02}, {"name": "collapse", "above": 9.0}]
DAMAGE = [{"of": "drift_ux_m", "states": STATES}]
STRIPES = {"of": [{}], "stripes": {"pga": LEVELS}}
MOTIONS = 9


def text_of(markup):
    return " ".join(re.sub(r"<[^>]+>", " ", markup).split())


def of_level(outcome, level):
    """Drifts of the runs at a level."""
    return np.array([row["drift_ux_m"] for row in outcome.good if row["level"] == level])


class Made(unittest.TestCase):
    """Studies of a drift that is 0.04 m/g times the intensity, and times a factor of the motion whose logarithm has the deviation 0.4."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = pathlib.Path(folder.name)
        for name in (f"runs/{number}" for number in range(MOTIONS)):
            (self.out / name).mkdir(parents=True)
            (self.out / name / "summary.json").write_text(json.dumps({"versions": "coupler 1.2.3"}))
        self.addCleanup(style.plt.close, "all")

    def outcome(self, rows, **read):
        path = self.out / "made.yaml"
        path.write_text("scene: <tunnel>.yaml\n")
        return Outcome(Study(path, {"scene": "tunnel.yaml", "questions": ["drift_ux_m"], **read}), rows)

    def row(self, motion, intensity, level=None, factor=1.0, sample="0_0", failed="", **more):
        drift = None if failed else 0.04 * np.exp(0.4 * norm.ppf((motion + 0.5) / MOTIONS)) * intensity / G
        return {"run": 1, "motion": f"m{motion}", "level": level, "factor": factor, "sample": sample, "pga_m_per_s2": intensity,
                "drift_ux_m": drift, **more, "failed": failed, "folder": f"runs/{motion}"}

    def stripes(self, failed=(), damage=STATES, **more):
        rows = [self.row(motion, level, level, level / 2, failed="the time step <became> unstable" if (motion, level) in failed else "")
                for motion in range(MOTIONS) for level in LEVELS]
        return self.outcome(rows, motions=STRIPES, damage=[{"of": "drift_ux_m", "states": damage}], **more)

    def climbs(self):
        rows = []
        for motion in range(MOTIONS):
            for level in LEVELS:
                rows.append(self.row(motion, level, level, sample=f"0_{motion}"))
                if rows[-1]["drift_ux_m"] > STATES[1]["above"]:
                    break
        return self.outcome(rows, motions={"of": [{}], "increments": {"pga": LEVELS}}, damage=[{"of": "drift_ux_m", "states": STATES[:2]}])

    def cloud(self, count=24):
        rows = [self.row(number * 5 % MOTIONS, G * 0.05 * 1.12**number) for number in range(count)]
        return self.outcome(rows, motions={"of": [{}]}, damage=DAMAGE)

    def plain(self, count=40):
        rows = [self.row(number % MOTIONS, G * 0.4) | {"motion": "", "stiffness": float(number)} for number in range(count)]
        random = {"name": "stiffness", "keys": ["material.young_modulus"], "unit": "MPa", "lognormal": {"median": 100, "dispersion": 0.2},
                  "least": 50}
        return self.outcome(rows, random=[random], damage=DAMAGE)

    def lines(self, drawing):
        """{label: (x, y)} of what is drawn, and the texts of the legends."""
        drawn, panels = style.plt.subplots(drawing.layout.rows, drawing.layout.columns, squeeze=False)
        keys = drawing.paint(*panels.flat)
        lines = {line.get_label(): line.get_data() for panel in panels.flat for line in panel.get_lines()}
        style.plt.close(drawn)
        return lines, [" ".join(handle.get_label().split()) for key in keys or () for handle in key.handles]

    def written(self, outcome):
        return page.write(outcome, pictures.draw(outcome, self.out), self.out).read_text()


class Fragility(Made):
    def of(self, outcome):
        ((_, drawing),) = fragility.curves(outcome, self.out)
        return drawing

    def test_curves_are_those_of_the_fits(self):
        """The drawn curve is the fitted one: at its median 50 %, in g and in per cent."""
        for outcome in (self.stripes(), self.climbs(), self.cloud()):
            lines, _ = self.lines(self.of(outcome))
            for each in outcome.curves[:2]:
                x, y = lines[each.state.name]
                np.testing.assert_allclose(y, 100 * each.fit.curve.probability(x * G), rtol=1e-12)
                self.assertAlmostEqual(np.interp(each.fit.curve.median / G, x, y), 50, delta=0.5)

    def test_a_state_without_a_curve_is_told(self):
        lines, legend = self.lines(self.of(self.stripes()))
        self.assertNotIn("collapse", lines)
        self.assertIn("collapse: not exceeded up to 0.8 g in 36 runs", legend)

    def test_without_any_curve_the_picture_is_whole(self):
        outcome = self.stripes(damage=STATES[2:])
        lines, legend = self.lines(self.of(outcome))
        self.assertEqual(legend[0], "collapse: not exceeded up to 0.8 g in 36 runs")
        self.assertFalse([label for label in legend if "band" in label])

    def test_points_at_levels_are_shares_of_the_runs_at_each(self):
        """Of stripes those at the level itself; of climbs those that are known to be damaged there, though they ended before."""
        outcome = self.stripes()
        levels, shares = fragility.at_levels(outcome, outcome.curves[1])
        np.testing.assert_array_equal(levels, LEVELS)
        np.testing.assert_array_equal(shares, [np.mean(of_level(outcome, level) > 0.02) for level in LEVELS])
        climbs = self.climbs()
        for level, share in zip(*fragility.at_levels(climbs, climbs.curves[1])):
            self.assertEqual(share, shares[LEVELS.index(level)])
        self.assertLess(len(climbs.good), len(outcome.good))

    def test_runs_of_a_cloud_stand_above_or_below(self):
        outcome = self.cloud()
        x, y = fragility.of_runs(outcome, 0, outcome.curves[0])
        np.testing.assert_array_equal(y > 1, outcome.answers("drift_ux_m") > 0.01)
        self.assertTrue(((y > 1) | (y < 0)).all())
        np.testing.assert_array_equal(x, outcome.intensity)

    def test_published_curves_stand_beside_named_states_over_peak_acceleration_only(self):
        named = {"motions": STRIPES, "damage": [{"of": "drift_ux_m", "set": "argyroudis_pitilakis"}]}
        lines, legend = self.lines(self.of(self.outcome(self.stripes().listed, **named)))
        name = "HAZUS, bored tunnels, slight: median 0.6 g, dispersion 0.6"
        self.assertIn(name, legend)
        self.assertAlmostEqual(np.interp(0.6, *lines[name]), 50, delta=0.1)
        rows = [row | {"pgv_m_per_s": row["pga_m_per_s2"] / 10} for row in self.cloud().listed]
        of_velocity = self.outcome(rows, motions={"of": [{}], "intensity": {"measure": "pgv"}}, damage=named["damage"])
        for outcome in (of_velocity, self.stripes()):
            damage = outcome.study.damage[0]
            self.assertEqual((fragility.published(outcome, damage), fragility.notes(outcome, damage)), ([], []))

    def test_bands_are_those_of_the_motions_drawn_again(self):
        """At the lowest and the highest computed intensity the filled part ends, at the limits of the bootstrap there."""
        outcome = self.stripes()
        _, panel = style.plt.subplots()
        self.of(outcome).paint(panel)
        for each, filled in zip(outcome.curves, panel.collections):
            x, y = filled.get_paths()[0].vertices.T
            for level in (LEVELS[0], LEVELS[-1]):
                ends = y[np.isclose(x, level / G)]
                np.testing.assert_allclose([ends.min(), ends.max()], 100 * np.ravel(each.bootstrap.band([level])), rtol=1e-9)
            self.assertAlmostEqual(x.min(), LEVELS[0] / G)
            self.assertAlmostEqual(x.max(), LEVELS[-1] / G)

    def test_a_band_that_tells_nothing_is_not_drawn(self):
        """One motion leaves every probability possible."""
        outcome = self.outcome([row | {"motion": "m"} for row in self.cloud().listed], motions={"of": [{}]}, damage=DAMAGE)
        self.assertIsNone(fragility.band(outcome.curves[0], np.array(LEVELS)))
        self.assertIn("too few motions for a band", self.lines(self.of(outcome))[1][0])


class Answers(Made):
    def of(self, outcome):
        ((name, drawing),) = answers.drawings(outcome, self.out)
        self.assertEqual(name, "answer_drift_ux_m")
        return drawing

    def test_fractiles_at_levels_are_those_of_the_runs(self):
        outcome = self.stripes()
        for level, at, count, values in answers.fractiles(outcome, "drift_ux_m"):
            self.assertEqual((at, count), (level, MOTIONS))
            np.testing.assert_allclose(values, np.percentile(of_level(outcome, level), (16, 50, 84)))
        x, y = self.lines(self.of(outcome))[0]["50 % of the runs at a level"]
        np.testing.assert_allclose(x, np.array(LEVELS) / G)
        np.testing.assert_allclose(y, 40 * x, rtol=1e-12)  # mm: the median of the factors is 1

    def test_fractiles_of_climbs_end_where_climbs_end(self):
        """Higher up the strongest answers are missing, so that fractiles would be too low."""
        outcome = self.climbs()
        ends = min(max(row["level"] for row in outcome.good if row["motion"] == f"m{motion}") for motion in range(MOTIONS))
        self.assertEqual([level for level, *_ in answers.fractiles(outcome, "drift_ux_m")], [level for level in LEVELS if level <= ends])

    def test_the_regression_of_a_cloud_is_its_line(self):
        """Where drift is 40 mm/g, the middle line has the power 1 but for the chance of 24 factors."""
        outcome = self.cloud()
        found = outcome.regression("drift_ux_m")
        lines, _ = self.lines(self.of(outcome))
        (label,) = [label for label in lines if label.startswith("regression")]
        self.assertEqual(label, f"regression: power {found.slope:.3g}, R² = {found.r2:.2f}")
        x, y = lines[label]
        np.testing.assert_allclose(y, 1e3 * np.exp(found.intercept) * (x * G)**found.slope, rtol=1e-12)
        np.testing.assert_allclose(lines["84 % by the regression"][1] / y, np.exp(found.deviation), rtol=1e-12)

    def test_runs_without_an_answer_above_0(self):
        rows = self.stripes().listed
        some = self.outcome([row | {"drift_ux_m": 0.0} if row["level"] == LEVELS[0] else row for row in rows], motions=STRIPES)
        self.assertEqual([text for text, _ in self.of(some).notes], ["9 runs with the answer 0 have no place on the logarithmic axis."])
        self.lines(self.of(some))
        none = self.outcome([row | {"drift_ux_m": 0.0} for row in rows], motions=STRIPES)
        self.assertEqual(self.of(none).title, "drift ux: distribution over 36 runs")
        png.figure(self.of(none))
        absent = self.outcome([row | {"drift_ux_m": None} for row in rows], motions=STRIPES)
        self.assertEqual(list(answers.drawings(absent, self.out)), [])

    def test_the_distribution_rises_by_a_step_a_run(self):
        outcome = self.plain()
        lines, legend = self.lines(self.of(outcome))
        x, y = lines["runs up to an answer"]
        values = np.sort(outcome.answers("drift_ux_m"))
        np.testing.assert_allclose(x[1:], 1e3 * values)
        np.testing.assert_allclose(np.diff(y), 100 / len(values))
        self.assertIn(f"50 %: {1e3 * np.median(values):.4g}", legend)
        self.assertIn("collapse above 9e+03, not drawn", legend)


class OverTime(Made):
    def histories(self, number, times, values):
        rows = [f"{time},{value}" for time, value in zip(times, values)]
        (self.out / f"runs/{number}/histories.csv").write_text("\n".join(["time_s,drift_ux_m", *rows]) + "\n")

    def test_fractiles_over_runs_with_other_times(self):
        """Runs with drifts n t have the median 4 t, whatever the times of their rows; a run that ends early counts until then."""
        for number in range(MOTIONS):
            times = np.linspace(0, 1 if number == 8 else 2, 11 + number)
            self.histories(number, times, number * times)
        outcome = self.stripes()
        ((name, drawing),) = over_time.histories(outcome, self.out)
        (x, y) = self.lines(drawing)[0]["50 %"]
        before = x <= 1
        np.testing.assert_allclose(y[before], 4 * x[before], atol=1e-12)
        np.testing.assert_allclose(y[~before], 3.5 * x[~before], atol=1e-12)
        self.assertEqual((name, drawing.title), ("over_time", "answers over time: fractiles of 9 runs at pga = 0.2 g"))

    def test_the_level_nearest_the_median_of_the_lightest_state_is_shown(self):
        self.assertEqual(chosen.level_shown(self.stripes()), LEVELS[1])  # 0.01 m of 0.04 m/g: 0.25 g
        self.assertEqual(chosen.level_shown(self.stripes(damage=STATES[1:])), LEVELS[2])  # 0.5 g
        self.assertEqual(chosen.level_shown(self.stripes(damage=STATES[2:])), LEVELS[1])  # no curve: one in the middle

    def test_of_many_runs_some_are_read(self):
        found = chosen.chosen(self.plain(count=250), self.out)
        self.assertEqual((len(found.runs), found.said), (chosen.MOST, "100 of 250 runs"))

    def test_figures_of_the_summary_have_no_histories(self):
        for number in range(MOTIONS):
            (self.out / f"runs/{number}/histories.csv").write_text("time_s,other_ux_m\n0,0\n1,1\n")
        self.assertEqual(list(over_time.histories(self.stripes(), self.out)), [])


class Linings(Made):
    def test_largest_values_along_a_tunnel(self):
        """Of runs with forces from -n to n/2 MN everywhere, the median of the largest is 4 MN at every chainage, though each has others."""
        for number in range(MOTIONS):
            rows = [f"{at},{-number * 1e6},{number * 5e5}" for at in np.linspace(0, 1000, 5 + number)]
            header = "chainage_m,axial_force_min_N,axial_force_max_N"
            (self.out / f"runs/{number}/envelopes.csv").write_text("\n".join([header, *rows]) + "\n")
        ((name, drawing),) = linings.envelopes(self.stripes(keep=["envelopes.csv"]), self.out)
        lines, _ = self.lines(drawing)
        self.assertEqual(name, "along_the_axis")
        np.testing.assert_allclose(lines["50 %"][1], 4)
        np.testing.assert_allclose(lines["50 %"][0], np.linspace(0, 1, 5))

    def test_without_kept_files_there_is_none(self):
        for keep in ([], ["fields"], ["envelopes.csv"]):
            self.assertEqual(list(linings.envelopes(self.stripes(keep=keep), self.out)), [])

    def test_largest_forces_around_a_lining(self):
        """Of rings with moments from -n to n/2 kN m, the median of the largest is 4 kN m at every node."""
        angle = np.radians(np.arange(0, 360, 30))
        forces = {f"peak_{end}_{force}": np.zeros(12) for force in ("thrust_N", "shear_N") for end in ("least", "largest")}

        def run_of(number):
            moments = {"peak_least_moment_Nm": np.full(12, -1e3 * number), "peak_largest_moment_Nm": np.full(12, 500 * number)}
            ring = piece(np.column_stack([np.cos(angle), np.sin(angle)]), [(k, (k + 1) % 12) for k in range(12)], forces | moments)
            return SimpleNamespace(models=[("continuum", {"linings": [{"name": "ring"}]})], instants=[(1.0, {"linings": "the last"})],
                                   pieces_of=lambda files: {"linings": ring} if files == {"linings": "the last"} else {})
        ((name, drawing),) = linings.around_linings([run_of(number) for number in range(MOTIONS)], "9 runs")
        self.assertEqual((name, drawing.title), ("around_lining_ring", "largest forces around lining ring: fractiles of 9 runs"))
        _, panels = style.plt.subplots(3)
        drawing.paint(*panels)
        (median,) = [line.get_ydata() for line in panels[1].get_lines() if line.get_label() == "50 %"]
        np.testing.assert_allclose(median, np.full(12, 4))

    def test_values_at_the_places_of_another_run(self):
        """Around a ring, 350 degrees and 10 degrees are neighbours."""
        ring = [linings.around.Places(np.arange(len(at)), np.array(at, float), True) for at in ([0, 180], [10, 170, 190, 350])]
        np.testing.assert_allclose(linings.at_places(*ring, [np.array([1, 5, 7, 3])]), [[2, 6]])


class Inputs(Made):
    def test_bars_have_the_indices(self):
        outcome = self.plain()
        outcome.indices = {"drift_ux_m": [("stiffness", 0.7, (0.5, 0.9)), ("pga_m_per_s2", 0.1, (-0.2, 0.3))]}
        ((_, drawing),) = inputs.indices(outcome, self.out)
        _, panel = style.plt.subplots()
        drawing.paint(panel)
        self.assertEqual([bar.get_width() for bar in panel.patches], [0.1, 0.7])
        self.assertEqual([tick.get_text() for tick in panel.get_yticklabels()], ["pga", "stiffness"])
        (intervals,) = panel.collections
        self.assertEqual([segment[:, 0].tolist() for segment in intervals.get_segments()], [[-0.2, 0.3], [0.5, 0.9]])
        outcome.indices = {}
        self.assertEqual(list(inputs.indices(outcome, self.out)), [])


class Page(Made):
    def test_of_fragility(self):
        """The page says medians with intervals, why a state has none, the failed run's reason, and factors of motions."""
        outcome = self.stripes(failed={(3, LEVELS[2])}, description="drift of <a> column")
        told = text_of(self.written(outcome))
        minor = outcome.curves[0]
        low, high = (end / G for end in minor.intervals["median"])
        self.assertIn(f"minor 10 mm {minor.fit.curve.median / G:.3g} ({low:.3g} to {high:.3g})", told)
        self.assertIn("collapse 9 m no curve: not exceeded up to 0.8 g in 35 runs", told)
        self.assertIn("1 of 36 runs failed", told)
        self.assertIn("m3 0.4 g 0_0 the time step &lt;became&gt; unstable", told)
        self.assertIn("drift of &lt;a&gt; column", told)
        self.assertIn("m0 0.4903 0.9807 1.961 3.923", told)
        self.assertIn("coupler 1.2.3", told)
        files = {path.stem for path in (self.out / "pictures").iterdir()}
        self.assertEqual(files, {"fragility_drift_ux_m", "answer_drift_ux_m", "indices"})

    def test_of_each_kind_of_study(self):
        """Pages are self-contained: they ask for nothing from a network, and hold a picture for each file with a text in its place."""
        for kind in (self.stripes, self.climbs, self.cloud, self.plain):
            outcome = kind()
            drawn = pictures.draw(outcome, self.out)
            written = page.write(outcome, drawn, self.out).read_text()
            self.assertEqual(re.findall(r'(?:src|href)="(?!data:|#)([^"]*)"', written), [])
            self.assertNotRegex(re.sub(r'src="data:[^"]*"', "", written), r"https?://")
            self.assertEqual(len(re.findall(r'<img src="data:image/[^"]*" alt="[^"]+"', written)), sum(map(len, drawn.values())))
            self.assertEqual(set(re.findall(r'href="#([a-z]+)"', written)), set(re.findall(r'<section id="([a-z]+)"', written)))
            self.assertNotIn('id="failed"', written)

    def test_without_motions(self):
        outcome = self.plain()
        told = text_of(self.written(outcome))
        share, (low, high) = outcome.exceeded(outcome.study.damage[0], outcome.study.damage[0].states[0])
        self.assertIn(f"minor drift ux 10 mm {100 * share:.3g} % ({100 * low:.3g} to {100 * high:.3g} %)", told)
        self.assertIn("stiffness lognormal: median 100, dispersion 0.2; least 50, in MPa material.young_modulus", told)
        self.assertNotIn("Ground motions", told)

    def test_of_a_single_run(self):
        """With motions at levels, as they are, without motions, and without an answer."""
        level = {"of": [{}], "stripes": {"pga": [2.0]}}
        random = [{"name": "stiffness", "uniform": {"from": 0, "to": 2}}]
        for row, said, read in ((self.row(4, 2.0, 2.0), "minor 10 mm no curve: not exceeded up to 0.204 g in 1 runs", {"motions": level}),
                                (self.row(4, 4.0), "minor 10 mm no curve: exceeded from 0.408 g on in 1 runs", {"motions": {"of": [{}]}}),
                                (self.row(4, 4.0, stiffness=1.0), "minor drift ux 10 mm 100 % (2.5 to 100 %)", {"random": random}),
                                (self.row(4, 4.0) | {"drift_ux_m": None}, "m4 1 4 m/s²", {"motions": {"of": [{}]}})):
            told = text_of(self.written(self.outcome([row], damage=DAMAGE, **read)))
            self.assertIn(said, told)
            self.assertIn("The only run is complete.", told)

    def test_old_pictures_are_gone(self):
        (self.out / "pictures").mkdir()
        (self.out / "pictures" / "old.png").write_text("")
        pictures.draw(self.plain(), self.out)
        self.assertFalse((self.out / "pictures" / "old.png").exists())

    def test_of_a_named_set(self):
        outcome = self.outcome(self.stripes().listed, motions=STRIPES)
        outcome.study.read["damage"] = [{"of": "drift_ux_m", "set": "argyroudis_pitilakis"}]
        self.assertIn("Soil Dynamics and Earthquake Engineering 35 (2012) 1-12", page.fragility.source(outcome.study, 0))

    def test_crossings_are_told(self):
        """Of medians 0.3 g and 0.4 g with dispersions 0.1 and 0.8, where (0.8 ln 0.3 - 0.1 ln 0.4) / 0.7 is the logarithm."""
        outcome = self.stripes()
        damage = outcome.study.damage[0]
        outcome.curves = [replace(each, fit=replace(each.fit, curve=Curve(median * G, dispersion)))
                          for each, median, dispersion in zip(outcome.curves, (0.3, 0.4), (0.1, 0.8))]
        self.assertIn("The curves of minor and major cross at 0.288 g", page.fragility.further(outcome, damage))
        outcome.curves = [replace(each, fit=replace(each.fit, curve=Curve(each.fit.curve.median, 0.5))) for each in outcome.curves]
        self.assertNotIn("cross", page.fragility.further(outcome, damage) or "")

    def test_intervals_without_ends(self):
        self.assertEqual(page.fragility.interval(0.0, np.inf), "0 to ∞")


class Words(Made):
    def test_names_and_units(self):
        self.assertEqual(axes.of_answer("lining_largest_moment_Nm", np.array([2e5])), ("lining largest moment [kN m]", 1e3))
        self.assertEqual(axes.of_answer("ratio", np.array([np.nan, 2e5])), ("ratio", 1))
        self.assertEqual(axes.in_words("sa", 0.5, "surface"), "spectral acceleration at 0.5 s at surface")
        self.assertEqual(axes.of_level(self.stripes().study, LEVELS[0]), "0.1 g")


if __name__ == "__main__":
    unittest.main()
