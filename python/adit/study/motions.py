"""The ground motions of a study, and the factors that give them an intensity.

All measures but the Arias intensity grow with the motion, and that with its square.
"""
import math
from dataclasses import dataclass, field

from adit.results.files import Unusable
from adit.study import component
from adit.study.study import variants

POWERS = {"arias": 2}  # of the motion with which a measure grows; of others 1
SEEDS_APART = 1000  # of synthetic motions in further rounds


@dataclass(frozen=True)
class Motion:
    """A motion: its Components, and the measures [SI] of the first one as it is stated. A factor scales all of them."""
    name: str
    components: tuple
    measures: dict = field(hash=False)

    def factor_at(self, measure, level):
        """The factor by which the motion has a level."""
        return (level / self.measures[measure])**(1 / power_of(measure))

    def measures_at(self, factor):
        """All measures of the motion that is scaled by a factor."""
        return {measure: value * factor**power_of(measure) for measure, value in self.measures.items()}

    def settings_at(self, factor):
        """{key: text} of the scene."""
        return {each.key: each.scaled(factor) for each in self.components}

    @property
    def as_stated(self):
        """{key: text} of the scene without a factor."""
        return {each.key: each.as_stated for each in self.components}


def power_of(measure):
    return POWERS.get(measure, 1)


def read(study, number):
    """[Motion] of a round; in further rounds synthetic motions are others. Raises Unusable where one cannot be read."""
    given = [_of_round(each, number) for each in study.motions.get("of", [])]
    for each in given:
        if "file" in each:
            each["file"] = each["file"] | {"path": str((study.folder / each["file"]["path"]).resolve())}
    given += [{"file": {"path": str(path)}} for path in _records(study)]
    names = _names(given)
    firsts = component.read(study, study.motions.get("key") or _key(study), names, given, study.path)
    further = component.beside(study, names, [first for first, _ in firsts])
    return [Motion(name, (first, *others), measures) for name, (first, measures), others in zip(names, firsts, further)]


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
