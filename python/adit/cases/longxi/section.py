"""Thrust and moment around the lining of cases/longxi/elastic, of particles and of zones, at one instant."""
import numpy as np


def of_zones(run, time):
    """(angle from x [rad], thrust [N], moment [N m], per metre) from the mean stresses of the zones over the thickness."""
    grid = _at(run, time)["grid"]
    ring = run.scene["continuum"]["blocks"][0]["ring"]
    inner, outer = ring["inner_radius"], ring["outer_radius"]
    rows = run.scene["continuum"]["blocks"][0]["across"]["zones"]
    in_lining = grid.field("group") == 1
    middle = grid.points[grid.cells[in_lining]].mean(axis=1)
    angle, radius = np.arctan2(middle[:, 1], middle[:, 0]), np.hypot(*middle.T)
    xx, yy, xy = grid.field("stress_Pa")[in_lining].T
    hoop = xx * np.sin(angle) ** 2 + yy * np.cos(angle) ** 2 - 2 * xy * np.sin(angle) * np.cos(angle)
    order = np.lexsort((radius, angle.round(6)))  # the rows of one angle after another
    hoop, angle, radius = (values[order].reshape(-1, rows) for values in (hoop, angle, radius))
    thickness, from_axis = outer - inner, radius - radius.mean(axis=1, keepdims=True)
    slope = (hoop * from_axis).sum(axis=1) / (from_axis**2).sum(axis=1)  # the stress is linear over the thickness
    return angle[:, 0], hoop.mean(axis=1) * thickness, slope * thickness**3 / 12


def of_particles(run, time):
    """The same from the sections of particles."""
    sections = _at(run, time)["sections"]
    x, y = sections.points.T
    return np.arctan2(y, x), sections.field("thrust_N"), sections.field("moment_Nm")


def second_harmonic(angle, values):
    """Amplitude of the part that varies as cos 2 theta and sin 2 theta, for values at equal angles; a row of values for each time."""
    return 2 * np.abs(np.mean(values * np.exp(-2j * angle), axis=-1))


def compare(particles, zones):
    """Rows (quantity, in particles, in zones) at the first instant at which both wrote fields."""
    time = particles.times[0]
    forces = of_particles(particles, time), of_zones(zones, time)
    for name, column, unit in (("thrust", 1, "kN"), ("moment", 2, "kN m")):
        yield (f"{name}, amplitude of cos 2θ [{unit}]", *(second_harmonic(f[0], f[column]) / 1e3 for f in forces))
        yield (f"{name}, largest [{unit}]", *(np.abs(f[column]).max() / 1e3 for f in forces))


def _at(run, time):
    """The pieces of the fields nearest to a time."""
    return min(run.snapshots(), key=lambda snapshot: abs(snapshot[0] - time))[1]
