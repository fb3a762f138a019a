"""The picture of a ladder: results of each model relative to the finest one, over its CPU time."""
import matplotlib.pyplot as plt
from matplotlib.ticker import LogLocator, NullFormatter, StrMethodFormatter

from adit.plots import style

LOOKS = ((style.GREEN, "^"), (style.ORANGE, "v"), (style.BLUE, "s"), (style.RED, "o"), (style.PINK, "D"))
TOP = 2.2  # of the axes at most; larger multiples are written there
LEAST = 0.8, 1.2  # that the axes show
NEAR = 0.1  # difference from the finest that is shaded
COLUMNS = 3


def findings_over_cost(ladder, rows):
    lines = -(-len(ladder.quantities) // COLUMNS)
    height, below = 2.4 * lines + 1.6, 0.5 + 0.2 * -(-len(rows) // COLUMNS)
    figure, panels = plt.subplots(lines, COLUMNS, sharex=True, sharey=True, squeeze=False, figsize=(10.5, height))
    looks = dict(zip(dict.fromkeys(row["family"] for row in rows), LOOKS))
    for axes, quantity in zip(panels.flat, ladder.quantities):
        _panel(axes, quantity, rows, looks)
    panels[0, 0].set_ylim(_limits(ladder, rows))
    for axes in panels.flat[len(ladder.quantities):]:
        axes.axis("off")
    for axes in panels.flat[max(0, len(ladder.quantities) - COLUMNS):len(ladder.quantities)]:
        axes.set_xlabel("CPU time [s]")
        axes.tick_params(labelbottom=True)
    for number, row in enumerate(rows, 1):
        color, marker = looks[row["family"]]
        panels[0, 0].scatter([], [], color=color, marker=marker, label=f"{number}  {row['model']}")
    figure.legend(loc="lower center", ncol=COLUMNS)
    figure.suptitle(f"{ladder.name}: multiples of what the finest model ({len(rows)}) finds; shaded: within 10 %",
                    x=0.01, ha="left")
    figure.subplots_adjust(left=0.05, right=0.98, top=1 - 0.6 / height, bottom=(below + 0.3) / height, hspace=0.4, wspace=0.08)
    return figure


def _limits(ladder, rows):
    """Of the axes, which all panels share."""
    multiples = [1 + error for row in rows for quantity in ladder.quantities if (error := row[f"{quantity.key} error"]) is not None]
    low, high = min(LEAST[0], *multiples), max(LEAST[1], *(min(multiple, TOP) for multiple in multiples))
    return low - 0.15 * (high - low), high + 0.15 * (high - low)


def _panel(axes, quantity, rows, looks):
    axes.set_title(quantity.heading.split(" [")[0], loc="left")
    axes.set(xscale="log")
    axes.xaxis.set_major_locator(LogLocator(subs=(1, 3)))
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:g}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.axhspan(1 - NEAR, 1 + NEAR, color="#EEEEEE", zorder=0)
    for number, row in enumerate(rows, 1):
        error = row[f"{quantity.key} error"]
        if error is None:
            continue
        color, marker = looks[row["family"]]
        at = row["cpu_s"], min(1 + error, TOP)
        text = f"{number}: {1 + error:.1f}" if 1 + error > TOP else f"{number}"
        beside = (4, 4) if number % 2 else (4, -11)  # models that cost alike follow one another
        axes.scatter(*at, color=color, marker=marker, s=26, zorder=3)
        axes.annotate(text, at, xytext=beside, textcoords="offset points", fontsize=8, color=color)
    axes.margins(x=0.1)
