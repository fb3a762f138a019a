"""Numbers that are 0 but for rounding."""

ROUNDING = 1e-10  # share of a size, below which a number beside it is 0


def settled(value, size):
    """The value; 0 where it is rounding beside this size, such as a coordinate beside that of the model."""
    return 0.0 if abs(value) <= ROUNDING * abs(size) else value


def coordinate(value, *others):
    """A coordinate [m] of a model of unknown size, which is at least 1 m or as far as the other ones."""
    return settled(value, max([1.0, *map(abs, others)]))
