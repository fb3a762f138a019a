"""Which points and boundary edges the areas of a scene (`where`) select, and the outline of a grid."""
from typing import NamedTuple

import numpy as np
from matplotlib.path import Path as Outline


class Group(NamedTuple):
    """What a block or a mesh calls by a name."""
    zones: np.ndarray = np.empty((0, 4, 2))  # corners
    edges: np.ndarray = np.empty((0, 2, 2))  # ends; those of physical curves only


def inside(area, points):
    """Whether each point lies inside or on all shapes of the area, an absent area being everywhere."""
    area = area or {}
    x, y = points.T
    near = 1e-6 * max(np.ptp(x), np.ptp(y), 1e-9)
    chosen = np.ones(len(points), bool)
    for key, values, sign in (("x_min", x, 1), ("x_max", x, -1), ("y_min", y, 1), ("y_max", y, -1)):
        if key in area:
            chosen &= sign * (values - area[key]) >= -near
    if "circle" in area:
        chosen &= _distance(area["circle"]["centre"], points) <= area["circle"]["radius"] + near
    if "annulus" in area:
        ring = area["annulus"]
        distance = _distance(ring["centre"], points)
        chosen &= (distance >= ring["inner_radius"] - near) & (distance <= ring["outer_radius"] + near)
    if "band" in area:
        chosen &= _in_band(area["band"], points, near)
    if "polygon" in area:
        chosen &= _in_corners(area["polygon"], points, near)
        for hole in area["polygon"].get("holes", []):
            chosen &= ~_in_corners(hole, points, -near)
    return chosen


def boundary(grid):
    """The sides of one zone only, as pairs of points, with the zone on their left."""
    sides = np.concatenate([grid.cells[:, [k, (k + 1) % 4]] for k in range(4)])
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[first[count == 1]]


def points_in(area, piece, groups=None):
    """Points (n, 2) in the area; of a group, the corners of its zones and the ends of its edges. `groups`: {name: Group}."""
    points = piece.points
    if "group" in (area or {}):
        points = np.unique(np.concatenate([each.reshape(-1, 2) for each in groups[area["group"]]]), axis=0)
    return points[inside(area, points)] if len(points) else points


def edges_in(area, grid, edges, groups):
    """Ends (n, 2, 2) of the edges wholly inside the area; of a group, its own edges, or the sides of its zones among `edges`."""
    ends = grid.points[edges]
    if "group" in (area or {}):
        group = groups[area["group"]]
        ends = group.edges if len(group.edges) else ends[_are_sides(ends, group.zones)]
    return ends[inside(area, ends.reshape(-1, 2)).reshape(-1, 2).all(axis=1)] if len(ends) else ends


def zones_in(area, grid, groups):
    """Corners (n, 4, 2) of the zones, those of a group where the area names one, whose centres lie in the area."""
    corners = groups[area["group"]].zones if "group" in (area or {}) else grid.points[grid.cells]
    return corners[inside(area, centres(corners))] if len(corners) else corners


def centres(cells):
    """The middles (n, 2) of cells given by their corners."""
    return cells.mean(axis=1)


def _are_sides(ends, zones):
    """Whether each edge is a side of one of the zones."""
    sides = np.stack([zones, np.roll(zones, -1, axis=1)], axis=2).reshape(-1, 2, 2)
    known = {frozenset(map(tuple, side)) for side in sides.tolist()}
    return np.array([frozenset(map(tuple, each)) in known for each in ends.tolist()], bool)


def _distance(centre, points):
    return np.hypot(points[:, 0] - centre["x"], points[:, 1] - centre["y"])


def _in_band(band, points, near):
    begin, end = (np.array([band[key]["x"], band[key]["y"]]) for key in ("from", "to"))
    length = np.hypot(*(end - begin))
    along = (end - begin) / length
    offset = points - begin
    place = offset @ along
    across = offset @ np.array([-along[1], along[0]])
    return (place >= -near) & (place <= length + near) & (np.abs(across) <= band["width"] / 2 + near)


def _in_corners(polygon, points, near):
    corners = np.array([[corner["x"], corner["y"]] for corner in polygon["corners"]])
    (x, y), (x_next, y_next) = corners.T, np.roll(corners, -1, axis=0).T
    if np.sum(x * y_next - x_next * y) < 0:  # contains_points widens what runs counter-clockwise
        corners = corners[::-1]
    return Outline(np.vstack([corners, corners[:1]]), closed=True).contains_points(points, radius=near)
