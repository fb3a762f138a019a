"""What the page says of how runs differ: motions with their factors, random quantities and fields."""
from adit.report.markup import bullets, table
from adit.report.quantities import digits, quantity, unit_of
from adit.study.pictures import axes as axis
from adit.study.study import DISTRIBUTIONS
from adit.study.table import column_of

MEASURES = {"pga": "PGA", "pgv": "PGV", "pgd": "PGD", "arias": "Arias intensity", "cav": "CAV"}


def motions(outcome):
    """A row for each motion: its factors at the levels, or its measures where it is used as it is."""
    if not outcome.study.motions:
        return None
    of = {}
    for row in outcome.listed:
        of.setdefault(row["motion"], []).append(row)
    return factors(outcome, of) if outcome.study.levels else measures(outcome, of)


def factors(outcome, of):
    levels = sorted({row["level"] for row in outcome.listed})
    what = axis.in_words(*outcome.study.levels.intensity)
    rows = [(name, *(factor(each, level) for level in levels)) for name, each in of.items()]
    return table(f"Factors by which the motions are scaled to levels of the {what}",
                 ("motion", *(axis.of_level(outcome.study, level) for level in levels)), rows)


def factor(rows, level):
    """A dash where the motion has no run at the level."""
    return next((digits(row["factor"]) for row in rows if row["level"] == level), "–")


def measures(outcome, of):
    known = {column_of(measure): said for measure, said in MEASURES.items() if column_of(measure) in outcome.listed[0]}
    rows = [(name, len(each), *(quantity(each[0][column], unit_of(column)) for column in known)) for name, each in of.items()]
    return table("Motions as they are given to the scene", ("motion", "runs", *known.values()), rows)


def random(study):
    """Tables of random quantities and fields, what correlates them, and the keys that get a seed; None where nothing is random."""
    if not (study.random or study.fields or study.seeds):
        return None
    quantities = [(each["name"], distribution(each), ", ".join(each.get("keys", [])) or "functions of a run only") for each in study.random]
    fields = [(each["name"], f"{' and '.join(each['of'])} of {', '.join(each['parts'])}", f"{each['dispersion']:g}",
               *(quantity(float(each[f"length_{along}"]), "m") for along in "xy")) for each in study.fields]
    sentences = [f"{' and '.join(each['between'])} have the correlation {each['coefficient']:g}, of what they would be if both were normal."
                 for each in study.read.get("correlations", [])]
    if study.seeds:
        sentences.append(f"Every sample has its own seed at {' and '.join(study.seeds)}.")
    if study.random:
        sentences.append(f"The quantities are drawn as {study.method.replace('_', ' ')} with the seed {study.seed}.")
    return [table("Random quantities", ("quantity", "distribution", "keys of the scene"), quantities),
            table("Random fields, lognormal", ("field", "of", "dispersion", "correlation length along x", "along y"), fields),
            bullets(sentences)]


def distribution(given):
    """A distribution as it is stated, such as `lognormal: median 1, dispersion 0.2`."""
    kind = next(kind for kind in DISTRIBUTIONS if kind in given)
    numbers = ", ".join(f"{name} {said(value)}" for name, value in given[kind].items())
    ends = "".join(f"; {name} {given[name]:g}" for name in ("least", "largest") if name in given)
    return f"{kind}: {numbers}{ends}" + (f", in {given['unit']}" if "unit" in given else "") + (
        "; multiplies what the scene states" if given.get("multiplies") else "")


def said(value):
    return " ".join(map(str, value)) if isinstance(value, list) else f"{value:g}"
