"""Micro-properties of cemented discs that give wanted laboratory values.

Poisson's ratio depends only on the ratio of stiffnesses; Young's modulus is then proportional to the modulus. The ratio of the
two strengths depends on cohesion over tensile strength of the cement; both strengths are then proportional to it. The fit is
therefore two searches in one dimension, by secants in logarithms, and scalings. Strengths vary from packing to packing, so the
means of several packings are fitted.
"""
from dataclasses import dataclass, replace
from math import exp, inf, log


from adit.calibrate.laboratory import Micro, mean_properties

STIFFNESS_RATIOS = (1.0, 10.0)
COHESIONS = (0.5, 4.0)  # over the tensile strength
ELASTIC_STRAIN = 4e-4
POISSON_TOLERANCE, RATIO_TOLERANCE = 0.01, 0.1  # the strengths' ratio scatters too much between packings for less
MOST_TRIALS = 4


@dataclass(frozen=True)
class Wanted:
    young_modulus: float  # [Pa]
    poisson_ratio: float
    compressive_strength: float  # [Pa]
    tensile_strength: float  # [Pa], in the Brazilian test

    def properties(self):
        return {"young_modulus_Pa": self.young_modulus, "poisson_ratio": self.poisson_ratio,
                "uniaxial_compressive_strength_Pa": self.compressive_strength,
                "brazilian_tensile_strength_Pa": self.tensile_strength}


def search(measure, wanted, start, limits, tolerance):
    """(argument, measured) with measure(argument) nearest to `wanted` within limits; measure increases with its argument."""
    low, high = map(log, limits)
    tried = []
    x = log(start)
    for _ in range(MOST_TRIALS):
        value = measure(exp(x))
        tried.append((abs(value / wanted - 1), x, value))
        if tried[-1][0] <= tolerance or len({at for _, at, _ in tried}) < len(tried):
            break
        slope = 0.5 if len(tried) == 1 else _slope(tried[-2:])
        x = min(max(x + (log(wanted / value)) / slope, low), high)
    _, x, value = min(tried)
    return exp(x), value


def _slope(two):
    (_, x_1, value_1), (_, x_2, value_2) = two
    slope = log(value_2 / value_1) / (x_2 - x_1) if x_2 != x_1 else 0
    return min(max(slope, 0.1), 2)


def fit(wanted, laboratory, say):
    """(Micro, [Rock]) nearest to the wanted properties; say(text) reports each trial."""
    moduli = {}

    def poisson(ratio):
        micro = Micro(wanted.young_modulus, ratio, inf, inf)
        young_modulus, poisson_ratio = laboratory.elastic_constants(micro, ELASTIC_STRAIN, f"elastic_{len(moduli)}")
        moduli[ratio] = young_modulus / micro.modulus
        say(f"stiffness ratio {ratio:.3f}: Poisson's ratio {poisson_ratio:.4f}")
        return poisson_ratio

    ratio, _ = search(poisson, wanted.poisson_ratio, 2.5, STIFFNESS_RATIOS, POISSON_TOLERANCE)
    elastic = Micro(wanted.young_modulus / moduli[ratio], ratio, inf, inf)
    tried = {}

    def strengths(cohesion):
        tension = wanted.compressive_strength / (1.3 * min(cohesion, 1.3))  # a first guess, scaled afterwards
        micro = replace(elastic, tensile_strength=tension, cohesion=cohesion * tension)
        reached = mean_properties(laboratory.test(micro, f"strength_{len(tried)}"))
        tried[cohesion] = micro, reached
        quotient = reached["uniaxial_compressive_strength_Pa"] / reached["brazilian_tensile_strength_Pa"]
        say(f"cohesion {cohesion:.3f} times the tensile strength: compressive {quotient:.2f} times the tensile strength")
        return quotient

    cohesion, _ = search(strengths, wanted.compressive_strength / wanted.tensile_strength, 1.0, COHESIONS,
                         RATIO_TOLERANCE)
    micro, reached = tried[cohesion]
    misfit = {name: reached[name] / goal for name, goal in wanted.properties().items()}
    # Each strength gets half of the misfit.
    factor = (misfit["uniaxial_compressive_strength_Pa"] * misfit["brazilian_tensile_strength_Pa"]) ** -0.5
    micro = replace(micro, modulus=micro.modulus / misfit["young_modulus_Pa"],
                    tensile_strength=factor * micro.tensile_strength, cohesion=factor * micro.cohesion)
    return micro, laboratory.test(micro, "fitted")
