"""Which runs a study makes: climbs of runs, and what each run has."""
import math
import re
from dataclasses import dataclass, field, replace

from adit.results.files import Unusable
from adit.study import component, fields, motions as ground, quantities
from adit.study.study import variants


@dataclass
class Row:
    """A run: {key: text} of its scene, and what it was drawn for. After identify(), what it is known by: the hash of its scene, and
    of the state at rest that it begins from."""
    motion: str = ""
    scalable: ground.Motion = None  # the same, where it is scaled
    level: float = None
    factor: float = 1.0
    sample: str = "0"
    drawn: dict = field(default_factory=dict)
    seeds: dict = field(default_factory=dict)
    settings: dict = field(default_factory=dict)
    measures: dict = field(default_factory=dict)  # of the motion, as it is given to the scene [SI]
    hash: str = ""
    statics: str = ""

    def scaled(self, factor):
        """The row with its motion scaled by another factor, not identified yet."""
        return replace(self, factor=factor, settings=self.settings | self.scalable.settings_at(factor),
                       measures=self.scalable.measures_at(factor))


@dataclass
class Design:
    """The runs of a round as climbs: lists of rows of which each is computed after the one before, if that reached no end. Where factors
    are searched for (search.py), that of a row is where the search may begin. `left_out`: a sentence for each motion that would have to
    be scaled too far."""
    climbs: list
    left_out: list


def of_round(study, stated, motions, number, folder):
    """The Design of a round. `stated`: the scene as it is read; `folder`: where random fields are written. Raises Unusable where a run
    cannot be made so."""
    design = with_motions(study, motions) if motions else Design([[Row()] for _ in range(study.samples)], [])
    one_draw = study.climbs  # of a climb, which meets the same tunnel at all levels
    drawn = quantities.drawn(study, len(design.climbs) if one_draw else sum(map(len, design.climbs)), number)
    sample = 0
    for climb in design.climbs:
        for row in climb:
            row.sample = f"{number}_{sample}"
            row.drawn = drawn[sample]
            row.seeds = {key: quantities.seed_of(study.seed, row.sample, key) % 10**6 for key in study.seeds}
            row.settings |= settings(study, stated, row.drawn) | {key: str(value) for key, value in row.seeds.items()}
            row.settings |= fields.settings(study, row.sample, folder)
            sample += not one_draw
        sample += one_draw
    identify(study, [row for climb in design.climbs for row in climb])
    return design


def with_motions(study, motions):
    """The Design of rows that have their motion and its intensity, and no samples yet."""
    if study.levels is None:  # as they are: they take turns in the samples
        count = max(study.samples, len(motions))
        return Design([[_row(motions[number % len(motions)])] for number in range(count)], [])
    measure = component.sa(study.levels.period) if study.levels.measure == "sa" else study.levels.measure
    largest, left_out, climbs = study.largest_factor, [], []
    for motion in motions:
        rows = [_row(motion, measure, level) for level in study.levels.values for _ in range(study.samples)]
        kept = [row for row in rows if study.searches or not ground.excessive(row.factor, largest)]
        if len(kept) < len(rows):
            worst = max((row.factor for row in rows if row not in kept), key=lambda factor: abs(math.log(factor)))
            left_out.append(f"{motion.name}: {len(rows) - len(kept)} of {len(rows)} runs are left out; it would be scaled by up to {worst:.3g}")
        if study.climbs or study.searches:  # each sample climbs by itself
            climbs += [climb for sample in range(study.samples) if (climb := [row for row in rows[sample::study.samples] if row in kept])]
        else:
            climbs += [[row] for row in kept]
    require_some(study, climbs)
    return Design(climbs, left_out)


def require_some(study, found):
    """Raises Unusable where all runs are left out."""
    if not found:
        raise Unusable(f"{study.path}: no motion can be scaled to any of the levels by a factor of at most {study.largest_factor:g}; "
                       "raise motions.largest_factor, or choose other motions or levels.")


def _row(motion, measure=None, level=None):
    if level is None:
        return Row(motion.name, settings=motion.as_stated, measures=dict(motion.measures))
    scaled = Row(motion.name, motion, level).scaled(motion.factor_at(measure, level))
    return replace(scaled, measures=scaled.measures | {measure: level})  # to the last digit, in which motions would differ


def settings(study, stated, drawn):
    """{key: text} of the scene for what is drawn."""
    found = {}
    for given in study.random:
        value = drawn[given["name"]]
        for key, at in (place for pattern in given.get("keys", []) for place in places(stated, pattern)):
            if given.get("multiplies"):
                found[key] = _product(study, given["name"], key, at, float(value))
            else:
                found[key] = f"{value if isinstance(value, str) else repr(float(value))} {given.get('unit', '')}".strip()
    return found


def places(stated, pattern):
    """[(key, what the scene states there or None)] of a key, in which `[*]` stands for every element of a list."""
    found = [("", stated)]
    for name, element in re.findall(r"([^.\[\]]+)|\[(\d+|\*)\]", pattern):
        further = []
        for key, at in found:
            if name:
                further.append((f"{key}.{name}".lstrip("."), at.get(name) if isinstance(at, dict) else None))
            else:
                listed = at if isinstance(at, list) else []
                numbers = range(len(listed)) if element == "*" else [int(element)]
                further += [(f"{key}[{number}]", listed[number] if number < len(listed) else None) for number in numbers]
        found = further
    return found


def _product(study, name, key, stated, factor):
    """The text of a number, or of a list of numbers, times a factor."""
    def times(value):
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise Unusable(f"{study.path}: random: {name} multiplies {key}, but the scene states no number there; state one, or draw the value itself.")
        return repr(value * factor)
    return "[" + ", ".join(map(times, stated)) + "]" if isinstance(stated, list) else times(stated)


def identify(study, rows):
    """Gives the rows their hashes. Raises Unusable where a scene is refused, naming what was drawn."""
    for row, told in zip(rows, variants(study, [row.settings for row in rows])):
        if "error" in told:
            drawn = ", ".join(f"{key} = {value if isinstance(value, str) else format(value, '.4g')}" for key, value in row.drawn.items())
            raise Unusable(f"{study.path}: run {row.sample}{' with ' + drawn if drawn else ''} cannot be computed: {told['error']}; "
                           "cut the distribution off by `least` and `largest`, or mend the key.")
        row.hash, row.statics = told["hash"], told["statics"]
