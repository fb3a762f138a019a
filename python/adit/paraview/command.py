"""Opens results in ParaView: writes a state that shows a run deformed and in colours.

%(prog)s RUN_DIR...
    writes RUN_DIR/fields/paraview.py. Open it by File > Load State, or by: paraview --script=RUN_DIR/fields/paraview.py
    It shows the last instant: displaced zones, particles and cells coloured by displacement, cracks between cells by their
    opening, linings by thrust, springs by force. The time controls of ParaView have all instants. Bonds, coloured by their normal force, are hidden at first.
"""
from pathlib import Path
from string import Template

import numpy as np

from adit import Run, programs
from adit.plots.deformation import scale_of_run

SHOWN = {"grid": "displacement_m", "particles": "displacement_m", "cells": "displacement_m", "cracks": "opening_m",
         "linings": "thrust_N", "springs": "force_N", "bars": "stress_Pa", "bonds": "normal_force_N"}  # kind: the array of its colours
TEMPLATE = Template((Path(__file__).parent / "state.py.in").read_text())


def write(folder):
    """Writes the state of a run and returns its path."""
    run = Run(folder)
    fields = run.fields()
    arrays = {kind: array for kind, array in SHOWN.items() if kind in fields and fields[kind].field(array) is not None}
    written = run.instants[-1][1]
    pieces = {name: (kind, arrays[kind], "POINTS" if arrays[kind] in fields[kind].point_fields else "CELLS")
              for name in written if (kind := name.rpartition("_")[2]) in arrays and len(fields[kind].cells)
              and name.removesuffix("particles") + "cells" not in written}  # particles that have polygons are these
    ranges = {array: limits(array, [fields[kind][array] for kind, other in arrays.items() if other == array]) for array in arrays.values()}
    path = run.folder / "fields" / "paraview.py"
    path.write_text(TEMPLATE.substitute(
        name=run.name, fields=repr(str(run.folder.resolve() / "fields" / "fields.pvd")), scale=f"{scale_of_run(run):g}",
        pieces=entries(pieces), ranges=entries(ranges)))
    return path


def limits(array, arrays):
    """From 0 to the longest of vectors and the widest opening; as far below 0 as above for forces."""
    vectors = arrays[0].ndim > 1
    largest = max(float(np.max(np.linalg.norm(values, axis=1) if vectors else np.abs(values), initial=0)) for values in arrays) or 1.0
    return 0.0 if vectors or array == "opening_m" else -largest, largest


def entries(mapping):
    return ",\n    ".join(f"{key!r}: {value!r}" for key, value in mapping.items())


def main(words):
    parser = programs.parser("paraview", __doc__)
    parser.add_argument("folders", metavar="RUN_DIR", nargs="+", help="folder of a run")
    options = parser.parse_args(words)
    for folder in options.folders:
        print(f"state              {write(folder)}")
