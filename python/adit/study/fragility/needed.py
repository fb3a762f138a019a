"""How many motions a median needs, before a study and within it."""
import math

from scipy.stats import norm


def motions_needed(dispersion, share=0.10, level=0.95):
    """Motions of which the median capacity lies within a share of the true one: (1.96 dispersion / ln(1 + share))^2, because the
    logarithm of the median of n capacities has the deviation dispersion / sqrt(n)."""
    return math.ceil((norm.ppf(0.5 + level / 2) * dispersion / math.log1p(share))**2)


def share_reached(median_interval):
    """0.10 of an interval (low, high) whose ends lie 10 % from its middle: high / low = 1.10^2."""
    low, high = median_interval
    return math.sqrt(high / low) - 1 if 0 < low and high < math.inf else math.inf


def reached(median_interval, share=0.10):
    return share_reached(median_interval) <= share


def motions_in_all(median_interval, motions, share=0.10):
    """How many motions the median will need, if its interval of `motions` narrows as 1 / sqrt(motions); None if it is unbounded."""
    now = share_reached(median_interval)
    return None if now == math.inf else math.ceil(motions * (math.log1p(now) / math.log1p(share))**2)
