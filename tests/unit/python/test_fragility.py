"""Fragility curves recover what the runs were drawn from, tell how far, and say so where the runs show none."""
import itertools
import math
import pathlib
import tempfile
import time
import unittest

import numpy as np
from scipy.optimize import minimize
from scipy.stats import binom, norm

from adit.results.files import Unusable
from adit.study.fragility import cloud, goodness, likelihood, needed, nrml, pelicun, sets, states
from adit.study.fragility.bootstrap import bootstrap, interval
from adit.study.fragility.curves import Curve, fit
from adit.study.fragility.observations import of_climbs, of_runs

TRUE = Curve(0.5, 0.55)
LEVELS = np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.2])


def capacities(rng, motions, curve=TRUE):
    return curve.median * np.exp(curve.dispersion * rng.normal(size=motions))


def stripes(capacity, levels=LEVELS):
    """(motion, intensity, exceeded) of every motion at every level."""
    motion, intensity = np.repeat(np.arange(len(capacity)), len(levels)), np.tile(levels, len(capacity))
    return motion, intensity, intensity >= capacity[motion]


def increments(capacity, levels=LEVELS):
    """The same, up to the first level that exceeds."""
    motion, intensity, exceeded = stripes(capacity, levels)
    kept = intensity < capacity[motion]
    first = exceeded & (np.r_[True, kept[:-1]] | (intensity == levels[0]))
    return motion[kept | first], intensity[kept | first], exceeded[kept | first]


def clouds(rng, motions, curve=TRUE):
    """One run of each motion, at an intensity of its own."""
    intensity = 0.4 * np.exp(0.6 * rng.normal(size=motions))
    return np.arange(motions), intensity, intensity >= capacities(rng, motions, curve)


def inside(value, ends):
    return ends[0] <= value <= ends[1]


class Fits(unittest.TestCase):
    def test_the_likelihood_is_largest(self):
        """The maximum is that of another method, over the likelihood as Baker (2015) writes it."""
        _, intensity, exceeded = runs = clouds(np.random.default_rng(1), 60)

        def loss(parameters):
            p = norm.cdf((np.log(intensity) - parameters[0]) / math.exp(parameters[1]))
            return -np.log(np.where(exceeded, p, 1 - p)).sum()
        other = minimize(loss, [-1, -1], method="Nelder-Mead", options={"xatol": 1e-9, "fatol": 1e-12})
        curve = fit(of_runs(*runs)).curve
        self.assertAlmostEqual(math.log(curve.median), other.x[0], 6)
        self.assertAlmostEqual(math.log(curve.dispersion), other.x[1], 6)

    def test_probabilities_in_either_tail_are_exact(self):
        """Between 10 and 11 deviations, on both sides: the difference of two tails."""
        true = math.log(norm.sf(10) - norm.sf(11))
        for ends in ((11.0, 10.0), (-10.0, -11.0)):
            self.assertAlmostEqual(float(likelihood.log_probability(*np.array(ends))), true, 9)

    def test_fine_increments_tell_the_mean_and_deviation_of_the_logarithms(self):
        capacity = capacities(np.random.default_rng(2), 40)
        curve = fit(of_climbs(*increments(capacity, np.geomspace(0.02, 20, 4000)))).curve
        self.assertAlmostEqual(curve.median / math.exp(np.log(capacity).mean()), 1, 2)
        self.assertAlmostEqual(curve.dispersion / np.log(capacity).std(), 1, 3)

    def test_increments_need_no_more_than_the_first_that_exceeds(self):
        capacity = capacities(np.random.default_rng(3), 30)
        self.assertEqual(fit(of_climbs(*increments(capacity))).curve, fit(of_climbs(*stripes(capacity))).curve)

    def test_motions_that_never_reach_the_state_count(self):
        """Truncated at 0.5 g, half of the motions have no capacity: leaving them out would halve the median."""
        curve = fit(of_climbs(*increments(capacities(np.random.default_rng(4), 2000), LEVELS[LEVELS <= 0.5]))).curve
        self.assertAlmostEqual(curve.median / TRUE.median, 1, delta=4 * TRUE.dispersion / math.sqrt(2000))
        self.assertAlmostEqual(curve.dispersion / TRUE.dispersion, 1, delta=0.12)

    def test_the_order_of_runs_and_the_unit_do_not_matter(self):
        motion, intensity, exceeded = stripes(capacities(np.random.default_rng(5), 20))
        order = np.random.default_rng(6).permutation(len(motion))
        one, other = fit(of_climbs(motion, intensity, exceeded)), fit(of_climbs(motion[order], 9.81 * intensity[order], exceeded[order]))
        self.assertAlmostEqual(other.curve.median / one.curve.median, 9.81)
        self.assertAlmostEqual(other.curve.dispersion, one.curve.dispersion)

    def test_stripes_increments_and_clouds_agree(self):
        rng = np.random.default_rng(7)
        capacity = capacities(rng, 40)
        for observations in (of_runs(*stripes(capacity)), of_climbs(*increments(capacity)), of_runs(*clouds(rng, 120))):
            found = bootstrap(fit(observations), 500).intervals(0.999)
            self.assertTrue(inside(TRUE.median, found["median"]), observations.noun)
            self.assertTrue(inside(TRUE.dispersion, found["dispersion"]), observations.noun)

    def test_intensity_0_is_refused(self):
        with self.assertRaisesRegex(Unusable, "Motion kobe has the intensity 0"):
            of_runs(np.array(["kobe"]), [0.0], [False])
        with self.assertRaisesRegex(Unusable, "No run is left"):
            of_runs([], [], [])


