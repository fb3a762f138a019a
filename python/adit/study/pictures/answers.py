"""Answers over the intensity of the motions, or their distribution where there are none."""
import numpy as np
from matplotlib.lines import Line2D

from adit.plots import style
from adit.plots.drawing import Drawing, legend
from adit.study.outcome import FRACTILES
from adit.study.pictures import axes as axis

LOOKS = ("--", "-", "--")  # of FRACTILES
BEYOND = 1.25  # ends of logarithmic axes beyond the runs
NEAR = 2.0  # times the largest answer: thresholds farther off are told, not drawn


def drawings(outcome, out):
    """Yields (name, Drawing) of each answer that a run has."""
    for name in outcome.study.answers:
        if np.isfinite(outcome.answers(name)).any():
            yield f"answer_{name}", over_intensity(outcome, name) if outcome.study.motions else distribution(outcome, name)


def thresholds(outcome, name):
    """[(State, colour)] of the damage that an answer tells."""
    return [(state, axis.of_state(number)) for damage in outcome.study.damage if damage.of == name
            for number, state in enumerate(damage.states)]


def over_intensity(outcome, name):
    """Each run in the colour of the worst state that it reaches; fractiles at levels, or the regression of a cloud."""
    answers, where, states = outcome.answers(name), axis.of_intensity(outcome), thresholds(outcome, name)
    known = np.isfinite(answers) & (answers > 0)
    x, of = outcome.intensity / where.size, axis.of_answer(name, answers)
    y = answers / of.size
    reached = sum((answers > state.above).astype(int) for state, _ in states) if states else np.zeros(len(answers), int)
    kinds = [("no state", axis.UNDAMAGED) if states else ("a run", style.BLUE), *((state.name, colour) for state, colour in states)]
    lines = fractile_lines(outcome, name) if outcome.study.levels else regression_lines(outcome, name)

    def paint(panel):
        for line in climbs(outcome) if outcome.study.levels and outcome.study.levels[0] == "increments" else ():
            line = [number for number in line if known[number]]
            panel.plot(x[line], y[line], color=style.GREY, lw=0.4, zorder=1)
        for number, (label, colour) in enumerate(kinds):
            shown = known & (reached == number)
            if shown.any():
                panel.plot(x[shown], y[shown], ".", color=colour, ms=5, alpha=0.8, label=f"_{label}")
        for (label, at, values), look in zip(lines, LOOKS):
            panel.plot(at / where.size, values / of.size, look, color=style.BLACK, lw=1.2, label=label)
        panel.set(xscale="log", yscale="log", xlim=beyond(x[known]), ylim=beyond(
            np.append(y[known], [state.above / of.size for state, _ in states if 0 < state.above <= NEAR * answers[known].max()])))
        for state, colour in states:
            panel.axhline(state.above / of.size, color=colour, lw=1.4, ls=":")
        for one in (panel.xaxis, panel.yaxis):
            axis.logarithmic(one)
        panel.set(xlabel=where.label, ylabel=of.label)
        panel.grid(**axis.GRID)
        shown = [kind for number, kind in enumerate(kinds) if (known & (reached == number)).any()]
        return [legend(panel, handles(shown, lines, states, of, answers[known].max()), **axis.BESIDE)]

    if not known.any():
        return distribution(outcome, name)
    hidden = np.count_nonzero(answers == 0)
    note = [(f"{hidden} runs with the answer 0 have no place on the logarithmic axis.", style.BLACK)] if hidden else []
    return Drawing("", f"{axis.said(name)} over intensity", axis.rows(1, 4.0), paint, notes=note)


def handles(kinds, lines, states, of, highest):
    found = [Line2D([], [], color=colour, marker=".", ls="none", ms=7, label=style.literal(label)) for label, colour in kinds]
    found += [Line2D([], [], color=style.BLACK, lw=1.2, ls=look, label=label) for (label, *_), look in zip(lines, LOOKS)]
    return found + of_thresholds(states, of, highest)


