"""Which input matters: first-order indices as bars."""
from adit.plots import style
from adit.plots.drawing import Drawing, Panels
from adit.plots.tunnel_pictures import APART
from adit.study.pictures import axes as axis

BAR = 0.3  # inches


def indices(outcome, out):
    """Yields (name, Drawing) of the indices of all answers, a panel each."""
    found = {name: sorted(each, key=lambda one: one[1]) for name, each in outcome.indices.items() if each}
    if not found:
        return
    ends = [end for each in found.values() for *_, interval in each for end in interval]
    limits = min(0, *ends) - 0.02, max(1, *ends) + 0.02

    def paint(*panels):
        for panel, (name, each) in zip(panels, found.items()):
            inputs, values, intervals = zip(*each)
            places = range(len(each))
            panel.barh(places, values, color=style.SKY, height=0.6)
            panel.hlines(places, *zip(*intervals), color=style.BLACK, lw=1.2)
            panel.set_yticks(places, [style.literal(axis.said(one)) for one in inputs])
            panel.axvline(0, color=style.GREY, lw=0.5)
            panel.set(xlabel=f"share of the variance of {style.literal(axis.said(name))}", xlim=limits)
            panel.grid(axis="x", **axis.GRID)
            panel.set_axisbelow(True)

    heights = [0.8 + BAR * len(each) for each in found.values()]
    layout = Panels(len(found), 1, (8.0, 0.3 + sum(heights)), heights, pads=APART)
    yield "indices", Drawing("", "which input matters: first-order indices", layout, paint,
                             notes=[("A line is the 95 % interval of a bar.", style.BLACK)])