class NoCurve(unittest.TestCase):
    def test_levels_that_differ_by_rounding_are_one(self):
        """Two climbs end on either side of a level: nothing tells the dispersion, in whichever digit the level was rounded."""
        level = 0.2 * 9.80665
        found = fit(of_climbs([0, 0, 1, 1], [0.5 * level, level, np.nextafter(level, 9), 1.5 * level], [False, True, False, True]))
        self.assertEqual(found.kind, likelihood.SEPARATED)

    """Where the likelihood has no maximum, a sentence says what the runs show."""
    MOTION, INTENSITY = np.repeat(np.arange(4), 3), np.tile([0.2, 0.4, 0.8], 4)

    def sentence(self, exceeded, of=of_runs):
        found = fit(of(self.MOTION, self.INTENSITY, exceeded))
        self.assertIsNone(found.curve)
        return found.sentence("g")

    def test_never_and_always(self):
        self.assertEqual(self.sentence(self.INTENSITY > 1), "not exceeded up to 0.8 g in 12 runs")
        self.assertEqual(self.sentence(self.INTENSITY > 0), "exceeded from 0.2 g on in 12 runs")
        self.assertEqual(self.sentence(self.INTENSITY > 1, of_climbs), "not exceeded up to 0.8 g in 4 climbs")

    def test_the_unit_of_the_sentence_may_be_another(self):
        found = fit(of_runs(self.MOTION, 9.80665 * self.INTENSITY, self.INTENSITY > 1))
        self.assertEqual(found.sentence("g", 9.80665), "not exceeded up to 0.8 g in 12 runs")

    def test_separated(self):
        self.assertIn("never exceeded up to 0.4 g and always from 0.8 g in 12 runs", self.sentence(self.INTENSITY > 0.5))
        self.assertIn("never exceeded up to 0.4 g and always from 0.8 g in 4 climbs", self.sentence(self.INTENSITY > 0.5, of_climbs))

    def test_separated_but_for_one_level(self):
        """At 0.4 g one of four runs exceeds: a dispersion of 0 fits it as well as any."""
        one_at_the_middle = (self.INTENSITY == 0.4) & (self.MOTION == 0)
        self.assertIn("by some and not by others at 0.4 g alone", self.sentence((self.INTENSITY > 0.5) | one_at_the_middle))

    def test_not_rising(self):
        for exceeded in (self.INTENSITY < 0.3, (self.INTENSITY < 0.3) | (self.MOTION == 1)):
            self.assertIn("no more often exceeded by stronger motions", self.sentence(exceeded))

    def test_overlap_has_a_curve(self):
        exceeded = (self.INTENSITY > 0.5) & (self.MOTION < 3) | (self.INTENSITY == 0.4) & (self.MOTION == 0)
        found = fit(of_runs(self.MOTION, self.INTENSITY, exceeded))
        self.assertEqual((found.kind, found.sentence("g")), ("curve", ""))
        self.assertTrue(inside(found.curve.median, (0.4, 0.8)))


