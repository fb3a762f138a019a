"""The file of a study, as the reader of scenes reads it (study.proto), and what its parts must agree in."""
import json
import math
import subprocess
import sys
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import yaml

from adit import programs
from adit.results.files import Unusable, nearest
from adit.results.run import SceneLoader
from adit.study.fragility import sets

MEASURES = ("pga", "pgv", "arias", "sa")
DISTRIBUTIONS = ("normal", "lognormal", "uniform", "triangular", "discrete")


@dataclass(frozen=True)
class Damage:
    """The states of one answer, the lightest first; `set`: the name of theirs in the literature, or empty."""
    of: str
    states: tuple
    set: str = ""

    def reached(self, answer):
        """The number of states that an answer exceeds."""
        return sum(abs(answer) > state.above for state in self.states)


class Detail(NamedTuple):
    """How many runs are computed in detail, those with the largest of one answer."""
    of: str
    runs: int = 1


class Levels(NamedTuple):
    """Levels of a measure [SI], with the period of `sa`, that motions are scaled to: as `stripes` or `increments`; reached in the history
    `at` of the scene, or, where that is empty, by the motion as it is given to the scene."""
    how: str
    measure: str
    values: list
    period: float
    at: str

    @property
    def intensity(self):
        """(measure, period, place) as that of a Study."""
        return self.measure, self.period, self.at


class Study:
    """A study: `read`, as mappings and lists in SI units."""

    def __init__(self, path, read):
        self.path, self.folder, self.read = Path(path), Path(path).resolve().parent, read
        self.name = self.path.stem
        self.scene = self.folder / read["scene"]
        self.set = dict(_setting(text) for text in read.get("set", []))
        self.motions = read.get("motions")
        self.largest_factor = (self.motions or {}).get("largest_factor", math.inf)
        self.random = read.get("random", [])
        self.fields = read.get("fields", [])
        self.seeds = read.get("seeds", [])
        self.questions = read.get("questions", [])
        self.functions = {each["name"]: self._file(each["file"]) for each in read.get("functions", [])}
        self.keep = read.get("keep", [])
        sampling = read.get("sampling", {})
        self.method, self.samples, self.seed = (sampling.get("method", "latin_hypercube"), sampling.get("samples", 1), sampling.get("seed", 1))
        self.damage = [_damage(each, self.answers) for each in read.get("damage", [])]
        self.detail = Detail(**read["detail"]) if "detail" in read else None
        self._check()

    @property
    def answers(self):
        """Names of all that is asked of a run."""
        return [*self.questions, *self.functions]

    @cached_property
    def levels(self):
        """The Levels of motions that are scaled; None where they are not."""
        for how in ("stripes", "increments"):
            if self.motions and how in self.motions:
                given = self.motions[how]
                measures = [name for name in MEASURES if name in given]
                if len(measures) != 1:
                    raise Unusable(f"{self.path}: motions.{how}: states {' and '.join(measures) or 'no level'}; "
                                   "give levels of one of pga, pgv, arias, sa.")
                period = self._period(f"motions.{how}", measures[0], given)
                return Levels(how, measures[0], given[measures[0]], period, given.get("at", ""))
        return None

    @property
    def climbs(self):
        """Whether motions climb until all damage states are exceeded."""
        return self.levels is not None and self.levels.how == "increments"

    @property
    def searches(self):
        """Whether the factors of motions are searched for, run by run."""
        return self.levels is not None and self.levels.at != ""

    @cached_property
    def intensity(self):
        """(measure, period, place) that fragility is told over; the place is a history of the scene, or empty for the motion as it
        is given to the scene."""
        given = (self.motions or {}).get("intensity", {})
        if not given and self.levels:
            return self.levels.intensity
        measure = given.get("measure", "pga")
        return measure, self._period("motions.intensity", measure, given), given.get("at", "")

    def _period(self, where, measure, given):
        if measure == "sa" and "period" not in given:
            raise Unusable(f"{self.path}: {where}.period: is absent, but sa is the acceleration of an oscillator; give its period, such as 0.5 s.")
        return given.get("period") if measure == "sa" else None

    def _file(self, name):
        path = self.folder / name
        if not path.is_file():
            raise Unusable(f"{self.path}: functions: {path} is no file; name the Python file of the function.")
        return path

    def _check(self):
        names = [each["name"] for each in (*self.random, *self.fields)] + self.answers
        twice = next((name for name in names if names.count(name) > 1), None)
        if twice:
            raise Unusable(f"{self.path}: {twice} is the name of two quantities or answers; give each its own.")
        if not self.answers:
            raise Unusable(f"{self.path}: asks nothing of its runs; name figures of summary.json in `questions`.")
        if self.detail and self.detail.of not in self.answers:
            raise Unusable(f"{self.path}: detail.of: {self.detail.of} is not asked of a run; {nearest(self.detail.of, self.answers)}")
        if not (self.motions or self.random or self.fields or self.seeds):
            raise Unusable(f"{self.path}: nothing varies from run to run; give motions, random quantities, fields or seeds.")
        if self.motions and not (self.motions.get("of") or "folder" in self.motions):
            raise Unusable(f"{self.path}: motions: are none; list them in `of`, or name a folder of records.")
        for number, each in enumerate(self.read.get("correlations", [])):
            for name in each["between"]:
                known = [one["name"] for one in self.random]
                if name not in known:
                    raise Unusable(f"{self.path}: correlations[{number}].between: {name} is no random quantity; {nearest(name, known)}")
        for each in self.random:
            if not any(kind in each for kind in DISTRIBUTIONS):
                raise Unusable(f"{self.path}: random: {each['name']} has no distribution; give normal, lognormal, uniform, triangular or discrete.")
        if self.climbs and not self.damage:
            raise Unusable(f"{self.path}: motions.increments: motions climb until a damage state is exceeded, but `damage` states none.")
        self.intensity  # refuses what is wrong in it


