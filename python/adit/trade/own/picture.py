"""The picture of a scene's models: differences from the finest over CPU time, a panel a question, a line a dimension."""
import matplotlib.pyplot as plt

from adit.plots import style
from adit.trade.own.rows import computed, finest

LOOKS = ((style.BLACK, "D"), (style.BLUE, "o"), (style.RED, "v"), (style.GREEN, "^"), (style.ORANGE, "s"), (style.SKY, ">"), (style.PINK, "P"),
         (style.YELLOW, "X"))
COLUMNS = 2


def differences_over_cost(name, rows, questions):
    """`rows`: as `rows_of` gives them."""
    columns = min(COLUMNS, len(questions))
    lines = -(-len(questions) // columns)
    height = 3.2 * lines + 1.3
    figure, panels = plt.subplots(lines, columns, sharex=True, squeeze=False, figsize=(5.0 * columns, height))
    models = computed(rows)
    looks = dict(zip(dict.fromkeys(row["dimension"] for row in models), LOOKS))
    for axes, question in zip(panels.flat, questions):
        _panel(axes, models, question, looks)
    for axes in panels.flat[len(questions):]:
        axes.axis("off")
    for axes in panels[-1]:
        axes.set_xlabel("CPU time [s]")
    panels[0, 0].set_ylabel("from the finest [%]")
    figure.legend(*panels[0, 0].get_legend_handles_labels(), loc="lower center", ncol=4)
    figure.suptitle(f"{name}: difference from the finest model ({finest(rows)['model']}) over CPU time", x=0.01, ha="left")
    figure.subplots_adjust(left=0.13 / columns + 0.03, right=0.98, top=1 - 0.65 / height, bottom=1.0 / height, hspace=0.3, wspace=0.2)
    return figure


def _panel(axes, models, question, looks):
    axes.set_title(question, loc="left")
    axes.set(xscale="log")
    axes.axhline(0, color=style.GREY, lw=0.7, zorder=0)
    stated = models[0]
    for dimension, (color, marker) in looks.items():
        own = [row for row in models if row["dimension"] == dimension]
        joined = sorted([stated, *(row for row in own if row is not stated)], key=lambda row: row["level"])
        for rows, options in ((joined, {"lw": 0.8}), (own, {"lw": 0, "marker": marker, "ms": 5, "label": dimension})):
            axes.plot([row["cpu_s"] for row in rows], [100 * (row[f"{question} difference"] or 0) for row in rows], color=color, **options)