class Confidence(unittest.TestCase):
    def test_the_intervals_hold_the_truth_in_19_of_20_studies(self):
        """Over 200 studies, a true share of 0.95 gives a number within these bounds in 999 of 1000 cases."""
        studies = 200
        bounds = binom.interval(0.999, studies, 0.95)
        for name, motions, observe in (("stripes", 15, lambda rng: of_runs(*stripes(capacities(rng, 15)))),
                                       ("increments", 20, lambda rng: of_climbs(*increments(capacities(rng, 20)))),
                                       ("cloud", 40, lambda rng: of_runs(*clouds(rng, 40)))):
            hits = {"median": 0, "dispersion": 0}
            for seed in range(studies):
                found = bootstrap(fit(observe(np.random.default_rng(seed))), 150).intervals()
                for quantity, true in (("median", TRUE.median), ("dispersion", TRUE.dispersion)):
                    hits[quantity] += inside(true, found[quantity])
            for quantity, number in hits.items():
                self.assertTrue(inside(number, bounds), (name, motions, quantity, number, bounds))

    def test_the_band_holds_the_curve_in_nine_of_ten_studies_and_rises(self):
        at = np.array([0.25, 0.5, 1.0])
        hits = np.zeros(3)
        for seed in range(100):
            low, high = bootstrap(fit(of_climbs(*increments(capacities(np.random.default_rng(seed), 20)))), 150).band(at)
            hits += (low <= TRUE.probability(at)) & (TRUE.probability(at) <= high)
            self.assertTrue((np.diff(low) >= 0).all() and (np.diff(high) >= 0).all())
        self.assertTrue((hits >= binom.ppf(0.0005, 100, 0.9)).all(), hits)

    def test_runs_of_one_motion_count_once(self):
        """Each run told five times tells no more: the interval of motions stays, that of independent runs shrinks."""
        runs = stripes(capacities(np.random.default_rng(8), 20))
        one, five = fit(of_runs(*runs)), fit(of_runs(*(np.repeat(each, 5) for each in runs)))
        for name, ends in bootstrap(one, 200).intervals().items():
            np.testing.assert_allclose(bootstrap(five, 200).intervals()[name], ends, rtol=1e-9)
        self.assertAlmostEqual(math.log(five.asymptotic()["median"][1] / five.curve.median),
                               math.log(one.asymptotic()["median"][1] / one.curve.median) / math.sqrt(5), 6)

    def test_the_fisher_information_of_fine_increments(self):
        """Of n known capacities, the median has the error dispersion / sqrt(n), and the dispersion dispersion / sqrt(2 n)."""
        found = fit(of_climbs(*increments(capacities(np.random.default_rng(9), 50), np.geomspace(0.02, 20, 3000))))
        ends = found.asymptotic()
        self.assertAlmostEqual(math.log(ends["median"][1] / found.curve.median) / (1.96 * found.curve.dispersion / math.sqrt(50)), 1, 3)
        self.assertAlmostEqual(math.log(ends["dispersion"][1] / found.curve.dispersion) / (1.96 / math.sqrt(100)), 1, 2)

    def test_resamples_without_a_curve_are_counted(self):
        """One motion of six exceeds at 0.8 g: the resamples without it do not exceed, and nothing bounds the median above."""
        motion, intensity = np.repeat(np.arange(6), 3), np.tile([0.2, 0.4, 0.8], 6)
        found = bootstrap(fit(of_runs(motion, intensity, (motion == 0) & (intensity > 0.3))))
        self.assertAlmostEqual(found.without["never"] / 1000, (5 / 6)**6, delta=0.05)
        self.assertEqual(found.intervals()["median"][1], math.inf)

    def test_a_thousand_resamples_of_96_runs_take_less_than_3_s(self):
        found = fit(of_runs(*clouds(np.random.default_rng(10), 96)))
        start = time.process_time()
        self.assertEqual(len(bootstrap(found).medians), 1000)
        self.assertLess(time.process_time() - start, 3)

    def test_the_bias_of_resamples_is_taken_off(self):
        """Resamples that lie 0.3 above the estimate on average tell that the estimate lies 0.3 above the truth."""
        low, high = interval(1.0, 1.3 + norm.ppf((np.arange(4000) + 0.5) / 4000), 1000, 0.95)
        self.assertAlmostEqual(low, 0.7 - 1.963, 2)
        self.assertAlmostEqual(high, 0.7 + 1.963, 2)

    def test_resamples_without_a_curve_have_the_limit_of_their_likelihood(self):
        """No run, each run, a step and a constant share exceed."""
        found = np.array(["never", "always", "separated", "flat"])
        z = likelihood.normal_scores(np.array([0.2, 0.5, 0.9]), found, np.array([np.inf, 0, 0.5, np.inf]),
                                     np.array([np.nan, np.nan, 0, np.inf]), np.array([0, 1, 0.5, 0.25]))
        np.testing.assert_allclose(norm.cdf(z), [[0, 0, 0], [1, 1, 1], [0, 0.5, 1], [0.25, 0.25, 0.25]])

    def test_one_motion_bounds_nothing(self):
        found = fit(of_runs(np.zeros(4), [0.2, 0.3, 0.4, 0.5], [False, True, False, True]))
        self.assertEqual(bootstrap(found, 20).intervals()["median"], (0, math.inf))


