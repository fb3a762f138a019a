"""Indices of a study are those of functions of which they are known."""
import unittest

import numpy as np
from scipy.stats import binom

from adit.results.files import Unusable
from adit.study.indices import indices


def ishigami(x):
    """First indices 0.3139, 0.4424, 0 (Ishigami and Homma 1990, with a = 7, b = 0.1)."""
    return np.sin(x[:, 0]) + 7 * np.sin(x[:, 1])**2 + 0.1 * x[:, 2]**4 * np.sin(x[:, 0])


def linear(rng, runs):
    """3 x + 2 y + z + noise of the deviation 2: shares 9, 4, 1 of 18."""
    inputs = rng.normal(size=(runs, 3))
    return inputs, inputs @ [3, 2, 1] + 2 * rng.normal(size=runs)


class Indices(unittest.TestCase):
    def test_ishigami(self):
        inputs = np.random.default_rng(1).uniform(-np.pi, np.pi, (4000, 3))
        found = indices(inputs, ishigami(inputs), subsamples=50)["first_order"]
        for index, true in zip(found, (0.3139, 0.4424, 0)):
            self.assertAlmostEqual(index.value, true, delta=0.06)

    def test_all_measures_tell_the_shares_of_a_linear_answer(self):
        found = indices(*linear(np.random.default_rng(2), 4000), subsamples=20)
        for name, delta in (("first_order", 0.06), ("regression", 0.04), ("of_ranks", 0.06)):
            for index, true in zip(found[name], (9 / 18, 4 / 18, 1 / 18)):
                self.assertAlmostEqual(index.value, true, delta=delta, msg=name)

    def test_the_intervals_hold_the_shares(self):
        """In 100 studies of 80 runs; the bounds are those of 95 % in 999 of 1000 cases."""
        hits = {"first_order": np.zeros(3), "regression": np.zeros(3)}
        for seed in range(100):
            found = indices(*linear(np.random.default_rng(seed), 80), subsamples=60)
            for name, number in hits.items():
                number += [index.interval[0] <= true <= index.interval[1] for index, true in zip(found[name], (9 / 18, 4 / 18, 1 / 18))]
        for name, number in hits.items():
            self.assertTrue((number >= binom.ppf(0.0005, 100, 0.95)).all(), (name, number))

    def test_the_number_of_the_motion_is_an_input(self):
        """Answers differ by motion with the variance 1, and within by 1/3: the motion tells 3/4."""
        rng = np.random.default_rng(3)
        motion = np.repeat(np.arange(100), 20)
        answers = rng.normal(size=100)[motion] + np.sqrt(1 / 3) * rng.normal(size=2000)
        other = rng.normal(size=2000)
        found = indices(np.column_stack([motion, other]), answers, subsamples=20)["first_order"]
        self.assertAlmostEqual(found[0].value, 0.75, delta=0.1)
        self.assertAlmostEqual(found[1].value, 0, delta=0.1)

    def test_inputs_that_vary_in_order_tell_no_more_than_their_share(self):
        """Stripes are listed motion by motion, level by level: the motion has no share of an answer that only the level makes."""
        motion, level = np.repeat(np.arange(20), 40), np.tile(np.repeat(np.arange(8.0), 5), 20)
        found = indices(np.column_stack([motion, level]), level + 0.1 * np.random.default_rng(5).normal(size=800), subsamples=20)["first_order"]
        self.assertAlmostEqual(found[0].value, 0, delta=0.1)
        self.assertAlmostEqual(found[1].value, 1, delta=0.02)

    def test_too_few_runs_and_constants_are_refused(self):
        with self.assertRaisesRegex(Unusable, "12 runs do not tell"):
            indices(np.random.default_rng(4).normal(size=(12, 2)), np.arange(12))
        with self.assertRaisesRegex(Unusable, "the same in all runs"):
            indices(np.ones((30, 1)), np.arange(30))


if __name__ == "__main__":
    unittest.main()
