"""Linings and members in the fields: chains of beams, whose nodes follow one another along their paths."""
import numpy as np

from adit.results.files import Unusable, nearest
from adit.results.tables import Table


def names(run, kind="lining"):
    """Names of the linings or members in the order of their numbers in the fields; none where several models have them."""
    found = [[each["name"] for each in model[f"{kind}s"]] for _, model in run.models if model.get(f"{kind}s")]
    return found[0] if len(found) == 1 else []


def chains(run, piece, kind="lining"):
    """[(name, numbers of its nodes along the path)] of the linings or members in a piece."""
    number, known = piece.field(kind, np.zeros(len(piece.cells))), names(run, kind)
    nodes = [(int(k), np.unique(piece.cells[number == k])) for k in np.unique(number)]
    return [(known[k] if k < len(known) else f"{kind} {k + 1}", of) for k, of in nodes]


def angles(points):
    """Angles [°] of places about their middle, from x, counter-clockwise."""
    x, y = (points - points.mean(axis=0)).T
    return np.degrees(np.arctan2(y, x)) % 360


def table(run, piece, name, kind="lining"):
    """The Table of one of them in a piece: place, angle and all fields of its nodes along its path."""
    found = dict(chains(run, piece, kind))
    if name not in found:
        raise Unusable(f"{run.folder} has no {kind} `{name}`; {nearest(name, found)}")
    nodes = found[name]
    place = dict(zip(("x_m", "y_m"), piece.points[nodes].T))
    fields = {field: values[nodes] for field, values in piece.point_fields.items()}
    return Table({**place, "angle_deg": angles(piece.points[nodes]), **fields}, f"{kind} {name}")
