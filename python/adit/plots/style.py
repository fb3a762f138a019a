"""Colours, sizes and the page layout that all pictures share."""
import logging

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import scale, ticker
from matplotlib.font_manager import FontProperties
from matplotlib.textpath import text_to_path
from PIL import Image

plt.switch_backend("Agg")
logging.getLogger("matplotlib.legend").setLevel(logging.ERROR)  # it warns of every panel that has no curve to name

# Okabe and Ito's palette, whose colours can be told apart with any colour vision.
BLUE, RED, GREEN, ORANGE, SKY, PINK, YELLOW, BLACK = (
    "#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9", "#CC79A7", "#F0E442", "#000000")
GREY = "#8C8C8C"
WIDTH = 9.0  # inches of a picture of the model; a page to be read on a phone sets less
LINE = 0.17  # inches from one line of a title to the next
COMPRESSION = 3  # of PNG: 6 takes twice as long and saves 5 %
LABELS_BELOW = 0.5  # inches that the ticks and the label of the x axis take

plt.rcParams.update({
    "figure.dpi": 100, "savefig.dpi": 220, "font.size": 9, "axes.titlesize": 10, "axes.labelsize": 9,
    "legend.fontsize": 8.5, "legend.frameon": False, "axes.linewidth": 0.7, "lines.linewidth": 1.3,
    "axes.spines.top": False, "axes.spines.right": False, "axes.formatter.use_mathtext": True,
    "path.simplify": True})


class Ticks(ticker.ScalarFormatter):
    """Numbers at ticks as plain text: only a power of ten that is common to all is set as a formula, whose parser takes longer
    than the rest of a picture."""

    def __call__(self, x, pos=None):
        return super().__call__(x, pos).removeprefix(r"$\mathdefault{").removesuffix("}$")


class Linear(scale.LinearScale):
    """The scale of every axis that asks for no other one."""

    def set_default_locators_and_formatters(self, axis):
        super().set_default_locators_and_formatters(axis)
        axis.set_major_formatter(Ticks())


scale.register_scale(Linear)


def milliseconds(time):
    return f"{1e3 * time:.0f}" if time >= 10 else f"{1e3 * time:.4g}"


def instant(time):
    """A time as titles write it."""
    return f"{time:.4g} s" if time >= 1 else f"{milliseconds(time)} ms"


def time_axis(times):
    """Times [s] in the unit in which an axis shows them, and the axis's label."""
    return (times, "t [s]") if len(times) and times[-1] >= 1 else (1e3 * times, "t [ms]")


def bounds_of(*point_sets):
    """x_min, x_max, y_min, y_max of points, with a margin of 4 % of the larger side, or of a metre around a single place."""
    points = np.concatenate([p for p in point_sets if len(p)])
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.04 * max(high - low) or 1.0  # a disc drawn a million times as large as the sheet would take hours
    return low[0] - margin, high[0] + margin, low[1] - margin, high[1] + margin


def literal(text):
    """A name of the scene as it stands there: matplotlib would read what stands between dollar signs as a formula."""
    return text.replace("$", r"\$")


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


def model_sheet(bounds, title, width=None, right=0.2):
    """A figure as high as the model needs: (figure, axes of equal aspect, legend function)."""
    left, below, above = 0.65, 0.95, 0.4  # inches for labels, legend and title; `right` for a scale of colours
    width = width or WIDTH
    x_min, x_max, y_min, y_max = bounds
    axes_width = width - left - right
    axes_height = axes_width * (y_max - y_min) / (x_max - x_min)
    if axes_height > 7.0:  # a tall model: the height decides
        axes_width, axes_height = max(4.5, axes_width * 7.0 / axes_height), 7.0
    axes_height = max(axes_height, 0.9)
    title, lines = fitted(title, axes_width + right - 0.05)
    above += LINE * (lines - 1)
    figure_width, figure_height = axes_width + left + right, axes_height + below + above
    figure = plt.figure(figsize=(figure_width, figure_height))
    axes = figure.add_axes((left / figure_width, below / figure_height,
                            axes_width / figure_width, axes_height / figure_height))
    axes.set(xlim=(x_min, x_max), ylim=(y_min, y_max), aspect="equal", anchor="W", xlabel="x [m]", ylabel="y [m]")
    axes.locator_params(axis="y", nbins=max(3, int(2.5 * axes_height)), min_n_ticks=2)
    axes.set_title(title, loc="left")

    def add_legend(handles, columns=None):
        for count in range(columns or len(handles), 0, -1):
            legend = figure.legend(handles=handles, loc="lower center", ncol=count,
                                   columnspacing=1.8, handlelength=2.2, borderaxespad=0.4)
            legend_width, legend_height = legend.get_window_extent(figure.canvas.get_renderer()).size / figure.dpi
            if legend_width <= figure.get_figwidth() or count == 1:
                _grow_below(figure, legend_height + LABELS_BELOW - below)
                break
            legend.remove()

    return figure, axes, add_legend


