"""Fragility curves of the damage states of an answer, with what they were fitted to and published curves beside."""
import textwrap
from itertools import cycle

import numpy as np
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from adit.plots import style
from adit.plots.drawing import Drawing, legend
from adit.study.fragility import goodness, sets
from adit.study.pictures import axes as axis

POINTS = 200  # of a curve
LONGEST = 70  # letters of a line of the legend
BEYOND = 1.1  # the largest intensity: end of the axis
OF_PUBLISHED = (((0, (5, 2)), style.GREY), ((0, (5, 2)), "#4D4D4D"), (":", style.GREY), (":", "#4D4D4D"))  # style and colour, in turn


def curves(outcome, out):
    """Yields (name, Drawing) of each answer that damage is told by."""
    for damage in outcome.study.damage:
        if states := outcome.of_damage(damage):
            yield f"fragility_{damage.of}", drawing(outcome, damage, states)


def drawing(outcome, damage, states):
    """The curves of StateCurves, with their 95 % bands within the intensities that were computed; the shares of runs that exceed at each
    level, or the runs themselves."""
    where = axis.of_intensity(outcome)
    grid = np.linspace(0, BEYOND * outcome.intensity.max(), POINTS + 1)[1:]
    within = np.linspace(outcome.intensity.min(), outcome.intensity.max(), POINTS)
    beside, seen = published(outcome, damage), observed(outcome, states)
    bands = [band(each, within) for each in states]
    handles = [state(outcome, number, *each) for number, each in enumerate(zip(states, bands))]
    if any(bands):
        handles.append(Patch(fc=style.GREY, alpha=0.3, label="95 % band of a curve: its motions drawn again"))
    handles += [Line2D([], [], color=style.GREY, marker="o", ls="none", ms=4, label="share of the runs at a level, as computed")
                if on_levels(outcome) else
                Line2D([], [], color=style.GREY, marker=".", ls="none", label="a run: above 100 % if it exceeds the state, else below 0")]
    handles += [Line2D([], [], lw=1.1, **look, label=style.literal(label)) for label, _, look in beside]

    dots = {"marker": "o" if on_levels(outcome) else ".", "ms": 4 if on_levels(outcome) else 2, "ls": "none", "alpha": 0.8}

    def paint(panel):
        for label, curve, look in beside:
            panel.plot(grid / where.size, 100 * curve.probability(grid / where.size), lw=1.1, **look, label=style.literal(label))
        for number, (each, ends, (x, y)) in enumerate(zip(states, bands, seen)):
            colour = axis.of_state(number)
            if ends:
                panel.fill_between(within / where.size, *(100 * end for end in ends), color=colour, alpha=0.13, lw=0)
            if each.fit.curve:
                panel.plot(grid / where.size, 100 * each.fit.curve.probability(grid), color=colour, label=style.literal(each.state.name))
            panel.plot(x / where.size, 100 * y, color=colour, **dots)
        panel.set(xlabel=where.label, ylabel="probability of exceeding the state [%]", xlim=(0, grid[-1] / where.size))
        panel.grid(**axis.GRID)
        return [legend(panel, handles, **axis.BESIDE)]

    return Drawing("", f"fragility by {axis.said(damage.of)}", axis.rows(1, 4.0), paint, notes=notes(outcome, damage))


def band(each, intensity):
    """(low, high) of a StateCurve; None without a curve, and where its few motions leave every probability possible."""
    if each.fit.curve is None:
        return None
    low, high = each.bootstrap.band(intensity)
    return (low, high) if (low > 0).any() or (high < 1).any() else None


def state(outcome, number, each, ends):
    """What the legend says of a state, beside its line where it has a curve."""
    curve, (unit, si) = each.fit.curve, outcome.unit
    found = f"median {curve.median / si:.3g} {unit}, dispersion {curve.dispersion:.3g}" if curve else each.fit.sentence(unit, si)
    found += "; too few motions for a band" if curve and not ends else ""
    return Line2D([], [], color=axis.of_state(number), ls="-" if curve else "none", marker="" if curve else "o", ms=4,
                  label=style.literal(textwrap.fill(f"{each.state.name}: {found}", LONGEST)))


def on_levels(outcome):
    """Whether the motions are scaled to levels of the intensity that fragility is told over."""
    levels = outcome.study.levels
    return levels is not None and outcome.study.intensity == levels.intensity


def observed(outcome, states):
    """[(intensity [SI], share that exceeds)] of each state: at levels; otherwise of each run, a little above 1 or below 0, apart
    for each state."""
    return [at_levels(outcome, each) if on_levels(outcome) else of_runs(outcome, number, each) for number, each in enumerate(states)]


def at_levels(outcome, each):
    if outcome.study.levels[0] == "increments":
        levels, known, exceeded = goodness.shares(each.fit.observations)
        return levels, exceeded / known
    answers, at = outcome.answers(each.damage.of), np.array([row["level"] for row in outcome.good], dtype=float)
    levels = np.unique(at[~np.isnan(answers)])
    return levels, np.array([(answers[(at == level) & ~np.isnan(answers)] > each.state.above).mean() for level in levels])


def of_runs(outcome, number, each):
    answers = outcome.answers(each.damage.of)
    apart = 0.02 * (1 + number)
    return outcome.intensity[~np.isnan(answers)], np.where(answers > each.state.above, 1 + apart, -apart)[~np.isnan(answers)]


def fitting(outcome, damage):
    """Published curves over the same measure in the same unit, beside states of a lining that the literature names."""
    measure = outcome.study.intensity[0]
    return [each for each in sets.PUBLISHED.values() if each.measure == measure.upper() and each.unit == outcome.unit[0]] if damage.set else []


def published(outcome, damage):
    """[(label, Curve in the unit of intensities, look of its line)] of the literature."""
    found = [(f"{each.title}, {name}: median {curve.median:.3g} {each.unit}, dispersion {curve.dispersion:.3g}", curve)
             for each in fitting(outcome, damage) for name, curve in each.curves.items()]
    return [(*each, dict(zip(("ls", "color"), look))) for each, look in zip(found, cycle(OF_PUBLISHED))]


def notes(outcome, damage):
    """Where the published curves come from, and what they are over."""
    if known := fitting(outcome, damage):
        place = outcome.study.intensity[2]
        own = f"at {place}" if place else "of the motion as it is given to the scene"
        sources = "; ".join(f"{each.title}: {each.source}" for each in known)
        return [(f"Grey: published curves over the acceleration at the ground surface; those of the study are over that {own}. "
                 f"{sources}.", style.BLACK)]
    return []
