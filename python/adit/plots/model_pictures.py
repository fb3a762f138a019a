"""Pictures of the model at an instant: deformed shape, force chains (Fig. 8), bonds and cracks (Fig. 9)."""
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Polygon

from adit.plots import joints, particle_groups, style
from adit.plots.deformation import common_motion, near, round_below, told
from adit.plots.drawing import Drawing, Sheet, legend
from adit.plots.particle_shapes import Shapes

ZONE_FACE, ZONE_EDGE, DISC_FACE, DISC_EDGE = "#C6DBEF", style.BLUE, "#FDD9A0", "#A86400"
OVERLAP_FACE = "#BDBDBD"
LINES = {"linings": style.BLACK, "members": style.RED}
CLOSE_UP = 0.36  # of the area
LEVELS = 40  # of the widths of force chains
LINES_OF_A_PATH = 5000  # longer paths overflow the memory of the renderer
INTACT, TENSILE_CRACK, SHEAR_CRACK = 0, 1, 2


def deformed(run, time, pieces, scale):
    """The deformed model: zones as quadrilaterals, particles as they are. `scale` of the displacements: that of
    the run. The common motion of all points is subtracted and stated in the title."""
    models = {kind: pieces[kind] for kind in ("grid", "particles") if kind in pieces}
    if not models:
        return None
    common = common_motion(pieces)
    moved = {kind: piece.moved(scale, common) for kind, piece in models.items()}
    kept = {kind: near(models[kind], points, scale) for kind, points in moved.items()}
    bounds = style.bounds_of(*(p.points for p in models.values()), *(moved[kind][kept[kind]] for kind in models))
    grid = pieces.get("grid")
    shapes = Shapes(pieces["particles"], pieces.get("cells"), scale, common) if "particles" in pieces else None

    def paint(axes):
        handles = _shade_overlap(axes, run, grid, moved.get("grid"))
        if grid is not None:
            _draw_zones(axes, grid, moved["grid"], fc=ZONE_FACE, ec="none", zorder=1)
            width = min(0.7, 0.06 * style.length_in_points(axes, np.ptp(grid.points[grid.cells], axis=1).max(axis=1)))
            _draw_zones(axes, grid, moved["grid"], fc="none", ec=ZONE_EDGE, lw=width, zorder=3)  # over the particles
            handles.append(Patch(fc=ZONE_FACE, ec=ZONE_EDGE, label="zones"))
        for kind, colour in LINES.items():
            if (lines := pieces.get(kind)) is not None and len(lines.cells):
                axes.add_collection(LineCollection(lines.moved(scale, common)[lines.cells], color=colour, lw=1.6, zorder=4))
                handles.append(Line2D([], [], color=colour, lw=1.6, label=kind))
        if shapes is not None:
            handles += _draw_particles(axes, run, shapes, kept["particles"])
        return [legend(None, handles)]

    title = f"deformed model at t = {style.instant(time)}, displacements × {scale:,.0f}{told(common)}"
    return Drawing(run.name, title, Sheet(bounds), paint)


def _draw_particles(axes, run, shapes, kept):
    """`kept`: which of them are not loose."""
    shapes.add(axes, shapes.there, fc=DISC_FACE, ec=DISC_EDGE, lw=0.35, zorder=2)
    handles = [shapes.handle("particles", fc=DISC_FACE, ec=DISC_EDGE)]
    handles += particle_groups.draw(axes, _parts(run), shapes, ec=DISC_EDGE, lw=0.35, zorder=2)
    far = int(np.sum(shapes.there & ~kept))
    if far:
        handles.append(Line2D([], [], ls="", label=f"{count(far, 'loose particle')} may lie outside"))
    return handles


def force_chains(run, time, pieces, bounds=None, scale=None):
    """Bonds as lines whose width is proportional to the normal force; the largest force is marked. `scale`: the force [N] of
    the widest line, the largest of this picture where it is not given; `bounds`: what is drawn, else `close_up`."""
    bonds = pieces.get("bonds")
    if bonds is None or len(bonds.cells) == 0:
        return None
    lines, force, bounds = bonds.points[bonds.cells], bonds.field("normal_force_N"), bounds or close_up(pieces)
    largest = np.nanmax(np.abs(force))

    def paint(axes):
        handles = draw_surroundings(axes, run, pieces)
        if largest > 0:
            handles += _draw_forces(axes, lines, force, scale or largest)
        return [legend(None, handles, ncol=3)]

    title = f"normal forces in the bonds at t = {style.instant(time)}{style.cut(bounds, pieces)}"
    return Drawing(run.name, title, Sheet(bounds), paint)


