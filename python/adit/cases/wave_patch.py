"""A cylindrical pulse that leaves a circular patch of particles in the middle of a grid.

The pulse is sent by radial forces on a ring of particles around the centre. In two dimensions a pulse leaves a
tail; a model of particles alone says how much of it is still inside when the pulse has left.
"""
import math

import numpy as np

from adit import Run
from adit.runs import coupled_runs
from adit.cases.wave_packet import ROW, SPACING, Packet


def radius(case):
    """Radius of the patch inside the overlap [m]: reflections must not return while the pulse is still leaving."""
    return case.zone * max(25, math.ceil(packet_of(case).duration / 2 / case.zone + case.overlap_over_h / 2))


def measure(case, folder):
    """The shares of the energy that left in the model of particles alone."""
    run = coupled_runs.run(scene(case), folder / case.name)
    return coupled_runs.shares(run, case.side, tail(case, folder))


def tail(case, folder):
    """Energy inside the patch at the end, in the model of particles alone: twice the kinetic energy."""
    particles = Run(folder / reference_name(case)).fields()["particles"]
    inside = np.hypot(*particles.points.T) <= radius(case) + case.overlap / 2
    velocity = particles.field("velocity_m_per_s")[inside]
    return float(np.sum(velocity**2) * SPACING * ROW)


def fields(case, folder):
    """The fields when the pulse has left."""
    return Run(folder / case.name).fields()


def reference_name(case):
    return f"patch_particles_alone_h{case.h_over_a}_lambda{case.lambda_over_h}_dt{case.dt_factor}"


def run_reference(case, folder):
    return coupled_runs.run(particles_alone(case), folder / reference_name(case))


def packet_of(case):
    return Packet(case.wavelength, cut=4.0)


def duration_of(case):
    return packet_of(case).duration + (radius(case) + 2 * case.overlap) / packet_of(case).group_velocity


def particles_alone(case):
    """A model so large that no reflection from its edges returns in time."""
    half = (radius(case) + case.overlap + duration_of(case)) / 2 + case.wavelength
    scene = case.scene(duration_of(case))
    scene["particles"] = particles(case, half)
    return scene


def scene(case):
    half = radius(case) + case.overlap
    zones = 2 * math.ceil((half + packet_of(case).duration / 2) / case.zone + 5)
    scene = case.scene(duration_of(case))
    scene["particles"] = particles(case, half + 3 * SPACING)
    side = zones * case.zone / 2
    scene["continuum"] = {"block": {"x_min": -side, "x_max": side, "y_min": -side, "y_max": side,
                                    "zones_x": zones, "zones_y": zones}}
    scene["interface"] = {"overlap": {"around": {"circle": {"centre": {"x": 0, "y": 0},
                                                            "radius": radius(case)}}, "width": case.overlap},
                          "solve": case.solve}
    return scene


def particles(case, half):
    """A box of particles that reaches at least `half` to all sides, with one particle at the centre."""
    rows = 4 * math.ceil(half / ROW / 4)  # below and above the middle row, which is a wide one
    columns = math.ceil(half / SPACING) + 0.5
    packet = packet_of(case)
    pulse = packet.table(packet.velocity, 100)
    ring = max(case.wavelength / 4, SPACING)
    reach = math.ceil(ring / ROW) + 1
    lattice = [(i + (j % 2) / 2, j * ROW) for j in range(-reach, reach + 1) for i in range(-2 * reach, 2 * reach)]
    loads = [{"where": {"x_min": x - 0.1, "x_max": x + 0.1, "y_min": y - 0.1, "y_max": y + 0.1},
              "force": {"x": 1e-6 * x / ring, "y": 1e-6 * y / ring}, "time": pulse}
             for x, y in lattice if abs(math.hypot(x, y) - ring) <= 0.55 * SPACING]
    return {"packing": {"x_min": -columns, "x_max": columns, "y_min": -(rows + 0.5) * ROW,
                        "y_max": (rows + 0.5) * ROW, "radius": 0.5}, "loads": loads}
