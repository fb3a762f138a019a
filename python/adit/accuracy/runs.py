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
from adit.accuracy.scatter import PACKINGS, Scatter
from adit.results.files import Unusable
from adit.runs import children

OF_CRACKS = ("crack_path", "longest_crack_path")  # figures that only a run with cracks has
FIGURE, PLACE = re.compile(r".*_(m|m_per_s2?|N|Nm|Pa)"), re.compile(r"statics_.*|.*_[xy]_m")  # by their units


@dataclass
class Computed:
    """A model: its levels, {question: value}, what it cost [s], and {key: value} of all its figures. Where it scatters, the value is the
    median of several runs, and `ranges` = {question: (least, largest)}."""
    levels: dict
    values: dict
    seconds: float
    ranges: dict = None
    figures: dict = field(default_factory=dict)

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
    if value is None or isinstance(value, (str, list, bool)):
        return None
    return abs(float(value)) if "_largest_" in question else float(value)


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
        values = run and self._answers(run, name)
        if values is None:
            return None
        found, cracked = Computed(levels, values, seconds, figures=figures(run)), bool(run.summary.get("crack_count"))
        all_values = {question: [value] for question, value in values.items()}
        others = {f"{name}_{number}": settings | changed for number, changed in enumerate(self.scatter.others(cracked), 2)}
        for other in reversed(others):  # from the last one on, while the first are computed here
            self._begin(other, others[other])
        for other in others:
            run, seconds = self._run(other, others[other])
            found.seconds += seconds
            for question, value in (run and self._answers(run, other) or {}).items():
                all_values[question].append(value)
        if self.scatter.counts(all_values, cracked):
            found.values = {question: float(np.median(each)) for question, each in all_values.items()}
            found.ranges = {question: (min(each), max(each)) for question, each in all_values.items()}
        self.computed.append(found)
        print(f"  {name}: " + ", ".join(f"{key} = {value:.5g}" for key, value in found.values.items()) + f", {found.seconds:.3g} s"
              + (f" ({PACKINGS} {self.scatter.what})" if found.ranges else ""), flush=True)
        return found

    def _answers(self, run, name):
        """{question: value}; None where one has no value in this model."""
        values = {question: answer(run, question) for question in self.questions}
        for question, value in values.items():
            there = question in run.summary or question in run.histories or question.startswith(OF_CRACKS)
            if value is None and not there and not self.computed:
                known = [*(key for key, known in run.summary.items() if type(known) in (int, float)), *run.histories]
                near = get_close_matches(question, known, 3, 0.5)
                raise Unusable(f"{question} is no figure of {run.folder / 'summary.json'} and no column of its histories; "
                               + (f"the nearest are {', '.join(near)}." if near else f"choose one of its {len(known)} figures."))
            if value is None:
                self.failure = f"{name} has no {question}"
                self._tell_failure()
                return None
        return values

    def _begin(self, name, settings):
        if name not in self.begun:
            self.begun[name] = self.beside.submit(self._program, name, settings)

    def _run(self, name, settings):
        """(the Run, or None, its seconds), of a run that was begun or not."""
        begun = self.begun.pop(name, None)
        code, said, seconds = begun.result() if begun and not begun.cancel() else self._program(name, settings)
        if code:
            self.failure = f"{name} cannot be computed (exit code {code}): {(said.strip() or 'it said nothing').splitlines()[-1].removeprefix('error: ')}"
            self._tell_failure()
        return (Run(self.out / name) if code == 0 else None), seconds

    def _program(self, name, settings):
        """(exit code, what the program said, its seconds)."""
        begun = time.monotonic()
        sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        code, said = children.run([self.program, "run", self.scene, "--out", self.out / name, *sets, *self.others])
        return code, said, time.monotonic() - begun

    def _tell_failure(self):
        """But for models before the first one, which are coarser than they can be."""
        if self.computed:
            print(f"  {self.failure}", flush=True)

    def failed(self):
        return Unusable(f"{os.path.relpath(self.scene)}: {self.failure}")
