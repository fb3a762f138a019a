"""Fields of a model, made up for a test."""

import numpy as np

from adit import Piece, Table


def piece(points, cells, point_fields=None, cell_fields=None):
    found = object.__new__(Piece)
    found.points, found.cells = np.array(points, float), np.array(cells)
    found.point_fields, found.cell_fields = Table(point_fields or {}, "piece"), Table(cell_fields or {}, "piece")
    return found
