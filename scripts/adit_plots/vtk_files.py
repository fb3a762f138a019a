"""Reads the VTU, VTP and PVD files of a run (written by protocol/results/vtk.cpp), without VTK."""
import base64
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np

TYPES = {"Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}
HEADER_BYTES = 8  # size of the length that precedes the values


class Piece:
    """Points [m] of shape (n, 2), cells of shape (m, points of a cell), and fields by name."""

    def __init__(self, path):
        element = ElementTree.parse(path).getroot()[0].find("Piece")
        self.points = _array(element.find("Points")[0])[:, :2]
        cells = next(e for e in (element.find(name) for name in ("Verts", "Lines", "Cells")) if e is not None)
        arrays = {a.get("Name"): _array(a) for a in cells}
        count = len(arrays["offsets"])
        self.cells = arrays["connectivity"].reshape(count, -1) if count else np.empty((0, 1), int)
        self.point_fields = {a.get("Name"): _array(a) for a in element.find("PointData")}
        self.cell_fields = {a.get("Name"): _array(a) for a in element.find("CellData")}

    @staticmethod
    def joined(pieces):
        """Joins the pieces of one kind of several models, with the fields that all of them have."""
        first = pieces[0]
        if len(pieces) == 1:
            return first
        whole = object.__new__(Piece)
        offsets = np.cumsum([0] + [len(piece.points) for piece in pieces])
        whole.points = np.concatenate([piece.points for piece in pieces])
        whole.cells = np.concatenate([piece.cells + offset for piece, offset in zip(pieces, offsets)])
        for fields in ("point_fields", "cell_fields"):
            shared = [name for name in getattr(first, fields) if all(name in getattr(p, fields) for p in pieces)]
            setattr(whole, fields, {name: np.concatenate([getattr(p, fields)[name] for p in pieces]) for name in shared})
        return whole

    def field(self, name, default=None):
        """A field of the points or of the cells."""
        return self.point_fields.get(name, self.cell_fields.get(name, default))

    def is_there(self):
        """Of each point of a cloud: particles that were taken away keep their place but have no cell."""
        there = np.full(len(self.points), False)
        there[self.cells[:, 0]] = True
        return there

    def moved(self, scale):
        """The points after the displacement, times `scale`."""
        displacement = self.point_fields.get("displacement_m")
        return self.points if displacement is None else self.points + scale * displacement[:, :2]


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
