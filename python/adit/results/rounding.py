"""Numbers that are 0 but for rounding."""
import numpy as np

ROUNDING = 1e-10  # share of a size, below which a number beside it is 0
STILL = np.finfo(float).eps / ROUNDING  # share of a coordinate: beside it a displacement is 0 that is too small to change the coordinate


def settled(value, size):
    """The value, or array of values; 0 where it is rounding beside this size, such as a coordinate beside that of the model."""
    return np.where(np.abs(value) <= ROUNDING * abs(size), 0.0, value)[()]


def coordinate(value, *others):
    """A coordinate [m] of a model of unknown size, which is at least 1 m or as far as the other ones."""
    return settled(value, max([1.0, *map(abs, others)]))
