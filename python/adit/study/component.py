"""Components of ground motions: curves that the scene takes at one of its keys each.

A curve is scaled by the `peak` of the scene's ground motion, which is that of the whole curve, although a run may take a part of it. Its
peak as it is stated is M / M1, with the peak acceleration M of the part that is taken, and that of the same part, M1, at a `peak` of
1 m/s².
"""
import json
from dataclasses import dataclass
from pathlib import Path

from adit.results.files import Unusable
from adit.study.study import variants


@dataclass(frozen=True, eq=False)
class Component:
    """A curve as the scene states it, {key: value} in `given`, at `key` of the scene; `peak` [m/s²]: of the whole curve, stated or not."""
    key: str
    given: dict
    peak: float

    @property
    def as_stated(self):
        """The text of the value at the key."""
        return json.dumps(self.given)

    def scaled(self, factor):
        return json.dumps(self.given | {"peak": factor * self.peak})


def read(study, key, names, given, where):
    """[(Component, {measure: value [SI]} of the part that a run takes)] of each curve. Raises Unusable, with the place `where` in the
    study, for one that cannot be read or does not move the ground."""
    of_levels, of_intensity = study.levels.period if study.levels else None, study.intensity[1]
    periods = [each for each in dict.fromkeys([of_levels, of_intensity]) if each]
    asked = ["--key", key, *(word for each in periods for word in ("--period", f"{each!r}"))]
    told = variants(study, [{key: json.dumps(each | peak)} for each in given for peak in ({}, {"peak": 1.0})], "--motion", *asked)
    found = []
    for name, each, stated, unit in zip(names, given, told[::2], told[1::2]):
        for one in (stated, unit):
            if "error" in one:
                raise Unusable(f"{where}: motion {name}: {one['error']}")
        if not stated["motion"]["pga"]:
            raise Unusable(f"{where}: motion {name}: does not move the ground before the end of the run; give a longer `time.duration`.")
        found.append((Component(key, each, stated["motion"]["pga"] / unit["motion"]["pga"]), _measures(stated["motion"], periods)))
    return found


def _measures(told, periods):
    found = {key: value for key, value in told.items() if key in ("pga", "pgv", "pgd", "arias", "cav")}
    return found | dict(zip(map(sa, periods), told.get("sa", [])))


def sa(period):
    """The name of a spectral acceleration among the measures."""
    return f"sa({period:g}s)" if period else "sa"


def beside(study, names, firsts):
    """[[Component]]: the further components of records, with the processing that the study states of the first ones, and with their scale:
    where a `peak` scales the first one, it scales all. Raises Unusable where a motion is no record, or lacks a component."""
    further = [[] for _ in firsts]
    if "components" not in study.motions:
        return further
    recorded = [{key: value for key, value in first.given.items() if key != "peak"} for first in firsts]
    scales = [first.peak / one.peak for first, (one, _) in zip(firsts, read(study, firsts[0].key, names, recorded, study.path))]
    keys = [firsts[0].key]
    for number, asked in enumerate(study.motions["components"]):
        where = f"{study.path}: motions.components[{number}]"
        if asked["key"] in keys:
            raise Unusable(f"{where}.key: at {asked['key']} stands another component already; name another key, such as "
                           "continuum.base.across.")
        keys.append(asked["key"])
        companions = [_companion(name, each, asked, where) for name, each in zip(names, recorded)]
        for first, scale, others, (one, _) in zip(firsts, scales, further, read(study, asked["key"], names, companions, where)):
            peak = scale * one.peak
            others.append(Component(one.key, one.given | ({"peak": peak} if "peak" in first.given else {}), peak))
    return further


def _companion(name, given, asked, where):
    """The record beside another one, as a scene states it."""
    if "file" not in given:
        raise Unusable(f"{where}: motion {name} is no record, and has no other component; leave it or `components` out.")
    path = Path(given["file"]["path"])
    before, found, after = path.name.rpartition(asked["instead_of"])
    if not found:
        raise Unusable(f"{where}.instead_of: {path.name} has no {asked['instead_of']} in its name; name what tells components apart, "
                       "and let motions.files match the first ones only.")
    companion = path.with_name(before + asked["name"] + after)
    if not companion.is_file():
        raise Unusable(f"{where}: {path.name} has no {companion.name} beside it; add that file, or leave the record out.")
    return given | {"file": given["file"] | {"path": str(companion)}}
