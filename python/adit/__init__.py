"""Reads the results of runs: numbers as numpy arrays, tables as pandas frames where pandas is installed.

    from adit import Run

    run = Run("runs/cantilever/coupled")
    run.summary["crack_count"]                      # every figure of summary.json
    run.histories["tip_uy_m"]                       # one array for each column, and "time_s"
    run.cracks.frame()                              # a pandas.DataFrame
    run.fields(0.032)["grid"]["displacement_m"]     # at the points of the grid, 32 ms after the beginning

Runs of `coupler` and of `simplified` are read alike, and so are runs that failed, were stopped or are still going on: they
have what was written until then. What a run does not have raises `Unusable`, whose message is one sentence. Names of columns,
fields and figures end in their units, all SI. docs/python.md tells more.
"""
from adit.results.files import Unusable
from adit.results.pieces import Piece
from adit.results.run import Run
from adit.results.tables import Table

__all__ = ["Piece", "Run", "Table", "Unusable"]
