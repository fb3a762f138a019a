"""Linings and members by their names and stages, bolts and springs."""
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from adit.plots import style
from adit.plots.setup.checked import in_stages

LININGS = (style.BLACK, "#7A3E9D", "#6B6B6B", "#14665A")  # in turn
MEMBERS = ("#1B7837", "#2166AC", "#B2182B")
MOST = 8  # linings or members of a model that are named one by one
BARS = {"bolts": "#8C510A", "springs": "#C2185B"}


def draw(axes, members, pieces):
    """Draws the supports of all models; returns the handles of the legend."""
    handles = []
    for kind, colours in (("lining", LININGS), ("member", MEMBERS)):
        before = len(handles)
        for member in members:
            handles += _draw_chains(axes, kind, member.model.get(f"{kind}s", []), pieces.get(member.called(f"{kind}s")),
                                    np.roll(colours, before - len(handles)))
    for kind, color in BARS.items():
        of_kind = [(member.model.get(kind, []), pieces[member.called(kind)]) for member in members if member.called(kind) in pieces]
        lines = [line for _, piece in of_kind for line in piece.points[piece.cells]]
        if lines:
            parts = [part for stated, _ in of_kind for part in stated]
            handles.append(_draw(axes, lines, color, 2.0, f"{kind}{in_stages(parts)}"))
    return handles


def _draw_chains(axes, kind, stated, piece, colours):
    if piece is None or not len(piece.cells):
        return []
    lines, number = piece.points[piece.cells], piece.field(kind)
    if number is None or len(stated) > MOST:
        return [_draw(axes, lines, colours[0], 3.0, f"{kind}s{in_stages(stated)}")]
    return [_draw(axes, lines[number == k], colours[k % len(colours)], 3.0,
                  style.literal(f"{kind} {part['name']}{in_stages([part])}"))
            for k, part in enumerate(stated) if (number == k).any()]


def _draw(axes, lines, color, width, label):
    axes.add_collection(LineCollection(lines, color=color, lw=width, zorder=4, capstyle="round"))
    return Line2D([], [], color=color, lw=width, label=label)
