"""Finished runs beside the reference.json of a case: figures of summary.json, each with its tolerance and the reason for it.

{"spread": variants that represent another machine,
 "tolerances": {name: {"relative": share of the figure by which it may differ, "reason": why}},
 "runs": [{"command": that computes it, "reduced": how it differs from the case, "computed": program and date,
           "scene_hash": of summary.json, "figures": {key of summary.json: [value, name of a tolerance]}}]}
"""
import json
from dataclasses import dataclass

from adit import Unusable
from adit.results.files import read
from adit.report.quantities import digits, quantity, unit_of


@dataclass
class Figure:
    key: str  # of summary.json
    found: float  # None where the run has none
    expected: float
    relative: float

    def is_within(self):
        return self.found is not None and abs(self.found - self.expected) <= self.relative * abs(self.expected)

    def difference(self):
        """In words, relative to the reference."""
        if self.found is None:
            return "missing"
        if self.found == self.expected:
            return "none"
        difference = self.found - self.expected
        return f"{100 * difference / abs(self.expected):+.2g} %" if self.expected else f"{difference:+.3g}"


class Reference:
    """The contents of a reference.json."""

    def __init__(self, path):
        self.path = path
        contents = read(path, lambda file: json.loads(file.read_text()))
        try:
            self.runs, self.tolerances = contents["runs"], contents["tolerances"]
        except (KeyError, TypeError) as missing:
            raise Unusable(f"{path} is no reference: it has no {missing}.") from None

    def of(self, run):
        """The expected figures of this run: the entry of its scene."""
        for expected in self.runs:
            if expected["scene_hash"] == run.summary.get("scene_hash"):
                return expected
        raise Unusable(f"{run.folder} computed another scene than those of {self.path}: compute it as a `command` there says.")

    def figures(self, run):
        """[Figure] of a run."""
        if not run.completed:
            raise Unusable(f"{run.folder} holds no complete run: compute it again, by {self.of(run)['command']}")
        return [Figure(key, run.number(key), value, self.tolerances[name]["relative"])
                for key, (value, name) in self.of(run)["figures"].items()]


def lines(run, reference, figures):
    """A table for the screen, and a sentence on the agreement."""
    cells = [("", run.name, "reference", "difference", "allowed", "")]
    for each in figures:
        unit, allowed = unit_of(each.key), f"±{digits(100 * each.relative)} %" if each.relative else "none"
        cells.append((each.key, quantity(each.found, unit), quantity(each.expected, unit), each.difference(), allowed,
                      "" if each.is_within() else "NOT WITHIN"))
    widths = [max(map(len, column)) for column in zip(*cells)]
    for first, *others in cells:
        yield "  ".join([first.ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(others, widths[1:]))]).rstrip()
    outside = sum(not each.is_within() for each in figures)
    yield f"{len(figures) - outside} of {len(figures)} figures are within their tolerances; {reference.path} tells the reasons"
