"""The ring of cases/qingcaosha across the tunnel, shaken: rings at rest in the strain of a soil column, and coupled models whose
region of particles grows.

All give the change of the forces by the motion: the amplitude of the part that varies as sin 2 theta around the ring, and the largest
moment anywhere. The rings at rest are linear: their scene shears the clay by 1/1000, and their forces are scaled by the strain of a
column of the same ground beside the ring.
"""
import numpy as np

from adit import programs
from adit.cases.longxi.section import second_harmonic
from adit.cases.tunnels import lined_tunnel, ring_ovaling
from adit.trade.tunnels.ladder import Ladder, Quantity, Rung

CASE = programs.ROOT / "cases" / "qingcaosha"
SECTION = CASE / "section.yaml"
INNER, OUTER = 2.92, 3.4  # radii of the ring [m]
NEIGHBOURS = 48e6  # rotational stiffness by the neighbours [N m/rad]
JOINTS = range(15, 360, 60)  # angles [deg]
SHEAR_MODULUS, POISSON = 44.8e6, 0.45  # of the clay [Pa]
SHEARED = 1e-3  # strain of the clay in CASE/ovaling
APART = 6.8  # distance of the two places whose displacements give the strain [m]
COLUMN = [
    "tunnels=[]", "statics.count_from_stage=0", "time.substeps=1",
    "continuum.block.x_min=-20.4 m", "continuum.block.x_max=-19.6 m", "continuum.block.zones_x=1",
    "continuum.histories=[{name: free_above, quantity: displacement_x, at: {x: -20 m, y: -11.3 m}}, "
    "{name: free_below, quantity: displacement_x, at: {x: -20 m, y: -18.1 m}}]"]
HINGES = "continuum.linings[0].joints=[" + ", ".join(
    f"{{angle: {angle} deg, rotational_stiffness: {NEIGHBOURS:g}}}" for angle in JOINTS) + "]"

# The rungs of growing regions have discs: concrete with the strength of plain C55, and clay of the
# right shear modulus, as discs cannot have its Poisson's ratio.
DISCS = [
    "tunnels[0].lining.material={young_modulus: 35.5 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3, "
    "mohr_coulomb: {cohesion: 6.5 MPa, friction_angle: 50 deg, tension: 2.74 MPa}}"]
CLAY_OF_DISCS = "{young_modulus: 107.5 MPa, poisson_ratio: 0.2, density: 1.75 t/m^3}"

QUANTITIES = [Quantity("strain", "strain of the ground [1/1000]", 1e3, ".2f"),
              Quantity("thrust", "thrust [kN]", 1e-3, ".0f"), Quantity("moment", "moment [kN m]", 1e-3, ".0f"),
              Quantity("largest moment", "largest moment [kN m]", 1e-3, ".0f"),
              Quantity("opening", "opening of a joint [mm]", 1e3, ".3f"),
              Quantity("rotation", "rotation of a joint [mrad]", 1e3, ".2f"), Quantity("diameter", "diameter [mm]", 1e3, ".1f"),
              Quantity("broken", "broken bonds", 1, ".0f")]


def motion(quick):
    """The strongest part of the case's motion."""
    duration = 0.02 if quick else 1.3
    return [f"time.duration={duration} s", "continuum.base.acceleration.from=9 s", f"output.field_times=[0 s, {duration} s]"]


def free_strain(run):
    return np.abs(run.histories["free_above_ux_m"] - run.histories["free_below_ux_m"]).max() / APART


def in_column(forces):
    """A rung: `forces(meter, strain)` in the strain of a soil column."""
    def shaken(settings):
        def compute(meter):
            strain = free_strain(meter.run("coupler", SECTION, "column", [*settings, *COLUMN]))
            found = forces(meter, strain)
            return {"strain": strain, "largest moment": found["moment"]} | found
        return compute
    return shaken


