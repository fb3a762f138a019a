"""Which zones become particles, and where the overlap around them ends.

The core, of particles alone, has the zones whose demand reached the share, and MARGIN layers around: what breaks moves load beside, and
no crack shall reach the overlap. The overlap is ACROSS times as wide as the largest zones beside the core: with fewer than two zones
it would carry waves badly. Both end at free faces where the ground does. They keep away from where the grid is held, loaded or absorbs:
these zones stay.
"""
from dataclasses import dataclass

import numpy as np

from adit.plots.setup.areas import boundary, inside as in_area
from adit.zoom.outlines import distances, hull, inside, loops

ACROSS = 2  # zones over the width of an overlap
MARGIN = 2  # layers of zones between it and what is near its strength


@dataclass
class Place:
    """Flags of zones: `core` and what particles fill, `filled`, the overlap included; `width` [m] of the overlap."""
    core: np.ndarray
    filled: np.ndarray
    width: float


def conditioned(continuum, grid):
    """Flags of the points at which the grid is held, moved, loaded or absorbs waves. Of areas that name a group of a mesh, whose edges only
    the mesh knows, all of the boundary counts."""
    points = grid.points
    (left, lowest), right = points.min(axis=0), points[:, 0].max()
    at_points = [condition.get("where", {}) for key in ("motions", "point_loads", "foundations") for condition in continuum.get(key, [])]
    at_edges = [condition["where"] for key in ("quiet", "edge_loads") for condition in continuum.get(key, [])]
    at_edges += [area for side, area in (("left", {"x_max": left}), ("right", {"x_min": right})) if continuum.get("free_field", {}).get(side)]
    if "base" in continuum:
        at_edges.append(continuum["base"].get("where", {"y_max": lowest}))
    at_edges += [area for area in at_points if "group" in area]
    ends = np.isin(np.arange(len(points)), boundary(grid))
    chosen = np.zeros(len(points), bool)
    for area in at_points:
        chosen |= in_area(area, points) & ("group" not in area)
    for area in at_edges:
        chosen |= in_area(area, points) & ends
    return chosen


def places(zones, near, kept):
    """([Place], flags of the zones near their strength that stay zones) of the zones that are `near` it, where the points `kept`
    belong to the continuum alone."""
    edge = zones.at(kept)
    free = ~zones.grown(edge, ACROSS)  # for a core
    core = zones.closed(zones.grown(near & free, MARGIN) & free, free)
    while True:
        found = [_place(zones, piece, edge) for piece in zones.pieces(core)]
        before = core
        for part in zones.pieces(np.any([place.filled for place in found], axis=0), by_side=False) if found else ():
            if sum((place.core & part).any() for place in found) > 1:
                core = core | _joined(zones, core & part, part) & free
        if (core == before).all():
            break
        core = zones.closed(core, free)
    return sorted(found, key=lambda place: -place.core.sum()), near & ~core


def _joined(zones, pieces, part):
    """What lies between pieces: the zones in the convex hull, or all where these do not join them."""
    between = part & inside(hull(zones.points[np.unique(zones.cells[pieces])]), zones.centres) | pieces
    return part if len(zones.pieces(between)) > 1 else between


def _place(zones, core, edge):
    """With the zones that its overlap reaches, which are not those of the edge."""
    around = next(loop for loop in loops(zones, core) if loop.outer)
    begins = distances(zones.points, around)[zones.cells].min(axis=1)  # of each zone, from the core
    width = min(ACROSS * np.sqrt(zones.areas[zones.grown(core) & ~core]).max(initial=0), begins[edge].min(initial=np.inf))
    return Place(core, core | (begins < (1 - 1e-6) * width), float(width))
