"""`adit run SCENE --within 5% --figure KEY`: as accurate as is asked."""
import os
import re
import time

import numpy as np

from adit import Run, programs
from adit.accuracy.dimensions import dimensions_of, name_of
from adit.accuracy.page import csv_rows, markdown, verdict
from adit.accuracy.search import Computed, Search
from adit.results.files import Unusable, nearest
from adit.runs import children
from adit.trade.table import write_csv

NOT_REACHED = 6  # exit code
UNITS = {"": 1, "s": 1, "min": 60, "h": 3600}


def share_of(text):
    """0.05 of `5%` or `0.05`."""
    found = re.fullmatch(r"\s*(\d*\.?\d+|\d+\.)\s*(%?)\s*", text)
    value = float(found[1]) / (100 if found[2] else 1) if found else 0
    if not 0 < value < 1:
        raise Unusable(f"--within {text} is no share between 0 and 1; write for example --within 5%.")
    return value


def seconds_of(text):
    """1200 of `20min`."""
    found = re.fullmatch(r"\s*(\d+\.?\d*)\s*(s|min|h|)\s*", text)
    if not found or not float(found[1]):
        raise Unusable(f"--budget {text} is no time; write for example --budget 20min.")
    return float(found[1]) * UNITS[found[2]]


def answer(run, question):
    """A figure of the summary, or the largest value by size of a column of the histories, with its sign; None where there is neither."""
    value = run.summary.get(question)
    if value is None and question in run.histories:
        column = run.histories[question]
        value = column[np.abs(column).argmax()]
    return float(value) if value is not None and not isinstance(value, (str, list, bool)) else None


class Runs:
    """Computes the scene at levels of its dimensions, each run in a folder of its own below `out`."""

    def __init__(self, scene, questions, out, others):
        self.scene, self.questions, self.out, self.others = scene, questions, out, others
        self.dimensions = {}

    def stated(self):
        """The scene as it is stated; finds its dimensions."""
        run = self._run("stated", {})
        if isinstance(run, str):
            raise Unusable(f"{os.path.relpath(self.scene)} failed: {run}")
        missing = [question for question in self.questions if answer(run, question) is None]
        if missing:
            known = [*(key for key, value in run.summary.items() if type(value) in (int, float)), *run.histories]
            raise Unusable(f"--figure {missing[0]} is no figure of {run.folder / 'summary.json'} and no column of its histories; {nearest(missing[0], known)}")
        self.dimensions = {each.name: each for each in dimensions_of(run.scene_as_written)}
        if not self.dimensions:
            raise Unusable(f"{os.path.relpath(self.scene)} has neither zones nor particles whose number could be changed; compute it by other means.")
        return run

    def compute(self, levels):
        """A Computed at these levels, or None where the scene cannot be made so."""
        settings = {}
        for name, level in levels.items():
            changed = self.dimensions[name].settings(level) if level else {}
            if changed is None:
                return None
            settings |= changed
        name = name_of(levels)
        begun = time.monotonic()
        run = self._run(name, settings)
        took = time.monotonic() - begun
        if isinstance(run, str):
            print(f"  {name}: {run}", flush=True)
            return None
        values = {question: answer(run, question) for question in self.questions}
        if None in values.values():
            print(f"  {name}: has no {next(key for key, value in values.items() if value is None)}", flush=True)
            return None
        print(f"  {name}: " + ", ".join(f"{key} = {value:.5g}" for key, value in values.items()) + f", {took:.3g} s", flush=True)
        return Computed(levels, values, took)

    def _run(self, name, settings):
        """The Run, or why there is none."""
        folder = self.out / name
        sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        code, said = children.run([programs.program("coupler"), "run", self.scene, "--out", folder, *sets, *self.others])
        return Run(folder) if code == 0 else f"exit code {code}: {(said.strip() or 'it said nothing').splitlines()[-1]}"


def run(scene, options, others):
    """Computes, tells and writes; returns (exit code, the folder of the finest run)."""
    if not options.figure:
        raise Unusable("--within asks for an accuracy, but of nothing; name figures of summary.json, as in --figure lining_ring_largest_thrust_N.")
    within, budget = share_of(options.within), seconds_of(options.budget)
    children.end_with_this_process()
    out = options.out or programs.RUNS / scene.parent.name / f"{scene.stem}_accuracy"
    out.mkdir(parents=True, exist_ok=True)
    print(f"run: {os.path.relpath(scene)} within {100 * within:g} %", flush=True)
    runs = Runs(scene, options.figure, out, others)
    begun = time.monotonic()
    stated = runs.stated()
    search = Search(runs.compute, list(runs.dimensions), within, budget)
    first = Computed(dict.fromkeys(runs.dimensions, 0), {question: answer(stated, question) for question in options.figure}, time.monotonic() - begun)
    reached = search.run(first)
    write_csv(out / "accuracy.csv", csv_rows(search))
    (out / "accuracy.md").write_text("\n".join(markdown(search)) + "\n", encoding="utf-8")
    print(*verdict(search, reached), f"\naccuracy           {out / 'accuracy.md'}, accuracy.csv", sep="\n")
    return (0 if reached else NOT_REACHED), out / name_of(search.best.levels)
