"""The water of a scene: its level, what stands on the ground, and places with a level or a pressure of their own."""
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from adit.plots import style
from adit.plots.setup.areas import boundary, zones_in
from adit.plots.setup.checked import in_stages

SEA = "#A6D8F0"
PLACES = ("#17639B", "#6A4FA8", "#137D70")  # in turn
COLUMNS = 600  # across the ground, in which its top is sought
SIGN = [(0, 0), (-0.6, 1), (0.6, 1), (0, 0)]  # a triangle that stands on the level
SIGN_AT = 0.94  # of a level's length


def raised(bounds, water):
    """The bounds of a sheet that shows the water above the ground, as far as it is not deeper than the model is high."""
    left, right, low, high = bounds
    return left, right, low, min(max(high, water.get("level", high)), 2 * high - low)


def draw(axes, members, pieces, water):
    """Draws the water of a scene, `{}` where it has none; returns the handles of the legend."""
    if not water:
        return []
    ground = np.concatenate([_spans(member, pieces[member.piece]) for member in members if member.piece in pieces])
    handles = _draw_level(axes, water["level"], ground[..., 0], "water level", color=style.BLUE)
    x = np.linspace(ground[..., 0].min(), ground[..., 0].max(), COLUMNS)
    handles += _draw_sea(axes, x, _levels(x, water, members, pieces), ground)
    for number, place in enumerate(water.get("places", [])):
        handles += _draw_place(axes, members, pieces, place, PLACES[number % len(PLACES)])
    return handles


def _draw_level(axes, level, x, of, **look):
    """A line of this look with the triangle of a level over these x."""
    low, high = axes.get_ylim()
    outside = ", above the picture" if level > high else ", below the picture" if level < low else ""
    if outside:
        return [Line2D([], [], ls="", label=f"{of}: y = {level:.4g} m{outside}")]
    left, right = x.min(), x.max()
    axes.plot((left, right), (level, level), lw=1.3, zorder=6, **look)
    axes.plot(left + SIGN_AT * (right - left), level, marker=SIGN, ms=9, mfc="white", mec=look["color"], mew=1.2, zorder=6.1)
    return [Line2D([], [], lw=1.3, marker="v", ms=6, mfc="white", label=f"{of}: y = {level:.4g} m", **look)]


def _levels(x, water, members, pieces):
    """The level at each x: that of the last place there that has one from the beginning on, else the general one."""
    levels = np.full(len(x), float(water["level"]))
    for place in water.get("places", []):
        if "level" not in place or place.get("stage", 0) > 0:
            continue
        for corners in _all_zones(place, members, pieces):
            levels[(corners[:, 0].min() <= x) & (x <= corners[:, 0].max())] = place["level"]
    return levels


def _draw_sea(axes, x, levels, ground):
    """The water that stands on the ground; openings are dry."""
    top = _top(x, ground)
    wet = top < levels
    if not wet.any():
        return []
    axes.fill_between(x, np.where(wet, top, levels), levels, where=wet, step="mid", fc=SEA, lw=0, zorder=0)
    return [Patch(fc=SEA, label="water above the ground")]


def _top(x, ground):
    """The highest y of the spans of the ground at each x; NaN where there is none."""
    (left, y_left), (right, y_right) = ground[:, 0].T, ground[:, 1].T
    top = np.full(len(x), np.nan)
    for k, at in enumerate(x):
        there = np.flatnonzero((left <= at) & (at <= right))
        if len(there):
            share = (at - left[there]) / (right - left)[there]
            top[k] = np.max(y_left[there] + share * (y_right - y_left)[there])
    return top


def _spans(member, piece):
    """Lines (n, 2, 2) from their left to their right ends that bound the ground: sides of zones, tops of particles."""
    if member.is_grid:
        lines = piece.points[boundary(piece)]
        lines = np.where((lines[:, 0, 0] <= lines[:, 1, 0])[:, None, None], lines, lines[:, ::-1])
        return lines[lines[:, 0, 0] < lines[:, 1, 0]]
    there = piece.is_there()
    places, radius = piece.points[there], piece["radius_m"][there]
    return np.stack([places + np.stack([side * radius, radius], axis=1) for side in (-1, 1)], axis=1)


def _draw_place(axes, members, pieces, place, colour):
    """Its zones, shaded, and where it states a level, this line over them."""
    corners = _all_zones(place, members, pieces)
    look = {"fc": colour, "alpha": 0.25, "lw": 0}
    axes.add_collection(PolyCollection(corners, zorder=1.3, antialiased=False, **look))
    if "pressure" in place:
        return [Patch(label=f"water at {place['pressure'] / 1e3:.4g} kPa{in_stages([place])}", **look)]
    if not corners:
        return []
    level = _draw_level(axes, place["level"], np.array(corners)[:, :, 0], f"its level{in_stages([place])}", color=colour, ls=(0, (4, 1.5)))
    return [Patch(label="water of its own level", **look), *level]


def _all_zones(place, members, pieces):
    return [zones for member in members if member.is_grid and member.piece in pieces
            for zones in _zones(place["where"], pieces[member.piece], member)]


def _zones(area, grid, member):
    groups = member.zone_groups(grid)
    return zones_in(area, grid, groups) if area.get("group") in (None, *groups) else []