def _draw_forces(axes, lines, force, scale):
    """`scale`: the force [N] of the widest line."""
    widest = min(4.0, max(0.8, 0.5 * _length_in_points(axes, lines)))  # dense bonds stay apart
    level = np.round(LEVELS * np.abs(force) / scale).astype(int)
    for k in range(1, LEVELS + 1):  # the largest on top; single lines of their own widths take long to draw
        for sign, color in ((1, style.RED), (-1, style.BLUE)):
            draw_lines(axes, lines[(level == k) & (sign * force > 0)], color, widest * k / LEVELS)
    top, sample = int(np.nanargmax(np.abs(force))), round_below(scale)
    x, y = lines[top].mean(axis=0)
    axes.plot(x, y, "o", ms=11, mfc="none", mec=style.BLACK, mew=1.1, zorder=5)
    mark = Line2D([], [], ls="", marker="o", ms=9, mfc="none", mec=style.BLACK, label=(
        f"largest: {_kilonewton(abs(force[top]))} ({'tension' if force[top] > 0 else 'compression'}) at x = {x:z.2f} m, y = {y:z.2f} m"))
    return [*(Line2D([], [], color=color, lw=widest * sample / scale, label=f"{sign} (width of {_kilonewton(sample)})")
              for color, sign in ((style.RED, "tension"), (style.BLUE, "compression"))), mark]


def bonds(run, time, pieces, bounds=None):
    """Intact bonds as thin lines; a crack, and a bond between two groups that broke, as a short line across the bond. None of
    cells, whose cracks have a width (crack_pictures)."""
    piece = pieces.get("bonds")
    if piece is None or len(piece.cells) == 0 or "cells" in pieces:
        return None
    lines, state, bounds = piece.points[piece.cells], piece.field("state"), bounds or close_up(pieces)
    intact, between = state == INTACT, _between_groups(pieces)
    cracks = int(np.sum(~intact & ~between))

    def paint(axes):
        handles = draw_surroundings(axes, run, pieces)
        draw_lines(axes, lines[intact], style.GREY, 0.5)
        handles.append(Line2D([], [], color=style.GREY, lw=0.8, label=count(int(np.sum(intact)), "intact bond")))
        for chosen, name, color in (((state == TENSILE_CRACK) & ~between, "tensile crack", style.RED),
                                    ((state == SHEAR_CRACK) & ~between, "shear crack", style.BLUE),
                                    (~intact & between, "debonded bond", style.ORANGE)):
            if chosen.any():
                axes.add_collection(LineCollection(_across(lines[chosen]), lw=2.4, color=color, zorder=4))
                handles.append(Line2D([], [], color=color, lw=2.4, label=count(int(np.sum(chosen)), name)))
        return [legend(None, handles)]

    title = f"{count(cracks, 'crack') if cracks else 'no cracks'} at t = {style.instant(time)}{style.cut(bounds, pieces)}"
    return Drawing(run.name, title, Sheet(bounds), paint)


def _between_groups(pieces):
    """Whether each bond joins particles of two groups."""
    cells = pieces["bonds"].cells
    group = pieces["particles"].field("group") if "particles" in pieces else None
    return np.zeros(len(cells), bool) if group is None else group[cells[:, 0]] != group[cells[:, 1]]


