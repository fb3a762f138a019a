"""The runs of a study: samples have the distributions that are stated, keys mean what they say, intensities are those of their definitions."""
import unittest
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace

import numpy as np
from scipy import stats

from adit.results.files import Unusable
from adit.study import design, fields, quantities, table

QUANTITIES = [
    {"name": "modulus", "lognormal": {"median": 2.0, "dispersion": 0.5}},
    {"name": "friction", "normal": {"mean": 30.0, "deviation": 5.0}, "least": 25.0},
    {"name": "depth", "triangular": {"from": 0.0, "mode": 1.0, "to": 3.0}},
    {"name": "water", "uniform": {"from": -4.0, "to": -2.0}},
    {"name": "law", "discrete": {"values": ["a", "b"], "weights": [1.0, 3.0]}}]


def study(random=QUANTITIES, **changes):
    given = {"random": random, "read": {}, "method": "latin_hypercube", "seed": 1, "path": Path("s.yaml"), "fields": [], "seeds": []}
    return SimpleNamespace(**(given | changes))


def columns(of, count, number=0):
    drawn = quantities.drawn(of, count, number)
    return {name: np.array([row[name] for row in drawn]) for name in drawn[0]}


class Samples(unittest.TestCase):
    def test_have_the_stated_distributions_in_every_design(self):
        exact = {"modulus": stats.lognorm(0.5, scale=2), "friction": stats.truncnorm(-1, np.inf, 30, 5), "depth": stats.triang(1 / 3, 0, 3),
                 "water": stats.uniform(-4, 2)}
        for method in ("latin_hypercube", "sobol", "random"):
            drawn = columns(study(method=method), 1000)
            for name, distribution in exact.items():
                with self.subTest(method=method, name=name):
                    self.assertGreater(stats.kstest(drawn[name], distribution.cdf).pvalue, 1e-3)
            self.assertAlmostEqual(np.mean(drawn["law"] == "b"), 0.75, delta=0.05)

    def test_of_a_latin_hypercube_have_one_value_in_each_stratum(self):
        drawn = columns(study(), 50)
        strata = np.floor(50 * stats.lognorm(0.5, scale=2).cdf(drawn["modulus"]))
        self.assertEqual(sorted(strata), list(range(50)))

    def test_are_correlated_as_normal_scores(self):
        drawn = columns(study(read={"correlations": [{"between": ["modulus", "water"], "coefficient": -0.7}]}), 4000)
        scores = stats.norm.ppf(stats.uniform(-4, 2).cdf(drawn["water"]))
        self.assertAlmostEqual(np.corrcoef(np.log(drawn["modulus"]), scores)[0, 1], -0.7, delta=0.02)

    def test_are_the_same_again_and_others_in_another_round_or_with_another_seed(self):
        first = quantities.drawn(study(), 5, 0)
        self.assertEqual(first, quantities.drawn(study(), 5, 0))
        self.assertNotEqual(first, quantities.drawn(study(), 5, 1))
        self.assertNotEqual(first, quantities.drawn(study(seed=2), 5, 0))

    def test_impossible_ones_are_refused(self):
        pairs = [("modulus", "friction", 0.9), ("friction", "depth", 0.9), ("modulus", "depth", -0.9)]
        read = {"correlations": [{"between": [a, b], "coefficient": value} for a, b, value in pairs]}
        with self.assertRaisesRegex(Unusable, "no quantities can have all of these at once"):
            quantities.drawn(study(read=read), 5, 0)
        with self.assertRaisesRegex(Unusable, "cut off where nothing of it is left"):
            quantities.drawn(study([{"name": "a", "uniform": {"from": 0, "to": 1}, "least": 2.0}]), 5, 0)


