"""The runs of a search and what they tell, as tables and sentences."""
import math

from adit.accuracy.dimensions import name_of
from adit.trade.table import lines


def csv_rows(search):
    """A row a model; that of the finest has the middle and half of each interval, too."""
    told = {f"{key}_{what}": value(key) for key in search.best.values for what, value in (("told", search.value), ("interval", search.interval))}
    return [{"run": name_of(run.levels), "seconds": run.seconds, **run.values, **(told if run is search.best else dict.fromkeys(told, ""))}
            for run in search.runs]


def markdown(search):
    questions = list(search.best.values)
    yield from lines(["run", "time [s]", *questions],
                     ([name_of(run.levels), f"{run.seconds:.3g}", *(f"{run.values[question]:.5g}" for question in questions)] for run in search.runs))
    yield ""
    yield from lines(["result", "value", "± [%]", "of which lengths [%]", "order", "rest [%]", "scatter [%]"],
                     ([question, f"{value:.5g}", _percent(search.interval(question), value), *_parts(search, question, value)]
                      for question in questions for value in [search.value(question)]))


def _percent(size, value):
    if math.isinf(size):
        return "not known"
    return f"{100 * size / abs(value):.2g}" if value else "–"


def _parts(search, question, value):
    lengths, rest = search.refinement(question), search.unrest(question)
    order = "none" if lengths.order is None else f"{lengths.order:.2g}"
    return [_percent(lengths.size, value), order, _percent(rest.size, value) if rest else "–",
            _percent(search.best.spread(question), value)]


def verdict(search, reached, scatter, choices):
    """Lines for the terminal."""
    for question in search.best.values:
        told = _scatter if search.scatters(question) else _interval
        yield f"{question} = {told(search, question, scatter)}{choices.beside(question)}"
    spent, named = sum(run.seconds for run in search.runs), choices.named()
    apart = f", apart from what depends on a choice ({', '.join(named)})" if reached and named else ""
    yield f"accuracy asked for {_outcome(search, reached)}{apart}: {len(search.runs)} models, {spent:.3g} s"
    if reached or search.unfinished():
        yield f"a further halving would take about {search.next_seconds():.3g} s"
    if reached and all(level <= 0 for level in search.best.levels.values()):
        yield "the scene as stated is fine enough"


def _interval(search, question, scatter):
    if len(search.models) == 1:
        return f"{search.value(question):.5g}, whose error one model does not tell"
    told = f"{search.value(question):.5g} ± {_percent(search.interval(question), search.value(question))} %"
    if search.best.spread(question):
        told += f", the median of five {scatter.what} ({_range(search.best, question)})"
    return told


def _scatter(search, question, scatter):
    before = search.models[-2] if len(search.models) > 1 else None
    coarser = f"; before the last halving {before.values[question]:.5g}, {_range(before, question)}" if before and before.ranges else ""
    return f"{search.best.values[question]:.5g}, {_range(search.best, question)}: it scatters, and this is the median of five {scatter.what}{coarser}"


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
