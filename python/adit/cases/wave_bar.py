"""Packets along a bar: one row of particles against one row of zones, a chain of springs against 1-D elements."""
import math

from adit.runs import coupled_runs
from adit.cases.wave_packet import AMPLITUDE, ROW, SPACING, Packet


def measure(case, folder):
    """The shares (reflected, transmitted, lost) of the energy that the source sent."""
    return coupled_runs.shares(coupled_runs.run(scene(case), folder / case.name), case.side)


def scene(case):
    packet = Packet(case.wavelength, spacing=case.zone if case.side == "continuum" else SPACING)
    # The packet leaves the source before its front returns, and then needs as long again to pass.
    near = case.zone * math.ceil((packet.duration * packet.group_velocity + 100) / case.zone)
    far = case.zone * math.ceil(1.3 * packet.duration * packet.speed / case.zone) + 2 * case.overlap
    duration = math.ceil(packet.duration + near / packet.group_velocity + 2 * case.overlap / packet.speed)
    begin = near if case.side == "particles" else far  # where the grid begins
    end, length = begin + case.overlap, near + case.overlap + far

    scene = case.scene(duration)
    # dt_factor is relative to a/c, the critical step of the chain; that of the zones also depends on their height.
    del scene["time"]["dt_factor"]
    scene["time"]["dt"] = case.dt_factor * SPACING / packet.speed
    scene["material"] = {"young_modulus": 1, "poisson_ratio": 0, "density": 1}
    scene["particles"] = {
        "packing": {"x_min": 0, "x_max": length, "y_min": 0, "y_max": ROW, "radius": SPACING / 2},
        "bonds": {"normal_stiffness": ROW, "shear_stiffness": 0}}  # no slanted bonds: the row has all its stiffness
    scene["continuum"] = {"block": {"x_min": 0, "x_max": length, "y_min": 0, "y_max": ROW,
                                    "zones_x": round(length / case.zone), "zones_y": 1}}
    scene["interface"] = {"overlap": {"particles_begin": {"x": end, "y": 0}, "continuum_ends": {"x": begin, "y": 0}},
                          "solve": case.solve}
    where = {"particles": {"x_max": 0.6}, "continuum": {"x_min": length}}[case.side]
    scene[case.side]["motions"] = [
        {"where": where, "velocity": {"x": AMPLITUDE}, "time": packet.table(packet.velocity, 200)}]
    return scene
