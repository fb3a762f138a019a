"""`adit run SCENE` of a scene with `accuracy`, or with `--within 5% --figure KEY`: as accurate as is asked."""
import os
import re

from adit import programs
from adit.accuracy import dimensions
from adit.accuracy.choices import Choices, softens
from adit.accuracy.page import csv_rows, markdown, verdict
from adit.accuracy.runs import Runs
from adit.accuracy.search import Search, coarsest
from adit.accuracy.shares import share_of
from adit.results.files import Unusable
from adit.runs import children
from adit.trade.table import write_csv

NOT_REACHED = 6  # exit code
BUDGET = 1200.0  # [s]
LOWEST = -3  # level of the first model
UNITS = {"": 1, "s": 1, "min": 60, "h": 3600}


def seconds_of(text):
    """1200 of `20min`."""
    found = re.fullmatch(r"\s*(\d+\.?\d*)\s*(s|min|h|)\s*", text)
    if not found or not float(found[1]):
        raise Unusable(f"--budget {text} is no time; write for example --budget 20min.")
    return float(found[1]) * UNITS[found[2]]


def asked_of(read, options):
    """(questions, within, budget [s]) of the command line, or of the scene where it does not say; None where neither asks for an
    accuracy."""
    within = share_of(options.within) if options.within else read.get("accuracy", {}).get("within")
    if options.within and within is None:
        raise Unusable(f"--within {options.within} is no share between 0 and 1; write for example --within 5%.")
    questions = options.figure or read.get("questions", [])
    if within is None:
        return None
    if not questions:
        raise Unusable("--within asks for an accuracy, but of nothing; name figures of summary.json, as in --figure "
                       "lining_ring_largest_thrust_N, or `questions` in the scene.")
    return questions, within, budget_of(read, options)


def budget_of(read, options):
    """[s] of the command line, or of the scene where it does not say."""
    return seconds_of(options.budget) if options.budget else read.get("accuracy", {}).get("budget", BUDGET)


def run(scene, read, asked, options, others):
    """Computes, tells and writes; returns (exit code, the folder of the finest run)."""
    questions, within, budget = asked
    children.end_with_this_process()
    out = options.out or programs.RUNS / scene.parent.name / f"{scene.stem}_accuracy"
    out.mkdir(parents=True, exist_ok=True)
    print(f"run: {os.path.relpath(scene)} within {100 * within:g} %", flush=True)
    refining = dimensions.refining(read)
    if not refining:
        raise Unusable(f"{os.path.relpath(scene)} has no zones, particles, elements or columns whose number could be changed; compute it by other means.")
    runs = Runs(scene, read, questions, out, others, within)
    nearer = dimensions.rest(read)
    first = coarsest(lambda levels: runs.compute(refining, levels), [each.name for each in refining], LOWEST)
    if first is None:
        raise runs.failed()
    choices = Choices(runs, refining, dimensions.choices(read), first, within, localizes=softens(read))
    choices.begin(budget)
    search = Search(lambda levels: runs.compute([*refining, *nearer], levels), within, budget, rest="".join(each.name for each in nearer),
                    ahead=lambda *levels: runs.ahead([*refining, *nearer], *levels))
    reached = search.run(first)
    choices.compute(budget - sum(run.seconds for run in search.runs))
    write_csv(out / "accuracy.csv", csv_rows(search))
    (out / "accuracy.md").write_text("\n".join([*markdown(search), "", *choices.sentences()]) + "\n", encoding="utf-8")
    print(*verdict(search, reached, runs.scatter, choices), *choices.sentences(), "", f"accuracy           {out / 'accuracy.md'}, accuracy.csv",
          sep="\n")
    return (0 if reached else NOT_REACHED), out / dimensions.name_of(search.best.levels)
