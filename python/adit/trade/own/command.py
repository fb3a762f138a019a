"""`adit trade SCENE`: what coarser and finer models of a scene cost, and how far they are from the finest."""
import os

from adit.accuracy import dimensions, scene as scenes
from adit.accuracy.command import budget_of
from adit.accuracy.dimensions import name_of
from adit.accuracy.runs import Runs
from adit.plots import style
from adit.results.files import Unusable
from adit.runs import children
from adit.trade.own.picture import differences_over_cost
from adit.trade.own.rungs import Ladder
from adit.trade.table import lines, write_csv

SCATTER = 0.05  # of which a tenth is the least that counts


def trade(scene, options):
    """Computes, tells and writes SCENE.csv, .md and .png in the folder of `options.out`."""
    read = scenes.read(scene, ())
    questions = options.figure or read.get("questions", [])
    if not questions:
        raise Unusable(f"{os.path.relpath(scene)} has no `questions`; name figures of summary.json or columns of histories.csv there, "
                       "or by --figure.")
    children.end_with_this_process()
    refining, choices = dimensions.refining(read), [*dimensions.choices(read), *dimensions.rest(read)]
    runs = Runs(scene, read, questions, options.out / scene.stem, (), SCATTER)
    print(f"trade: {os.path.relpath(scene)}", flush=True)
    ladder = Ladder(lambda levels: runs.compute([*refining, *choices], levels), refining, choices, budget_of(read, options))
    if not ladder.climb():
        raise runs.failed()
    table = list(markdown(ladder, questions, runs.scatter))
    write_csv(options.out / f"{scene.stem}.csv", csv_rows(ladder))
    (options.out / f"{scene.stem}.md").write_text("\n".join(table) + "\n", encoding="utf-8")
    style.save(differences_over_cost(scene.stem, ladder, questions), options.out / f"{scene.stem}.png")
    print(*table, f"written: {options.out / scene.stem}.csv, .md, .png", sep="\n")


def csv_rows(ladder):
    return [{"dimension": rung.dimension, "model": name_of(rung.levels), "seconds": rung.computed.seconds, **rung.computed.values} for rung in ladder.rungs]


def markdown(ladder, questions, scatter):
    """A row a model; behind the finest of a dimension its orders."""
    yield from lines(["dimension", "model", "time [s]", *(f"{question} (from the finest, order)" for question in questions)],
                     ([rung.dimension, name_of(rung.levels), f"{rung.computed.seconds:.3g}", *(_cell(ladder, rung, question) for question in questions)]
                      for rung in ladder.rungs))
    yield ""
    yield f"The finest model is {name_of(ladder.finest.levels)}."
    if any(rung.computed.ranges for rung in ladder.rungs):
        yield f"Values with ± scatter: medians of five {scatter.what}, with half of their range."
    if ladder.left_out:
        yield f"Beyond the budget: {', '.join(ladder.left_out)}."


def _cell(ladder, rung, question):
    value, difference = rung.computed.values[question], ladder.difference(rung, question)
    scatter = f" ± {rung.computed.spread(question):.2g}" if rung.computed.ranges else ""
    told = [] if rung is ladder.finest or difference is None else [f"{100 * difference:+.2g} %"]
    if _ends_its_dimension(ladder, rung) and (order := ladder.order(rung.dimension, question)) is not None:
        told.append(f"order {order:.2g}")
    return f"{value:.4g}{scatter}" + (f" ({', '.join(told)})" if told else "")


def _ends_its_dimension(ladder, rung):
    """Whether a model is the finest of a dimension that zones or particles are."""
    own = [each.levels[rung.dimension] for each in ladder.rungs if each.dimension == rung.dimension and rung.dimension in each.levels]
    return bool(own) and rung.dimension in {each.name for each in ladder.refining} | {"step"} and rung.levels[rung.dimension] == max(own)
