"""Joints, stages, boundaries and loads of a model, as its scene states them."""
import math

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from adit.plots import joints, style
from adit.plots.setup.areas import UnknownGroup, boundary, edges_in, inside, zones_in

BOUNDARIES = {"held": style.BLACK, "moved": style.PINK, "quiet": style.GREEN, "free field": style.BLUE, "base": style.RED}
HATCHES = ("////", "\\\\\\\\", "xx", "..", "--")  # of stages
ARROWS = 7  # of one load at most
REACH = 0.045  # length of an arrow, relative to the model


def draw(axes, members, pieces, span):
    """Draws the conditions of all models; returns the handles of the legend, and notes for its end."""
    lines, marks, unknown, notes, loads, handles = {}, {}, [], [], [], []

    def attempt(what, select, *arguments):
        """The selection of an area; empty, with a note, if it names an unknown group."""
        try:
            return select(*arguments)
        except UnknownGroup as group:
            unknown.append(f"not drawn: {what} of group {group}")
            return np.empty((0, 2) if select in (_points_in, _middles_in) else (0, 2, 2))

    for member in members:
        piece = pieces.get(member.piece)
        if piece is None:
            continue
        if member.is_grid:
            handles += _draw_stages(axes, member, piece, attempt)
            _collect_boundaries(member, piece, attempt, lines, marks)
            loads += _grid_loads(member, piece, attempt)
        else:
            _collect_particle_boundaries(member, piece, attempt, lines, marks)
            loads += [(attempt("a load", _points_in, load["where"], piece), load["force"])
                      for load in member.model.get("loads", [])]
        notes += _body_loads(member.model)
    handles += _draw_boundaries(axes, lines, marks)
    handles += joints.draw(axes, [member.model for member in members])
    loads = [(places[style.shown(axes, places)], force) for places, force in loads]
    for places, force in loads:
        _draw_arrows(axes, places, force, REACH * span)
    if any(len(places) for places, _ in loads):
        handles.append(Line2D([], [], ls="", marker=r"$\rightarrow$", ms=11, color=style.RED, label="loads"))
    return handles, [Line2D([], [], ls="", label=style.literal(note)) for note in dict.fromkeys(notes + unknown)]


def _points_in(area, piece):
    return piece.points[inside(area, piece.points)]


def _middles_in(area, grid, edges, groups):
    return edges_in(area, grid, edges, groups).mean(axis=1)


def _draw_stages(axes, member, grid, attempt):
    """Hatches the zones that stages of excavation remove."""
    handles = []
    for excavation in member.model.get("excavations", []):
        stage = excavation.get("stage", 0)
        zones = attempt("an excavation", zones_in, excavation["where"], grid, member.mesh_groups)
        if stage == 0 or len(zones) == 0:
            continue
        hatch = HATCHES[(stage - 1) % len(HATCHES)]
        axes.add_collection(PolyCollection(zones, fc="none", ec="#5A5A5A", lw=0, hatch=hatch, zorder=1.5))
        handles.append(Patch(fc="none", ec="#5A5A5A", lw=0, hatch=hatch, label=f"excavated in stage {stage}"))
    return handles


def _kind_of(motion):
    """A motion without a velocity is that of a body, which moves by a table."""
    return "moved" if "velocity" not in motion or any(motion["velocity"].values()) else "held"


def _collect_boundaries(member, grid, attempt, lines, marks):
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
        found = attempt(kind, edges_in, area, grid, edges, member.mesh_groups)
        if len(found):
            lines.setdefault(kind, []).append(found)
        elif kind in ("held", "moved") and "group" not in (area or {}):
            marks.setdefault(kind, []).append(_points_in(area, grid))


def _collect_particle_boundaries(member, discs, attempt, lines, marks):
    conditions = [(_kind_of(motion), motion.get("where")) for motion in member.model.get("motions", [])]
    conditions += [("quiet", quiet.get("where")) for quiet in member.model.get("quiet", [])]
    for kind, area in conditions:
        marks.setdefault(kind, []).append(attempt(kind, _points_in, area, discs))
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


def _grid_loads(member, grid, attempt):
    edges = boundary(grid)
    for load in member.model.get("edge_loads", []):
        yield attempt("a load", _middles_in, load["where"], grid, edges, member.mesh_groups), load["force"]
    for load in member.model.get("point_loads", []):
        yield attempt("a load", _points_in, load["where"], grid), load["force"]


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
