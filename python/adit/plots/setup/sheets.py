"""Pictures of a model before it runs: materials, groups, joints, supports, water, boundaries, loads, probes, overlap."""
import numpy as np
from matplotlib.collections import PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from adit.plots import style
from adit.plots.drawing import Drawing, Sheet, legend
from adit.plots.particle_shapes import Shapes
from adit.plots.setup import conditions, supports, water
from adit.plots.setup.areas import zones_in
from adit.plots.setup.labels import add_labels
from adit.plots.setup.checked import in_stages

# Pale for zones, stronger for particles; the pairs keep apart with any colour vision and in grey.
ZONES = ("#DCE8F4", "#F6E3C0", "#C9DFC9", "#E9D3E3", "#D2D2D2", "#FFF6B8", "#B9D3EA")
PARTICLES = ("#F2B65A", "#6C9FC9", "#5FB89B", "#C98BB0", "#E8DC5A", "#9A9A9A", "#D98A5B")
OVERLAP = "#404040"
OWN_SHEET = 0.25  # particles that fill less of the width get a sheet of their own


def model(checked):
    """Yields (name, drawing): the whole model, and where particles fill a small part of it, a sheet cut to them."""
    pieces = checked.pieces()
    points = [piece.points for name, piece in pieces.items() if name.endswith(("grid", "particles"))]
    whole = water.raised(style.bounds_of(*points), checked.scene.get("water", {}))
    discs = [piece.points for name, piece in pieces.items() if name.endswith("particles")]
    cut = style.bounds_of(*discs) if discs else whole
    both = cut[1] - cut[0] < OWN_SHEET * (whole[1] - whole[0])
    yield "model", _sheet(checked, pieces, whole, "the model", [cut] if both else [])
    if both:
        yield "model_particles", _sheet(checked, pieces, cut, "the particles", [])


def _sheet(checked, pieces, bounds, title, elsewhere):
    """One picture; probes inside the boxes `elsewhere` are named on another sheet."""
    span = max(bounds[1] - bounds[0], bounds[3] - bounds[2])
    room = 0.05 * span  # for arrows and thick edges
    bounds = bounds[0] - room, bounds[1] + room, bounds[2] - room, bounds[3] + room
    members = list(checked.members())

    def paint(axes):
        handles = []
        for member in members:
            if member.piece not in pieces:
                continue
            piece = pieces[member.piece]
            handles += (_draw_zones(axes, member, piece) if member.is_grid else
                        _draw_particles(axes, member, Shapes(piece, pieces.get(member.called("cells")))))
        handles += _shade_overlap(axes, pieces)
        handles += supports.draw(axes, members, pieces)
        handles += water.draw(axes, members, pieces, checked.scene.get("water", {}))
        drawn, notes = conditions.draw(axes, members, pieces, span)
        return [legend(None, handles + drawn + _draw_probes(axes, members, bounds, elsewhere) + notes)]

    return Drawing(checked.name, title, Sheet(bounds, is_setup=True), paint)


def _draw_zones(axes, member, grid):
    number = np.asarray(grid.field("material", np.zeros(len(grid.cells))), int)
    corners = grid.points[grid.cells]
    lines = 0.25 if style.length_in_points(axes, np.ptp(corners, axis=1).max(axis=1)) > 3 else 0
    handles = []
    for k in np.unique(number):
        face = ZONES[(k + member.first_colour) % len(ZONES)]
        axes.add_collection(PolyCollection(corners[number == k], fc=face, ec="#8AA0B5" if lines else face,
                                           lw=lines or 0.2, zorder=1))
        if style.shown(axes, corners[number == k]).any():
            handles.append(Patch(fc=face, ec="#8AA0B5", lw=0.5, label=f"zones: {style.literal(member.material(k))}"))
    return handles + _draw_later_zones(axes, member, grid)


def _draw_later_zones(axes, member, grid):
    """Over those that are there at first, the zones that change in later stages, with the last material that each gets."""
    areas = [(area["stage"], k, area) for k, area in enumerate(member.model.get("materials", []), 1) if area.get("stage")]
    groups = member.zone_groups(grid) if areas else {}
    handles = []
    for _, k, area in sorted(areas, key=lambda each: each[:2]):
        corners = zones_in(area["where"], grid, groups)
        if not len(corners):  # places that are no ground at first
            continue
        look = {"fc": ZONES[(k + member.first_colour) % len(ZONES)], "ec": "#8AA0B5", "ls": "--"}
        axes.add_collection(PolyCollection(corners, lw=0.25, zorder=1.2, **look))
        handles.append(Patch(lw=0.5, label=f"zones: {style.literal(member.material(k))}{in_stages([area])}", **look))
    return handles


def _draw_particles(axes, member, shapes):
    number = member.particle_groups(shapes.discs)
    handles = []
    for k in np.unique(number[shapes.there]):
        face = PARTICLES[(k + member.first_colour) % len(PARTICLES)]
        shapes.add(axes, shapes.there & (number == k), fc=face, ec="none", zorder=2)
        name = f"particles: {style.literal(member.group(k))}{in_stages([{'stage': member.stage_of_group(k)}])}"
        handles.append(shapes.handle(name, size=7, fc=face, ec="none"))
    return handles


def _shade_overlap(axes, pieces):
    """Darker with a smaller share of the continuum in the energy; the particles have the rest."""
    shaded = False
    for name, grid in pieces.items():
        weight = grid.field("weight")
        if not name.endswith("grid") or weight is None:
            continue
        shared = weight < 1 - 1e-9
        shaded |= bool(shared.any())
        colours = np.zeros((shared.sum(), 4))
        colours[:, 3] = 0.08 + 0.3 * (1 - weight[shared])
        axes.add_collection(PolyCollection(grid.points[grid.cells[shared]], fc=colours, ec="none", zorder=2.5))
    return [Patch(fc=OVERLAP, alpha=0.3, label="overlap, darker where zones weigh less")] if shaded else []


def _draw_probes(axes, members, bounds, elsewhere):
    """A dot for each place of a history, with the names of the histories there; the sections all around a lining go without."""
    names = {}
    for member in members:
        for history in member.model.get("histories", []):
            of_section = history["name"].startswith(f"{history.get('lining')}_section_")
            if "at" in history and not of_section:
                at = history["at"]["x"], history["at"]["y"]
                names.setdefault(at, {})[history["name"]] = True
    if not names:
        return []
    places = np.array(list(names))
    axes.plot(*places.T, "o", ms=4.5, mfc="white", mec=style.BLACK, mew=1.1, zorder=7, clip_on=True)
    named = [i for i, place in enumerate(places) if _within(place, bounds) and not any(_within(place, b) for b in elsewhere)]
    texts = [style.literal(", ".join(names[tuple(places[i])])) for i in named]
    add_labels(axes, places[named], texts)
    return [Line2D([], [], ls="", marker="o", ms=4.5, mfc="white", mec=style.BLACK, mew=1.1, label="histories")]


def _within(place, bounds):
    return bounds[0] <= place[0] <= bounds[1] and bounds[2] <= place[1] <= bounds[3]
