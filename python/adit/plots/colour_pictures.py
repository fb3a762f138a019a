"""Fields in colours over the undeformed model: peaks over time; displacement, principal stress, yield state and
pressure of the water at an instant."""
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch

from adit.plots import style
from adit.plots.colour_scale import Scale, number
from adit.plots.deformation import common_motion, heavy_cells, told
from adit.plots.drawing import Colours, Drawing, Sheet, legend
from adit.plots.particle_shapes import Shapes
from adit.results.rounding import STILL, settled

OF_PRESSURE, OF_STRENGTH = "of the effective vertical pressure", "of the strength"
SHARES = OF_PRESSURE, OF_STRENGTH  # units of what is 0 at rest and 1 at the limit: in every run the scale is from 0 to 1
HALF_WEIGHT = 0.5  # particles with less weight: the zones below them are shown instead

PEAKS = {  # field: name, unit, size of the unit, function whose largest value is marked
    "peak_displacement_m": ("largest displacement", "mm", 1e-3, np.abs),
    "peak_velocity_m_per_s": ("largest velocity", "m/s", 1, np.abs),
    "peak_acceleration_m_per_s2": ("largest acceleration", "m/s²", 1, np.abs),
    "peak_shear_strain": ("largest shear strain", "10⁻³", 1e-3, np.abs),
    "peak_largest_principal_stress_Pa": ("largest principal stress (tension)", "MPa", 1e6, np.positive),
    "peak_smallest_principal_stress_Pa": ("smallest principal stress (compression)", "MPa", 1e6, np.negative),
    "peak_pressure_ratio": ("largest pressure ratio", OF_PRESSURE, 1, np.positive),
    "peak_demand": ("largest demand", OF_STRENGTH, 1, np.positive)}

HYSTERETIC = 256
# Bits of yield_state (fdm_server/materials/solid.hpp) of each kind, its name and colour; the first match counts.
YIELD = ((1, "shear now", style.RED), (2, "tension now", style.BLUE), (16 | 32, "weak plane now", style.GREEN),
         (4, "shear before", "#F3C3A8"), (8, "tension before", "#B5D3E8"), (64 | 128, "weak plane before", "#B2DDD0"),
         (HYSTERETIC, "hysteretic, which does not yield", "#F0F0F0"))


def peaks(run, time, pieces):
    """Yields (name, drawing) of every peak over time in the snapshot."""
    for field, (what, unit, size, marked) in PEAKS.items():
        shown = _with_field(pieces, field)
        if shown:
            values = {kind: piece[field] / size for kind, piece in shown.items()}
            what = _total(what, pieces)
            yield field.partition("_m_per")[0].removesuffix("_m").removesuffix("_Pa"), _coloured(
                run, f"{what} until t = {style.instant(time)}", shown, pieces.get("cells"), values, unit, marked)


def displacement(run, time, pieces):
    """Displacement of zones and particles, without the common motion of all points, which the title states."""
    shown = _with_field(pieces, "displacement_m")
    if not shown:
        return None
    common = common_motion(shown)
    lengths = {kind: np.hypot(*(piece["displacement_m"][:, :2] - common).T) for kind, piece in shown.items()}
    size = max(np.abs(piece.points).max() for piece in shown.values())
    values = {kind: 1e3 * settled(length, max(np.hypot(*common), STILL * size)) for kind, length in lengths.items()}
    return _coloured(run, f"displacement at t = {style.instant(time)}{told(common)}", shown, pieces.get("cells"), values, "mm",
                     np.abs)


def principal_stress(run, time, pieces):
    """The larger principal stress in the plane, tension positive: of the whole model, or where the particles are and in the
    zones among them."""
    shown = _with_field(pieces, "stress_Pa")
    if not shown:
        return None
    values, largest = {}, max(np.abs(piece["stress_Pa"]).max() for piece in shown.values())
    for kind, piece in shown.items():
        xx, yy, xy = piece["stress_Pa"].T
        values[kind] = settled((xx + yy) / 2 + np.hypot((xx - yy) / 2, xy), largest) / 1e6
    near = [shown["particles"]] if "particles" in shown else None
    what = _total("largest principal stress (tension)", pieces)
    return _coloured(run, f"{what} at t = {style.instant(time)}", shown, pieces.get("cells"), values,
                     "MPa", np.positive, near)


def _total(what, pieces):
    """The name of a principal stress says that it is the total one where the ground has pores with water."""
    return what.replace("principal", "total principal") if _with_field(pieces, "pore_pressure_Pa") else what


def pore_pressure(run, time, pieces):
    """The pressure of the water in the pores; None where there is none."""
    shown = _with_field(pieces, "pore_pressure_Pa")
    values = {kind: piece["pore_pressure_Pa"] / 1e3 for kind, piece in shown.items()}
    if not any(each.any() for each in values.values()):
        return None
    return _coloured(run, f"pore pressure at t = {style.instant(time)}", shown, None, values, "kPa", np.positive)


def pressure_ratio(run, time, pieces):
    """What the pressure of the water has grown by since time 0 over the effective vertical pressure of then."""
    shown = _with_field(pieces, "pressure_ratio")
    if not shown:
        return None
    values = {kind: piece["pressure_ratio"] for kind, piece in shown.items()}
    return _coloured(run, f"pressure ratio of the water at t = {style.instant(time)}", shown, None, values,
                     OF_PRESSURE, np.positive)


def _with_field(pieces, field):
    """The zones and particles that have this field."""
    return {kind: pieces[kind] for kind in ("grid", "particles") if kind in pieces and pieces[kind].field(field) is not None}


