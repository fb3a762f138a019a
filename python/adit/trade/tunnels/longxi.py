"""The tunnel of cases/longxi along its axis, cut by 0.5 m of its fault: a beam, zones, and coupled models of growing regions.

All give the change of the forces of the tube by the offset, one and two diameters from the fault, and the extent of the damage of
the lining: in the beam and in elastic zones the stress exceeds the strength, other zones yield, and bonds of particles break.
"""
import time

import numpy as np

from adit import programs
from adit.cases.longxi import along
from adit.trade.tunnels import scene
from adit.trade.tunnels.fault_beam import Beam
from adit.trade.tunnels.ladder import Ladder, Quantity, Rung

SCENE = programs.ROOT / "cases" / "longxi" / "along_offset.yaml"
PLACES = {"1 d": 12.0, "2 d": 24.0}  # one and two diameters from the fault, on the axis [m]
WALLS = {"crown": 1, "invert": -1}
WALL, THICKNESS, ARM, WIDTH = 4.0557, 1.159, 8.111, 12.0  # of a wall from the axis; h and d of cases/longxi/README.md [m]
INNER, OUTER = 3.476, 4.635  # faces of the walls [m]
OVERLAP = 2.3  # particles beyond the inner side of the overlap [m]
DIP = np.radians(60)  # of the fault
TENSION, COMPRESSION = 1.64e6, 15.4e6  # strengths of the walls [Pa]
BREAKABLE = "continuum.materials[1].material.mohr_coulomb={cohesion: 3.59 MPa, friction_angle: 40 deg, tension: 1.64 MPa}"
YIELDING_ROCK = ("continuum.material={young_modulus: 8 GPa, poisson_ratio: 0.25, density: 2.6 t/m^3, "
                 "mohr_coulomb: {cohesion: 8 MPa, friction_angle: 40 deg, tension: 3 MPa}}")  # as strong as the particles'

OFFSET = 0.5  # of the fault [m]
EARLY, EARLY_OFFSET = 0.25, 0.073  # a time [s], and the offset until then [m]: the lining still bears it

QUANTITIES = [Quantity("early thrust", "thrust at 1 d, 7 cm of offset [MN]", 1e-6, ".0f"),
              Quantity("thrust 1 d", "largest thrust at 1 d [MN]", 1e-6, ".0f"),
              Quantity("thrust 2 d", "largest thrust at 2 d [MN]", 1e-6, ".0f"),
              Quantity("moment 1 d", "largest moment at 1 d [MN m]", 1e-6, ".0f"),
              Quantity("moment 2 d", "largest moment at 2 d [MN m]", 1e-6, ".0f"),
              Quantity("broken", "broken bonds of the lining", 1, ".0f"), Quantity("damage", "damage within [m]", 1, ".1f")]


def beam(meter):
    """README.md of the case has the numbers of tube and ground."""
    begun = time.process_time()
    area, inertia, young = 18.06, 18.06 * 16.56, 28e9
    tube = Beam(young * area, young * inertia, kappa=8 * 3.2e9 * 0.75 / 2 * WIDTH, spread=4 / np.sin(DIP))
    along_axis, across = OFFSET * np.cos(DIP), OFFSET * np.sin(DIP)
    x = np.arange(0, 60, 0.5)
    thrust, moment = (np.abs([force(at, step) for at in x]) for force, step in ((tube.thrust, along_axis), (tube.moment, across)))
    bent, pressed = moment / inertia * 6, thrust / area
    beyond = (pressed + bent > 23.7e6) | (bent - pressed > 2.53e6)
    meter.cpu_s = time.process_time() - begun
    early = EARLY_OFFSET / OFFSET * thrust[x == PLACES["1 d"]][0]
    return {"early thrust": early, "damage": x[beyond].max(initial=0)} | {
        f"{name} {place}": force[x == at][0] for place, at in PLACES.items()
        for name, force in (("thrust", thrust), ("moment", moment))}


def stations(within):
    """(settings of histories and sections, column and factor by wall and place) at ±1 and ±2 diameters: of sections of
    particles within this distance from the fault [m], of zones beyond."""
    sections, of_particles, of_zones, columns = [], [], [], {}
    for at in (sign * x for x in PLACES.values() for sign in (-1, 1)):
        for wall, side in WALLS.items():
            name = f"{wall}_{'west' if at < 0 else 'east'}_{abs(at):g}"
            if abs(at) < within:
                sections.append(f"{{name: {name}, from: {{x: {at}, y: {side * INNER}}}, to: {{x: {at}, y: {side * OUTER}}}}}")
                of_particles.append(f"{{name: {name}, quantity: thrust, section: {name}}}")
                columns[wall, at] = f"{name}_thrust_N", 1
            else:
                of_zones.append(f"{{name: {name}, quantity: stress_xx, at: {{x: {at}, y: {side * WALL}}}}}")
                columns[wall, at] = f"{name}_sxx_Pa", THICKNESS
    settings = {"particles.sections": sections, "particles.histories": of_particles, "continuum.histories": of_zones}
    return [f"{path}=[{', '.join(entries)}]" for path, entries in settings.items()], columns


