"""Answers that are histories, over time: fractiles of the runs."""
import numpy as np

from adit.plots import style
from adit.plots.drawing import Drawing, legend
from adit.study.pictures import axes as axis
from adit.study.pictures.chosen import chosen, draw

HEIGHT = 2.0  # inches of a panel


def histories(outcome, out):
    """Yields (name, Drawing) of the questions that are columns of histories.csv, a panel each."""
    runs, which = chosen(outcome, out)
    names = [name for name in outcome.study.questions if runs and name in runs[0].histories]
    if not names:
        return
    times, values = on_one_time(runs, names)
    scaled, label = style.time_axis(times)

    def paint(*panels):
        for panel, name in zip(panels, names):
            of = axis.of_answer(name, values[name])
            draw(panel, scaled, values[name] / of.size)
            panel.axhline(0, color=style.GREY, lw=0.4, zorder=0)
            panel.set_ylabel(of.label)
            panel.grid(**axis.GRID)
        panels[-1].set(xlabel=label, xlim=(scaled[0], scaled[-1]))
        return [legend(panels[0], **axis.BESIDE)]

    yield "over_time", Drawing("", f"answers over time: fractiles of {which}", axis.rows(len(names), HEIGHT), paint)


def on_one_time(runs, names):
    """(times (n,), {name: values (runs, n)}): at the times of the run that ends last; NaN after the end of others."""
    times = max((run.histories["time_s"] for run in runs), key=lambda of: of[-1])
    return times, {name: np.array([np.interp(times, run.histories["time_s"], run.histories[name], right=np.nan) for run in runs])
                   for name in names}