class Fields(unittest.TestCase):
    GIVEN = {"name": "stiff", "parts": ["continuum", "particles"], "of": ["stiffness"], "dispersion": 0.3, "length_x": 8.0, "length_y": 2.0,
             "x_min": 0.0, "x_max": 80.0, "y_min": -20.0, "y_max": 0.0}

    def test_have_the_stated_dispersion_and_correlation(self):
        logarithms = np.array([np.log(fields.realization(self.GIVEN, seed)[2]) for seed in range(200)])
        x, y, _ = fields.realization(self.GIVEN, 1)
        self.assertAlmostEqual(logarithms.std(), 0.3, delta=0.01)
        for apart, step, length, a, b in ((2, x[1] - x[0], 8.0, logarithms[:, :, :-2], logarithms[:, :, 2:]),
                                          (3, y[1] - y[0], 2.0, logarithms[:, :-3], logarithms[:, 3:])):
            self.assertAlmostEqual(np.corrcoef(a.ravel(), b.ravel())[0, 1], np.exp(-apart * step / length), delta=0.02)

    def test_reach_the_scene_as_lattices_of_each_part(self):
        with TemporaryDirectory() as folder:
            found = fields.settings(study(fields=[self.GIVEN]), "0_1", Path(folder))
            path = Path(folder) / "stiff_0_1.csv"
            self.assertEqual(found, {f"{part}.scatter": f"[{{of: stiffness, path: {path}}}]" for part in ("continuum", "particles")})
            written = np.genfromtxt(path, delimiter=",", names=True)
            x, y, _ = fields.realization(self.GIVEN, 1)
            self.assertEqual(len(written), len(x) * len(y))
            np.testing.assert_allclose(np.unique(written["x_m"]), x, rtol=1e-5)


class Keys(unittest.TestCase):
    STATED = {"materials": [{"young_modulus": 1e8}, {"young_modulus": 2e8}], "gasket": {"force": [0.0, 25.0]}, "text": "a"}

    def test_a_star_stands_for_every_element(self):
        self.assertEqual(design.places(self.STATED, "materials[*].young_modulus"),
                         [("materials[0].young_modulus", 1e8), ("materials[1].young_modulus", 2e8)])
        self.assertEqual(design.places(self.STATED, "materials[1].young_modulus"), [("materials[1].young_modulus", 2e8)])
        self.assertEqual(design.places(self.STATED, "time.dt"), [("time.dt", None)])

    def settings(self, **given):
        return design.settings(study([{"name": "q", **given}]), self.STATED, {"q": 0.5})

    def test_factors_multiply_numbers_and_lists_of_them(self):
        self.assertEqual(self.settings(keys=["materials[*].young_modulus"], multiplies=True),
                         {"materials[0].young_modulus": "50000000.0", "materials[1].young_modulus": "100000000.0"})
        self.assertEqual(self.settings(keys=["gasket.force"], multiplies=True), {"gasket.force": "[0.0, 12.5]"})
        with self.assertRaisesRegex(Unusable, "the scene states no number there"):
            self.settings(keys=["text"], multiplies=True)

    def test_values_have_their_unit(self):
        self.assertEqual(self.settings(keys=["time.dt"], unit="ms"), {"time.dt": "0.5 ms"})


class Intensities(unittest.TestCase):
    def test_of_a_history_are_those_of_their_definitions(self):
        times = np.linspace(0, 2, 2001)  # two periods of a sine of 3 m/s^2 and 1 Hz
        histories = {"time_s": times, "top_ax_m_per_s2": 3 * np.sin(2 * np.pi * times)}
        with TemporaryDirectory() as folder:
            (Path(folder) / "summary.json").write_text("{}")
            np.savetxt(Path(folder) / "histories.csv", np.column_stack(list(histories.values())), delimiter=",", header=",".join(histories), comments="")
            self.assertAlmostEqual(table.measured(folder, "top", "pga", None), 3, 5)
            self.assertAlmostEqual(table.measured(folder, "top", "pgv", None), 3 / np.pi, 5)
            self.assertAlmostEqual(table.measured(folder, "top", "arias", None), np.pi / (2 * 9.80665) * 9, 4)
            self.assertAlmostEqual(table.measured(folder, "top", "sa", 0.02), 3, 1)  # a stiff oscillator follows the ground
            with self.assertRaisesRegex(Unusable, "did you mean `top_ax_m_per_s2`"):
                table.measured(folder, "tip", "pga", None)


if __name__ == "__main__":
    unittest.main()
