"""Fields in colours over the undeformed model: peaks over time; displacement, principal stress and yield state at an instant."""
import numpy as np
from matplotlib.collections import EllipseCollection, PolyCollection
from matplotlib.colors import Normalize, TwoSlopeNorm
from matplotlib.patches import Patch

from adit_plots import style

LIGHT_WEIGHT = 0.01  # zones that have less tell little: they follow the particles
HALF_WEIGHT = 0.5  # particles that have less: the zones below them tell more

PEAKS = {  # field: what it is, unit, size of the unit, what is marked: the largest of this function
    "peak_displacement_m": ("largest displacement", "mm", 1e-3, np.abs),
    "peak_velocity_m_per_s": ("largest velocity", "m/s", 1, np.abs),
    "peak_acceleration_m_per_s2": ("largest acceleration", "m/s²", 1, np.abs),
    "peak_shear_strain": ("largest shear strain", "10⁻³", 1e-3, np.abs),
    "peak_largest_principal_stress_Pa": ("largest principal stress (tension)", "MPa", 1e6, np.positive),
    "peak_smallest_principal_stress_Pa": ("smallest principal stress (compression)", "MPa", 1e6, np.negative)}

# Bits of yield_state (fdm_server/materials/solid.hpp) that make a kind, its name and colour; the first that holds.
YIELD = ((1, "shear now", style.RED), (2, "tension now", style.BLUE), (16 | 32, "weak plane now", style.GREEN),
         (4, "shear before", "#F3C3A8"), (8, "tension before", "#B5D3E8"), (64 | 128, "weak plane before", "#B2DDD0"))


def peaks(run, time, pieces):
    """Yields (name, figure) of every peak over time that the snapshot holds."""
    for field, (what, unit, size, marked) in PEAKS.items():
        shown = _with_field(pieces, field)
        if shown:
            values = {kind: piece[field] / size for kind, piece in shown.items()}
            yield field.partition("_m_per")[0].removesuffix("_m").removesuffix("_Pa"), _coloured(
                run, f"{what} until t = {style.instant(time)}", shown, values, unit, marked)


def displacement(run, time, pieces):
    """How far zones and particles have moved."""
    shown = _with_field(pieces, "displacement_m")
    if not shown:
        return None
    values = {kind: 1e3 * np.hypot(*piece["displacement_m"][:, :2].T) for kind, piece in shown.items()}
    return _coloured(run, f"displacement at t = {style.instant(time)}", shown, values, "mm", np.abs)


def principal_stress(run, time, pieces):
    """The larger principal stress in the plane, tension positive: of the whole model, or where the particles are and in the
    zones among them."""
    shown = _with_field(pieces, "stress_Pa")
    if not shown:
        return None
    values = {}
    for kind, piece in shown.items():
        xx, yy, xy = piece["stress_Pa"].T
        values[kind] = ((xx + yy) / 2 + np.hypot((xx - yy) / 2, xy)) / 1e6
    near = [shown["particles"]] if "particles" in shown else None
    return _coloured(run, f"largest principal stress (tension) at t = {style.instant(time)}", shown, values, "MPa", np.positive,
                     near)


def _with_field(pieces, field):
    """The zones and particles that have this field."""
    return {kind: pieces[kind] for kind in ("grid", "particles") if kind in pieces and pieces[kind].field(field) is not None}


def yield_state(run, time, pieces):
    """Which zones yield now and which did before, and how."""
    grid = pieces.get("grid")
    state = None if grid is None else grid.field("yield_state")
    if state is None:
        return None
    figure, axes, add_legend = style.model_sheet(
        style.bounds_of(grid.points), f"{run.name}: what yields at t = {style.instant(time)}")
    heavy = grid.field("weight") >= LIGHT_WEIGHT
    axes.add_collection(PolyCollection(grid.points[grid.cells[heavy]], fc="none", ec="#D5D5D5", lw=0.3))
    handles, left = [], heavy
    for bits, name, colour in YIELD:
        chosen = left & (state.astype(int) & bits > 0)
        left = left & ~chosen
        if np.any(chosen):
            axes.add_collection(PolyCollection(grid.points[grid.cells[chosen]], fc=colour, ec="none"))
            handles.append(Patch(fc=colour, label=f"{name}: {int(chosen.sum()):,} zones"))
    handles.append(Patch(fc="white", ec="#D5D5D5", label=f"elastic: {int(left.sum()):,} zones"))
    add_legend(handles, columns=min(len(handles), 4))
    return figure


