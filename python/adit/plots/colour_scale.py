"""The colour scale of values, which a few extreme values do not determine, and the values outside it."""
import numpy as np
from matplotlib.colors import LogNorm, Normalize, TwoSlopeNorm

INNER = 0.5, 99.5  # percentiles between which most values lie
FAR = 0.25  # share of their range, beyond which values are outside the scale
WIDE = 10  # times the median: values of one sign that reach farther need a logarithmic scale
PALE = 0.2  # share of the larger sign's values: smallest value of the strongest colour of the other sign
PARTS = 10  # of the scale, between lines of equal values


def number(value):
    """Four digits, without a power of ten for large values."""
    return f"{value:,.0f}" if abs(value) >= 1e4 else f"{value:.4g}"


class Scale:
    """low, high: its ends. Values far beyond most others, such as loose grains and tips of cracks, lie outside."""

    def __init__(self, values):
        self._values = values
        self.least, self.greatest = values.min(), values.max()
        low, median, high = np.percentile(values, (INNER[0], 50, INNER[1]))
        reach = FAR * (high - low)
        self.is_logarithmic = low > 0 and high > WIDE * median
        self.low = low if self.is_logarithmic or low - self.least > reach > 0 else self.least
        self.high = high if self.greatest - high > reach > 0 else self.greatest

    def look(self):
        """For artists: one hue for one sign, two around 0 for both, of which the smaller is pale where it is much smaller."""
        if self.is_logarithmic:
            return {"cmap": "viridis", "norm": LogNorm(self.low, self.high)}
        if self.low < 0 < self.high:
            return {"cmap": "RdBu_r", "norm": TwoSlopeNorm(0, min(self.low, -PALE * self.high), max(self.high, -PALE * self.low))}
        return {"cmap": "viridis_r" if self.high <= 0 else "viridis", "norm": Normalize(self.low, self.high)}

    def levels(self):
        """Values that divide the scale into parts of equal length."""
        return self.look()["norm"].inverse(np.linspace(0, 1, PARTS + 1))[1:-1]

    def extend(self):
        """The ends of a colour bar that values exceed."""
        below, above = self.least < self.low, self.greatest > self.high
        return "both" if below and above else "min" if below else "max" if above else "neither"

    def beyond(self, unit):
        """A text on the values outside the scale; empty if there are none."""
        ends = (("above", self._values > self.high, "up to", self.greatest),
                ("below", self._values < self.low, "down to", self.least))
        told = [f"{outside.sum():,} {side}, {until} {number(end)} {unit}" for side, outside, until, end in ends if outside.any()]
        return f"Beyond the scale of colours: {'; '.join(told)}" if told else ""