def region(length, height):
    """Settings: only particles within these distances from the fault and from the axis [m], and the overlap around them."""
    box = {"x_min": -length, "x_max": length, "y_min": -height, "y_max": height}
    settings = [f"interface.overlap.around.box.{key}={value}" for key, value in box.items()]
    settings += [f"particles.packing.{key}={value + np.copysign(OVERLAP, value)}" for key, value in box.items()]
    # the fault through the whole region: beyond its end the particles would be rock where the zones are gouge
    end = f"{{x: {2 * height / np.tan(DIP)}, y: {2 * height}}}"
    start = f"{{x: {-2 * height / np.tan(DIP)}, y: {-2 * height}}}"
    settings += [f"particles.groups[2].where.band.{key}={at}" for key, at in (("from", start), ("to", end))]
    settings += [f"particles.joints[0].from={start}", f"particles.joints[2].to={end}"]
    return settings + [f"particles.groups[{group}].where.{key}={np.copysign(length - 0.5, box[key])}"
                       for group in (3, 4) for key in ("x_min", "x_max")]


def coupled(length, height, settings):
    def compute(meter):
        histories, columns = stations(length - 2)
        run = meter.run("coupler", SCENE, "run", [*region(length, height), *histories, *settings])
        lining = along.Lining(run)
        distance, broken = lining.bonds()
        return forces(run, columns) | {"broken": broken.sum(), "damage": within(np.abs(distance[broken]))}
    return compute


def forces(run, columns):
    """Forces of the tube: their changes since time 0, the mean of both sides of the fault."""
    def wall(name, at):
        column, factor = columns[name, at]
        return factor * (run.histories[column] - run.histories[column][0])

    found = {}
    for name, x in PLACES.items():
        crown, invert = (np.array([wall(side, at) for at in (-x, x)]) for side in WALLS)
        thrust, moment = WIDTH * np.abs(crown + invert), WIDTH * ARM / 2 * np.abs(crown - invert)
        found |= {f"thrust {name}": thrust.max(axis=1).mean(), f"moment {name}": moment.max(axis=1).mean()}
        if x == PLACES["1 d"]:
            found["early thrust"] = thrust[:, np.argmin(np.abs(run.histories["time_s"] - EARLY))].mean()
    return found


def within(distances):
    """The distance that contains 95 % of the damage."""
    return np.percentile(distances, 95) if len(distances) else 0.0


def zones(damaged, settings):
    """The same scene without its particles: the walls are zones from end to end, and were always there."""
    def compute(meter):
        alone = scene.read(SCENE)
        for part in ("particles", "interface"):
            del alone[part]
        del alone["statics"]["count_from_stage"]
        del alone["time"]["substeps"]
        histories, columns = stations(0)
        run = meter.run_scene(alone, "run", [setting for setting in histories if setting.startswith("continuum")] + settings)
        grid, in_walls = walls(run)
        lost = damaged(run, grid, in_walls)
        middle = grid.points[grid.cells[in_walls][lost]].mean(axis=1)
        return forces(run, columns) | {"damage": within(np.abs(middle[:, 0] - middle[:, 1] / np.tan(DIP)))}
    return compute


def walls(run):
    """The grid at the end, and which of its zones are walls outside the gouge."""
    grid = run.fields()["grid"]
    middle = grid.points[grid.cells].mean(axis=1)
    return grid, (np.abs(middle[:, 1]) > INNER) & (np.abs(middle[:, 1]) < OUTER)


def beyond_strength(run, grid, in_walls):
    """The zones of walls whose stress by the offset exceeds their strength."""
    before = next(run.snapshots())[1]["grid"]["stress_Pa"][in_walls, 0]
    change = grid["stress_Pa"][in_walls, 0] - before
    return (change > TENSION) | (change < -COMPRESSION)


def yielded(run, grid, in_walls):
    return grid["plastic_shear_strain"][in_walls] > 0


def ladder(quick):
    settings = ["time.duration=5 ms", "output.field_times=[0 s, 5 ms]", "statics.unbalanced_ratio=0.02"] if quick else []
    sizes = ((0.5, 7), (1.25, 7)) if quick else ((0.5, 7), (1.25, 7), (2.5, 7), (4.3, 7), (2.5, 14))
    regions = [Rung("coupled", f"particles within {diameters:g} d" + (f", {height} m high" if height > 7 else ""),
                    coupled(diameters * WIDTH, height, settings)) for diameters, height in sizes]
    yielding = Rung("coupled", "particles within 2.5 d, rock that yields", coupled(2.5 * WIDTH, 7, [YIELDING_ROCK]))
    return Ladder("longxi", QUANTITIES, [
        Rung("beam", "elastic beam in elastic ground", beam),
        Rung("zones", "elastic zones", zones(beyond_strength, settings)),
        Rung("zones", "zones that yield", zones(yielded, [*settings, BREAKABLE])),
        *regions[:-1], *([] if quick else [yielding]), regions[-1]])