@in_column
def handbook(_, strain):
    """Wang's thrust and Penzien's moment."""
    plane = 35.5e9 / (1 - 0.2**2) * (OUTER - INNER)
    ring = lined_tunnel.Tunnel(SHEAR_MODULUS, POISSON, (INNER + OUTER) / 2, plane, plane * (OUTER - INNER)**2 / 12, np.inf)
    return {"thrust": strain * lined_tunnel.wang_thrust(ring), "moment": strain * lined_tunnel.penzien_moment(ring)}


@in_column
def annulus(_, strain):
    clay = 2 * (1 + POISSON) * SHEAR_MODULUS, POISSON
    return named(ring_ovaling.annulus((35.5e9, 0.2), clay, INNER, OUTER, SHEAR_MODULUS), strain)


@in_column
def zones(meter, strain):
    run = meter.run("coupler", CASE / "ovaling" / "zones.yaml", "ring")
    return named(ring_ovaling.of_zones(run, INNER, OUTER), strain / SHEARED)


@in_column
def beams(meter, strain):
    return named(ring_ovaling.of_beams(meter.run("coupler", CASE / "ovaling" / "beams.yaml", "ring")), strain / SHEARED)


@in_column
def hinged_beams(meter, strain):
    """The joints turn, held by the neighbours alone."""
    run = meter.run("coupler", CASE / "ovaling" / "beams.yaml", "ring", [HINGES])
    angle, _, moment, _ = lined_tunnel.around(run)
    largest, in_joints = np.abs(moment).max(), max(np.abs(moment[np.argmin(np.abs(angle - joint))]) for joint in JOINTS)
    found = named(ring_ovaling.of_beams(run), strain / SHEARED)
    return found | {"largest moment": largest * strain / SHEARED, "rotation": in_joints * strain / SHEARED / NEIGHBOURS}


def named(forces, factor):
    return {name: abs(force) * factor for name, force in zip(("thrust", "moment"), forces)}


def coupled(rows, ground, settings):
    """So many rows of particles over the thickness, and this thickness of clay of particles around [m]."""
    def compute(meter):
        radius = (OUTER - INNER) / (np.sqrt(3) * rows)
        run = meter.run("coupler", SECTION, "run", [
            *settings, *DISCS, f"tunnels[0].particles={{radius: {radius:.5f} m, ground: {ground} m, overlap: 0.8 m, "
            f"material: {CLAY_OF_DISCS}, damping: {{local: 0.02}}}}"])
        opening = max(values.max() for name, values in run.histories.items() if name.endswith("_opening_m"))
        return {"strain": free_strain(run), "opening": opening, "broken": run.summary["crack_count"],
                "thrust": amplitude(run, "thrust_N"), "moment": amplitude(run, "moment_Nm"),
                "largest moment": largest_change(run, "moment_Nm"),
                "rotation": largest_change(run, "rotation_rad"), "diameter": largest_change(run, "diameter_change_m")}
    return compute


def amplitude(run, force):
    angle, values = ring_ovaling.around(run, force)
    return second_harmonic(angle, values - values[0]).max()


def largest_change(run, quantity):
    """Changes of all histories of a quantity since the state at rest."""
    return max(np.abs(values - values[0]).max() for name, values in run.histories.items() if name.endswith(quantity))


def ladder(quick):
    settings = motion(quick)
    forms = [Rung("closed form", "column, Wang and Penzien", handbook(settings)),
             Rung("closed form", "column, annulus", annulus(settings))]
    rings = [Rung("beams", "column, ring of beams", beams(settings)),
             Rung("beams", "column, hinged beams", hinged_beams(settings)),
             Rung("zones", "column, ring of zones", zones(settings))]
    sizes = ((3, 0.9), (3, 1.2)) if quick else ((4, 0.9), (4, 1.2), (4, 2), (6, 1.2))
    return Ladder("qingcaosha", QUANTITIES, forms + ([] if quick else rings) + [
        Rung("coupled", f"{rows} rows, {ground} m of clay", coupled(rows, ground, settings)) for rows, ground in sizes])