class Goodness(unittest.TestCase):
    STUDIES = 60

    def p(self, draw, observe):
        return np.array([goodness.goodness(fit(observe(draw(np.random.default_rng(seed)))), 200).p for seed in range(self.STUDIES)])

    def test_what_is_lognormal_is_rejected_in_1_of_20_and_two_groups_mostly(self):
        def two(rng):
            return np.where(rng.random(160) < 0.5, 0.25, 1.0) * np.exp(0.12 * rng.normal(size=160))
        levels = np.geomspace(0.1, 2, 15)
        for observe in (lambda c: of_climbs(*increments(c, levels)),
                        lambda c: of_runs(np.arange(160), np.resize(levels, 160), np.resize(levels, 160) >= c)):
            p = self.p(lambda rng: capacities(rng, 160), observe)
            self.assertLessEqual((p < 0.05).sum(), binom.ppf(0.999, self.STUDIES, 0.05))
            self.assertAlmostEqual(p.mean(), 0.5, delta=4 / math.sqrt(12 * self.STUDIES))  # p is uniform if the curve is right
        self.assertGreater((self.p(two, lambda c: of_climbs(*increments(c, levels))) < 0.05).mean(), 0.9)

    def test_what_cannot_be_tested_is_said(self):
        capacity = capacities(np.random.default_rng(11), 20)
        self.assertIn("runs of one motion depend on each other", goodness.goodness(fit(of_runs(*stripes(capacity)))).sentence)
        self.assertIn("12 runs are too few", goodness.goodness(fit(of_runs(*clouds(np.random.default_rng(14), 12)))).sentence)

    def test_shares_at_levels(self):
        levels, known, exceeded = goodness.shares(of_climbs([0, 0, 1, 1, 1], [1, 2, 1, 2, 3], [False, True, False, False, False]))
        self.assertEqual((list(levels), list(known), list(exceeded)), ([1, 2, 3], [2, 2, 2], [0, 1, 1]))


class States(unittest.TestCase):
    def test_crossings(self):
        """Curves of equal probability at 1.0: z = 1 for both."""
        lesser, worse = Curve(math.exp(-0.3), 0.3), Curve(math.exp(-0.2), 0.2)
        ((i, j, at),) = states.crossings([lesser, worse], 0.1, 2.0)
        self.assertEqual((i, j), (0, 1))
        self.assertAlmostEqual(at, 1)
        self.assertEqual(states.crossings([lesser, worse], 0.1, 0.9), [])
        self.assertEqual(states.crossings([lesser, None, Curve(1, 0.3)], 0.1, 2.0), [])

    def test_a_common_dispersion(self):
        """Of states whose capacities are those of the first times a factor, all have its dispersion; one that is not reached has none."""
        capacity = capacities(np.random.default_rng(12), 400)
        levels = np.geomspace(0.1, 6, 40)
        curves = states.common_dispersion([of_climbs(*increments(factor * capacity, levels)) for factor in (1, 2, 100)])
        self.assertIsNone(curves[2])
        self.assertEqual(curves[0].dispersion, curves[1].dispersion)
        self.assertAlmostEqual(curves[0].dispersion, np.log(capacity).std(), 2)
        self.assertAlmostEqual(curves[1].median / curves[0].median, 2, 1)

    def test_dispersions_add_in_squares(self):
        self.assertAlmostEqual(Curve(1, 0.5).widened(0.3, 0.4).dispersion, math.sqrt(0.5))


