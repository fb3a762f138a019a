"""What the page says of fragility: the curves, where the damage states come from, crossings, and the parts of the dispersion."""
import math

from adit.report.markup import bullets, paragraphs, table, tag
from adit.report.quantities import quantity, unit_of
from adit.study.fragility import needed, sets, states
from adit.study.pictures import axes as axis

SHARE = 0.10  # of a median, for the number of motions
TESTS = {"chi_square": "χ²", "kolmogorov": "Kolmogorov"}


def told(outcome):
    """For each answer with damage states: their curves, their source, and what else its runs tell."""
    return [part for number, damage in enumerate(outcome.study.damage) if outcome.of_damage(damage)
            for part in (curves(outcome, damage), *paragraphs([source(outcome.study, number)]), further(outcome, damage))]


def curves(outcome, damage):
    """The table of the states of an answer."""
    of = outcome.of_damage(damage)
    over = f"{axis.in_words(*outcome.study.intensity)} of {of[0].fit.observations.motions} motions"
    head = ("state", "exceeded above", f"median [{outcome.unit[0]}]", "dispersion", "does the curve fit?",
            f"motions for a median within {100 * SHARE:g} %")
    return table(f"{axis.said(damage.of)}, over the {over}; in brackets 95 % intervals", head,
                 [(each.state.name, quantity(each.state.above, unit_of(damage.of)), *curve(outcome, each)) for each in of])


def curve(outcome, each):
    """The cells of a StateCurve."""
    unit, si = outcome.unit
    if not each.fit.curve:
        return [tag("td", f"no curve: {each.fit.sentence(unit, si)}", colspan=4)]
    fits, ends = each.goodness, each.intervals
    more = needed.motions_in_all(ends["median"], each.bootstrap.motions, SHARE)
    return (f"{each.fit.curve.median / si:.3g} ({interval(*(end / si for end in ends['median']))})",
            f"{each.fit.curve.dispersion:.3g} ({interval(*ends['dispersion'])})",
            fits.sentence or f"p = {fits.p:.2g}, {TESTS[fits.test]} test", "not known" if more is None else f"{more:,}")


def interval(low, high):
    """Ends of an interval, of which the upper one may be infinite."""
    return f"{low:.3g} to {f'{high:.3g}' if math.isfinite(high) else '∞'}"


def source(study, number):
    """Where the thresholds of a named set come from; None of stated ones."""
    name = study.read["damage"][number].get("set")
    return f"Damage states by {sets.DAMAGE_SETS[name].of}: {sets.DAMAGE_SETS[name].source}." if name else None


def further(outcome, damage):
    """Crossings of the curves, and the parts of the dispersion."""
    (unit, si), of = outcome.unit, outcome.of_damage(damage)
    sentences = [f"The curves of {of[i].state.name} and {of[j].state.name} cross at {at / si:.3g} {unit}: on one side of it, "
                 "the worse state would be the more likely one. Compute more runs, or add levels there."
                 for i, j, at in states.crossings([each.fit.curve for each in of], outcome.intensity.min(), outcome.intensity.max())]
    regression = outcome.regression(damage.of)
    parts = regression and regression.parts()
    if parts:
        sentences.append(f"Dispersion by the regression of {axis.said(damage.of)} over intensity in logarithms (R² = {regression.r2:.2f}): "
                         f"{parts.between:.3g} between motions; {parts.within:.3g} within a motion, by random ground and by what "
                         "intensity does not tell.")
    return bullets(sentences)
