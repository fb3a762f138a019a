"""How the quantities of a study stand at axes: their names, units, and the colours of damage states."""
from typing import NamedTuple

import numpy as np
from matplotlib.ticker import LogLocator, NullLocator, StrMethodFormatter

from adit.plots import style
from adit.plots.drawing import Panels
from adit.report.quantities import ENDINGS, prefix
from adit.study.fragility.measures import unit_of

MEASURES = {"pga": "peak ground acceleration", "pgv": "peak ground velocity", "arias": "Arias intensity", "sa": "spectral acceleration"}
OF_STATES = (style.BLUE, style.ORANGE, style.RED, style.PINK, style.GREEN, style.BLACK)  # the lightest damage first
UNDAMAGED = style.GREY
GRID = {"lw": 0.3, "color": "#DDDDDD"}
BESIDE = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.03)}  # of a panel: its legend
DECADES = 2.5  # of an axis with a number at 2 and 5, too


class Axis(NamedTuple):
    """Label of an axis, and the size of its unit."""
    label: str
    size: float


def of_state(number):
    return OF_STATES[number % len(OF_STATES)]


def said(name):
    """An answer or an input as words, without the unit that ends its name."""
    ending = next((ending for ending, _ in ENDINGS if name.endswith(ending)), "")
    return name.removesuffix(ending).replace("_", " ")


def of_answer(name, values):
    """The Axis of an answer, in the unit in which the largest of the values is at least 1."""
    unit = next((unit for ending, unit in ENDINGS if name.endswith(ending)), "")
    symbol, size = prefix(np.nanmax(np.abs(values), initial=0), unit)
    return Axis(style.literal(said(name)) + (f" [{symbol}{unit}]" if unit else ""), size)


def in_words(measure, period, place=""):
    """A measure of intensity."""
    return MEASURES[measure] + (f" at {period:g} s" if measure == "sa" else "") + (f" at {place}" if place else "")


def of_intensity(outcome):
    """The Axis that fragility is told over."""
    unit, si = outcome.unit
    return Axis(f"{style.literal(in_words(*outcome.study.intensity))} [{unit}]", si)


def of_level(study, level):
    """A level of the motions as an engineer writes it."""
    unit, si = unit_of(study.levels[1])
    return f"{level / si:.3g} {unit}"


def logarithmic(axis):
    """Plain numbers at the ticks of a logarithmic axis whose limits are set."""
    low, high = np.log10(axis.get_view_interval())
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high - low < DECADES else (1,)))
    axis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axis.set_minor_locator(NullLocator())


def rows(count, height):
    """The layout of panels of this height [inches] over one axis, with room for legends at their right."""
    whole = 0.9 + (height + 0.15) * count
    margins = {"left": 0.1, "right": 0.8, "top": 1 - 0.35 / whole, "bottom": 0.55 / whole, "hspace": 0.15}
    return Panels(count, 1, (8.0, whole), sharex=True, margins=margins)
