"""The ground motions of a study, and the factors that give them an intensity.

All measures but the Arias intensity grow with the motion, and that with its square. A motion is scaled by the `peak` of the scene's
ground motion: the measure M1 at a peak of 1 m/s² gives the peak L/M1 for the level L, or sqrt(L/M1) for the Arias intensity.
"""
import json
import math
from dataclasses import dataclass, field

from adit.results.files import Unusable
from adit.study.study import variants

POWERS = {"arias": 2}  # of the motion with which a measure grows; of others 1
SEEDS_APART = 1000  # of synthetic motions in further rounds


@dataclass(frozen=True)
class Motion:
    """A motion as the scene takes it, with its measures [SI] as it is stated: at key `key` of the scene, {key: value} in `given`."""
    name: str
    key: str
    given: dict
    measures: dict = field(hash=False)
    at_unit_peak: dict = field(hash=False)

    def at(self, measure, level):
        """(the motion at this level as the text of a value, the factor by which it is scaled)."""
        peak = self._peak(measure, level)
        return json.dumps(self.given | {"peak": peak}), (level / self.measures[measure])**(1 / POWERS.get(measure, 1))

    def measures_at(self, measure, level):
        """All measures of the motion at this level."""
        peak = self._peak(measure, level)
        return {key: value * peak**POWERS.get(key, 1) for key, value in self.at_unit_peak.items()}

    def _peak(self, measure, level):
        return (level / self.at_unit_peak[measure])**(1 / POWERS.get(measure, 1))

    @property
    def as_stated(self):
        return json.dumps(self.given)


def read(study, number):
    """[Motion] of a round; in further rounds synthetic motions are others. Raises Unusable where one cannot be read."""
    given = [_of_round(each, number) for each in study.motions.get("of", [])]
    for each in given:
        if "file" in each:
            each["file"] = each["file"] | {"path": str((study.folder / each["file"]["path"]).resolve())}
    given += [{"file": {"path": str(path)}} for path in _records(study)]
    names = _names(given)
    key = ["--key", study.motions["key"]] if "key" in study.motions else []
    period = [study.levels[3] if study.levels else None, study.intensity[1]]
    periods = [word for value in dict.fromkeys(period) if value for word in ("--period", f"{value!r}")]
    at = study.motions.get("key") or _key(study)
    rows = [{at: json.dumps(each | peak)} for each in given for peak in ({}, {"peak": 1.0})]
    told = variants(study, rows, "--motion", *key, *periods)
    for number, one in enumerate(told):
        if "error" in one:
            raise Unusable(f"{study.path}: motion {names[number // 2]}: {one['error']}")
    measures = [_flat(one["motion"], dict.fromkeys(value for value in period if value)) for one in told]
    return [Motion(name, at, each, stated, unit) for name, each, stated, unit in zip(names, given, measures[::2], measures[1::2])]


def sa(period):
    """The name of a spectral acceleration among the measures."""
    return f"sa({period:g}s)" if period else "sa"


def _flat(told, periods):
    found = {key: value for key, value in told.items() if key in ("pga", "pgv", "pgd", "arias", "cav")}
    return found | dict(zip(map(sa, periods), told.get("sa", [])))


def _key(study):
    """The key at which the scene has its motion."""
    told = variants(study, [{}], "--motion")[0]
    if "error" in told:
        raise Unusable(f"{study.scene}: {told['error']}")
    return told["motion"]["key"]


def _records(study):
    if "folder" not in study.motions:
        return []
    folder, pattern = study.folder / study.motions["folder"], study.motions.get("files", "*")
    if not folder.is_dir():
        raise Unusable(f"{study.path}: motions.folder: {folder} is no folder; name that of your records.")
    found = sorted(path.resolve() for path in folder.glob(pattern) if path.is_file())
    if not found:
        raise Unusable(f"{study.path}: motions.folder: {folder} has no file {pattern}.")
    return found


def _of_round(given, number):
    if number == 0 or "synthetic" not in given:
        return dict(given)
    synthetic = given["synthetic"]
    return given | {"synthetic": synthetic | {"seed": synthetic.get("seed", 1) + SEEDS_APART * number}}


def _names(given):
    """Of records their file's, of others the kind with what tells them apart; with a number where two would be the same."""
    names = []
    for each in given:
        kind = next(kind for kind in ("file", "ricker", "sine", "gabor", "synthetic") if kind in each)
        if kind == "file":
            name = each["file"]["path"].rpartition("/")[2].rpartition(".")[0] or each["file"]["path"].rpartition("/")[2]
            if "column" in each["file"]:
                name += f"_{each['file']['column']}"
        elif kind == "synthetic":
            of = each["synthetic"]
            spectrum = of.get("spectrum", "gb_18306")
            name = "_".join([spectrum, *([of.get("ground", "c")] if spectrum.startswith("ec8") else []), str(of.get("seed", 1))])
        else:
            name = f"{kind}_{each[kind]['frequency']:g}Hz"
        names.append(name)
    return [name if names.count(name) == 1 else f"{name}_{names[:number + 1].count(name)}" for number, name in enumerate(names)]


def excessive(factor, largest):
    """Whether a motion is scaled farther than is allowed, up or down."""
    return not math.isinf(largest) and not 1 / largest <= factor <= largest
