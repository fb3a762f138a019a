"""Which zones become particles, and where the overlap around them ends.

The core, of particles alone, has the zones whose demand reached the share, and as many layers around as the overlap is wide: what
breaks moves load beside, and no crack shall reach the overlap. The overlap has LAYERS more; with fewer than two zones across it
would carry waves badly. Both end on lines of the grid, and at free faces where the ground does. They keep away from where the grid is
held, loaded or absorbs: these zones stay.
"""
from dataclasses import dataclass

import numpy as np

from adit.plots.setup.areas import boundary, inside as in_area
from adit.zoom.outlines import distances, hull, inside, loops

LAYERS = 2  # of zones, in the overlap; and between it and what is near its strength


@dataclass
class Place:
    """Flags of zones: `core` and what particles fill, `filled`, the overlap included; `width` [m] of the overlap."""
    core: np.ndarray
    filled: np.ndarray
    width: float


def conditioned(continuum, grid):
    """Flags of the points at which the grid is held, moved, loaded or absorbs waves."""
    points = grid.points
    (left, lowest), right = points.min(axis=0), points[:, 0].max()
    areas = [condition.get("where") for key in ("quiet", "motions", "edge_loads", "point_loads", "foundations")
             for condition in continuum.get(key, [])]
    areas += [area for side, area in (("left", {"x_max": left}), ("right", {"x_min": right})) if continuum.get("free_field", {}).get(side)]
    if "base" in continuum:
        areas.append(continuum["base"].get("where", {"y_max": lowest}))
    at_boundary = np.zeros(len(points), bool)
    at_boundary[np.unique(boundary(grid))] = True
    chosen = np.zeros(len(points), bool)
    for area in areas:
        chosen |= in_area(area, points)
    return chosen & at_boundary


def places(zones, near, kept):
    """([Place], flags of the zones near their strength that stay zones) of the zones that are `near` it, where the points `kept`
    belong to the continuum alone."""
    edge = zones.at(kept)
    free = ~zones.grown(edge, LAYERS)  # for a core
    core = zones.closed(zones.grown(near, LAYERS) & free, free)
    while True:
        parts = [(part, zones.pieces(core & part)) for part in zones.pieces(zones.grown(core, LAYERS) & ~edge, by_side=False)]
        apart = [part for part, pieces in parts if len(pieces) > 1]
        if not apart:
            break
        for part in apart:
            core = core | _joined(zones, core & part, part) & free
        core = zones.closed(core, free)
    found = [Place(core & part, part, _width(zones, core & part, part)) for part, pieces in parts if pieces]
    return sorted(found, key=lambda place: -place.core.sum()), near & ~core


def _joined(zones, pieces, part):
    """What lies between pieces: the zones in the convex hull, or all where these do not join them."""
    between = part & inside(hull(zones.points[np.unique(zones.cells[pieces])]), zones.centres) | pieces
    return part if len(zones.pieces(between)) > 1 else between


def _width(zones, core, filled):
    """The distance from the core to where other zones begin beyond what is filled."""
    beyond = zones.grown(filled) & ~filled
    ends = np.intersect1d(zones.cells[beyond], zones.cells[filled])
    if not len(ends):
        return float(zones.longest[filled].max())
    around = next(loop for loop in loops(zones, core) if loop.outer)
    return float(distances(zones.points[ends], around).min())
