"""`adit trade SCENE`: what coarser and finer models of a scene cost, and how far they are from the finest."""
import os

from adit.accuracy import dimensions, scene as scenes
from adit.accuracy.command import budget_of
from adit.accuracy.runs import Runs
from adit.plots import style
from adit.results.files import Unusable
from adit.runs import children
from adit.trade.own.picture import differences_over_cost
from adit.trade.own.rows import markdown, rows_of
from adit.trade.own.rungs import Ladder
from adit.trade.table import write_csv

SCATTER = 0.05  # of which a tenth is the least that counts


def trade(name, scene, questions, options):
    """Computes, tells and writes NAME.csv, .md and .png in the folder of `options.out`. Without `questions`, those of the scene count."""
    read = scenes.read(scene, ())
    questions = questions or read.get("questions", [])
    if not questions:
        raise Unusable(f"{os.path.relpath(scene)} has no `questions`; name figures of summary.json or columns of histories.csv there, "
                       "or by --figure.")
    children.end_with_this_process()
    refining, choices = dimensions.refining(read), [*dimensions.choices(read), *dimensions.rest(read)]
    runs = Runs(scene, read, questions, options.out / name, (), SCATTER)
    print(f"trade: {os.path.relpath(scene)}", flush=True)
    ladder = Ladder(lambda levels: runs.compute([*refining, *choices], levels), refining, choices, budget_of(read, options))
    if not ladder.climb():
        raise runs.failed()
    rows = rows_of(ladder, questions)
    table = list(markdown(rows, questions, runs.scatter.what))
    write_csv(options.out / f"{name}.csv", rows)
    (options.out / f"{name}.md").write_text("\n".join(table) + "\n", encoding="utf-8")
    style.save(differences_over_cost(name, rows, questions), options.out / f"{name}.png")
    print(*table, f"written: {options.out / name}.csv, .md, .png", sep="\n")
