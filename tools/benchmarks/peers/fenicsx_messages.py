"""Steps of adapters/fenicsx without a coupler: mpirun -np RANKS fenicsx_messages.py ZONES_X ZONES_Y STEPS prints the messages and
bytes that each rank sends and receives in one step.
"""
import json
import pathlib
import sys

ADAPTERS = pathlib.Path(__file__).resolve().parents[3] / "adapters"
sys.path[:1] = map(str, (ADAPTERS / "fenicsx", ADAPTERS / "python"))
import numpy as np  # noqa: E402
from mpi4py import MPI  # noqa: E402

from divided import Continuum  # noqa: E402
from google.protobuf import text_format  # noqa: E402
from petsc4py import PETSc  # noqa: E402
from wire import scene, wire  # noqa: E402

SCENE = """
time {{ duration: 1 }} material {{ young_modulus: 25e9 poisson_ratio: 0.2 density: 2500 }}
continuum {{ block {{ x_min: 0 x_max: {x} y_min: 0 y_max: {y} zones_x: {x} zones_y: {y} }} body_loads {{ acceleration {{ y: -10 }} }} }}"""

WARM_UP = 2  # the first product asks who needs what


def exchanged():
    """Messages and bytes that this rank has sent and received in products, as PETSc counts them."""
    product = PETSc.Log.Event("MatMult").getPerfInfo()
    return np.array([product["numMessages"], product["messageLength"]])


def main():
    x, y, steps = map(int, sys.argv[1:])
    ranks, model = MPI.COMM_WORLD, wire.Model()
    PETSc.Log.begin()
    continuum = Continuum(ranks)
    continuum.setup(wire.Setup(scene=text_format.Parse(SCENE.format(x=x, y=y), scene.Scene())), model)
    continuum.weights(wire.Weights(), wire.Interface())
    for n in range(WARM_UP + steps):
        if n == WARM_UP:
            before = exchanged()
        continuum.advance(wire.Advance(step=n, dt=model.critical_dt / 2), wire.Predicted())
    by_rank = ranks.gather(exchanged() - before)
    if ranks.rank == 0:
        print(json.dumps((np.array(by_rank) / steps).tolist()))


main()
