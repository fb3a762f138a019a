"""The runs of a search and what they tell, as tables and sentences."""
from adit.accuracy.dimensions import name_of
from adit.trade.table import lines


def csv_rows(search):
    return [{"run": name_of(run.levels), "seconds": run.seconds, **run.values} for run in search.runs]


def markdown(search):
    questions = list(search.best.values)
    yield from lines(["run", "time [s]", *questions],
                     ([name_of(run.levels), f"{run.seconds:.3g}", *(f"{run.values[question]:.5g}" for question in questions)] for run in search.runs))
    yield ""
    yield from lines(["result", "value", "± [%]", *(f"of which {name} [%] (order)" for name in search.pairs)],
                     ([question, f"{search.best.values[question]:.5g}", _percent(search.interval(question), search.best.values[question]),
                       *(_part(search, question, name) for name in search.pairs)] for question in questions))


def _percent(size, value):
    return f"{100 * size / abs(value):.2g}" if value else "–"


def _part(search, question, name):
    error = search.errors[question].get(name)
    if error is None:
        return "not known"
    order = "none" if error.order is None else f"{error.order:.2g}"
    return f"{_percent(error.size, search.best.values[question])} ({order})"


def verdict(search, reached):
    """Lines for the terminal."""
    for question, value in search.best.values.items():
        unknown = [name for name, pairs in search.pairs.items() if not pairs]
        known = f"± {_percent(search.interval(question), value)} %" + (f", without the error of the {' and '.join(unknown)}" if unknown else "")
        yield f"{question} = {value:.5g} {known}"
    spent = sum(run.seconds for run in search.runs)
    outcome = "is reached" if reached else "is not reached within the budget" if search.next_seconds else "is not reached, because the scene cannot be made finer"
    yield f"accuracy asked for {outcome}: {len(search.runs)} runs, {spent:.3g} s"
    if not reached and search.next_seconds:
        yield f"next would be finer {search.next()}, about {search.next_seconds:.3g} s"
    elif reached and all(level <= 0 for run in search.runs for level in run.levels.values()):
        yield "the scene as stated is fine enough"
