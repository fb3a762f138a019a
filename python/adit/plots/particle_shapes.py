"""Particles as what they are: polygons of cells, or discs of their size."""
import numpy as np
from matplotlib.collections import EllipseCollection, PolyCollection
from matplotlib.lines import Line2D
from matplotlib.patches import Patch


class Shapes:
    """The shapes of the particles at rest, or displaced `scale` times without a `common` motion [m]. Where only some of several
    regions have `cells`, all are discs."""

    def __init__(self, discs, cells=None, scale=0, common=0):
        self.discs, self.there = discs, discs.is_there()
        self._places = discs.moved(scale, common)
        self._corners = None
        if cells is not None and len(cells.cells) == self.there.sum():
            self._corners = cells.moved(scale, common)[cells.cells]

    def add(self, axes, chosen, **look):
        """Draws those that are chosen among the particles that are there; returns the collection."""
        if self._corners is not None:
            return axes.add_collection(PolyCollection(self._corners[chosen[self.there]], **look))
        size = 2 * self.discs.field("radius_m", np.zeros(len(chosen)))[chosen]
        return axes.add_collection(EllipseCollection(size, size, np.zeros_like(size), units="xy", offsets=self._places[chosen],
                                                     offset_transform=axes.transData, **look))

    def handle(self, label, size=6, **look):
        """Of a legend; `size` of a disc [points]."""
        if self._corners is not None:
            return Patch(label=label, **look)
        renamed = {"m" + name: value for name, value in look.items() if name in ("fc", "ec")}
        return Line2D([], [], ls="", marker="o", ms=size, alpha=look.get("alpha"), label=label, **renamed)
