"""How far a model has moved: the motion that all points share, the scale of a picture, and grains that have left the others."""
import math

import numpy as np

AT_REST = 0.5  # share of the common displacement: a model with points that move less is supported, and its whole displacement is shown
LOOSE = 3.0  # times the displacement of 99 % of the particles: particles that move farther are loose
NOISE = 1e-9  # displacement relative to the model's size, below which it is left as it is


def common_motion(pieces):
    """The displacement [m] that all points share, such as that of shaken ground; 0 if some points are at rest."""
    moved = np.concatenate([_displacements(piece) for piece in _models(pieces)])
    common = np.median(moved, axis=0)
    return common if np.hypot(*moved.T).min() > AT_REST * np.hypot(*common) else np.zeros(2)


def told(common):
    """The text of a title on the common motion that was subtracted."""
    return f", without the common ({1e3 * common[0]:.4g}, {1e3 * common[1]:.4g}) mm" if common.any() else ""


def scale_of(pieces):
    """The round factor that makes the largest displacement about a fourteenth of the model, at least 1. The common motion
    and loose grains do not count."""
    models = _models(pieces)
    size = max(np.ptp(np.concatenate([p.points for p in models]), axis=0), default=0)
    common = common_motion(pieces)
    largest = max((_largest(piece, common) for piece in models), default=0)
    return max(1.0, round_below(0.07 * size / largest)) if largest > NOISE * size else 1.0


def near(piece, moved, scale):
    """Which points are not loose grains; `moved`: the points after their displacement times `scale`."""
    length = np.hypot(*(moved - piece.points).T) / scale
    return length <= _reach(piece, length[np.unique(piece.cells)])


def round_below(value):
    """The largest of 1, 2, 5, 10, … (and 0.5, 0.2, …) that is not above the value."""
    power = 10.0 ** math.floor(math.log10(value))
    return max(factor * power for factor in (1, 2, 5) if factor == 1 or factor * power <= value)


def _models(pieces):
    return [pieces[kind] for kind in ("grid", "particles") if kind in pieces]


def _displacements(piece):
    """Displacements of the points that belong to a cell."""
    return (piece.moved(1) - piece.points)[np.unique(piece.cells)]


def _largest(piece, common):
    length = np.hypot(*(_displacements(piece) - common).T)
    return np.max(length[length <= _reach(piece, length)], initial=0)


def _reach(piece, lengths):
    """The displacement beyond which a grain is loose; zones cannot leave each other."""
    return LOOSE * np.percentile(lengths, 99) if piece.is_cloud else np.inf
