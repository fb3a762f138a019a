"""A lognormal fragility curve and its fit by maximum likelihood."""
from dataclasses import dataclass

import numpy as np
from scipy.special import ndtr
from scipy.stats import norm

from adit.study.fragility import likelihood
from adit.study.fragility.observations import Observations


@dataclass(frozen=True)
class Curve:
    """P(exceeded | intensity) = Phi(ln(intensity / median) / dispersion)."""
    median: float
    dispersion: float

    def probability(self, intensity):
        return ndtr(np.log(np.asarray(intensity) / self.median) / self.dispersion)

    def widened(self, *dispersions):
        """The curve with further dispersions, stated by who knows them, added in squares: of the capacity, of the definition of the
        state."""
        return Curve(self.median, float(np.sqrt(self.dispersion**2 + sum(each**2 for each in dispersions))))


@dataclass(frozen=True)
class Fit:
    """`curve`: of the largest likelihood, None where it has no maximum; then `kind` says why (likelihood.kinds)."""
    observations: Observations
    kind: str
    curve: Curve

    def sentence(self, unit="", size=1.0):
        """What the data show where there is no curve; empty where there is one. `size`: of the `unit` in that of the intensities, such as
        9.80665 of g where they are in m/s^2."""
        def at(intensity):
            return f"{intensity / size:.3g} {unit}".rstrip()
        lower, upper = self.observations.lower, self.observations.upper
        below, above = lower.max(), upper.min()
        which = f"in {len(self.observations)} {self.observations.noun}"
        if self.kind == likelihood.NEVER:
            return f"not exceeded up to {at(below)} {which}"
        if self.kind == likelihood.ALWAYS:
            return f"exceeded from {at(above)} on {which}"
        if self.kind == likelihood.FLAT:
            return f"no more often exceeded by stronger motions than by weaker ones {which}: this intensity does not tell the damage"
        if self.kind == likelihood.SEPARATED and below == above:
            return f"exceeded by some and not by others at {at(below)} alone {which}: the dispersion cannot be told; add levels near it"
        if self.kind == likelihood.SEPARATED:
            return f"never exceeded up to {at(below)} and always from {at(above)} {which}: the dispersion cannot be told; " \
                   "add levels between"
        return ""

    def asymptotic(self, level=0.95):
        """{"median": (low, high), "dispersion": (low, high)} by the Fisher information, as if all runs were independent: too narrow
        where a motion has several (`bootstrap.Bootstrap.intervals` is not)."""
        upper, lower, counts = self.observations.merged()
        slope, intercept = 1 / self.curve.dispersion, -np.log(self.curve.median) / self.curve.dispersion
        _, curvature = likelihood.Terms(upper, lower).gradient_and_curvature(np.array([[slope, intercept]]), counts.sum(axis=0)[None])
        of_logarithms = np.array([[intercept / slope**2, -1 / slope], [-1 / slope, 0]])  # of median and dispersion by the parameters
        errors = np.sqrt(np.diag(of_logarithms @ np.linalg.inv(-curvature[0]) @ of_logarithms.T))
        with np.errstate(over="ignore"):  # of a curve that hardly rises
            factors = np.exp(norm.ppf(0.5 + level / 2) * errors)
        return {name: (float(value / factor), float(value * factor))
                for name, value, factor in zip(("median", "dispersion"), (self.curve.median, self.curve.dispersion), factors)}


def fit(observations):
    """The Fit of `observations.of_runs()` or `of_climbs()`."""
    upper, lower, counts = observations.merged()
    (kind,), (median,), (dispersion,), _ = likelihood.medians_and_dispersions(upper, lower, counts.sum(axis=0, keepdims=True))
    return Fit(observations, str(kind), Curve(float(median), float(dispersion)) if kind == likelihood.CURVE else None)
