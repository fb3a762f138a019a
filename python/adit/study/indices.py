"""Which input of a study matters, from the runs that it has anyway.

`first_order`: the share of the variance of the answer that an input tells by itself (Sobol 1993): Var(E[answer | input]) / Var(answer).
Runs are sorted by the input, and half the mean square of the difference of neighbours is the variance that it does not tell (the rank
estimator of Gamboa, Gremaud, Klein and Lagnoux 2022, Bernoulli 28:2345, by differences). It holds for inputs that depend on each
other, for numbered choices and for the number of the motion, and is uncertain for few runs.
`regression`, `of_ranks`: squared coefficients of the standardized regression, and of that of ranks (OpenTURNS): the shares that a
straight line or a monotonic curve tells if inputs are independent.
"""
from dataclasses import dataclass

import numpy as np
from scipy.stats import norm

from adit.results.files import Unusable

SUBSAMPLES = 300
SEED = 1
FEWEST = 20  # runs; half of them must tell something


@dataclass(frozen=True)
class Index:
    """`interval`: (low, high); an index near 0 may come out below."""
    value: float
    interval: tuple


def first_order(inputs, answers):
    """(R, d) of inputs (R, n, d) and answers (R, n)."""
    order = np.argsort(inputs, axis=1, kind="stable")
    neighbours = np.diff(np.take_along_axis(answers[..., None], order, axis=1), axis=1)
    return 1 - (neighbours**2).mean(axis=1) / (2 * answers.var(axis=1, ddof=1)[:, None])


def regressions(inputs, answers, squares):
    """(R, d) by `squares(analysis)` of OpenTURNS' CorrelationAnalysis."""
    import openturns
    return np.array([squares(openturns.CorrelationAnalysis(openturns.Sample(x), openturns.Sample(y[:, None])))
                     for x, y in zip(inputs, answers)])


MEASURES = {
    "first_order": first_order,
    "regression": lambda inputs, answers: regressions(inputs, answers, lambda analysis: list(analysis.computeSquaredSRC())),
    "of_ranks": lambda inputs, answers: regressions(inputs, answers, lambda analysis: [each**2 for each in analysis.computeSRRC()]),
}


def indices(inputs, answers, level=0.95, subsamples=SUBSAMPLES, seed=SEED):
    """{measure: [Index of each input]}, measures as above. `inputs` (n, d), `answers` (n,).

    The deviation is that of the estimates of random halves of the runs without replacement (Shao and Wu 1989, Ann. Stat. 17:1176): runs
    drawn twice would be their own neighbours. Unusable if there are too few runs, or an input or the answer does not vary.
    """
    inputs, answers = np.asarray(inputs, dtype=float), np.asarray(answers, dtype=float)
    if len(answers) < FEWEST:
        raise Unusable(f"{len(answers)} runs do not tell which input matters: compute {FEWEST} or more.")
    if np.ptp(answers) == 0 or (np.ptp(inputs, axis=0) == 0).any():
        raise Unusable("An answer or an input is the same in all runs: leave it out.")
    rng = np.random.default_rng(seed)
    order = rng.permutation(len(answers))  # where an input has few values, neighbours must have nothing else in common
    inputs, answers = inputs[order], answers[order]
    halves = np.sort([rng.permutation(len(answers))[:len(answers) // 2] for _ in range(subsamples)], axis=1)
    factor = norm.ppf(0.5 + level / 2) * np.sqrt((len(answers) // 2) / (len(answers) - len(answers) // 2))
    found = {}
    for name, measure in MEASURES.items():
        values = measure(inputs[None], answers[None])[0]
        of_halves = measure(inputs[halves], answers[halves])
        half = factor * of_halves.std(axis=0)
        found[name] = [Index(float(value), (float(value - each), float(value + each))) for value, each in zip(values, half)]
    return found
