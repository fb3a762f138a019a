"""Legends of pictures as text beside small swatches: text reflows on narrow screens and is read aloud."""
from matplotlib.backend_bases import RendererBase
from matplotlib.collections import Collection
from matplotlib.colors import to_hex
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from adit.report.markup import Markup, bullets, safe, tag

MARKERS = {"o": '<circle cx="16" cy="6" r="4" {}/>', "^": '<path d="M11 10L16 2L21 10Z" {}/>',
           "v": '<path d="M11 2L16 10L21 2Z" {}/>',
           "x": '<path d="M12 2L20 10M20 2L12 10" {}/>', "+": '<path d="M16 1V11M11 6H21" {}/>',
           ".": '<circle cx="16" cy="6" r="2" {}/>'}
ARROW = '<path d="M8 6H24M19 2L24 6L19 10" {}/>'
HATCHES = {"/": "M4 11L12 1M12 11L20 1M20 11L28 1", "\\": "M4 1L12 11M12 1L20 11M20 1L28 11", "x": "M4 1L28 11M4 11L28 1",
           "-": "M4 4H28M4 8H28", ".": "M8 6h1M16 6h1M24 6h1"}


def written(legends):
    """A list for each legend; where a picture has several, the panel's quantity stands before it."""
    legends = [each for each in legends if each.handles]
    return [tag("div", tag("p", each.axes.get_ylabel(), class_="panel") if len(legends) > 1 and each.axes else None,
                bullets([[_swatch(handle), " ", plain(handle.get_label())] for handle in each.handles], class_="legend"), class_="key")
            for each in legends]


def plain(text):
    """A text of a picture without the signs that keep matplotlib from reading a formula."""
    return text.replace(r"\$", "$")


def _swatch(handle):
    if isinstance(handle, Patch):
        drawn = _patch(handle)
    elif isinstance(handle, Line2D):
        drawn = _line(handle)
    elif isinstance(handle, Collection):
        colours = handle.get_facecolor() if len(handle.get_facecolor()) else handle.get_edgecolor()
        drawn = f'<rect x="2" y="1" width="28" height="10" fill="{to_hex(colours[0])}"/>'
    else:
        return safe("")
    return Markup(f'<svg class="swatch" viewBox="0 0 32 12" width="32" height="12" aria-hidden="true">{drawn}</svg>')


def _line(line):
    colour, marker, drawn = to_hex(line.get_color()), line.get_marker(), ""
    if line.get_linestyle() not in ("None", "", " ") and line.get_linewidth() > 0:
        dashes = _dashes(line)
        pattern = f' stroke-dasharray="{",".join(f"{2 * d:.3g}" for d in dashes)}"' if dashes else ""
        drawn = f'<path d="M1 6H31" stroke="{colour}" stroke-width="{max(1.0, 1.4 * line.get_linewidth()):.3g}"{pattern}/>'
    if marker in MARKERS:
        face = line.get_markerfacecolor()
        fill = "none" if isinstance(face, str) and face == "none" else to_hex(face)
        edge = line.get_markeredgecolor()
        stroke = "none" if isinstance(edge, str) and edge == "none" else to_hex(edge)
        drawn += MARKERS[marker].format(f'fill="{fill}" stroke="{stroke}" stroke-width="1.4"')
    elif isinstance(marker, str) and "arrow" in marker:
        drawn += ARROW.format(f'fill="none" stroke="{colour}" stroke-width="1.6"')
    return drawn


class _Pen(RendererBase):
    """Keeps the dashes of the last path that is drawn: only a renderer is told them in points."""
    dashes = None

    def draw_path(self, gc, path, transform, rgbFace=None):
        self.dashes = gc.get_dashes()[1]


def _dashes(line):
    drawn, pen = Line2D([0, 1], [0, 1]), _Pen()
    drawn.update_from(line)
    drawn.set_marker("")
    drawn.draw(pen)
    return pen.dashes


def _patch(patch):
    face, edge, hatch = patch.get_facecolor(), patch.get_edgecolor(), patch.get_hatch()
    fill = f'fill="{to_hex(face)}" fill-opacity="{face[3]:.2g}"'
    drawn = f'<rect x="2" y="1" width="28" height="10" {fill} stroke="{to_hex(edge)}" stroke-opacity="{edge[3]:.2g}"/>'
    if hatch:
        drawn += f'<path d="{HATCHES.get(hatch[0], HATCHES["/"])}" stroke="{to_hex(edge)}" fill="none"/>'
    return drawn
