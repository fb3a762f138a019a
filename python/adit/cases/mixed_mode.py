"""The beam of cases/laboratory/mixed_mode.yaml, turned against the axes, and by how far its crack leaves the path of theory."""
import cmath
import math
from dataclasses import dataclass
from functools import cache

import numpy as np

from adit.cases import crack_growth
from adit.cases.laboratory import CASE, Cells
from adit.runs import coupled_runs

DEPTH, LENGTH, SPAN = 0.32, 3.125, 2.5  # [m]; the others over the depth
NOTCH, ECCENTRICITY = 0.25, 0.625  # its depth, and its distance from the press, over the depth
PRESS = 0.02  # speed [m/s]
SEEN = 0.75  # height up to which the crack is followed, over the depth: above, the press is near
STRONG = {"fracture": {"tensile_strength": 100e6, "fracture_energy": 1e6, "compressive_strength": 1e9}}
ANGLES = (0, 15, 30)  # of the beam against the axes [degrees]


@dataclass(frozen=True)
class MixedMode:
    angle: float  # [degrees]
    cells: Cells
    HEAD = ("angle_deg", "size_m", "seed", "load_N_per_m", "mean_distance_m", "largest_distance_m")

    def row(self):
        return self.angle, self.cells.size, self.cells.seed

    def __str__(self):
        return f"mixed_mode_{self.angle:g}_{self.cells}"

    def measure(self, folder):
        """The largest load [N/m]; how far the middles of the cracks are from theory's path: their mean square and the largest [m]."""
        run = coupled_runs.run({"extends": str(CASE / "mixed_mode.yaml"), "particles": self._scene(), "output": {"field_times": None}},
                               folder / str(self))
        places = (run.cracks["x_m"] + 1j * run.cracks["y_m"]) / self._turn()
        seen = places[places.imag < SEEN * DEPTH]
        if len(seen) == 0:
            raise coupled_runs.Failed(f"{self} has no crack: choose another packing, whose discs touch the press and the rollers")
        away = crack_growth.distances(seen, theory() * DEPTH)
        load = np.hypot(run.histories["press_fx_N"], run.histories["press_fy_N"])
        return load.max(), math.sqrt(np.mean(away**2)), away.max()

    def _turn(self):
        return cmath.rect(1, math.radians(self.angle))

    def _scene(self):
        def point(x, y):
            place = complex(x, y) * self._turn()
            return {"x": place.real, "y": place.imag}

        def box(x_min, x_max, y_min, y_max):
            return {"polygon": {"corners": [point(x_min, y_min), point(x_max, y_min), point(x_max, y_max), point(x_min, y_max)]}}

        half, size, to_roller, mouth = LENGTH * DEPTH / 2, self.cells.size, SPAN * DEPTH / 2, -ECCENTRICITY * DEPTH
        beam = box(-half, half, 0, DEPTH)
        corners = beam["polygon"]["corners"]
        around = {f"{axis}_{name}": extreme(corner[axis] for corner in corners) + beyond
                  for axis in "xy" for name, extreme, beyond in (("min", min, -2 * size), ("max", max, 2 * size))}
        blocks = {"left": (-to_roller, 0, size), "right": (to_roller, 0, size), "top": (0, DEPTH - size, DEPTH)}
        walls = {"left_roller": (-to_roller, 0), "right_roller": (to_roller, 0), "press": (0, DEPTH)}
        return {
            "cells": self.cells.given(**around), "within": beam,
            "groups": [{"name": name, "where": box(x - size, x + size, low, high), "bonds": STRONG}
                       for name, (x, low, high) in blocks.items()],
            "joints": [{"name": "notch", "from": point(mouth, 0), "to": point(mouth, NOTCH * DEPTH), "open": True}],
            "walls": [{"name": name, "from": point(x - size, y), "to": point(x + size, y),
                       **({"velocity": point(0, -PRESS)} if name == "press" else {})} for name, (x, y) in walls.items()],
            "histories": [{"name": "press", "quantity": f"force_{axis}", "wall": "press"} for axis in "xy"]}


@cache
def theory(elements=32):
    """The path of the crack by linear elastic fracture mechanics, over the depth, from the middle of the lower side; with so many
    elements over the depth."""
    element, half, to_roller = 1 / elements, LENGTH / 2, SPAN / 2

    def pressure(places):
        under_press = (places.imag > 1 - 1e-9) & (np.abs(places.real) < element)
        over_rollers = (places.imag < 1e-9) & (np.abs(np.abs(places.real) - to_roller) < element)
        return under_press / under_press.sum() + over_rollers / over_rollers.sum()

    outline = np.array([-half, half, half + 1j, -half + 1j, -half])
    notch = np.array([0, 1j * NOTCH]) - ECCENTRICITY
    return crack_growth.crack_path(outline, pressure, notch, element, 0.7)


def distances(measured):
    """Lines of a table: means over the packings of each size, and the range of their loads."""
    yield f"{'turned':>8}{'cells':>8}{'load':>13}{'range':>17}{'distance from theory, over the cells':>38}{'largest':>9}"
    groups = {}
    for beam, values in measured.items():
        groups.setdefault((beam.cells.size, beam.angle), []).append(values)
    for (size, angle), values in sorted(groups.items()):
        load, mean, largest = np.array(values).T
        yield (f"{angle:4g} deg{1000 * size:5g} mm{load.mean() / 1e3:8.1f} kN/m{load.min() / 1e3:9.1f} - {load.max() / 1e3:5.1f}"
               f"{math.sqrt(np.mean(mean**2)) / size:38.2f}{largest.max() / size:9.2f}")
