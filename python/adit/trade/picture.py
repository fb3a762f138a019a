"""The picture of the trade-off: errors over cost, a colour for each family, the best variants joined by a line."""
import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from adit.plots import style
from adit.trade.front import ALONE, coupled, front

ERRORS = (("force_l2", "largest bond force: error [%]"), ("far_l2", "displacement far off: error [%]"))
COSTS = (("cpu_s", 1, "CPU time [s]"), ("updates", 1e-6, "particle and zone updates [10⁶]"))
LOOKS = ((style.BLACK, "D"), (style.BLUE, "o"), (style.RED, "v"), (style.GREEN, "^"), (style.ORANGE, "<"),
         (style.SKY, ">"), (style.PINK, "P"), ("#7A4B00", "*"), (style.YELLOW, "X"))


def pareto(name, rows):
    figure, panels = plt.subplots(2, 2, sharex="col", sharey="row", figsize=(9.0, 7.4))
    for line, (error, error_label) in zip(panels, ERRORS):
        for axes, (cost, unit, _) in zip(line, COSTS):
            _panel(axes, rows, error, cost, unit)
        line[0].set_ylabel(error_label)
    for axes, (_, _, cost_label) in zip(panels[-1], COSTS):
        axes.set_xlabel(cost_label)
    panels[0, 0].set_title(f"{name}: coupled against particles alone, relative L2 error over cost", loc="left")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="lower center", ncol=4)
    figure.subplots_adjust(left=0.08, right=0.98, top=0.95, bottom=0.17, hspace=0.08, wspace=0.06)
    return figure


def _panel(axes, rows, error, cost, unit):
    best = front(rows, error, cost)
    axes.step([unit * r[cost] for r in best], [100 * r[error] for r in best], where="post", color=style.GREY, lw=1,
              zorder=1, label="front of the coupled")
    for row, dashes in zip((r for r in rows if r["family"] == ALONE), ("--", ":")):
        axes.axvline(unit * row[cost], color=style.GREY, ls=dashes, zorder=0, label=row["variant"])
    shown = coupled(rows)
    for family, (color, marker) in zip(dict.fromkeys(row["family"] for row in shown), LOOKS):
        own = [row for row in shown if row["family"] == family]
        axes.scatter([unit * r[cost] for r in own], [100 * r[error] for r in own], s=34, color=color, marker=marker,
                     label=family, edgecolor="white", linewidth=0.4, zorder=3)
    axes.set(xscale="log", yscale="log")
    axes.grid(lw=0.3, color="#DDDDDD", which="both")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(StrMethodFormatter("{x:g}"))
        axis.set_minor_formatter(NullFormatter())