def _coloured(run, what, pieces, values, unit, marked, near=None):
    """`marked`: the largest of this function of the values is marked; `near`: the pieces whose extent is drawn, else all."""
    bounds = style.bounds_of(*(piece.points for piece in near or pieces.values()))
    figure, axes, _ = style.model_sheet(bounds, f"{run.name}: {what}", right=1.15)
    heavy = {kind: _heavy(kind, piece, values[kind]) for kind, piece in pieces.items()}
    look = _look(np.concatenate([values[kind][heavy[kind]] for kind in pieces]))
    low, high = look["norm"].vmin, look["norm"].vmax
    for kind, piece in pieces.items():
        if kind == "particles":
            width = 2 * piece.field("radius_m")[heavy[kind]]
            drawn = EllipseCollection(width, width, np.zeros_like(width), units="xy", offsets=piece.points[heavy[kind]],
                                      offset_transform=axes.transData, array=values[kind][heavy[kind]], ec="none", zorder=3,
                                      **look)
            axes.add_collection(drawn)
        elif len(values[kind]) == len(piece.cells):
            cells = piece.points[piece.cells[heavy[kind]]]
            drawn = PolyCollection(cells, array=values[kind][heavy[kind]], ec="face", lw=0.2, **look)
            axes.add_collection(drawn)
        else:
            triangles = np.concatenate([piece.cells[:, [0, 1, 2]], piece.cells[:, [0, 2, 3]]])
            drawn = axes.tripcolor(*piece.points.T, triangles, values[kind], shading="gouraud", **look)
    box = axes.get_position()
    bar = figure.colorbar(drawn, cax=figure.add_axes((box.x1 + 0.25 / figure.get_figwidth(), box.y0,
                                                      0.14 / figure.get_figwidth(), box.height)))
    bar.set_label(f"[{unit}]")
    if low == high:
        bar.set_ticks([low])
    _mark_largest(axes, pieces, values, heavy, unit, marked)
    return figure


def _heavy(kind, piece, values):
    """Which values count: not those of light zones and particles, nor of particles that were taken away."""
    there = piece.is_there() if kind == "particles" else np.full(len(values), True)
    weight = piece.field("weight")
    least = HALF_WEIGHT if kind == "particles" else LIGHT_WEIGHT
    return there & (weight >= least) if weight is not None and len(weight) == len(values) else there


def _look(values):
    """One hue for one sign, two around 0 for both."""
    low, high = _range(values)
    if low < 0 < high:
        return {"cmap": "RdBu_r", "norm": TwoSlopeNorm(0, low, high)}
    return {"cmap": "viridis_r" if high <= 0 else "viridis", "norm": Normalize(low, high)}


def _range(values):
    """Least and greatest value; without the outermost 0.5 % where these are farther off than all others are from each other,
    such as a loose grain among many."""
    low, inner_low, inner_high, high = np.percentile(values, (0, 0.5, 99.5, 100))
    spread = inner_high - inner_low
    return (inner_low if inner_low - low > spread > 0 else low), (inner_high if high - inner_high > spread > 0 else high)


def _mark_largest(axes, pieces, values, heavy, unit, marked):
    """Marks the largest value that is shown by a ring and writes it below the picture."""
    tops = []
    for kind, piece in pieces.items():
        of_zones = kind == "grid" and len(values[kind]) == len(piece.cells)
        places = piece.points[piece.cells].mean(axis=1) if of_zones else piece.points
        found = np.flatnonzero(heavy[kind] & style.shown(axes, places))
        if len(found):
            top = found[np.argmax(marked(values[kind][found]))]
            tops.append((marked(values[kind][top]), values[kind][top], *places[top]))
    _, value, x, y = max(tops)
    axes.plot(x, y, "o", ms=9, mfc="none", mec=style.RED, mew=1.3, zorder=5, clip_on=False)
    axes.figure.text(0.65 / axes.figure.get_figwidth(), 0.14 / axes.figure.get_figheight(), size=8.5,
                     s=f"○ {value:.4g} {unit} at x = {x:.4g} m, y = {y:.4g} m", color=style.RED)
