"""Joints, boundaries and loads of a model, as its scene states them."""
import math

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from adit.plots import joints, style
from adit.plots.setup import stages
from adit.plots.setup.areas import boundary, centres, edges_in, points_in

BOUNDARIES = {"held": style.BLACK, "moved": style.PINK, "quiet": style.GREEN, "free field": style.BLUE, "base": style.RED}
ARROWS = 7  # of one load at most
REACH = 0.045  # length of an arrow, relative to the model


def draw(axes, members, pieces, span):
    """Draws the conditions of all models; returns the handles of the legend, and notes for its end."""
    lines, marks, excavated, notes, loads = {}, {}, {}, [], []
    for member in members:
        piece = pieces.get(member.piece)
        if piece is None:
            continue
        groups = member.zone_groups(piece) if member.is_grid else {}
        stages.draw(axes, member, piece, groups, excavated)
        if member.is_grid:
            _collect_boundaries(member, piece, groups, lines, marks)
            loads += _grid_loads(member, piece, groups)
        else:
            _collect_particle_boundaries(member, piece, lines, marks)
            loads += [(points_in(load["where"], piece), load["force"]) for load in member.model.get("loads", [])]
        notes += _body_loads(member.model)
    handles = [excavated[key] for key in sorted(excavated)]
    handles += _draw_boundaries(axes, lines, marks)
    handles += joints.draw(axes, [member.model for member in members])
    loads = [(places[style.shown(axes, places)], force) for places, force in loads]
    for places, force in loads:
        _draw_arrows(axes, places, force, REACH * span)
    if any(len(places) for places, _ in loads):
        handles.append(Line2D([], [], ls="", marker=r"$\rightarrow$", ms=11, color=style.RED, label="loads"))
    return handles, [Line2D([], [], ls="", label=style.literal(note)) for note in dict.fromkeys(notes)]


def _kind_of(motion):
    """A motion without a velocity is that of a body, which moves by a table."""
    return "moved" if "velocity" not in motion or any(motion["velocity"].values()) else "held"


def _collect_boundaries(member, grid, groups, lines, marks):
    """Adds the edges of each kind of boundary to `lines`, and points without an edge to `marks`."""
    model, edges = member.model, boundary(grid)
    (left, lowest), right = grid.points.min(axis=0), grid.points[:, 0].max()
    areas = [("quiet", quiet.get("where")) for quiet in model.get("quiet", [])]
    sides = model.get("free_field", {})
    areas += [("free field", area) for side, area in (("left", {"x_max": left}), ("right", {"x_min": right})) if sides.get(side)]
    if "base" in model:
        areas.append(("base", model["base"].get("where", {"y_max": lowest})))
    areas += [(_kind_of(motion), motion.get("where")) for motion in model.get("motions", [])]
    for kind, area in areas:
        found = edges_in(area, grid, edges, groups)
        if len(found):
            lines.setdefault(kind, []).append(found)
        elif kind in ("held", "moved"):
            marks.setdefault(kind, []).append(points_in(area, grid, groups))


def _collect_particle_boundaries(member, discs, lines, marks):
    conditions = [(_kind_of(motion), motion.get("where")) for motion in member.model.get("motions", [])]
    conditions += [("quiet", quiet.get("where")) for quiet in member.model.get("quiet", [])]
    for kind, area in conditions:
        marks.setdefault(kind, []).append(points_in(area, discs))
    for wall in member.model.get("walls", []):
        lines.setdefault("held", []).append(np.array([joints.segment(wall)]))


def _draw_boundaries(axes, lines, marks):
    handles = []
    for kind, color in BOUNDARIES.items():
        edges = np.concatenate(lines.get(kind, [np.empty((0, 2, 2))]))
        edges = edges[style.shown(axes, edges).any(axis=1)]
        points = np.concatenate(marks.get(kind, [np.empty((0, 2))]))
        points = points[style.shown(axes, points)]
        axes.add_collection(LineCollection(edges, lw=3.2, capstyle="butt", color=color, zorder=5))
        axes.plot(*points.T, ls="", marker="^", ms=5 if len(points) < 50 else 2.5, color=color, zorder=5)
        if len(edges) or len(points):
            handles.append(Line2D([], [], color=color, lw=3.2 if len(edges) else 0, ms=5,
                                  marker="^" if len(points) else "", label=f"boundary: {kind}"))
    return handles


def _grid_loads(member, grid, groups):
    edges = boundary(grid)
    for load in member.model.get("edge_loads", []):
        yield centres(edges_in(load["where"], grid, edges, groups)), load["force"]
    for load in member.model.get("point_loads", []):
        yield points_in(load["where"], grid, groups), load["force"]


def _draw_arrows(axes, places, force, length):
    """Arrows at a few of the places, evenly along the line on which they lie; arrows along that line do not touch."""
    push = np.array([force.get("x", 0.0), force.get("y", 0.0)])
    if len(places) == 0 or not push.any():
        return
    push /= np.hypot(*push)
    spread = np.ptp(places, axis=0)
    axis = int(np.argmax(spread))
    room = 1.6 * length * abs(push[axis])
    count = min(ARROWS, len(places), 1 + int(spread[axis] / room) if room > 0 else ARROWS)
    ends = places[:, axis].min(), places[:, axis].max()
    wanted = np.linspace(*ends, count) if count > 1 else [np.mean(ends)]
    nearest = {int(np.argmin(np.abs(places[:, axis] - at))) for at in wanted}
    for place in places[sorted(nearest)]:
        start = place - length * push * (0.5 if abs(push[axis]) > 0.9 and spread[axis] > 0 else 1)
        axes.annotate("", xy=start + length * push, xytext=start, zorder=6, annotation_clip=False,
                      arrowprops={"arrowstyle": "-|>", "color": style.RED, "lw": 1.3, "shrinkA": 0, "shrinkB": 0})


def _body_loads(model):
    for load in model.get("body_loads", []):
        x, y = (load["acceleration"].get(axis, 0.0) for axis in "xy")
        if x or y:
            arrow = ("↓" if y < 0 else "↑") if abs(y) >= abs(x) else "→" if x > 0 else "←"
            yield f"body load {arrow} {math.hypot(x, y):.4g} m/s²{' in time' if 'time' in load else ''}"
