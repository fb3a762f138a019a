"""Random quantities: their distributions, drawn in designs of OpenTURNS.

A design fills the unit cube; a normal copula correlates it; the quantile of each distribution gives the values. So a Latin hypercube
stays one in every quantity where nothing is correlated.
"""
import hashlib
import math

import numpy as np

from adit.results.files import Unusable

MISSING = "the package openturns is missing; as root: apt-get install python3-openturns (in the source tree: scripts/setup studies)."


def openturns():
    """The module; raises Unusable where it is not installed."""
    try:
        import openturns as ot
    except ImportError:
        raise Unusable(MISSING) from None
    ot.Log.Show(ot.Log.NONE)
    return ot


def seed_of(*words):
    """A seed for a generator of random numbers that belongs to these words alone."""
    return int.from_bytes(hashlib.sha256(repr(words).encode()).digest()[:4], "big") >> 1


def drawn(study, count, number):
    """[{name: value}] of `count` samples in a round; values of discrete quantities are texts."""
    if not study.random:
        return [{} for _ in range(count)]
    ot = openturns()
    marginals = [_distribution(ot, study, each) for each in study.random]
    columns = [_values(each, marginal, column)
               for each, marginal, column in zip(study.random, marginals, _correlated(ot, study, _design(ot, study, count, number)).T)]
    return [dict(zip((each["name"] for each in study.random), row)) for row in zip(*columns)]


def _design(ot, study, count, number):
    """Points of the unit cube, (count, quantities)."""
    ot.RandomGenerator.SetSeed(seed_of(study.seed, number, "design"))
    cube = ot.ComposedDistribution([ot.Uniform(0, 1)] * len(study.random))
    if study.method == "sobol":
        experiment = ot.LowDiscrepancyExperiment(ot.SobolSequence(), cube, count)
        experiment.setRandomize(True)
    elif study.method == "random":
        experiment = ot.MonteCarloExperiment(cube, count)
    else:
        experiment = ot.LHSExperiment(cube, count)
    return np.clip(np.array(experiment.generate()), 1e-12, 1 - 1e-12)


def _correlated(ot, study, points):
    if "correlations" not in study.read:
        return points
    names = [each["name"] for each in study.random]
    matrix = ot.CorrelationMatrix(len(names))
    for each in study.read["correlations"]:
        matrix[names.index(each["between"][0]), names.index(each["between"][1])] = each["coefficient"]
    if not matrix.isPositiveDefinite():
        raise Unusable(f"{study.path}: correlations: no quantities can have all of these at once; make the coefficients smaller.")
    normal = np.array(ot.DistFunc.qNormal(points.ravel())).reshape(points.shape)
    factor = np.linalg.cholesky(np.array(matrix))
    return np.array(ot.DistFunc.pNormal((normal @ factor.T).ravel())).reshape(points.shape)


def _values(given, marginal, column):
    if "discrete" in given:
        values, weights = given["discrete"]["values"], given["discrete"].get("weights", [1] * len(given["discrete"]["values"]))
        ends = np.cumsum(weights) / sum(weights)
        return [values[int(place)] for place in np.minimum(np.searchsorted(ends, column), len(values) - 1)]
    return [marginal.computeQuantile(float(point))[0] for point in column]


def _distribution(ot, study, given):
    if "discrete" in given:
        return None
    if "normal" in given:
        found = ot.Normal(given["normal"]["mean"], given["normal"]["deviation"])
    elif "lognormal" in given:
        found = ot.LogNormal(math.log(given["lognormal"]["median"]), given["lognormal"]["dispersion"])
    elif "uniform" in given:
        found = ot.Uniform(given["uniform"]["from"], given["uniform"]["to"])
    else:
        found = ot.Triangular(*(given["triangular"][key] for key in ("from", "mode", "to")))
    if "least" not in given and "largest" not in given:
        return found
    low, high = found.getRange().getLowerBound()[0], found.getRange().getUpperBound()[0]
    low, high = max(low, given.get("least", low)), min(high, given.get("largest", high))
    if low >= high:
        raise Unusable(f"{study.path}: random: {given['name']} is cut off where nothing of it is left; change least or largest.")
    return ot.TruncatedDistribution(found, low, high)
