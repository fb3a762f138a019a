"""A beam of P or S waves in a wide strip, which meets a plane overlap at an angle.

The overlap stands upright, the particles left of it; the beam leaves their left edge at the angle to the horizontal.
Its displacement is the gradient (P) or the curl (S) of a potential with a Gaussian envelope along and across, so that
it holds nothing of the other wave: with s across the beam, A = exp(-s²/2σ²) and u the packet, the motion is A u(t) in
the direction of the wave's motion and s/σ² A c ∫u dt in that direction turned by a right angle.
"""
import math

import numpy as np

from adit.runs import coupled_runs
from adit.cases.wave_packet import AMPLITUDE, ROW, SPEED, Packet

BEAM_WIDTH = 1.0  # standard deviation σ of the beam [wavelengths]
HALF_BEAM = 3.0   # [σ]


def measure(case, folder):
    """The shares (reflected, transmitted, lost) after the beam has passed and before reflections return."""
    return coupled_runs.shares(coupled_runs.run(scene(case), folder / case.name), case.side)


def scene(case):
    packet = Packet(case.wavelength, SPEED[case.wave], cut=4.0)
    angle = math.radians(case.angle_deg)
    sigma = BEAM_WIDTH * case.wavelength
    source = HALF_BEAM * sigma / math.cos(angle)  # half the length of the edge that sends
    latest = source * math.sin(angle) / packet.speed  # delay of its upper end relative to its middle
    pulse = packet.duration + 2 * latest
    # Reflections must not have reached the overlap a second time when the end of the beam has passed.
    near = whole(pulse * packet.speed / 2 * math.cos(angle), case.zone)
    duration = pulse + (near + 2 * case.overlap) / math.cos(angle) / packet.speed
    far = whole(0.6 * pulse * packet.speed * math.cos(angle), case.zone) + 3 * case.overlap
    margin = 2 * sigma
    height = whole(2 * (source + margin) + (near + case.overlap) * math.tan(angle), case.zone)
    begin, end = near, near + case.overlap

    scene = case.scene(duration)
    scene["particles"] = {
        "packing": {"x_min": 0, "x_max": end + case.zone, "y_min": 0, "y_max": height, "radius": 0.5},
        "motions": list(beam(packet, case.wave, angle, sigma, source, source + margin))}
    scene["continuum"] = {"block": {"x_min": 0, "x_max": end + far, "y_min": 0, "y_max": height,
                                    "zones_x": round((end + far) / case.zone), "zones_y": round(height / case.zone)}}
    scene["interface"] = {"overlap": {"particles_begin": {"x": end, "y": 0}, "continuum_ends": {"x": begin, "y": 0}},
                          "solve": case.solve}
    return scene


def beam(packet, wave, angle, sigma, source, middle):
    """Motions of the left edge in pieces of an eighth of a wavelength, or a row: too short to radiate sideways."""
    pieces = math.floor(2 * source / max(packet.wavelength / 8, 1.2 * ROW))
    size = 2 * source / pieces
    direction = angle + {"P": 0, "S": math.pi / 2}[wave]
    main, turned = np.array([(math.cos(d), math.sin(d)) for d in (direction, direction + math.pi / 2)])
    for i in range(pieces):
        y = (i + 0.5) * size - source
        s = y * math.cos(angle)
        amplitude = AMPLITUDE * math.exp(-s * s / (2 * sigma**2))
        across = packet.speed * s / sigma**2
        delay = (y + source) * math.sin(angle) / packet.speed
        where = {"x_max": 1.1, "y_min": middle + y - size / 2, "y_max": middle + y + size / 2 - 1e-6}
        for k, axis in enumerate("xy"):
            motion = packet.table(
                lambda t: main[k] * packet.velocity(t) + turned[k] * across * packet.displacement(t), 40, delay)
            yield {"where": where, "velocity": {axis: amplitude}, "time": motion}


def whole(length, zone):
    return zone * math.ceil(length / zone)
