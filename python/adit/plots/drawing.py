"""A picture without a size: its content and the layout of its axes. Files and pages choose size and format, and place its texts."""
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import NamedTuple

LEFT, RIGHT, RIGHT_WITH_BAR = 0.65, 0.2, 1.15  # inches beside the axes of a sheet
TALLEST = 7.0  # inches of these axes
GAP, BAR = 0.25, 0.14  # inches: a scale of colours beside the axes, and its width


@dataclass(frozen=True)
class Sheet:
    """One pair of axes of the model, as high as the model needs."""
    bounds: tuple  # x_min, x_max, y_min, y_max [m]
    has_bar: bool = False  # a colour scale stands beside it, in separate axes
    width: float = 9.0  # inches at most
    is_setup: bool = False  # its long legend stands beside it
    dense = True  # many shapes: dots take less room than lines

    def size(self, width):
        """(width, height) [inches] of the axes in a picture of this width."""
        x_min, x_max, y_min, y_max = self.bounds
        width = width - LEFT - (RIGHT_WITH_BAR if self.has_bar else RIGHT)
        height = width * (y_max - y_min) / (x_max - x_min)
        return (width, height) if height <= TALLEST else (width * TALLEST / height, TALLEST)

    def axes(self, figure, below, size):
        """Adds the axes of this size so far above the lower edge [inches], and those of the scale of colours; returns them."""
        width, height = figure.get_size_inches()
        places = [(LEFT, size[0]), (LEFT + size[0] + GAP, BAR)][:1 + self.has_bar]
        first, *bar = [figure.add_axes((x / width, below / height, wide / width, size[1] / height)) for x, wide in places]
        first.set(xlim=self.bounds[:2], ylim=self.bounds[2:], aspect="equal", anchor="W", xlabel="x [m]", ylabel="y [m]")
        first.locator_params(axis="y", nbins=max(3, int(2.5 * size[1])), min_n_ticks=2)
        return first, *bar


@dataclass(frozen=True)
class Panels:
    """Axes in rows and columns. On a narrow page the axes of a row are placed below each other."""
    rows: int
    columns: int
    size: tuple  # inches of a file: width, height
    heights: list = None  # of the rows, relative
    sharex: bool = False
    sharey: bool = False
    margins: dict = None  # of a file, for subplots_adjust; None: as labels need
    pads: dict = field(default_factory=dict)  # of a file whose margins are as labels need
    title_above: bool = False  # the title stands above all panels, which have their own
    dense: bool = False  # many shapes: dots take less room than lines


class Legend(NamedTuple):
    axes: object  # None: of the whole picture
    handles: list
    look: dict  # of a file, arguments of matplotlib's legend


class Colours(NamedTuple):
    """The quantity of a colour scale, from `low` to `high`."""
    what: str
    low: float
    high: float
    unit: str

    @property
    def label(self):
        return f"{self.what} [{self.unit}]".strip()


@dataclass(frozen=True)
class Drawing:
    """paint(*axes) draws into the axes of the layout and returns the legends, if there are any."""
    of: str  # run or case; empty where there is only one
    title: str
    layout: Sheet | Panels
    paint: Callable
    notes: tuple = ()  # (text, colour) of each line below it, which may be empty
    colours: tuple = ()

    @property
    def full_title(self):
        return f"{self.of}: {self.title}" if self.of else self.title


def legend(axes, handles=None, **look):
    """The legend of the handles, or of everything with a name in the axes."""
    return Legend(axes, axes.get_legend_handles_labels()[0] if handles is None else handles, look)