def _grow_below(figure, more):
    """Makes the figure higher by so many inches under all of its axes."""
    if more <= 0:
        return
    places = [(axes, axes.get_position()) for axes in figure.axes]
    height = figure.get_figheight()
    figure.set_figheight(height + more)
    for axes, box in places:
        axes.set_position((box.x0, (box.y0 * height + more) / (height + more),
                           box.width, box.height * height / (height + more)))


def sheet_with_legend_beside(bounds, title):
    """A figure with its legend on the right, as large as both need: (figure, axes of equal aspect, legend function)."""
    width = WIDTH - 1.5
    left, below, above, gap = 0.65, 0.5, 0.4, 0.2  # inches
    x_min, x_max, y_min, y_max = bounds
    tall = (y_max - y_min) / (x_max - x_min)
    axes_width = min(width, 7.0 / tall)
    axes_height = axes_width * tall
    figure = plt.figure()
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set(xlim=(x_min, x_max), ylim=(y_min, y_max), xlabel="x [m]", ylabel="y [m]")
    axes.locator_params(axis="y", nbins=max(3, int(2.5 * axes_height)), min_n_ticks=2)
    axes.set_title(title, loc="left")

    def place(beside, height):
        whole = left + axes_width + beside, max(height, above + axes_height + below)
        figure.set_size_inches(whole)
        axes.set_position((left / whole[0], 1 - (above + axes_height) / whole[1], axes_width / whole[0], axes_height / whole[1]))
        return (left + axes_width + gap) / whole[0], 1 - above / whole[1]  # the upper left corner of the legend

    def add_legend(handles):
        legend = figure.legend(handles=handles, loc="upper left", borderaxespad=0, handlelength=2.2)
        size = legend.get_window_extent(figure.canvas.get_renderer()).size / figure.dpi
        legend.set_bbox_to_anchor(place(size[0] + 2 * gap, size[1] + above + gap))

    place(3.0, 0)
    return figure, axes, add_legend


def keep_apart(figure):
    """Room around the panels of a figure that is laid out by itself, so that labels touch neither the edge nor other panels."""
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.06, wspace=0.06)


def shown(axes, points):
    """Whether each point lies in the picture."""
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    x, y = points[..., 0], points[..., 1]
    return (x >= left) & (x <= right) & (y >= low) & (y <= high)


def length_in_points(axes, lengths):
    """Median of lengths along x, in the picture."""
    scale = axes.transData.transform([(0, 0), (1, 0)])
    return float(np.median(lengths)) * (scale[1, 0] - scale[0, 0]) * 72 / axes.figure.dpi


def dots(figure, per_inch):
    """The figure as an image of Pillow, and closes it. What lays itself out is drawn twice, since scales of colours get their place by
    then."""
    figure.set_dpi(per_inch)
    if figure.get_layout_engine():
        figure.canvas.draw()
    figure.canvas.draw()
    plt.close(figure)
    return Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")


def save(figure, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    per_inch = plt.rcParams["savefig.dpi"]
    dots(figure, per_inch).save(path, compress_level=COMPRESSION, dpi=2 * [per_inch])
    return path