class Cloud(unittest.TestCase):
    def runs(self, seed, motions=60, each=1, between=0.4, within=0.3):
        """ln(answer) = ln 2 + 1.5 ln(intensity) + motion + rest."""
        rng = np.random.default_rng(seed)
        motion = np.repeat(np.arange(motions), each)
        intensity = 0.3 * np.exp(0.5 * rng.normal(size=len(motion)))
        error = between * rng.normal(size=motions)[motion] + within * rng.normal(size=len(motion))
        return motion, intensity, 2 * intensity**1.5 * np.exp(error)

    def test_answers_without_scatter(self):
        motion, intensity, answer = self.runs(1, between=0, within=1e-9)
        found = cloud.regression(motion, intensity, answer)
        self.assertAlmostEqual(found.curve(1.0).median, 0.5**(1 / 1.5))
        self.assertAlmostEqual(found.r2, 1)

    def test_the_interval_holds_the_truth_though_no_run_reaches_the_threshold(self):
        hits = [0, 0]
        for seed in range(200):
            motion, intensity, answer = self.runs(seed, 20)
            found = cloud.regression(motion, intensity, np.minimum(answer, 5.9)).bootstrap(6.0, 150).intervals()
            hits = [hits[0] + inside(3**(1 / 1.5), found["median"]), hits[1] + inside(0.5 / 1.5, found["dispersion"])]
        for number in hits:
            self.assertTrue(inside(number, binom.interval(0.999, 200, 0.95)), hits)

    def test_parts_of_the_dispersion(self):
        """Between and within motions, and their squares make up that of the regression."""
        found = cloud.regression(*self.runs(3, 300, 5))
        parts = found.parts()
        self.assertAlmostEqual(parts.between, 0.4 / 1.5, delta=4 * 0.4 / 1.5 / math.sqrt(600))
        self.assertAlmostEqual(parts.within, 0.3 / 1.5, delta=4 * 0.3 / 1.5 / math.sqrt(2400))
        self.assertAlmostEqual(math.hypot(parts.between, parts.within), found.curve(1).dispersion, 2)
        self.assertLess(cloud.regression(*self.runs(4, 100, 5, between=0)).parts().between, 0.05)
        self.assertIsNone(cloud.regression(*self.runs(5)).parts())

    def test_answers_that_do_not_grow_have_no_curve(self):
        motion, intensity, answer = self.runs(6)
        self.assertIsNone(cloud.regression(motion, intensity, 1 / answer).curve(1.0))

    def test_what_has_no_logarithm_is_refused(self):
        with self.assertRaisesRegex(Unusable, "An answer is 0"):
            cloud.regression([1, 2, 3], [1, 2, 3], [1, 0, 2])
        with self.assertRaisesRegex(Unusable, "three runs or more"):
            cloud.regression([1, 2, 3], [1, 1, 1], [1, 1, 2])


