"""Fields of a run: reads its VTU, VTP and PVD files (written by protocol/results/vtk.cpp), without VTK."""
import base64
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

from adit.results.files import Unusable, nearest
from adit.results.tables import Table

TYPES = {"Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}
HEADER_BYTES = 8  # size of the length that precedes the values


class Piece:
    """The fields of one kind at one instant, such as the grid or the bonds.

    points: their places [m] before any displacement, (n, 2)
    cells: numbers of the points of each zone, bond or beam, (m, points of a cell); of particles, their own number; of polygons
        as many as the one with most corners has: the others repeat their last corner
    point_fields, cell_fields: Tables of values, (n,) or (n, 3), and (m,) or (m, 3)
    piece["stress_Pa"]: the field of the points or of the cells
    """

    def __init__(self, path):
        element = ElementTree.parse(path).getroot()[0].find("Piece")
        self.points = _array(element.find("Points")[0])[:, :2]
        cells = next(e for e in (element.find(name) for name in ("Verts", "Lines", "Polys", "Cells")) if e is not None)
        arrays = {a.get("Name"): _array(a) for a in cells}
        self.cells = _cells(arrays["connectivity"], arrays["offsets"])
        self.point_fields, self.cell_fields = (
            Table({a.get("Name"): _array(a) for a in element.find(data)}, path) for data in ("PointData", "CellData"))

    @staticmethod
    def joined(pieces):
        """Joins the pieces of one kind of several models, with the fields that all of them have."""
        first = pieces[0]
        if len(pieces) == 1:
            return first
        whole = object.__new__(Piece)
        offsets = np.cumsum([0] + [len(piece.points) for piece in pieces])
        whole.points = np.concatenate([piece.points for piece in pieces])
        most = max(piece.cells.shape[1] for piece in pieces)
        whole.cells = np.concatenate([_with_corners(most, piece.cells) + offset for piece, offset in zip(pieces, offsets)])
        for fields in ("point_fields", "cell_fields"):
            shared = [name for name in getattr(first, fields) if all(name in getattr(p, fields) for p in pieces)]
            joined = {name: np.concatenate([getattr(p, fields)[name] for p in pieces]) for name in shared}
            setattr(whole, fields, Table(joined, getattr(first, fields).source))
        return whole

    def field(self, name, default=None):
        """A field of the points or of the cells; the default where it was not written."""
        return self.point_fields.get(name, self.cell_fields.get(name, default))

    def __getitem__(self, name):
        values = self.field(name)
        if values is None:
            known = [*self.point_fields, *self.cell_fields]
            raise Unusable(f"{self.point_fields.source} has no field `{name}`; {nearest(name, known)}")
        return values

    @property
    def is_cloud(self):
        """Whether its cells are single points: particles."""
        return self.cells.shape[1] == 1

    def is_there(self):
        """Whether each point of a cloud exists: removed particles keep their place but have no cell."""
        there = np.full(len(self.points), False)
        there[self.cells[:, 0]] = True
        return there

    def moved(self, scale, common=0):
        """The points after the displacement without a `common` one [m], times `scale`."""
        displacement = self.point_fields.get("displacement_m")
        return self.points if displacement is None else self.points + scale * (displacement[:, :2] - common)


class Fields(dict):
    """{kind: Piece} of one instant."""

    def __missing__(self, kind):
        raise Unusable(f"the fields have no `{kind}`; {nearest(kind, self)}")


def _cells(connectivity, offsets):
    """(cells, points of a cell); `offsets`: where each cell ends."""
    counts = np.diff(offsets, prepend=0)
    if not len(counts):
        return np.empty((0, 1), int)
    if counts.min() == counts.max():
        return connectivity.reshape(len(counts), -1)
    corner = np.minimum(np.arange(counts.max()), counts[:, None] - 1)
    return connectivity[(offsets - counts)[:, None] + corner]


def _with_corners(most, cells):
    """The cells with so many corners, of which the last is repeated."""
    return np.pad(cells, ((0, 0), (0, most - cells.shape[1])), mode="edge")


def _array(element):
    values = np.frombuffer(base64.b64decode(element.text), TYPES[element.get("type")], offset=HEADER_BYTES)
    components = int(element.get("NumberOfComponents"))
    return values if components == 1 else values.reshape(-1, components)


def read_collection(path):
    """[(time [s], {piece name: file})] of a PVD, in the order of time."""
    snapshots = {}
    for entry in ElementTree.parse(path).getroot().iter("DataSet"):
        pieces = snapshots.setdefault(float(entry.get("timestep")), {})
        pieces[entry.get("name")] = Path(path).parent / entry.get("file")
    return sorted(snapshots.items())