def yield_state(run, time, pieces):
    """Which zones yield now and which did before, and how; None if none does and no material of the scene may."""
    grid = pieces.get("grid")
    state = None if grid is None else grid.field("yield_state")
    heavy = grid is not None and heavy_cells(grid)
    if state is None or np.all(state[heavy] == HYSTERETIC):
        return None
    if not np.any(state[heavy].astype(int) & ~HYSTERETIC) and not _may_yield(run):
        return None
    found, left = [], heavy
    for bits, name, colour in YIELD:
        chosen = left & (state.astype(int) & bits > 0)
        left = left & ~chosen
        if np.any(chosen):
            found.append((grid.points[grid.cells[chosen]], colour, f"{name}: {int(chosen.sum()):,} zones"))

    def paint(axes):
        axes.add_collection(PolyCollection(grid.points[grid.cells[heavy]], fc="none", ec="#D5D5D5", lw=0.3))
        for corners, colour, _ in found:
            axes.add_collection(PolyCollection(corners, fc=colour, ec="none"))
        handles = [Patch(fc=colour, label=label) for _, colour, label in found]
        handles.append(Patch(fc="white", ec="#D5D5D5", label=f"elastic: {int(left.sum()):,} zones"))
        return [legend(None, handles, ncol=min(len(handles), 4))]

    return Drawing(run.name, f"what yields at t = {style.instant(time)}", Sheet(style.bounds_of(grid.points)), paint)


def _may_yield(run):
    """Whether the scene states a material with a strength."""
    parts = (run.scene, *(model for _, model in run.models))
    materials = [each.get("material") or {} for part in parts for each in (part, *part.get("materials", []), *part.get("groups", []))]
    return any(law in material for law in ("mohr_coulomb", "weak_plane") for material in materials)


def _coloured(run, what, pieces, cells, values, unit, marked, near=None):
    """`cells`: the polygons of the particles, None of discs; `marked`: the largest of this function of the values is marked, where they
    are not the same everywhere; `near`: the pieces whose extent is drawn, else all."""
    if unit in SHARES:
        values = {kind: settled(each, 1) for kind, each in values.items()}
    bounds = style.bounds_of(*(piece.points for piece in near or pieces.values()))
    what += style.cut(bounds, pieces)
    heavy = {kind: _heavy(piece, values[kind]) for kind, piece in pieces.items()}
    seen = {kind: heavy[kind] & style.inside(bounds, _places(piece, values[kind])) for kind, piece in pieces.items()}
    scale = Scale(np.concatenate([values[kind][seen[kind]] for kind in pieces]), (0, 1) if unit in SHARES else None)
    norm = scale.look()["norm"]
    colours = Colours("", norm.vmin, norm.vmax, unit)
    value, *place = _largest(pieces, values, seen, marked)
    x, y = (settled(each, max(map(abs, bounds))) for each in place)
    largest = (f"{number(value)} {unit} everywhere", style.BLACK) if scale.is_constant else (
        f"○ {number(value)} {unit} at x = {x:.4g} m, y = {y:.4g} m", style.RED)
    notes = (largest, (scale.beyond(unit), style.BLACK))

    def paint(axes, beside):
        for kind, piece in pieces.items():
            drawn = _draw(axes, piece, cells, values[kind], heavy[kind], scale)
        bar = axes.figure.colorbar(drawn, extend=scale.extend(), cax=beside, label=colours.label)
        if scale.is_single:
            bar.set_ticks([scale.low])
        if not scale.is_constant:
            axes.plot(x, y, "o", ms=9, mfc="none", mec=style.RED, mew=1.3, zorder=5, clip_on=False)

    return Drawing(run.name, what, Sheet(bounds, has_bar=True), paint, notes, () if scale.is_single else (colours,))


def _draw(axes, piece, cells, values, heavy, scale):
    """Particles as they are, zones in the colours of their values, or of those at their corners with lines of equal values."""
    look = scale.look()
    if piece.is_cloud:
        return Shapes(piece, cells).add(axes, heavy, array=values[heavy], ec="none", zorder=3, **look)
    if len(values) == len(piece.cells):
        return axes.add_collection(PolyCollection(piece.points[piece.cells[heavy]], array=values[heavy], ec="face", lw=0.2, **look))
    cells = piece.cells[heavy_cells(piece)]
    triangles = *piece.points.T, np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
    levels = [level for level in scale.levels() if values[heavy].min() < level < values[heavy].max()]
    if levels:
        axes.tricontour(*triangles, values, levels, colors="white", linewidths=0.4, linestyles="solid")
    return axes.tripcolor(*triangles, values, shading="gouraud", **look)


def _places(piece, values):
    """The places of the values: the points, or the middles of the cells."""
    return piece.points if len(values) == len(piece.points) else piece.points[piece.cells].mean(axis=1)


def _heavy(piece, values):
    """Which values count: not those of light zones and particles, nor of particles that were taken away."""
    if piece.is_cloud:
        weight = piece.field("weight")
        return piece.is_there() & (True if weight is None else weight >= HALF_WEIGHT)
    heavy = heavy_cells(piece)
    if len(values) == len(heavy):
        return heavy
    of_points = np.full(len(values), False)
    of_points[piece.cells[heavy]] = True
    return of_points


def _largest(pieces, values, seen, marked):
    """(value, x, y) where the function `marked` of the values that are shown is largest."""
    tops = []
    for kind, piece in pieces.items():
        found = np.flatnonzero(seen[kind])
        if len(found):
            top = found[np.argmax(marked(values[kind][found]))]
            tops.append((marked(values[kind][top]), values[kind][top], *_places(piece, values[kind])[top]))
    return max(tops)[1:]
