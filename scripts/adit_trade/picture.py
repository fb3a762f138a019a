"""The picture of the trade: errors over cost, a colour a family, the front as a line."""
import matplotlib.pyplot as plt

from adit_plots import style
from adit_trade.front import front

ERRORS = (("force_l2", "force chain, error"), ("far_l2", "displacement far off, error"))
COSTS = (("cpu_s", "CPU time [s]"), ("updates", "particle and zone updates"))
COLORS = (style.GREY, style.BLACK, style.BLUE, style.RED, style.GREEN, style.ORANGE, style.SKY, style.PINK,
          style.YELLOW, "#7A4B00")
MARKERS = "sDov^<>PX*"


def pareto(name, rows):
    families = list(dict.fromkeys(row["family"] for row in rows))
    figure, panels = plt.subplots(2, 2, sharex="col", sharey="row", figsize=(9.0, 7.4))
    for line, (error, error_label) in zip(panels, ERRORS):
        for axes, (cost, cost_label) in zip(line, COSTS):
            best = front(rows, error, cost)
            axes.step([r[cost] for r in best], [100 * r[error] for r in best], where="post", color=style.GREY, lw=1,
                      zorder=1, label="front")
            for family, color, marker in zip(families, COLORS, MARKERS):
                own = [row for row in rows if row["family"] == family]
                axes.scatter([r[cost] for r in own], [100 * r[error] for r in own], s=26, color=color, marker=marker,
                             label=family, edgecolor="white", linewidth=0.4, zorder=3)
            axes.set(xscale="log", yscale="log")
            axes.grid(lw=0.3, color="#DDDDDD", which="both")
        line[0].set_ylabel(f"{error_label} [%]")
    for axes, (_, cost_label) in zip(panels[-1], COSTS):
        axes.set_xlabel(cost_label)
    panels[0, 0].set_title(f"{name}: error against the particles alone, over cost", loc="left")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="lower center", ncol=4)
    figure.subplots_adjust(left=0.08, right=0.98, top=0.95, bottom=0.17, hspace=0.08, wspace=0.06)
    return figure
