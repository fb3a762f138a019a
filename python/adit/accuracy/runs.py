"""Computes a scene at levels of its dimensions and reads the answers to its questions."""
import os
import re
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from difflib import get_close_matches

import numpy as np

from adit import Run, programs
from adit.accuracy.dimensions import name_of, settings_of
from adit.accuracy.scatter import Scatter
from adit.results.files import Unusable
from adit.runs import children

OF_CRACKS = ("crack_path", "longest_crack_path")  # figures that only a run with cracks has
FIGURE, PLACE = re.compile(r".*_(m|m_per_s2?|N|Nm|Pa)"), re.compile(r"statics_.*|.*_[xy]_m")  # by their units
SIZE = re.compile(r".*_largest_.*|.*(?<!_per)_s")  # by their names
NO_NUMBERS = {str: "a text", list: "a list", dict: "a mapping", bool: "true or false"}


@dataclass
class Computed:
    """A model: its levels, {question: value}, what it cost [s], and {key: value} of all its figures. Where it scatters, the value is the
    median of the runs that could be computed, and `ranges` = {question: (least, largest)}. `runs`, `tried`: how many could be, and should.
    `sizes`: the questions whose answers cannot be negative."""
    levels: dict
    values: dict
    seconds: float
    ranges: dict = None
    figures: dict = field(default_factory=dict)
    runs: int = 1
    tried: int = 1
    sizes: frozenset = frozenset()

    def spread(self, question):
        """Half of the range."""
        low, high = self.ranges[question] if self.ranges else (0.0, 0.0)
        return (high - low) / 2


def answer(run, question):
    """A figure of the summary, or the largest size of a column of the histories; None where there is neither. Figures that are the
    largest of two directions count by their size too: between those that are about equal a trifle chooses, and the sign with it."""
    value = run.summary.get(question)
    if value is None and question in run.histories:
        value = np.abs(run.histories[question]).max()
    if value is None or type(value) in NO_NUMBERS:
        return None
    return abs(float(value)) if "_largest_" in question else float(value)


def is_size(run, question):
    """Whether an answer cannot be negative: a size, a time, or a number of something."""
    return SIZE.fullmatch(question) is not None or type(run.summary.get(question)) in (int, type(None))


def figures(run):
    """{key: value} of what is moved, borne or strained at any place: numbers of the summary, and the largest sizes of the histories."""
    keys = [key for key in dict.fromkeys([*run.summary, *run.histories]) if FIGURE.fullmatch(key) and not PLACE.fullmatch(key)]
    return {key: value for key in keys if (value := answer(run, key)) is not None}


class Runs:
    """Computes a scene, whose content is `read`, each run in a folder of its own below `out`. `others`: options of the program.
    `within`: a scatter below a tenth of it is none. Models that are begun ahead are computed beside the one that is asked for."""

    def __init__(self, scene, read, questions, out, others, within):
        self.scene, self.questions, self.out, self.others = scene, questions, out, others
        self.program = programs.program("simplified" if "simplified" in read else "coupler")
        self.scatter = Scatter(read, within / 10)
        self.failure = ""  # why the last model could not be computed
        self.computed = []
        self.beside = ThreadPoolExecutor(1)
        self.begun = {}  # {name of a run: Future of what _program() returns}

    def ahead(self, dimensions, *several_levels):
        """Begins models that will be asked for."""
        for levels in several_levels:
            if (settings := settings_of(dimensions, levels)) is not None:
                self._begin(name_of(levels), settings)

    def compute(self, dimensions, levels):
        """A Computed, or None where the scene cannot be made so or computed so. Raises Unusable where the first model does not know a
        question."""
        settings, name = settings_of(dimensions, levels), name_of(levels)
        if settings is None:
            self.failure = f"{name} is not possible"
            return None
        run, seconds = self._run(name, settings)
        if run and not self.computed:
            self._require_known(run)
        values = run and self._answers(run, name)
        if values is None:
            if self.computed:  # models before the first one are coarser than they can be
                self._tell_failure()
            return None
        sizes = frozenset(question for question in self.questions if is_size(run, question))
        found, cracked = Computed(levels, values, seconds, figures=figures(run), sizes=sizes), bool(run.summary.get("crack_count"))
        all_values = {question: [value] for question, value in values.items()}
        others = {f"{name}_{number}": settings | changed for number, changed in enumerate(self.scatter.others(cracked), 2)}
        for other in reversed(others):  # from the last one on, while the first are computed here
            self._begin(other, others[other])
        for other in others:
            run, seconds = self._run(other, others[other])
            found.seconds += seconds
            values = run and self._answers(run, other)
            if values is None:
                self._tell_failure()
                continue
            found.runs += 1
            for question, value in values.items():
                all_values[question].append(value)
        found.tried += len(others)
        if self.scatter.counts(all_values, cracked):
            found.values = {question: float(np.median(each)) for question, each in all_values.items()}
            found.ranges = {question: (min(each), max(each)) for question, each in all_values.items()}
        self.computed.append(found)
        print(f"  {name}: " + ", ".join(f"{key} = {value:.5g}" for key, value in found.values.items()) + f", {found.seconds:.3g} s"
              + self._runs(found), flush=True)
        return found

    def _runs(self, found):
        """How many the values come from, where it is not one alone that was asked for."""
        if found.runs < found.tried:
            return f" ({found.runs} of {found.tried} {self.scatter.what})"
        return f" ({found.runs} {self.scatter.what})" if found.ranges else ""

    def _answers(self, run, name):
        """{question: value}; None where one has no value in this model."""
        values = {question: answer(run, question) for question in self.questions}
        missing = next((question for question, value in values.items() if value is None), None)
        if missing:
            self.failure = f"{name} has no {missing}"
        return None if missing else values

    def _require_known(self, run):
        """Unusable where a question is about no number."""
        known = [*(key for key, value in run.summary.items() if type(value) in (int, float)), *run.histories]
        for question in self.questions:
            kind = NO_NUMBERS.get(type(run.summary.get(question)))
            if kind or not (question in run.summary or question in run.histories or question.startswith(OF_CRACKS)):
                what = f"is {kind} in {run.folder / 'summary.json'}, not a number" if kind else (
                    f"is no figure of {run.folder / 'summary.json'} and no column of its histories")
                near = get_close_matches(question, known, 3, 0.5)
                others = f"the nearest are {', '.join(near)}" if near else f"choose one of its {len(known)} figures"
                raise Unusable(f"{question} {what}; {others}.")

    def _begin(self, name, settings):
        if name not in self.begun:
            self.begun[name] = self.beside.submit(self._program, name, settings)

    def _run(self, name, settings):
        """(the Run, or None, its seconds), of a run that was begun or not."""
        begun = self.begun.pop(name, None)
        code, said, seconds = begun.result() if begun and not begun.cancel() else self._program(name, settings)
        if code:
            self.failure = f"{name} cannot be computed (exit code {code}): {(said.strip() or 'it said nothing').splitlines()[-1].removeprefix('error: ')}"
        return (Run(self.out / name) if code == 0 else None), seconds

    def _program(self, name, settings):
        """(exit code, what the program said, its seconds)."""
        begun = time.monotonic()
        sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        code, said = children.run([self.program, "run", self.scene, "--out", self.out / name, *sets, *self.others])
        return code, said, time.monotonic() - begun

    def _tell_failure(self):
        print(f"  {self.failure}", flush=True)

    def failed(self):
        return Unusable(f"{os.path.relpath(self.scene)}: {self.failure}")
