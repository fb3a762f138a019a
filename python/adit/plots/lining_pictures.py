"""What linings, members and interfaces bear, drawn across them where it acts; thrust and moment against the capacity."""
import re

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from adit.plots import style
from adit.plots.drawing import Drawing, Panels, legend
from adit.results.chains import chains
from adit.results.rounding import ROUNDING, settled

# Fields with their names, units, and a unit in those of the field.
FORCES = (("thrust_N", "thrust N", "kN", 1e3), ("moment_Nm", "moment M", "kN m", 1e3), ("shear_N", "shear force Q", "kN", 1e3))
OF_INTERFACES = (("normal_stress_Pa", "normal stress", "kPa", 1e3), ("shear_stress_Pa", "shear stress", "kPa", 1e3),
                 ("opening_m", "opening", "mm", 1e-3), ("offset_m", "offset", "mm", 1e-3))
OF_FORCES = (Patch(fc=style.RED, alpha=0.5, label="positive: tension, or the right-hand side of the path stretched"),
             Patch(fc=style.BLUE, alpha=0.5, label="negative"),
             Line2D([], [], color=style.GREY, ls="--", label="least and largest so far"))
# What has one dimension, and the field of the model that has it, too: beside the largest of them others may be rounding.
FAMILIES = ((("thrust_N", "moment_Nm", "shear_N"), None), (("normal_stress_Pa", "shear_stress_Pa"), "stress_Pa"),
            (("opening_m", "offset_m"), "displacement_m"))
REACH = 0.3  # length at which the largest value is drawn, relative to the size of the lining


def lining_forces(run, time, pieces):
    """One panel for each force. Positive values are drawn to the right of the lining's path; dashed lines are the least and
    the largest so far. Layers have a row each, from the ground inwards, and so have rings beside others."""
    return _across(run, pieces.get("linings"), FORCES, f"forces in the lining at t = {style.instant(time)}, per metre", OF_FORCES, _layers)


def member_forces(run, time, pieces):
    """The same of members, each with its own."""
    return _across(run, pieces.get("members"), FORCES, f"forces in the members at t = {style.instant(time)}, of one each", OF_FORCES)


def _layers(run, linings):
    """[(names, whether each beam is one of theirs)] of linings that lie on the ground, on these, and so on; of rings beside them."""
    return _by_layers(run, len(linings.cells), [(name, np.isin(linings.cells[:, 0], nodes)) for name, nodes in chains(run, linings)])


def _faces(run, interfaces):
    """The same of the interfaces of these linings; those between zones stand among those on the ground."""
    number, models = interfaces.field("interface"), [model for _, model in run.models if model.get("linings") or model.get("interfaces")]
    if number is None or len(models) != 1:
        return _all_in_one(run, interfaces)
    names = [each["name"] for each in (*models[0].get("interfaces", []), *(one for one in models[0].get("linings", []) if "interface" in one))]
    return _by_layers(run, len(number), [(name, number == k) for k, name in enumerate(names) if (number == k).any()])


def _all_in_one(run, lines):
    return [("", np.full(len(lines.cells), True))]


def _by_layers(run, count, parts):
    """Rows of `count` lines from [(name, which lines are of it)]."""
    stated = {lining["name"]: lining for _, model in run.models for lining in model.get("linings", [])}

    def depth(name):
        return 1 + depth(stated[name]["on"]) if "on" in stated.get(name, {}) else 0

    found = {}
    for name, of_it in parts:
        row = depth(name), "beside" in stated.get(name, {})
        names, shown = found.setdefault(row, ([], np.zeros(count, bool)))
        names.append(name)
        shown |= of_it
    return [(", ".join(names), shown) for _, (names, shown) in sorted(found.items())]


def lining_joints(run, time, pieces):
    """The openings of the joints of segments: a bar outwards, to the right of the path, for the outer face, one inwards for the
    inner face, with the larger of both in mm."""
    lines = pieces.get("linings")
    if lines is None or (outer := lines.field("outer_opening_m")) is None:
        return None
    inner, size = lines.field("inner_opening_m"), max(np.ptp(lines.points, axis=0))
    normals = _right_normals(lines)
    joints = np.flatnonzero(np.maximum(np.abs(outer), np.abs(inner)) > 0)
    largest = max(outer.max(), inner.max(), 1e-12)
    bounds = style.bounds_of(lines.points - 1.5 * REACH * size, lines.points + 1.5 * REACH * size)

    def paint(axes):
        axes.set(xlim=bounds[:2], ylim=bounds[2:], aspect="equal", xlabel="x [m]", ylabel="y [m]")
        axes.add_collection(LineCollection(lines.points[lines.cells], color=style.BLACK, lw=1.8))
        for side, opening, colour in ((1, outer, style.RED), (-1, inner, style.BLUE)):
            ends = lines.points + side * normals * (REACH * size * np.maximum(opening, 0) / largest)[:, None]
            axes.add_collection(LineCollection(np.stack([lines.points, ends], axis=1)[joints], color=colour, lw=5, alpha=0.7))
        for joint in joints:
            side, opening = (1, outer[joint]) if outer[joint] >= inner[joint] else (-1, inner[joint])
            x, y = lines.points[joint] + side * size * (REACH * max(opening, 0) / largest + 0.1) * normals[joint]
            axes.text(x, y, f"{max(opening, 0) / 1e-3:.2f}", ha="center", va="center", fontsize=8.5)
        return [legend(None, [Line2D([], [], color=style.RED, lw=5, alpha=0.7, label="outer face"),
                              Line2D([], [], color=style.BLUE, lw=5, alpha=0.7, label="inner face")], loc="lower center", ncol=2)]

    return Drawing(run.name, f"openings of the joints at t = {style.instant(time)}, in mm",
                   Panels(1, 1, (5.2, 5.4), title_above=True, dense=True, margins={"left": 0.12, "right": 0.97, "top": 0.9, "bottom": 0.18}), paint)


