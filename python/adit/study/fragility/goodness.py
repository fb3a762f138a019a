"""Whether a lognormal curve fits what the runs show."""
from dataclasses import dataclass

import numpy as np
from scipy.special import ndtr
from scipy.stats import chi2

from adit.study.fragility import likelihood
from adit.study.fragility.bootstrap import RESAMPLES, SEED

EXPECTED = 5  # the least expected number of runs that exceed the state, and of those that do not, in a group (Cochran 1954)


@dataclass(frozen=True)
class Goodness:
    """`p`: probability of a `statistic` as large if the curve is right, None where it cannot be told, for which `sentence` says why."""
    test: str
    statistic: float
    p: float
    sentence: str = ""


def shares(observations):
    """(levels, known, exceeded), (n,) each: at each intensity that bounds an observation, the number of observations that tell whether
    the state is exceeded there, and of those in which it is."""
    bounds = np.concatenate([observations.lower, observations.upper])
    levels = np.unique(bounds[(bounds > 0) & np.isfinite(bounds)])
    exceeded = (observations.upper <= levels[:, None]).sum(axis=1)
    return levels, exceeded + (observations.lower >= levels[:, None]).sum(axis=1), exceeded


def goodness(fit, resamples=RESAMPLES, seed=SEED):
    """Of a Fit with a curve: `kolmogorov()` of climbs, `chi_square()` of runs."""
    observations = fit.observations
    test = kolmogorov if observations.noun == "climbs" else chi_square
    if len(observations) > observations.motions:
        return Goodness(test.__name__, None, None, f"{observations.noun} of one motion depend on each other: they cannot test the curve")
    return test(fit, resamples, seed)


def kolmogorov(fit, resamples, seed):
    """The largest distance of the curve and the share of climbs at any level. The curve is fitted to the same climbs, so that the
    statistic is smaller than in Kolmogorov's table: its distribution is that of climbs drawn from the curve and fitted likewise
    (Lilliefors 1967, J. Am. Stat. Assoc. 62:399)."""
    levels, known, exceeded = shares(fit.observations)
    at_levels = fit.curve.probability(levels)
    statistic = np.abs(exceeded / known - at_levels).max()
    climbs = len(fit.observations)
    drawn = np.random.default_rng(seed).multinomial(climbs, np.diff(np.r_[0, at_levels, 1]), size=resamples).astype(float)
    edges = np.log(levels)
    found = likelihood.medians_and_dispersions(np.r_[edges, np.inf], np.r_[-np.inf, edges], drawn)
    fitted = ndtr(likelihood.normal_scores(levels, *found))
    of_drawn = np.abs(drawn[:, :-1].cumsum(axis=1) / climbs - fitted).max(axis=1)
    return Goodness("kolmogorov", float(statistic), float((1 + (of_drawn >= statistic).sum()) / (1 + resamples)))


def chi_square(fit, *_):
    """Observed and expected numbers in groups of rising intensity (Hosmer and Lemeshow 1980, Commun. Stat. A 9:1043); the groups have
    at least EXPECTED runs of either kind."""
    exceeded = fit.observations.lower == 0
    intensity = np.where(exceeded, fit.observations.upper, fit.observations.lower)
    order = np.argsort(intensity, kind="stable")
    expected = fit.curve.probability(intensity[order])
    groups = grouped(expected)
    if len(groups) < 3:
        return Goodness("chi_square", None, None, f"{len(exceeded)} runs are too few to test the curve")
    rows = np.array([(len(each), exceeded[order][each].sum(), expected[each].sum()) for each in groups])
    number, seen, mean = rows.T
    statistic = np.sum((seen - mean)**2 / (mean * (1 - mean / number)))
    return Goodness("chi_square", float(statistic), float(chi2.sf(statistic, len(groups) - 2)))


def grouped(expected):
    """Indices of groups of neighbours, of which each expects at least EXPECTED of either kind; what is left joins the last."""
    groups, first = [], 0
    for end in range(1, len(expected) + 1):
        part = expected[first:end]
        if min(part.sum(), (1 - part).sum()) >= EXPECTED:
            groups.append(np.arange(first, end))
            first = end
    return [*groups[:-1], np.r_[groups[-1], np.arange(first, len(expected))]] if groups else []
