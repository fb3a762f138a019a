"""The ring of cases/qingcaosha/ovaling under far-field shear: thrust and moment in beams, zones and particles.

Both vary as sin 2 theta around the ring; the functions return amplitudes (thrust [N], moment [N m], per metre).
"""
import numpy as np

from adit.cases.tunnels import lined_tunnel


def amplitude(angle, values):
    """Amplitude of sin 2 theta in values at equal distances around the ring."""
    return 2 * np.mean(values * np.sin(2 * angle))


def of_beams(run):
    degrees, thrust, moment, _ = lined_tunnel.around(run)
    return tuple(amplitude(np.radians(degrees), values) for values in (thrust, moment))


def around(run, force, lining="ring"):
    """(angles of the sections of a lining of `tunnels`, a force in them: a row for each time)."""
    columns = [name for name in run.histories if name.startswith(f"{lining}_section_") and name.endswith(force)]
    return 2 * np.pi * np.arange(len(columns)) / len(columns), np.array([run.histories[name] for name in columns]).T


def of_particles(run):
    thrust, moment = (around(run, force) for force in ("thrust_N", "moment_Nm"))
    return tuple(amplitude(angle, values[0]) for angle, values in (thrust, moment))


def of_zones(run, inner, outer):
    """From the hoop stress in the layers of zones between two radii [m], all of one thickness."""
    *_, (_, pieces) = run.snapshots()
    grid = pieces["grid"]
    x, y = grid.points[grid.cells].mean(axis=1).T
    radius, angle, (xx, yy, xy) = np.hypot(x, y), np.arctan2(y, x), grid.field("stress_Pa").T
    hoop = xx * np.sin(angle)**2 + yy * np.cos(angle)**2 - xy * np.sin(2 * angle)
    layers = [np.isclose(radius, r, atol=1e-5) for r in np.unique(radius[(radius > inner) & (radius < outer)].round(5))]
    stress = [amplitude(angle[layer], hoop[layer]) for layer in layers]
    slope, _ = np.polyfit([radius[layer].mean() for layer in layers], stress, 1)
    thickness = outer - inner
    return np.mean(stress) * thickness, slope * thickness**3 / 12


def annulus(ring, ground, inner, outer, shear, excavated=False):
    """(thrust, moment) of an elastic annulus bonded to infinite ground under a shear stress [Pa] far away, or, if `excavated`, that
    stands before the opening takes this stress away, so that the ground is strained by the opening alone.

    `ring`, `ground`: (Young's modulus, Poisson's ratio). Michell's solution; tests/verification/lined_tunnel/bonded_annulus.hpp
    derives it.
    """
    def terms(r, ratio):  # s_r, s_rt, 2G u_r, 2G u_t by c_1 to c_4
        k = 3 - 4 * ratio
        return np.array([[-2, 0, -6 / r**4, -4 / r**2], [2, 6 * r**2, -6 / r**4, -2 / r**2],
                         [-2 * r, (k - 3) * r**3, 2 / r**3, (k + 1) / r], [2 * r, (k + 3) * r**3, 2 / r**3, -(k - 1) / r]])

    stiffness = [young / (1 + ratio) for young, ratio in (ring, ground)]
    face = terms(outer, ring[1])
    face[2:] *= stiffness[1] / stiffness[0]
    beyond = terms(outer, ground[1])
    far = beyond[:, 0] * ([1, 1, 0, 0] if excavated else 1)
    c = np.linalg.solve(np.block([[terms(inner, ring[1])[:2], np.zeros((2, 2))], [face, -beyond[:, 2:]]]),
                        np.concatenate([np.zeros(2), -shear / 2 * far]))

    def hoop(r):  # integrals of s_t and of s_t r
        return np.array([2 * c[0] * r + 4 * c[1] * r**3 - 2 * c[2] / r**3, c[0] * r**2 + 3 * c[1] * r**4 - 3 * c[2] / r**2])

    thrust, about_centre = hoop(outer) - hoop(inner)
    return thrust, about_centre - (inner + outer) / 2 * thrust


def excavated_annulus(ring, ground, inner, outer, mean, shear):
    """[mean thrust, amplitudes of thrust and moment], without sign, of the annulus that stands before the opening takes away a
    pressure `mean` and a shear stress `shear` [Pa]. The pressure p that it bears follows from Lame's tube: the ground moves by
    (mean - p) b/2G."""
    shear_moduli = [young / (2 * (1 + ratio)) for young, ratio in (ring, ground)]
    tube = ((1 - 2 * ring[1]) * outer**2 + inner**2) / (outer**2 - inner**2)
    pressure = mean / (1 + shear_moduli[1] / shear_moduli[0] * tube)
    return np.array([pressure * outer, *np.abs(annulus(ring, ground, inner, outer, shear, excavated=True))])


def closed_forms(beams, inner, outer):
    """Yields (name, (thrust, moment)) for the lining and the ground of the run with beams, between two radii [m]."""
    tunnel, strain = lined_tunnel.Tunnel.of(beams), lined_tunnel.far_strain(beams)
    lining, ground = beams.scene["continuum"]["linings"][0], beams.scene["material"]
    yield "Wang, Penzien", (-strain * lined_tunnel.wang_thrust(tunnel), strain * lined_tunnel.penzien_moment(tunnel))
    thrust, moment, _ = lined_tunnel.full_solution(tunnel)
    yield "full solution, ring of beams", (-strain * thrust, strain * moment)
    yield "annulus", annulus((lining["young_modulus"], 0.2), (ground["young_modulus"], ground["poisson_ratio"]), inner, outer,
                             strain * tunnel.shear_modulus)
