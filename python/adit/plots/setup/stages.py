"""What is dug, hatched by the stage in which it is."""
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch

from adit.plots.setup.areas import centres, inside, zones_in

HATCHES = ("////", "\\\\\\\\", "xx", "..", "--")  # of stages, in turn
COVER = 2.5  # radii: a square of this side holds a particle, wherever it lies in a hexagonal packing


def draw(axes, member, piece, groups, handles):
    """Hatches what stages take from a model; adds to `handles` of the legend, {(stage, share released): handle}."""
    excavated = _zones(member, piece, groups) if member.is_grid else _particles(member, piece)
    for excavation, cells in excavated:
        stage, released = excavation.get("stage", 0), excavation.get("released", 1)
        if stage == 0 or len(cells) == 0:
            continue
        look = {"fc": "none", "ec": "#5A5A5A", "lw": 0, "hatch": HATCHES[(stage - 1) % len(HATCHES)]}
        axes.add_collection(PolyCollection(cells, zorder=1.5 if member.is_grid else 2.6, **look))  # over the overlap's shade
        share = "" if released == 1 else f", {100 * released:.4g} % released"
        handles[stage, released] = Patch(label=f"excavated in stage {stage}{share}", **look)


def _in_order(member):
    """Excavations by their stage: a zone is taken by the first that names it."""
    return sorted(member.model.get("excavations", []), key=lambda each: each.get("stage", 0))


def _zones(member, grid, groups):
    """Yields (excavation, corners of the zones that it takes)."""
    taken = np.empty(0, complex)
    for excavation in _in_order(member):
        zones = zones_in(excavation["where"], grid, groups)
        places = centres(zones) @ (1, 1j)
        yield excavation, zones[~np.isin(places, taken)]
        taken = np.append(taken, places)


def _particles(member, discs):
    """Yields (excavation, corners of rectangles over the particles that it takes and that no later group replaces)."""
    if "excavations" not in member.model:
        return
    begins = np.array([member.stage_of_group(number) for number in member.particle_groups(discs)])
    left = np.full(len(discs.points), True)
    for excavation in _in_order(member):
        chosen = left & inside(excavation["where"], discs.points)
        left &= ~chosen
        replaced = (begins > 0) & (begins >= excavation.get("stage", 0))
        yield excavation, covering(discs.points[chosen & ~replaced], COVER * np.median(discs["radius_m"]))


def covering(points, side):
    """Corners (n, 4, 2) of rectangles that cover the points: rows of squares of this side."""
    if not len(points):
        return np.empty((0, 4, 2))
    origin = points.min(axis=0)
    column, row = np.unique(np.round((points - origin) / side).astype(int), axis=0).T
    order = np.lexsort((column, row))
    column, row = column[order], row[order]
    begins = np.append(True, (np.diff(row) != 0) | (np.diff(column) != 1))
    ends = np.append(begins[1:], True)
    left, right, below = column[begins] - 0.5, column[ends] + 0.5, row[begins] - 0.5
    corners = np.stack([(left, below), (right, below), (right, below + 1), (left, below + 1)])
    return origin + side * np.moveaxis(corners, 2, 0)
