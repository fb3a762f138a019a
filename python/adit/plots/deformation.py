"""How far a model has moved: the motion that all points share, the scale of a picture, and grains that have left the others."""
import math

import numpy as np

from adit.plots.cores import on_all_cores
from adit.results.rounding import settled

AT_REST = 0.5  # share of the common displacement: a model with points that move less is supported, and its whole displacement is shown
LOOSE = 3.0  # times the displacement of 99 % of the particles: particles that move farther are loose
NOISE = 1e-9  # displacement relative to the model's size, below which it is left as it is
REACH = 0.1  # of the model: the largest displacement in a picture
STRAIN = 0.4  # in a picture: from 1 on zones fold, and openings turn inside out
FLAT = 1e-3  # corners of zones whose sides are more nearly parallel do not count
LIGHT_WEIGHT = 0.01  # zones with less weight follow the particles


def common_motion(pieces):
    """The displacement [m] that all points share, such as that of shaken ground; 0 if some points are at rest."""
    moved = np.concatenate([_displacements(piece) for piece in _models(pieces)])
    common = np.median(moved, axis=0)
    return common if np.hypot(*moved.T).min() > AT_REST * np.hypot(*common) else np.zeros(2)


def told(common):
    """The text of a title on the common motion that was subtracted."""
    x, y = (settled(1e3 * each, 1e3 * np.hypot(*common)) for each in common)
    return f", without the common ({x:.4g}, {y:.4g}) mm" if common.any() else ""


def scale_of_run(run, read=None):
    """The factor of all pictures of a run: that of its largest deformation. `read`: {number: pieces} of instants that need not be
    read again."""
    read = read or {}
    return scale_of(on_all_cores(lambda n: largest_factor(read[n] if n in read else run.pieces_at(n)), len(run.instants)))


def scale_of(largest_factors):
    """The round factor that none of these exceeds; at least 1."""
    least = min(largest_factors, default=math.inf)
    return max(1.0, round_below(least)) if math.isfinite(least) else 1.0


def largest_factor(pieces):
    """The factor that makes the largest displacement REACH of the model, or the largest strain STRAIN; infinite at rest. The
    common motion and loose grains do not count."""
    models = _models(pieces)
    if not models:
        return math.inf
    size = max(np.ptp(np.concatenate([p.points for p in models]), axis=0))
    common = common_motion(pieces)
    largest = max(_largest(piece, common) for piece in models)
    if largest <= NOISE * size:
        return math.inf
    strain = max(_strain_of_zones(pieces.get("grid")), _strain_of_bonds(pieces.get("bonds")))
    return REACH * size / largest if strain <= STRAIN * largest / (REACH * size) else STRAIN / strain


def _strain_of_zones(grid):
    """The largest principal strain at a corner of a zone. Rotation, of whatever size, folds nothing."""
    if grid is None:
        return 0
    cells = grid.cells[heavy_cells(grid)]
    corners, moved = (points[cells] for points in (grid.points, grid.moved(1) - grid.points))
    largest = 0
    for k in range(4):
        (ax, ay), (bx, by) = (np.moveaxis(corners[:, k - i] - corners[:, k], 1, 0) for i in (1, 3))  # both sides of the corner
        (aux, auy), (bux, buy) = (np.moveaxis(moved[:, k - i] - moved[:, k], 1, 0) for i in (1, 3))
        area = ax * by - ay * bx
        sharp = np.abs(area) > FLAT * np.hypot(ax, ay) * np.hypot(bx, by)
        xx, yy = aux * by - bux * ay, buy * ax - auy * bx
        xy = (bux * ax - aux * bx + auy * by - buy * ay) / 2
        principal = np.abs(xx + yy) / 2 + np.hypot((xx - yy) / 2, xy)
        largest = max(largest, np.max(principal[sharp] / np.abs(area[sharp]), initial=0))
    return largest


def _strain_of_bonds(bonds):
    """The largest strain of an intact bond along itself."""
    if bonds is None or not len(bonds.cells):
        return 0
    first, second = bonds.cells[bonds.field("state", np.zeros(len(bonds.cells))) == 0].T
    along, moved = (points[second] - points[first] for points in (bonds.points, bonds.moved(1) - bonds.points))
    return np.max(np.abs(np.sum(along * moved, axis=1)) / np.sum(along**2, axis=1), initial=0)


def heavy_cells(grid):
    """Which zones count."""
    weight = grid.field("weight")
    return np.full(len(grid.cells), True) if weight is None else weight >= LIGHT_WEIGHT


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
