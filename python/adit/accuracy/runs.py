"""Computes a scene at levels of its dimensions and reads the answers to its questions."""
import os
import time
from dataclasses import dataclass
from difflib import get_close_matches

import numpy as np

from adit import Run, programs
from adit.accuracy.dimensions import name_of, settings_of
from adit.accuracy.scatter import PACKINGS, Scatter
from adit.results.files import Unusable
from adit.runs import children

OF_CRACKS = ("crack_path", "longest_crack_path")  # figures that only a run with cracks has


@dataclass
class Computed:
    """A model: its levels, {question: value}, and what it cost [s]. Where it scatters, the value is the median of several runs, and
    `ranges` = {question: (least, largest)}."""
    levels: dict
    values: dict
    seconds: float
    ranges: dict = None

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


class Runs:
    """Computes a scene, whose content is `read`, each run in a folder of its own below `out`. `others`: options of the program.
    `within`: a scatter below a tenth of it is none."""

    def __init__(self, scene, read, questions, out, others, within):
        self.scene, self.questions, self.out, self.others = scene, questions, out, others
        self.scatter = Scatter(read, within / 10)
        self.failure = ""  # why the last model could not be computed
        self.computed = []

    def compute(self, dimensions, levels):
        """A Computed, or None where the scene cannot be made so or computed so. Raises Unusable where the first model does not know a
        question."""
        settings, name = settings_of(dimensions, levels), name_of(levels)
        if settings is None:
            self.failure = f"{name} is not possible"
            return None
        begun = time.monotonic()
        run = self._run(name, settings)
        if run is None:
            return None
        values = self._answers(run, name)
        if values is None:
            return None
        others = self.scatter.others(bool(run.summary.get("crack_count")))
        further = [self._answers(more, name) for number, changed in enumerate(others, 2) if (more := self._run(f"{name}_{number}", settings | changed))]
        all_values = {question: [each[question] for each in (values, *(one for one in further if one))] for question in self.questions}
        found = Computed(levels, values, time.monotonic() - begun)
        if self.scatter.counts(all_values, bool(run.summary.get("crack_count"))):
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

    def _run(self, name, settings):
        """The Run, or None."""
        folder = self.out / name
        sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        code, said = children.run([programs.program("coupler"), "run", self.scene, "--out", folder, *sets, *self.others])
        if code:
            self.failure = f"{name} cannot be computed (exit code {code}): {(said.strip() or 'it said nothing').splitlines()[-1].removeprefix('error: ')}"
            self._tell_failure()
        return Run(folder) if code == 0 else None

    def _tell_failure(self):
        """But for models before the first one, which are coarser than they can be."""
        if self.computed:
            print(f"  {self.failure}", flush=True)

    def failed(self):
        return Unusable(f"{os.path.relpath(self.scene)}: {self.failure}")
