"""The runs of a search and what they tell, as tables and sentences."""
import math

from adit.accuracy.dimensions import name_of
from adit.trade.table import lines


COUNTS = ("none", "one", "two", "three", "four", "five")


def csv_rows(search):
    """A row a model, with the range of what was computed several times; that of the finest has what is told, too: the middle and half of
    each interval, or the median alone of what scatters by more than is asked."""
    ranging = [key for key in search.best.values if any(run.ranges for run in search.runs)]
    told = {f"{key}_{what}": value for key in search.best.values for what, value in zip(("told", "interval"), _told(search, key))}
    return [{"run": name_of(run.levels), "seconds": run.seconds, **run.values,
             **{f"{key}_{what}": value for key in ranging
                for what, value in zip(("from", "to"), run.ranges[key] if run.ranges else ("", ""))},
             **(told if run is search.best else dict.fromkeys(told, ""))} for run in search.runs]


def _told(search, question):
    """(value, half of its interval, which is empty where it scatters by more than is asked)."""
    if search.scatters(question):
        return search.best.values[question], ""
    return search.value(question), search.interval(question)


def markdown(search):
    questions = list(search.best.values)
    yield from lines(["run", "time [s]", *questions],
                     ([name_of(run.levels), f"{run.seconds:.3g}", *(f"{run.values[question]:.5g}" for question in questions)] for run in search.runs))
    yield ""
    yield from lines(["result", "value", "± [%]", "of which lengths [%]", "order", "rest [%]", "scatter [%]"],
                     ([question, *_row(search, question)] for question in questions))


def _percent(size, value):
    if math.isinf(size):
        return "not known"
    return f"{float(f'{100 * size / abs(value):.2g}'):g}" if value else "–"


def _row(search, question):
    value, half = _told(search, question)
    scatter = _percent(search.best.spread(question), value)
    if search.scatters(question):
        return f"{value:.5g}", f"it scatters, {_range(search.best, question)}", "–", "–", "–", scatter
    lengths, rest = search.refinement(question), search.unrest(question)
    order = "none" if lengths.order is None else f"{lengths.order:.2g}"
    of_rest = _percent(min(rest.size, half), value) if rest else "–"
    return f"{value:.5g}", _percent(half, value), _percent(min(lengths.size, half), value), order, of_rest, scatter


def verdict(search, reached, scatter, choices):
    """Lines for the terminal."""
    for question in search.best.values:
        told = _scatter if search.scatters(question) else _interval
        yield f"{question} = {told(search, question, scatter)}{choices.beside(question)}"
    spent, named = sum(run.seconds for run in search.runs), choices.named()
    apart = f", apart from what depends on a choice ({', '.join(named)})" if reached and named else ""
    yield f"accuracy asked for {_outcome(search, reached)}{apart}: {len(search.runs)} model{'s' * (len(search.runs) > 1)}, {spent:.3g} s"
    if reached or search.unfinished():
        yield f"a further halving would take about {search.next_seconds():.3g} s"
    if reached and all(level <= 0 for level in search.best.levels.values()):
        yield "the scene as stated is fine enough"


def _interval(search, question, scatter):
    value, half = _told(search, question)
    told = f"{value:.5g}, whose error one model does not tell" if math.isinf(half) else f"{value:.5g} ± {_percent(half, value)} %"
    if search.best.spread(question):
        told += f", {_median(search.best, scatter)} ({_range(search.best, question)})"
    if search.best.runs == 1 < search.best.tried:
        told += f", of one alone of {COUNTS[search.best.tried]} {scatter.what}, so that it is not known how it scatters"
    return told


def _scatter(search, question, scatter):
    before = search.models[-2] if len(search.models) > 1 else None
    coarser = f"; before the last halving {before.values[question]:.5g}, {_range(before, question)}" if before and before.ranges else ""
    told = f"{search.best.values[question]:.5g}, {_range(search.best, question)}"
    return f"{told}: it scatters, and this is {_median(search.best, scatter)}{coarser}"


def _median(computed, scatter):
    return f"the median of {COUNTS[computed.runs]} {scatter.what}"


def _range(computed, question):
    return "from {:.5g} to {:.5g}".format(*computed.ranges[question])


def _outcome(search, reached):
    scattering = [question for question in search.best.values if search.scatters(question)]
    if reached:
        return "is reached"
    if search.unfinished():
        return "is not reached within the budget"
    if search.stuck:
        return "is not reached, because the scene cannot be made finer"
    return f"is not reached, because of what scatters ({', '.join(scattering)}), which refining need not change"