def of_thresholds(states, of, highest):
    labels = [f"{state.name} above {state.above / of.size:.3g}" + ("" if state.above <= NEAR * highest else ", not drawn")
              for state, _ in states]
    return [Line2D([], [], color=colour, lw=1.4, ls=":", label=style.literal(label)) for label, (_, colour) in zip(labels, states)]


def beyond(values):
    return values.min() / BEYOND, values.max() * BEYOND


def climbs(outcome):
    """[numbers of the good runs of a climb, by rising level]."""
    found = {}
    for number, row in sorted(enumerate(outcome.good), key=lambda each: each[1]["level"]):
        found.setdefault((row["motion"], row["sample"]), []).append(number)
    return list(found.values())


def fractiles(outcome, name):
    """[(level, median intensity [SI], runs, fractiles)] at levels. Of motions that climb, where as many runs have the answer as at the
    lowest level: higher up those are missing that were stopped because they had reached the last damage state."""
    answers, at = outcome.answers(name), np.array([row["level"] for row in outcome.good], dtype=float)
    found = []
    for level in np.unique(at):
        here = (at == level) & np.isfinite(answers)
        if here.any():
            values = np.percentile(answers[here], FRACTILES)
            found.append((level, float(np.median(outcome.intensity[here])), np.count_nonzero(here), values))
    if outcome.study.levels[0] == "increments":
        found = [each for each in found if each[2] == found[0][2]]
    return found


def fractile_lines(outcome, name):
    """[(label, intensities, values)] of FRACTILES."""
    found = fractiles(outcome, name)
    at, values = np.array([each[1] for each in found]), np.array([each[3] for each in found]).T
    return [(f"{share} % of the runs at a level", at, of_share) for share, of_share in zip(FRACTILES, values)]


def regression_lines(outcome, name):
    """The same of a cloud: its regression, and one standard deviation below and above."""
    found = outcome.regression(name)
    if found is None:
        return []
    x = np.linspace(found.x.min(), found.x.max(), 50)
    middle = found.intercept + found.slope * x
    labels = [f"{share} % by the regression" for share in FRACTILES]
    labels[1] = f"regression: power {found.slope:.3g}, R² = {found.r2:.2f}"
    return [(label, np.exp(x), np.exp(middle + times * found.deviation)) for label, times in zip(labels, (-1, 0, 1))]


def distribution(outcome, name):
    """How many runs have which answer, and the share of the runs up to each, with fractiles and thresholds."""
    answers, states = outcome.answers(name), thresholds(outcome, name)
    answers = np.sort(answers[np.isfinite(answers)])
    of = axis.of_answer(name, answers)
    values, near = answers / of.size, [(state, colour) for state, colour in states if state.above <= NEAR * answers[-1]]

    def paint(count, share):
        count.hist(values, bins="sturges", color=style.SKY, edgecolor="white")
        share.step(np.append(values[0], values), 100 * np.arange(len(values) + 1) / len(values), where="post", color=style.BLACK,
                   label="runs up to an answer")
        for at, look in zip(np.percentile(values, FRACTILES), LOOKS):
            for panel in (count, share):
                panel.axvline(at, color=style.GREY, lw=0.9, ls=look)
        for state, colour in near:
            for panel in (count, share):
                panel.axvline(state.above / of.size, color=colour, lw=1.4, ls=":")
        count.set_ylabel("runs")
        share.set(xlabel=of.label, ylabel="share of the runs [%]", ylim=(0, 102))
        for panel in (count, share):
            panel.grid(**axis.GRID)
            panel.set_axisbelow(True)
        told = [Line2D([], [], color=style.GREY, lw=0.9, ls=look, label=f"{what} %: {at:.4g}")
                for what, look, at in zip(FRACTILES, LOOKS, np.percentile(values, FRACTILES))]
        return [legend(count, told + of_thresholds(states, of, answers[-1]), **axis.BESIDE)]

    return Drawing("", f"{axis.said(name)}: distribution over {len(values)} runs", axis.rows(2, 2.0), paint)
