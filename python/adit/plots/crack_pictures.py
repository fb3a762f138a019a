"""Cracks between cells at an instant, as wide as they stand open."""
import numpy as np
from matplotlib.lines import Line2D

from adit.plots import style
from adit.plots.drawing import Drawing, Sheet, legend
from adit.plots.model_pictures import SHEAR_CRACK, TENSILE_CRACK, close_up, count, draw_lines, draw_surroundings
from adit.plots.particle_shapes import Shapes
from adit.results.rounding import coordinate

CELL_FACE, CELL_EDGE = "#F7F3EC", "#CFC8BB"
OPENINGS = (0.1, 0.2, 0.5, 1, 2, 10)  # mm, between classes of cracks: the same in all pictures
WIDTHS = (0.7, 1.2, 1.8, 2.6, 3.5, 4.5, 5.6)  # points, of the lines of each class


def cracks(run, time, pieces, bounds=None):
    """Cells as polygons, and the cracks between them as lines that are as wide as their class of opening. `bounds`: what is
    drawn, else `close_up`."""
    if "cells" not in pieces:
        return None
    piece, bounds = pieces.get("cracks"), bounds or close_up(pieces)
    shapes = Shapes(pieces["particles"], pieces["cells"])

    def paint(axes):
        shapes.add(axes, shapes.there, fc=CELL_FACE, ec=CELL_EDGE, lw=0.3, zorder=0.4)
        handles = [shapes.handle("cells", fc=CELL_FACE, ec=CELL_EDGE)] + draw_surroundings(axes, run, pieces)
        return [legend(None, handles if piece is None else handles + _draw_cracks(axes, piece))]

    return Drawing(run.name, f"{_told(piece)} at t = {style.instant(time)}{style.cut(bounds, pieces)}", Sheet(bounds), paint)


def _told(piece):
    within = [] if piece is None else piece["opening_m"][piece["debonded"] == 0]
    widest = np.max(within, initial=0)
    return (count(len(within), "crack") if len(within) else "no cracks") + (f", open by {1e3 * widest:.3g} mm at most," if widest > 0 else "")


def _draw_cracks(axes, piece):
    """Widest on top. Returns the handles of the legend: kinds, classes of width, the widest within a group."""
    lines, state, debonded, opening = piece.points[piece.cells], piece["state"], piece["debonded"] == 1, 1e3 * piece["opening_m"]
    kinds = [(name, color, chosen) for name, color, chosen in (
        ("tensile crack", style.RED, (state == TENSILE_CRACK) & ~debonded), ("shear crack", style.BLUE, (state == SHEAR_CRACK) & ~debonded),
        ("debonded facet", style.ORANGE, debonded)) if chosen.any()]
    width = np.searchsorted(OPENINGS, opening, side="right")
    for k in np.unique(width):
        for _, color, chosen in kinds:
            draw_lines(axes, lines[chosen & (width == k)], color, WIDTHS[k], zorder=4 + 0.1 * k)
    handles = [*(Line2D([], [], color=color, lw=2, label=count(int(np.sum(chosen)), name)) for name, color, chosen in kinds),
               *(Line2D([], [], color=style.GREY, lw=WIDTHS[k], label=_class(k)) for k in np.unique(width))]
    if debonded.all():
        return handles
    top = int(np.argmax(np.where(debonded, -1, opening)))
    x, y = lines[top].mean(axis=0)
    axes.plot(x, y, "o", ms=11, mfc="none", mec=style.BLACK, mew=1.1, zorder=5)
    return [*handles, Line2D([], [], ls="", marker="o", ms=9, mfc="none", mec=style.BLACK,
                             label=f"widest: {opening[top]:.3g} mm at ({coordinate(x):z.3g}, {coordinate(y):z.3g}) m")]


def _class(number):
    """The openings of a class."""
    if number == 0:
        return f"open by less than {OPENINGS[0]} mm"
    return f"{OPENINGS[number - 1]} to {OPENINGS[number]} mm" if number < len(OPENINGS) else f"more than {OPENINGS[-1]} mm"
