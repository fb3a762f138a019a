"""Linings and members by their names and stages, interfaces, bolts and springs."""
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from adit.plots import style
from adit.plots.setup.checked import in_stages

LININGS = (style.BLACK, "#7A3E9D", "#6B6B6B", "#14665A")  # in turn
MEMBERS = ("#1B7837", "#2166AC", "#B2182B")
MOST = 8  # linings or members of a model that are named one by one
BARS = {"bolts": "#8C510A", "springs": "#C2185B"}
INTERFACE = "#D6604D"
WIDTH = 3.0  # of the last layer [points]; those below it show on either side


def draw(axes, members, pieces):
    """Draws the supports of all models; returns the handles of the legend."""
    handles = []
    for kind, colours in (("lining", LININGS), ("member", MEMBERS)):
        before = len(handles)
        for member in members:
            handles += _draw_chains(axes, kind, member.model.get(f"{kind}s", []), pieces.get(member.called(f"{kind}s")),
                                    np.roll(colours, before - len(handles)))
    handles += _draw_interfaces(axes, members, pieces)
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
        return [_draw(axes, lines, colours[0], WIDTH, f"{kind}s{in_stages(stated)}")]
    return [_draw(axes, lines[number == k], colours[k % len(colours)], WIDTH * (1 + _layers_on(part["name"], stated)), _label(kind, part))
            for k, part in sorted(enumerate(stated), key=lambda one: -_layers_on(one[1]["name"], stated)) if (number == k).any()]


def _layers_on(name, stated):
    """How many layers lie on a lining, one on another; a ring beside another one counts as one."""
    def below(part):
        return part.get("on", part.get("beside", {}).get("lining"))
    return max((1 + _layers_on(part["name"], stated) for part in stated if below(part) == name), default=0)


def _label(kind, part):
    what = [f"{kind} {part['name']}"]
    if "section" in part:
        what.append("reinforced")
    if "beside" in part:
        what.append(f"beside {part['beside']['lining']}")
    if "interface" in part:
        what.append(f"slips on {part.get('on', 'the ground')}")
    return style.literal(", ".join(what) + in_stages([part]))


def _draw_interfaces(axes, members, pieces):
    """Those between zones; those of linings lie on the linings, whose names say so."""
    handles = []
    for member in members:
        stated, piece = member.model.get("interfaces", []), pieces.get(member.called("interfaces"))
        if not stated or piece is None or not len(piece.cells):
            continue
        number = piece.field("interface", np.zeros(len(piece.cells)))
        lines = piece.points[piece.cells][number < len(stated)]
        label = "interface " + ", ".join(part["name"] for part in stated) if len(stated) <= MOST else "interfaces"
        handles.append(_draw(axes, lines, INTERFACE, 1.6, style.literal(label), dashes=(0, (3, 1.2))))
    return handles


def _draw(axes, lines, color, width, label, dashes="-"):
    axes.add_collection(LineCollection(lines, color=color, lw=width, zorder=4, capstyle="round", ls=dashes))
    return Line2D([], [], color=color, lw=width, label=label, ls=dashes)
