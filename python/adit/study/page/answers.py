"""What the page says of answers: shares, fractiles, and which input matters."""
from adit.report.markup import details, table
from adit.report.quantities import quantity, unit_of
from adit.study.outcome import FRACTILES
from adit.study.page.fragility import interval
from adit.study.pictures import answers, axes as axis

HEAD = tuple(f"{share} %" for share in FRACTILES)


def shares(outcome):
    """Of studies without motions: how many runs exceed each state."""
    if outcome.study.motions:
        return None
    rows = []
    for damage in outcome.study.damage:
        for state in damage.states if outcome.spread(damage.of) else ():
            share, ends = outcome.exceeded(damage, state)
            rows.append((state.name, axis.said(damage.of), quantity(state.above, unit_of(damage.of)),
                         f"{100 * share:.3g} % ({interval(*(100 * end for end in ends))} %)"))
    return table("Share of the runs that exceed a damage state; in brackets 95 % intervals", ("state", "of", "above", "share"), rows)


def spread(outcome):
    """Of studies without motions: mean, deviation and fractiles of each answer."""
    if outcome.study.motions:
        return None
    keys = ("mean", "deviation", *(f"p{share}" for share in FRACTILES))
    rows = [(name, found["count"], *(quantity(found[key], unit_of(name)) for key in keys))
            for name in outcome.study.answers if (found := outcome.spread(name))]
    return table("Answers of the runs, by size", ("answer", "runs", "mean", "standard deviation", *HEAD), rows)


def at_levels(outcome):
    """Of motions at levels: the fractiles that the pictures show, a table for each answer."""
    if not outcome.study.levels:
        return None
    return [details(f"{axis.said(name)} at the levels", table(f"Fractiles of {name}", ("level", "runs", *HEAD), [
        (axis.of_level(outcome.study, level), count, *(quantity(float(value), unit_of(name)) for value in values))
        for level, _, count, values in answers.fractiles(outcome, name)])) for name in outcome.study.answers if outcome.spread(name)]


def indices(outcome):
    """The largest first."""
    rows = [(axis.said(name), axis.said(given), f"{value:.2f} ({low:.2f} to {high:.2f})".replace("-", "−"))
            for name, found in outcome.indices.items() for given, value, (low, high) in sorted(found, key=lambda each: -each[1])]
    return table("First-order indices: the share of the variance of an answer that an input tells by itself; in brackets 95 % intervals",
                 ("answer", "input", "index"), rows)
