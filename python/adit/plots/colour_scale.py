"""The colour scale of values, which a few extreme values do not determine, and the values outside it."""
import numpy as np
from matplotlib.colors import LogNorm, Normalize, TwoSlopeNorm

from adit.results.rounding import ROUNDING

INNER = 0.5, 99.5  # percentiles between which most values lie
FAR = 0.25  # share of their range, beyond which values are outside the scale
WIDE = 10  # times the median: values of one sign that reach farther need a logarithmic scale
PALE = 0.2  # share of the larger sign's values: smallest value of the strongest colour of the other sign
COLOUR = 1 / 256  # share of the scale of one colour: what is less cannot be seen
PARTS = 10  # of the scale, between lines of equal values


def number(value):
    """Four digits, without a power of ten for large values."""
    return f"{value:,.0f}" if abs(value) >= 1e4 else f"{value:.4g}"


class Scale:
    """low, high: its ends, those that are given, or those of the values: then values far beyond most others, such as loose grains and
    tips of cracks, lie outside. is_constant: whether all values are the same but for rounding; is_single: whether the ends are, too."""

    def __init__(self, values, ends=None):
        self.least, self.greatest = values.min(), values.max()
        self.is_constant = self.greatest - self.least <= ROUNDING * max(abs(self.least), abs(self.greatest))
        self.is_single = self.is_constant and ends is None
        self.is_logarithmic = False
        self.low, self.high = ends or (self.least, self.greatest)
        if ends is None and not self.is_constant:
            self._fit(values)
        reach = COLOUR * (self.high - self.low) if ends else 0
        self._below, self._above = (values < self.low - reach).sum(), (values > self.high + reach).sum()

    def _fit(self, values):
        low, median, high = np.percentile(values, (INNER[0], 50, INNER[1]))
        reach = FAR * (high - low)
        self.is_logarithmic = low > 0 and high > WIDE * median
        self.low = low if self.is_logarithmic or low - self.least > reach > 0 else self.least
        self.high = high if self.greatest - high > reach > 0 else self.greatest

    def look(self):
        """For artists: one hue for one sign, two around 0 for both, of which the smaller is pale where it is much smaller."""
        if self.is_single:
            reach = abs(self.low) or 1
            return {"cmap": "viridis", "norm": Normalize(self.low - reach, self.low + reach)}
        if self.is_logarithmic:
            return {"cmap": "viridis", "norm": LogNorm(self.low, self.high)}
        negative, positive = -self.low, self.high
        if min(negative, positive) > COLOUR * max(negative, positive):
            return {"cmap": "RdBu_r", "norm": TwoSlopeNorm(0, min(self.low, -PALE * self.high), max(self.high, -PALE * self.low))}
        return {"cmap": "viridis_r" if negative > positive else "viridis", "norm": Normalize(self.low, self.high)}

    def levels(self):
        """Values that divide the scale into parts of equal length; none where no line of equal values runs."""
        return [] if self.is_constant else self.look()["norm"].inverse(np.linspace(0, 1, PARTS + 1))[1:-1]

    def extend(self):
        """The ends of a colour bar that values exceed."""
        return "both" if self._below and self._above else "min" if self._below else "max" if self._above else "neither"

    def beyond(self, unit):
        """A text on the values outside the scale; empty if there are none."""
        ends = (("above", self._above, "up to", self.greatest), ("below", self._below, "down to", self.least))
        told = [f"{outside:,} {side}, {until} {number(end)}" for side, outside, until, end in ends if outside]
        return f"Beyond the scale of colours: {'; '.join(told)} {unit}" if told else ""
