"""A bar whose ends and middle are zones or particles."""

import numpy as np

from figures.discs import point

RADIUS = 10 / 156
HEIGHT = 9 * np.sqrt(3) * RADIUS
YOUNG, POISSON, DENSITY = 25e9, 0.2, 2500.0
STEP = 1e-5
ZONES_X, ZONES_Y = 20, 4


def discs(begin, end, **others):
    return {"packing": {"x_min": begin, "x_max": end, "y_min": 0, "y_max": HEIGHT, "radius": RADIUS}} | others


def overlap(begin, end, **others):
    return {"overlap": {"particles_begin": point((begin, 0)), "continuum_ends": point((end, 0))}} | others


def bar(duration, continuum=(), **others):
    """Of zones, 10 m long; `others`: the particles and how they are joined."""
    return {
        "plane": "plane_stress", "material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY},
        "time": {"duration": duration, "dt": STEP},
        "continuum": {"block": {"x_min": 0, "x_max": 10, "y_min": 0, "y_max": HEIGHT, "zones_x": ZONES_X, "zones_y": ZONES_Y}} | dict(continuum),
        "output": {"history_interval": STEP, "field_times": [duration - STEP, duration]}} | others


def masses_of_points(grid):
    """With their weights."""
    masses = np.zeros(len(grid.points))
    np.add.at(masses, grid.cells, DENSITY * 10 / ZONES_X * HEIGHT / ZONES_Y / 4 * grid["weight"][:, None])
    return masses


def masses_of_discs(particles):
    return DENSITY * 2 * np.sqrt(3) * RADIUS**2 * particles["weight"]


def kinetic_energy(masses, before, after):
    """In the form that the scheme keeps, of the velocities half a step before and after; discs turn, too."""
    twice = np.sum(masses[:, None] * before["velocity_m_per_s"] * after["velocity_m_per_s"])
    if "spin_rad_per_s" in after.point_fields:
        twice += np.sum(masses * RADIUS**2 / 2 * before["spin_rad_per_s"] * after["spin_rad_per_s"])
    return twice / 2
