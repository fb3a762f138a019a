"""Drawings as files: title above, legends and notes around the axes."""
import matplotlib.pyplot as plt
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import text_to_path

from adit.plots import style
from adit.plots.drawing import LEFT, RIGHT, RIGHT_WITH_BAR, Panels

LINE = 0.17  # inches from one line of a title to the next
LABELS_BELOW = 0.5  # inches that the ticks and the label of the x axis take
ABOVE = 0.4  # inches for a title of one line
NARROWEST, LOWEST = 4.5, 0.9  # inches: room for the axes of a model, also where it is tall and thin, or flat


def write(drawing, path):
    """Draws into a file; returns its path."""
    return style.save(figure(drawing), path)


def figure(drawing):
    """The drawing as a figure of matplotlib of a file's size."""
    if isinstance(drawing.layout, Panels):
        return _panels(drawing)
    return _setup(drawing) if drawing.layout.is_setup else _sheet(drawing)


def _panels(drawing):
    layout = drawing.layout
    drawn, panels = plt.subplots(layout.rows, layout.columns, sharex=layout.sharex, sharey=layout.sharey, squeeze=False,
                                 figsize=layout.size, height_ratios=layout.heights)
    if layout.margins is None:
        drawn.set_layout_engine("constrained", **layout.pads)
    else:
        drawn.subplots_adjust(**layout.margins)
    if layout.title_above:
        drawn.suptitle(style.literal(drawing.full_title), x=0.01, ha="left")
    else:
        panels.flat[0].set_title(style.literal(drawing.full_title), loc="left")
    legends = [(each.axes or drawn).legend(handles=each.handles, **each.look)
               for each in drawing.paint(*panels.flat) or () if each.handles]
    if layout.margins:
        _widen(drawn, legends)
    return drawn


def _widen(drawn, legends):
    """Makes the figure as wide as the legends at its right need."""
    width, needed = drawn.get_figwidth(), max((legend.get_window_extent().x1 for legend in legends), default=0) / drawn.dpi
    if needed > width:
        at = drawn.subplotpars
        drawn.set_figwidth(needed)
        drawn.subplots_adjust(left=at.left * width / needed, right=at.right * width / needed)


def _sheet(drawing):
    layout, below = drawing.layout, 0.95
    right = RIGHT_WITH_BAR if layout.has_bar else RIGHT
    size = layout.size(layout.width)
    width, height = max(NARROWEST, size[0]), max(LOWEST, size[1])
    title, lines = fitted(drawing.full_title, width + right - 0.05)
    drawn = plt.figure(figsize=(width + LEFT + right, height + below + (ABOVE + LINE * (lines - 1))))
    axes = layout.axes(drawn, below + (height - size[1]) / 2, size)
    axes[0].set_title(style.literal(title), loc="left")
    for legend in drawing.paint(*axes) or ():
        _add_below(drawn, legend, below)
    width, height = drawn.get_size_inches()
    for line, (text, colour) in enumerate(reversed(drawing.notes)):
        drawn.text(LEFT / width, (0.1 + LINE * line) / height, text, size=8.5, color=colour)
    return drawn


def _add_below(drawn, legend, below):
    """Adds a legend with as many columns as there is room for, and makes room for its rows."""
    for count in range(legend.look.get("ncol", len(legend.handles)), 0, -1):
        placed = drawn.legend(handles=legend.handles, loc="lower center", ncol=count, columnspacing=1.8, handlelength=2.2, borderaxespad=0.4)
        width, height = placed.get_window_extent(drawn.canvas.get_renderer()).size / drawn.dpi
        if width <= drawn.get_figwidth() or count == 1:
            _grow_below(drawn, height + LABELS_BELOW - below)
            break
        placed.remove()


def _grow_below(drawn, more):
    """Makes the figure higher by so many inches under all of its axes."""
    if more <= 0:
        return
    places = [(axes, axes.get_position()) for axes in drawn.axes]
    height = drawn.get_figheight()
    drawn.set_figheight(height + more)
    for axes, box in places:
        axes.set_position((box.x0, (box.y0 * height + more) / (height + more), box.width, box.height * height / (height + more)))


def _setup(drawing):
    """The legend stands on the right; the figure is as large as both need."""
    layout, below, gap = drawing.layout, 0.5, 0.2
    size = layout.size(layout.width - LEFT)
    drawn = plt.figure(figsize=(LEFT + size[0] + 3, ABOVE + size[1] + below))
    axes, = layout.axes(drawn, below, size)
    axes.set_title(style.literal(drawing.full_title), loc="left")
    (_, handles, _), = drawing.paint(axes)
    placed = drawn.legend(handles=handles, loc="upper left", borderaxespad=0, handlelength=2.2)
    needed = placed.get_window_extent(drawn.canvas.get_renderer()).size / drawn.dpi
    width, height = LEFT + size[0] + needed[0] + 2 * gap, max(needed[1] + ABOVE + gap, ABOVE + size[1] + below)
    drawn.set_size_inches(width, height)
    axes.set_position((LEFT / width, 1 - (ABOVE + size[1]) / height, size[0] / width, size[1] / height))
    placed.set_bbox_to_anchor(((LEFT + size[0] + gap) / width, 1 - ABOVE / height))
    return drawn


def fitted(text, inches):
    """A title in as many lines as this width needs: (text, number of lines)."""
    lines, font = [""], FontProperties(size=plt.rcParams["axes.titlesize"])
    for word in text.split(" "):
        longer = f"{lines[-1]} {word}".strip()
        if lines[-1] and text_to_path.get_text_width_height_descent(longer, font, ismath=False)[0] / 72 > inches:
            lines.append(word)
        else:
            lines[-1] = longer
    return "\n".join(lines), len(lines)
