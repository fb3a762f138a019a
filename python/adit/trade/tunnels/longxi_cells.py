"""The tunnel of cases/longxi along its axis in regions of cells of three heights, of which the last is the tallest.

Strengths are those of the discs' scene. The gouge is as weak as that of the zones, and rubs when it has broken: where it were not,
the fault would slip the more easily the taller the region.
"""
import numpy as np

from adit.trade.tunnels import longxi, scene
from adit.trade.tunnels.ladder import Ladder, Quantity, Rung

LENGTH, HEIGHTS = 2.5 * longxi.WIDTH, (7, 10, 14)  # of the regions [m]
SIZE = 0.386  # of cells, three to a wall [m]
GOUGE_WIDTH = 4.0  # [m]
ROCK = {"tensile_strength": "3 MPa", "fracture_energy": "400 N/m", "cohesion": "8 MPa", "friction_angle": "40 deg"}
WALL = {"tensile_strength": "1.64 MPa", "fracture_energy": "84 N/m", "compressive_strength": "15.4 MPa", "friction_angle": "40 deg"}
GOUGE = {"tensile_strength": "0.1 MPa", "fracture_energy": "50 N/m", "cohesion": "0.1 MPa", "friction_angle": "25 deg",
         "residual_friction_angle": "20 deg"}

QUANTITIES = [*longxi.QUANTITIES[:3], Quantity("lining", "cracks of the lining [m]", 1, ".0f"),
              Quantity("gouge", "cracks of the gouge per metre of height", 1, ".1f"), Quantity("all", "all cracks [m]", 1, ".0f")]


def with_fracture(material, fracture):
    return {key: value for key, value in material.items() if key != "mohr_coulomb"} | {"fracture": fracture}


def of_cells():
    """The scene with cells in place of the lattice, joined everywhere."""
    found = scene.read(longxi.SCENE)
    particles = found["particles"]
    del particles["packing"]
    particles |= {"bonds": {}, "contacts": {"friction": 0.6}, "material": with_fracture(particles["material"], ROCK)}
    fractures = {"walls_far": WALL, "crown": WALL, "invert": WALL, "gouge": GOUGE}
    for group in particles["groups"]:
        group["bonds"] = {}
        if group["name"] in fractures:
            group["material"] = with_fracture(group["material"], fractures[group["name"]])
    found["time"] |= {"dt_factor": 0.5, "substeps": 0}
    return found


def region(height, settings):
    def compute(meter):
        histories, columns = longxi.stations(LENGTH - 2)
        places = [text.replace("particles.packing", "particles.cells") for text in longxi.region(LENGTH, height)]
        run = meter.run_scene(of_cells(), "run", [f"particles.cells.size={SIZE}", *places, *histories, *settings])
        return longxi.forces(run, columns) | cracks(run, height)
    return compute


def cracks(run, height):
    """Lengths of cracks [m], those of the gouge per metre of the region's height, overlap included."""
    lines = run.fields().get("cracks")
    if lines is None:
        return {"lining": 0.0, "gouge": 0.0, "all": 0.0}
    ends = lines.points[lines.cells]
    length = np.hypot(*(ends[:, 1] - ends[:, 0])[:, :2].T)
    x, y = ends.mean(axis=1)[:, :2].T
    in_walls = (np.abs(y) > longxi.INNER) & (np.abs(y) < longxi.OUTER)
    in_gouge = np.abs(x - y / np.tan(longxi.DIP)) < GOUGE_WIDTH / 2 / np.sin(longxi.DIP)
    return {"lining": length[in_walls].sum(), "gouge": length[in_gouge].sum() / 2 / (height + longxi.OVERLAP), "all": length.sum()}


def ladder(quick):
    settings = ["time.duration=5 ms", "output.field_times=[0 s, 5 ms]", "statics.unbalanced_ratio=0.02"] if quick else []
    return Ladder("longxi_cells", QUANTITIES, [Rung("coupled", f"cells, {height} m high", region(height, settings))
                                               for height in HEIGHTS[:2 if quick else 3]])
