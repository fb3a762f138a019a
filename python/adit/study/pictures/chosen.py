"""The runs that pictures over time and along linings summarize, and their fractiles."""
from typing import NamedTuple

import numpy as np

from adit.plots import style
from adit.report.results import Results
from adit.study.outcome import FRACTILES
from adit.study.pictures import axes as axis

MOST = 100  # runs that are read


class Chosen(NamedTuple):
    """Runs, and what they are as the end of a title."""
    runs: list
    said: str


def chosen(outcome, out):
    """The Chosen of those at the level nearest the median of the lightest state that has one, at the middle level without; of all runs
    where there are no levels, MOST of them at even steps through the table."""
    rows, where = outcome.good, ""
    if outcome.study.levels:
        level = level_shown(outcome)
        rows = [row for row in rows if row["level"] == level]
        where = f" at {outcome.study.levels[1]} = {axis.of_level(outcome.study, level)}"
    count = len(rows)
    if count > MOST:
        rows = [rows[number] for number in np.linspace(0, count - 1, MOST).round().astype(int)]
    of = f"{len(rows)} of {count} runs" if count > MOST else f"{count} runs"
    return Chosen([Results(out / row["folder"]) for row in rows if (out / row["folder"]).exists()], f"{of}{where}")


def level_shown(outcome):
    at = np.array([row["level"] for row in outcome.good], dtype=float)
    levels = np.unique(at)
    median = next((each.fit.curve.median for each in outcome.curves if each.fit.curve), None)
    if median is None:
        return levels[(len(levels) - 1) // 2]
    return min(levels, key=lambda level: abs(np.log(np.median(outcome.intensity[at == level]) / median)))


def draw(panel, x, values, colour=style.BLUE):
    """Draws the fractiles of values (runs, n) over x (n,); values that a run lacks are NaN."""
    low, middle, high = np.nanpercentile(values, FRACTILES, axis=0)
    panel.fill_between(x, low, high, color=colour, alpha=0.2, lw=0)
    for share, line, width in zip(FRACTILES, (low, middle, high), (0.7, 1.3, 0.7)):
        panel.plot(x, line, color=colour, lw=width, label=f"{share} %")