def draw_lines(axes, lines, color, width, zorder=2):
    """Many lines of one look, joined to paths with gaps."""
    for some in np.array_split(lines, 1 + len(lines) // LINES_OF_A_PATH) if len(lines) else ():
        x, y = np.insert(some, 2, np.nan, axis=1).reshape(-1, 2).T
        axes.add_line(Line2D(x, y, color=color, lw=width, solid_capstyle="round", zorder=zorder))


def close_up(pieces):
    """Bounds of the whole model, or of the bonds alone where they fill a small part of it."""
    bonds, bounds = pieces["bonds"], style.bounds_of(*(p.points for p in pieces.values()))
    if not len(bonds.cells):
        return bounds
    near = style.bounds_of(bonds.points[np.unique(bonds.cells)], *([pieces["cells"].points] if "cells" in pieces else ()))
    return near if _area(near) < CLOSE_UP * _area(bounds) else bounds


def _area(bounds):
    x_min, x_max, y_min, y_max = bounds
    return (x_max - x_min) * (y_max - y_min)


def _draw_zones(axes, grid, points, **look):
    axes.add_collection(PolyCollection(points[grid.cells], **look))


def draw_surroundings(axes, run, pieces):
    grid = pieces.get("grid")
    handles = _shade_overlap(axes, run, grid)
    if grid is not None:
        _draw_zones(axes, grid, grid.points, fc="none", ec="#BBCFE0", lw=0.6)
        handles.append(Patch(fc="white", ec="#BBCFE0", label="zones"))
    if "particles" in pieces:
        shapes = Shapes(pieces["particles"], pieces.get("cells"))
        handles += particle_groups.draw(axes, _parts(run), shapes, ec="none", alpha=0.55, zorder=0.5)
    springs = pieces.get("springs")
    if springs is not None and len(springs.cells):
        axes.add_collection(LineCollection(springs.points[springs.cells], color=style.GREEN, lw=1.6, zorder=3))
        handles.append(Line2D([], [], color=style.GREEN, lw=1.6, label="springs"))
    return handles + _draw_bars(axes, pieces.get("bars")) + joints.draw(axes, _parts(run))


def _draw_bars(axes, bars):
    """Reinforcing bars, coloured by their stress."""
    if bars is None or not len(bars.cells):
        return []
    stress = bars.field("stress_Pa") / 1e6
    largest = max(np.abs(stress).max(), 1e-9)
    lines = LineCollection(bars.points[bars.cells], array=stress, cmap="coolwarm", lw=2.2, zorder=3.5)
    lines.set_clim(-largest, largest)
    axes.add_collection(lines)
    shown = [(lines.cmap(0.5 + value / (2 * largest)), value) for value in (stress.min(), stress.max())]
    return [Line2D([], [], color=color, lw=2.2, label=f"bars, {value:.0f} MPa") for color, value in shown]


def _parts(run):
    """The models of the run, as its scene states them."""
    return [model for _, model in run.models]


def _shade_overlap(axes, run, grid, points=None):
    """Shades the overlap: a strip from where particles begin to where the continuum ends, or the zones of a ring. `points`:
    those of the grid after its displacement."""
    ends = run.overlap()
    shade = {"fc": OVERLAP_FACE, "ec": "none", "alpha": 0.45}
    if ends is None:
        weight = np.array([]) if grid is None else grid.field("weight", np.array([]))
        shared = weight < 1 - 1e-9  # beyond the overlap rounding leaves a weight just below 1
        if not np.any(shared):
            return []
        points = grid.points if points is None else points
        axes.add_collection(PolyCollection(points[grid.cells[shared]], zorder=1.5, **shade))
        return [Patch(label="overlap", **shade)]
    direction = ends[1] - ends[0]
    along = np.array([-direction[1], direction[0]]) / np.hypot(*direction)
    far = along * (np.ptp(axes.get_xlim()) + np.ptp(axes.get_ylim()))
    corners = [ends[0] - far, ends[1] - far, ends[1] + far, ends[0] + far]
    axes.add_patch(Polygon(corners, zorder=0, **shade))
    return [Patch(label="overlap", **shade)]


def _length_in_points(axes, lines):
    """Median length of the lines in the picture."""
    ends = axes.transData.transform(lines.reshape(-1, 2)).reshape(-1, 2, 2)
    return float(np.median(np.hypot(*(ends[:, 1] - ends[:, 0]).T))) * 72 / axes.figure.dpi


def _across(lines):
    """Lines as long as the given ones, turned by a right angle about their middles."""
    middle, half = lines.mean(axis=1), (lines[:, 1] - lines[:, 0]) / 2
    turned = np.stack([-half[:, 1], half[:, 0]], axis=1)
    return np.stack([middle - turned, middle + turned], axis=1)


def _kilonewton(force):
    kilo = force / 1e3
    return f"{kilo:,.0f} kN" if kilo >= 100 else f"{kilo:.3g} kN"


def count(number, noun):
    return f"{number:,} {noun}" + ("" if number == 1 else "s")
