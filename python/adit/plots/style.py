"""Colours and letters that all pictures share, and figures as dots."""
import gc

import matplotlib.pyplot as plt
import numpy as np
from matplotlib import scale, ticker
from PIL import Image

plt.switch_backend("Agg")
# A picture has many small objects. Python's default frequency of garbage collection would cost a sixth of the time.
gc.freeze()
gc.set_threshold(20_000, 2)

# Okabe and Ito's palette, whose colours can be told apart with any colour vision.
BLUE, RED, GREEN, ORANGE, SKY, PINK, YELLOW, BLACK = (
    "#0072B2", "#D55E00", "#009E73", "#E69F00", "#56B4E9", "#CC79A7", "#F0E442", "#000000")
GREY = "#8C8C8C"
OF_RUNS = (BLACK, GREEN, RED, BLUE, ORANGE, PINK, SKY)  # in turn, in all pictures that compare runs
COMPRESSION = 3  # of PNG: level 6 takes twice as long and saves 5 %

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
    """The default scale of axes."""

    def set_default_locators_and_formatters(self, axis):
        super().set_default_locators_and_formatters(axis)
        axis.set_major_formatter(Ticks())


scale.register_scale(Linear)


def of_run(number):
    """The colour of the run of this number among those that are compared."""
    return OF_RUNS[number % len(OF_RUNS)]


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


def cut(bounds, pieces):
    """The end of a title where a sheet of these bounds shows the part with particles only."""
    whole = all(inside(bounds, piece.points).all() for piece in pieces.values())
    return "" if whole else "; only the part with particles is drawn"


def literal(text):
    """A name of the scene, escaped: matplotlib would read text between dollar signs as a formula."""
    return text.replace("$", r"\$")


def shown(axes, points):
    """Whether each point lies in the picture."""
    return inside((*axes.get_xlim(), *axes.get_ylim()), points)


def inside(bounds, points):
    """Whether each point lies between x_min, x_max, y_min, y_max."""
    left, right, low, high = bounds
    x, y = points[..., 0], points[..., 1]
    return (x >= left) & (x <= right) & (y >= low) & (y <= high)


def length_in_points(axes, lengths):
    """Median of lengths along x, in the picture."""
    scale = axes.transData.transform([(0, 0), (1, 0)])
    return float(np.median(lengths)) * (scale[1, 0] - scale[0, 0]) * 72 / axes.figure.dpi


def dots(figure, per_inch):
    """The figure as an image of Pillow, and closes it. Figures with an automatic layout are drawn twice, because colour scales get their
    places in the first pass."""
    figure.set_dpi(per_inch)
    if figure.get_layout_engine():
        figure.canvas.draw()
    figure.canvas.draw()
    plt.close(figure)
    return Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")


def save(figure, path):
    """Writes a figure of matplotlib as PNG; returns the path."""
    path.parent.mkdir(parents=True, exist_ok=True)
    per_inch = plt.rcParams["savefig.dpi"]
    dots(figure, per_inch).save(path, compress_level=COMPRESSION, dpi=2 * [per_inch])
    return path
