"""The choice of instants of a run to draw if all would be too many."""
import numpy as np

MOST = 8  # instants
FEW = 3  # instants of a model with more than MOST_CELLS zones, particles and bonds, because drawing them is slow
MOST_CELLS = 800_000


def spread(items, most, pieces=()):
    """At most `most` of the items, spread evenly, the last among them; fewer where the pieces of one instant are large."""
    cells = max(1, sum(len(piece.cells) for piece in pieces))
    count = min(most, len(items), max(FEW, MOST_CELLS // cells))
    return [items[k] for k in sorted({round(k) for k in np.linspace(len(items) - 1, 0, count)})]