class Needed(unittest.TestCase):
    def test_motions_for_a_median_within_10_percent(self):
        self.assertEqual([needed.motions_needed(each) for each in (0.40, 0.55, 0.70)], [68, 128, 208])

    def test_as_many_motions_reach_it(self):
        """The interval of a curve of as many motions as are needed lies near the 10 % that were asked for."""
        ends = fit(of_climbs(*increments(capacities(np.random.default_rng(13), 128), np.geomspace(0.05, 5, 60)))).asymptotic()["median"]
        self.assertAlmostEqual(needed.share_reached(ends), 0.10, delta=0.02)

    def test_reached(self):
        self.assertTrue(needed.reached((0.5 / 1.099, 0.5 * 1.099)))
        self.assertFalse(needed.reached((0.5 / 1.101, 0.5 * 1.101)))
        self.assertFalse(needed.reached((0.5, math.inf)))
        self.assertEqual(needed.motions_in_all((1 / 1.21, 1.21), 25), 100)
        self.assertIsNone(needed.motions_in_all((0.5, math.inf), 25))


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name) / "file"

    def test_mean_and_deviation_of_openquake(self):
        """Of the median 0.6 g and the dispersion 0.6."""
        self.assertEqual([round(each, 4) for each in nrml.mean_and_deviation(Curve(0.6, 0.6))], [0.7183, 0.4729])

    def test_nrml_round_trip(self):
        """The engine's formula gives the curves back, in g, to 12 digits."""
        curves = {f"DS{number}": Curve(median * 9.80665, dispersion)
                  for number, (median, dispersion) in enumerate(itertools.product((0.01, 0.6, 30.0), (0.05, 0.6, 2.0)))}
        nrml.write(self.path, "tunnel", curves, "SA", 0.1, 20.0, period=0.5, no_damage=0.2)
        (imt, read), = nrml.read(self.path).values()
        self.assertEqual((imt, list(read)), ("SA(0.5)", list(curves)))
        for state, curve in curves.items():
            self.assertAlmostEqual(read[state].median / (curve.median / 9.80665), 1, 12)
            self.assertAlmostEqual(read[state].dispersion / curve.dispersion, 1, 12)

    def test_nrml_is_the_engines(self):
        """Elements and attributes are those of the engine's manual."""
        nrml.write(self.path, "tunnel", {"minor": Curve(9.80665, 0.5)}, "PGA", 0.0, 9.80665)
        text = self.path.read_text()
        for part in ('<nrml xmlns="http://openquake.org/xmlns/nrml/0.5">', '<limitStates>minor</limitStates>', 'lossCategory="structural"',
                     '<fragilityFunction id="tunnel" format="continuous" shape="logncdf">',
                     '<imls imt="PGA" noDamageLimit="0.0" minIML="0.0" maxIML="1.0" />', '<params ls="minor" mean="1.13'):
            self.assertIn(part, text)
        with self.assertRaisesRegex(Unusable, "`very bad` cannot be a name"):
            nrml.write(self.path, "tunnel", {"very bad": Curve(1, 0.5)}, "PGA", 0.0, 9.8)

    def test_pelicun_writes_the_rows_of_hazus(self):
        """As they stand in damage_DB_Hazus_EQ_trnsp.csv of pelicun."""
        rows = {name: {state: Curve(curve.median * 9.80665, curve.dispersion) for state, curve in sets.PUBLISHED[of].curves.items()}
                for name, of in (("HTU.GS.1", "hazus_bored"), ("HTU.GS.2", "hazus_cut_and_cover"))}
        pelicun.write(self.path, rows, "PGA")
        self.assertEqual(self.path.read_text(), (
            "ID,Incomplete,Demand-Type,Demand-Unit,Demand-Offset,Demand-Directional,"
            "LS1-Family,LS1-Theta_0,LS1-Theta_1,LS1-DamageStateWeights,"
            "LS2-Family,LS2-Theta_0,LS2-Theta_1,LS2-DamageStateWeights,LS3-Family,LS3-Theta_0,LS3-Theta_1,LS3-DamageStateWeights,"
            "LS4-Family,LS4-Theta_0,LS4-Theta_1,LS4-DamageStateWeights\n"
            "HTU.GS.1,0,Peak Ground Acceleration,g,0,0,lognormal,0.6,0.6,,lognormal,0.8,0.6,,,,,,,,,\n"
            "HTU.GS.2,0,Peak Ground Acceleration,g,0,0,lognormal,0.5,0.6,,lognormal,0.7,0.6,,,,,,,,,\n"))
        self.assertEqual(pelicun.read(self.path)["HTU.GS.2"], ("Peak Ground Acceleration", "g", [Curve(0.5, 0.6), Curve(0.7, 0.6)]))

    def test_pelicun_has_velocities_but_no_arias_intensity(self):
        pelicun.write(self.path, {"T": {"minor": Curve(0.4, 0.5)}}, "PGV")
        self.assertEqual(pelicun.read(self.path)["T"], ("Peak Ground Velocity", "mps", [Curve(0.4, 0.5)]))
        with self.assertRaisesRegex(Unusable, "no fragility over ARIAS"):
            pelicun.write(self.path, {"T": {"minor": Curve(0.4, 0.5)}}, "ARIAS")

    def test_sets_worsen(self):
        for each in sets.DAMAGE_SETS.values():
            above = [state.above for state in each.states]
            self.assertEqual(above, sorted(set(above)))


if __name__ == "__main__":
    unittest.main()
