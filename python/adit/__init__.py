"""Reads the results of runs: numbers as numpy arrays, tables as pandas frames where pandas is installed.

    from adit import Run

    run = Run("runs/cantilever/coupled")
    run.summary["crack_count"]                      # every figure of summary.json
    run.histories["tip_uy_m"]                       # one array for each column, and "time_s"
    run.cracks.frame()                              # a pandas.DataFrame
    run.fields(0.032)["grid"]["displacement_m"]     # at the points of the grid, 32 ms after the beginning

Runs of `coupler` and of `simplified` are read in the same way. Runs that failed, were stopped or are still in progress have the
results written so far. A request for something that a run does not have raises `Unusable`, whose message is one sentence. Names
of columns, fields and figures end in their units, all SI. See docs/python.md.
"""
from adit.results.files import Unusable
from adit.results.pieces import Piece
from adit.results.run import Run
from adit.results.tables import Table

__all__ = ["Piece", "Run", "Table", "Unusable"]
