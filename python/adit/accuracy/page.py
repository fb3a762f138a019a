"""The runs of a search and what they tell, as tables and sentences."""
from adit.accuracy.dimensions import name_of
from adit.trade.table import lines


def csv_rows(search):
    """A row a model; that of the finest has the middle and half of each interval, too."""
    told = {f"{key}_{what}": value for key in search.best.values for what, value in (("told", search.value(key)), ("interval", search.interval(key)))}
    return [{"run": name_of(run.levels), "seconds": run.seconds, **run.values, **(told if run is search.best else dict.fromkeys(told, ""))}
            for run in search.runs]


def markdown(search):
    questions = list(search.best.values)
    yield from lines(["run", "time [s]", *questions],
                     ([name_of(run.levels), f"{run.seconds:.3g}", *(f"{run.values[question]:.5g}" for question in questions)] for run in search.runs))
    yield ""
    parts = [*search.pairs, *([search.rest] if search.unrest else [])]
    yield from lines(["result", "value", "± [%]", *(f"of which {name} [%] (order)" for name in parts)],
                     ([question, f"{search.value(question):.5g}", _percent(search.interval(question), search.value(question)),
                       *(_part(search, question, name) for name in parts)] for question in questions))


def _percent(size, value):
    return f"{100 * size / abs(value):.2g}" if value else "–"


def _part(search, question, name):
    error = search.errors[question].get(name)
    if error is None:
        return "not known"
    order = "none" if error.order is None else f"{error.order:.2g}"
    return f"{_percent(error.size, search.value(question))} ({order})"


def verdict(search, reached, scatter):
    """Lines for the terminal."""
    for question in search.best.values:
        yield f"{question} = " + (_scatter(search, question, scatter) if search.scatters(question) else _interval(search, question, scatter))
    spent = sum(run.seconds for run in search.runs)
    yield f"accuracy asked for {_outcome(search, reached)}: {len(search.runs)} models, {spent:.3g} s"
    if search.next() is not None:
        yield f"next would be finer {search.next()}, about {search.next_seconds:.3g} s"
    elif reached:
        yield "a further halving would take about " + ", ".join(f"{search.seconds_of(name):.3g} s for the {name}" for name in search.dimensions)
    if reached and all(level <= 0 for level in search.best.levels.values()):
        yield "the scene as stated is fine enough"


def _interval(search, question, scatter):
    unknown = [name for name, pairs in search.pairs.items() if not pairs]
    told = f"{search.value(question):.5g} ± {_percent(search.interval(question), search.value(question))} %"
    if search.best.spread(question):
        told += f", the median of five {scatter.what} ({_range(search.best, question)})"
    return told + (f", without the error of the {' and '.join(unknown)}" if unknown else "")


def _scatter(search, question, scatter):
    before = next((coarser for pairs in search.pairs.values() for coarser, finer in pairs if finer is search.best), None)
    coarser = f"; before the last halving {before.values[question]:.5g}, {_range(before, question)}" if before and before.ranges else ""
    return f"{search.best.values[question]:.5g}, {_range(search.best, question)}: it scatters, and this is the median of five {scatter.what}{coarser}"


def _range(computed, question):
    return "from {:.5g} to {:.5g}".format(*computed.ranges[question])


def _outcome(search, reached):
    scattering = [question for question in search.best.values if search.scatters(question)]
    if reached:
        return "is reached"
    if search.next() is not None:
        return "is not reached within the budget"
    if search.stuck:
        return "is not reached, because the scene cannot be made finer"
    return f"is not reached, because of what scatters ({', '.join(scattering)}), which refining need not change"
