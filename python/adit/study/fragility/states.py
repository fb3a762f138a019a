"""Curves of damage states that follow each other."""
import numpy as np

from adit.study.fragility import likelihood
from adit.study.fragility.curves import Curve


def crossings(curves, low, high):
    """[(i, j, intensity)]: where the curve of a worse state j rises above that of i within [low, high], as curves of different
    dispersions do. `curves`: from the least to the worst state; None where there is none."""
    found = []
    known = [(number, curve) for number, curve in enumerate(curves) if curve is not None]
    for place, (i, lesser) in enumerate(known):
        for j, worse in known[place + 1:]:
            if lesser.dispersion == worse.dispersion:
                continue
            at = np.exp((np.log(lesser.median) * worse.dispersion - np.log(worse.median) * lesser.dispersion)
                        / (worse.dispersion - lesser.dispersion))
            if low <= at <= high:
                found.append((i, j, float(at)))
    return found


def common_dispersion(observed):
    """Curves that share one dispersion, and therefore do not cross: the largest product of the likelihoods of all states. `observed`:
    the Observations of each state, from the least to the worst. None for a state that no run or each run exceeds, and for all where no
    state tells a dispersion."""
    merged = [each.merged() for each in observed]
    kinds = [likelihood.kinds(upper, lower, counts.sum(axis=0)[None])[0] for upper, lower, counts in merged]
    told = [number for number, kind in enumerate(kinds) if kind not in (likelihood.NEVER, likelihood.ALWAYS)]
    curves = [None] * len(observed)
    if all(kinds[number] != likelihood.CURVE for number in told):
        return curves
    upper, lower, weights = (np.concatenate([part(merged[number]) for number in told])
                             for part in (lambda m: m[0], lambda m: m[1], lambda m: m[2].sum(axis=0)))
    of = np.repeat(np.arange(len(told)), [len(merged[number][0]) for number in told])
    slope, *intercepts = likelihood.maximize(upper, lower, weights[None], of)[0]
    if slope > 0:
        for number, intercept in zip(told, intercepts):
            curves[number] = Curve(float(np.exp(-intercept / slope)), float(1 / slope))
    return curves