def interfaces(run, time, pieces):
    """One panel for each quantity of the interfaces, positive values to the right of the path; a row for each layer of linings."""
    return _across(run, pieces.get("interfaces"), OF_INTERFACES, f"interfaces at t = {style.instant(time)}", [
        Patch(fc=style.RED, alpha=0.5, label="positive: tension, or the left face moved along the path"),
        Patch(fc=style.BLUE, alpha=0.5, label="negative")], _faces, pieces.get("grid"))


def _across(run, lines, quantities, title, entries, rows_of=_all_in_one, grid=None):
    """`grid`: the zones beside whose fields those of the lines may be rounding."""
    if lines is None or len(lines.cells) == 0:
        return None
    size = max(np.ptp(lines.points, axis=0))
    aside = np.array([max(size - np.ptp(lines.points[:, 0]), 0) / 2, 0])  # beside a column, for titles
    bounds = style.bounds_of(lines.points - REACH * size - aside, lines.points + REACH * size + aside)
    normals, rows = _right_normals(lines), rows_of(run, lines)
    rounding = {name: ROUNDING * _beside(lines, name, size, grid) for name, *_ in quantities}

    def paint(*panels):
        of_panels = [(*row, *quantity) for row in rows for quantity in quantities]
        for axes, (of, shown, name, what, unit, scale) in zip(panels, of_panels):
            axes.set(xlim=bounds[:2], ylim=bounds[2:], aspect="equal")
            _draw(axes, lines, shown, normals, name, REACH * size, rounding[name])
            values = _range(lines.field(name)[np.unique(lines.cells[shown])], scale, rounding[name])
            axes.set_title(f"{what}: {values} {unit}", loc="left")
        for axes, (of, _) in zip(panels[::len(quantities)], rows):
            axes.set_ylabel(f"{of}\ny [m]" if len(rows) > 1 else "y [m]")
        for axes in panels[-len(quantities):]:
            axes.set_xlabel("x [m]")
        return [legend(None, entries, loc="lower center", ncol=len(entries))]

    height = 1.4 + 3.2 * len(rows)
    layout = Panels(len(rows), len(quantities), (3.5 * len(quantities), height), title_above=True, dense=True,
                    margins={"left": 0.06 if len(rows) == 1 else 0.08, "right": 0.99, "top": 1 - 0.55 / height, "bottom": 0.87 / height, "wspace": 0.16})
    return Drawing(run.name, title, layout, paint)


def lining_capacity(run):
    """Thrust and moment of the node with the largest utilisation, at the field times, for each lining with a section, and its
    capacity."""
    return _capacity(run, "lining", "per metre", lambda piece: chains(run, piece))


def member_capacity(run):
    """The same of members."""
    return _capacity(run, "member", "of one member", lambda piece: chains(run, piece, "member"))


def section_capacity(run):
    """The same of that cut through a lining of particles which is used most."""
    named = [section["name"] for _, model in run.models if "continuum" not in model for section in model.get("sections", [])]

    def worst(piece):
        node = piece.field("peak_utilisation").argmax()
        return [(named[node], np.array([node]))] if len(named) == len(piece.points) else []

    return _capacity(run, "section", "per metre", worst)