def _setting(text):
    key, found, value = text.partition("=")
    if not found:
        raise Unusable(f"set: `{text}` is not KEY=VALUE; write for example time.duration=20 s.")
    return key.strip(), value.strip()


def _damage(given, answers):
    if given["of"] not in answers:
        raise Unusable(f"damage.of: {given['of']} is not asked of a run; {nearest(given['of'], answers)}")
    if ("set" in given) == ("states" in given):
        raise Unusable(f"damage of {given['of']}: give either a named `set` or `states`.")
    if "set" in given and given["set"] not in sets.DAMAGE_SETS:
        raise Unusable(f"damage.set: {given['set']} is no known set; {nearest(given['set'], sets.DAMAGE_SETS)}")
    states = tuple(sets.DamageState(each["name"], each["above"]) for each in given.get("states", [])) or sets.DAMAGE_SETS[given["set"]].states
    if any(b.above <= a.above for a, b in zip(states, states[1:])):
        raise Unusable(f"damage of {given['of']}: the thresholds do not rise; state the lightest damage first.")
    return Damage(given["of"], states, given.get("set", ""))


def load(path, settings=(), records=None):
    """The Study in a file, with further texts of its `set`, and a folder of records in place of its own. Ends with the exit code of the
    reader where it is refused; raises Unusable where its parts do not agree."""
    done = subprocess.run([programs.program("coupler"), "study", path], stdout=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(done.returncode)  # the reader has told why
    read = yaml.load(done.stdout, SceneLoader)
    read.setdefault("set", []).extend(settings)
    if records:
        read.setdefault("motions", {})["folder"] = str(records.resolve())
    return Study(path, read)


def variants(study, rows, *options):
    """[what `coupler variants` tells] of {key: text} of each row, over what the study sets in all of them."""
    lines = "".join(json.dumps(study.set | row) + "\n" for row in rows)
    done = subprocess.run([programs.program("coupler"), "variants", study.scene, *options], input=lines, stdout=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(done.returncode)
    return [json.loads(line) for line in done.stdout.splitlines()]
