"""The rows of a scene's models, and their table."""
from adit.accuracy.dimensions import name_of
from adit.trade.table import lines


def rows_of(ladder, questions):
    """A row a model: its dimension, level and name, whether it is the finest, its CPU time and time [s]; of each question the answer,
    the difference from the finest, the order of its dimension where this is the finest model of it, and the scatter. Models beyond the
    budget have names only."""
    found = []
    for rung in ladder.rungs:
        row = {"dimension": rung.dimension, "level": rung.levels.get(rung.dimension, 0), "model": name_of(rung.levels),
               "finest": "yes" if rung is ladder.finest else None, "cpu_s": rung.cpu_s, "seconds": rung.computed.seconds}
        for question in questions:
            row |= {question: rung.computed.values[question], f"{question} difference": ladder.difference(rung, question),
                    f"{question} order": ladder.order(rung.dimension, question) if _ends_its_dimension(ladder, rung) else None,
                    f"{question} scatter": rung.computed.spread(question) if rung.computed.ranges else None}
        found.append(row)
    return found + [dict.fromkeys(found[0]) | {"model": name} for name in ladder.left_out]


def _ends_its_dimension(ladder, rung):
    """Whether a model is the finest of a dimension that has an order."""
    own = [each.levels[rung.dimension] for each in ladder.rungs if each.dimension == rung.dimension and rung.dimension in each.levels]
    return bool(own) and rung.dimension in {each.name for each in ladder.refining} | {"step"} and rung.levels[rung.dimension] == max(own)


def computed(rows):
    return [row for row in rows if row["seconds"] is not None]


def finest(rows):
    return next(row for row in rows if row["finest"])


def markdown(rows, questions, scatter):
    """`scatter`: of what the medians of models that scatter are, in words."""
    yield from lines(["dimension", "model", "CPU [s]", "time [s]", *(f"{question} (from the finest, order)" for question in questions)],
                     (_cells(row, questions) for row in computed(rows)))
    yield ""
    yield f"The finest model is {finest(rows)['model']}."
    if any(row[f"{question} scatter"] is not None for row in rows for question in questions):
        yield f"Values with ± scatter: medians of five {scatter}, with half of their range."
    if beyond := [row["model"] for row in rows if row["seconds"] is None]:
        yield f"Beyond the budget: {', '.join(beyond)}."


def _cells(row, questions):
    return [row["dimension"], row["model"], f"{row['cpu_s']:.3g}", f"{row['seconds']:.3g}", *(_cell(row, question) for question in questions)]


def _cell(row, question):
    difference, order, scatter = (row[f"{question} {what}"] for what in ("difference", "order", "scatter"))
    told = [] if row["finest"] or difference is None else [f"{100 * difference:+.2g} %"]
    told += [] if order is None else [f"order {order:.2g}"]
    return f"{row[question]:.4g}" + ("" if scatter is None else f" ± {scatter:.2g}") + (f" ({', '.join(told)})" if told else "")