def _capacity(run, kind, whose, chains_of):
    pieces = [found for number in range(len(run.instants)) if (found := run.pieces_at(number).get(f"{kind}s")) is not None]
    if not pieces or (peaks := pieces[-1].field("peak_utilisation")) is None:
        return None
    shown = [(name, nodes) for name, nodes in chains_of(pieces[-1]) if peaks[nodes].max() > 0]
    if not shown:
        return None
    limits = run.capacities

    def paint(*panels):
        for axes, (name, nodes) in zip(panels, shown):
            worst = nodes[peaks[nodes].argmax()]
            thrust, moment = (np.array([piece.field(field)[worst] for piece in pieces]) / 1e3 for field in ("thrust_N", "moment_Nm"))
            if (kind, name) in limits:
                axes.fill(*(limits[kind, name].T / 1e3), fc="none", ec=style.BLACK, lw=1.2)
            axes.plot(thrust, moment, color=style.RED, lw=0.9, marker=".", ms=3)
            at_most = [found for what in ("thrust", "moment") if (found := _at_most(run, kind, name, what)) is not None]
            if len(at_most) == 2:
                axes.plot(*at_most, color=style.BLUE, ls="", marker="o", mfc="none", ms=6)
            axes.axhline(0, color=style.GREY, lw=0.4, zorder=0)
            axes.axvline(0, color=style.GREY, lw=0.4, zorder=0)
            x, y = pieces[-1].points[worst][:2]
            axes.set_title(f"{name}, ({x:.4g}, {y:.4g}) m: {peaks[worst]:.3g} of its capacity", loc="left")
            axes.set(xlabel="thrust N [kN], tension positive", ylabel="moment M [kN m]")
        return [legend(None, [Line2D([], [], color=style.BLACK, label="capacity"),
                              Line2D([], [], color=style.RED, marker=".", label="where it is used most, at field times"),
                              Line2D([], [], color=style.BLUE, ls="", marker="o", mfc="none", label="when it is used most")],
                       loc="lower center", ncol=3)]

    layout = Panels(1, len(shown), (5.2 * len(shown) + 0.6, 4.4), title_above=True, dense=True,
                    margins={"left": 0.14 / len(shown), "right": 1 - 0.05 / len(shown), "top": 0.87, "bottom": 0.21, "wspace": 0.25})
    return Drawing(run.name, f"thrust and moment against the capacity, {whose}", layout, paint)


def _beside(lines, name, size, grid):
    """The largest of what has the dimension of a quantity, a moment being a force at a lever as long as the lines: beside it the
    quantity may be rounding."""
    names, of_grid = next(family for family in FAMILIES if name in family[0])
    lever = {each: size if each == "moment_Nm" else 1 for each in names}
    largest = max(np.abs(values).max() / lever[each] for each, values in _with_peaks(lines, names))
    field = None if grid is None else grid.field(of_grid)
    return lever[name] * largest if field is None else max(largest, np.abs(field).max())


def _with_peaks(lines, names):
    """(name, values) of fields, with their least and largest so far."""
    return [(name, values) for name in names for end in ("", "peak_least_", "peak_largest_")
            if (values := lines.field(f"{end}{name}")) is not None]


def _at_most(run, kind, name, what):
    """Thrust [kN] or moment [kN m] at the largest utilisation of a lining, a member or all sections."""
    unit = {"thrust": "N", "moment": "Nm"}[what]
    of = "sections" if kind == "section" else f"{kind}_{name}"
    found = [value for key, value in run.summary.items() if re.fullmatch(rf"(.+_)?{re.escape(of)}_{what}_at_largest_utilisation_{unit}", key)]
    return found[0] / 1e3 if len(found) == 1 else None


def _draw(axes, linings, shown, normals, name, reach, rounding):
    """Draws a quantity across the shown beams, as large as in all of them together; as 0 where all of it is `rounding`."""
    (_, values), *rest = _with_peaks(linings, [name])
    peaks, cells = [peak for _, peak in rest], linings.cells[shown]
    largest = np.abs([values, *peaks]).max()
    largest = largest if largest > rounding else 0
    offset = normals * (reach * values / largest if largest > 0 else 0 * values)[:, None]
    ends = linings.points[cells]
    moved = (linings.points + offset)[cells]
    positive = values[cells].mean(axis=1) >= 0
    axes.add_collection(PolyCollection(
        np.concatenate([ends, moved[:, ::-1]], axis=1), fc=np.where(positive, style.RED, style.BLUE), alpha=0.5, lw=0))
    axes.add_collection(LineCollection(moved, color=style.BLACK, lw=0.7))
    axes.add_collection(LineCollection(ends, color=style.BLACK, lw=1.8))
    for peak in peaks if largest > 0 else ():
        outline = linings.points + normals * (reach * peak / largest)[:, None]
        axes.add_collection(LineCollection(outline[cells], color=style.GREY, lw=0.9, ls="--"))


def _right_normals(linings):
    """The unit normal at each node, perpendicular to the mean direction of the beams that meet there."""
    along = linings.points[linings.cells[:, 1]] - linings.points[linings.cells[:, 0]]
    along /= np.maximum(np.hypot(*along.T), 1e-12)[:, None]  # two contacts of a corner share their place
    mean = np.zeros_like(linings.points)
    for end in (0, 1):
        np.add.at(mean, linings.cells[:, end], along)
    mean /= np.maximum(np.hypot(*mean.T), 1e-12)[:, None]
    return np.stack([mean[:, 1], -mean[:, 0]], axis=1)


def _range(values, scale=1e3, rounding=0):
    size = max(np.abs(values).max(), rounding / ROUNDING)
    low, high = (settled(end, size) / scale for end in (values.min(), values.max()))
    return f"{low:,.4g} to {high:,.4g}"
