"""Fields of a model, made up for a test, and tests that draw them."""

import unittest

import numpy as np

from adit import Piece, Table
from adit.plots import style


class PictureTest(unittest.TestCase):
    """A test that leaves no figure open."""

    def setUp(self):
        self.addCleanup(style.plt.close, "all")


def piece(points, cells, point_fields=None, cell_fields=None):
    found = object.__new__(Piece)
    found.points, found.cells = np.array(points, float), np.array(cells)
    found.point_fields, found.cell_fields = Table(point_fields or {}, "piece"), Table(cell_fields or {}, "piece")
    return found
