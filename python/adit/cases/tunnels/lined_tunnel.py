"""The tunnel of cases/lined_tunnel: results of its runs, and closed forms for a circular lining in sheared ground.

All are by the far field's engineering shear strain gamma = 1. Turned by 45 degrees the shear is a tension along x and as
much compression along y; thrust and moment follow cos 2 theta of that frame, the shear force sin 2 theta.

Wang 1993 (Parsons Brinckerhoff monograph 7), as in Hashash et al. 2001; Penzien 2000 (Earthquake Eng. Struct. Dyn. 29). Their
moment and Penzien's thrust simplify; `full_solution` does not: the plate with Airy's function (A + B/r^2) cos 2 theta on
top of the far field, and Timoshenko's ring, joined without slip or free to slip; derived in
tests/verification/lined_tunnel/ovaling.hpp.
"""
from dataclasses import dataclass

import numpy as np


@dataclass
class Tunnel:
    shear_modulus: float  # shear modulus of the ground [Pa]
    poisson: float
    radius: float  # radius of the lining's axis [m]
    axial: float  # EA, EI and G A_s of the lining in plane strain, per metre
    bending: float
    shear: float

    @classmethod
    def of(cls, run):
        """The tunnel in the scene of a run."""
        lining = run.scene["continuum"]["linings"][0]
        return cls.ring(run.scene["material"], lining, lining["along"]["circle"]["radius"])

    @classmethod
    def ring(cls, ground, lining, radius):
        """A ring whose axis has this radius [m]; `ground`, `lining`: their elastic constants, and the thickness, as in a scene."""
        young, ratio, thickness = lining["young_modulus"], lining.get("poisson_ratio", 0.2), lining["thickness"]
        plane = young / (1 - ratio**2)
        return cls(ground["young_modulus"] / (2 * (1 + ground["poisson_ratio"])), ground["poisson_ratio"], radius, plane * thickness,
                   plane * thickness**3 / 12, young / (2 * (1 + ratio)) * thickness * 5 / 6)

    @property
    def compressibility(self):
        return 2 * self.shear_modulus * self.radius / (self.axial * (1 - 2 * self.poisson))

    @property
    def flexibility(self):
        return self.shear_modulus * self.radius**3 / (3 * self.bending)


def wang_thrust(t):
    """Thrust without slip [N per metre]."""
    nu, n, c, f = t.poisson, 1 - 2 * t.poisson, t.compressibility, t.flexibility
    k = 1 + (f * (n - n * c) - n**2 / 2 + 2) / (f * (3 - 2 * nu + n * c) + c * (2.5 - 8 * nu + 6 * nu**2) + 6 - 8 * nu)
    return k * t.shear_modulus * t.radius


def wang_moment(t):
    """Moment with full slip [N m per metre]."""
    return 4 * (1 - t.poisson) / (2 * t.flexibility + 5 - 6 * t.poisson) * t.shear_modulus * t.radius**2


def penzien_moment(t):
    """Moment without slip [N m per metre]."""
    d = 2 * t.radius
    return 3 * t.bending / d * 4 * (1 - t.poisson) / (24 * t.bending * (3 - 4 * t.poisson) / (d**3 * t.shear_modulus) + 1)


def full_solution(t, slips=False, excavated=False):
    """(thrust, moment, shear force) [N, N m, N per metre], largest around the ring, without sign. A ring that slips on the ground
    has a motion of its own around the ring, and no shear stress there. `excavated`: the ground is stressed first, and the ring
    stands before the opening takes the stress away, so that it follows the motion from then on only."""
    r, g, kappa = t.radius, t.shear_modulus, 3 - 4 * t.poisson
    before = 0 if excavated else 1
    turned = 4 * t.bending / (t.shear * r**2)

    def forces(far, a, b, slip=0):  # a = A/r^2, b = B/r^4
        u = r * (before * far + (kappa + 1) * a + 2 * b) / (2 * g)
        v = r * (-before * far - (kappa - 1) * a + 2 * b + slip) / (2 * g)
        return t.axial * (u + 2 * v) / r, 4 * t.bending * (v + 2 * u) / (r**3 * (1 + turned))

    def imbalance(*of):  # of radial and tangential stress between ring and ground, and what slip leaves of the latter
        far, a, b, _ = of
        thrust, shear = forces(*of)
        tangential = -far - 2 * a - 6 * b
        return np.array([(thrust + 2 * shear) / r - (far - 4 * a - 6 * b), (2 * thrust + shear) / r - tangential, tangential])

    count = 3 if slips else 2
    slopes = np.stack([imbalance(0, *one)[:count] for one in np.eye(3)[:count]], axis=1)
    found = np.linalg.solve(slopes, -imbalance(g, 0, 0, 0)[:count])
    thrust, shear = forces(g, *found)
    return abs(thrust), abs(shear * r / 2), abs(shear)


def excavation_forces(t, mean, shear, slips=False):
    """[mean thrust, amplitudes of thrust, moment and shear force], without sign, of a ring that stands before the opening takes away
    the stress: a pressure `mean` and a shear stress `shear` [Pa]. Under the pressure p that the ring leaves to bear, the ground
    moves by (mean - p) r/2G, and the ring by p r^2/EA."""
    thrust = mean * t.radius / (1 + 2 * t.shear_modulus * t.radius / t.axial)
    return np.array([thrust, *np.array(full_solution(t, slips, excavated=True)) * shear / t.shear_modulus])


def around(run):
    """(angle from x [deg], thrust, moment, shear force) at the lining's nodes, in the last snapshot."""
    lining = run.fields()["linings"]
    angle = np.degrees(np.arctan2(lining.points[:, 1], lining.points[:, 0])) % 360
    order = np.argsort(angle)
    return angle[order], *(lining.field(name)[order] for name in ("thrust_N", "moment_Nm", "shear_N"))


def far_strain(run):
    """Shear strain of the ground far away, from the loads on its sides."""
    load, block = run.scene["continuum"]["edge_loads"][0], run.scene["continuum"]["blocks"][0]
    return load["force"]["x"] / block["ring"]["outer_side"] / Tunnel.of(run).shear_modulus


def free_strain(run):
    """Shear strain of the free field at the tunnel's depth, over time."""
    height = {place["name"]: place["at"]["y"] for place in run.scene["continuum"]["histories"]}
    h = run.histories
    return (h["free_above_ux_m"] - h["free_below_ux_m"]) / (height["free_above"] - height["free_below"])


def compare(ovaling, shear_wave):
    """Rows (what, unit, closed form, its value, found), of both runs."""
    t, strain = Tunnel.of(ovaling), far_strain(ovaling)
    full, (_, *found) = full_solution(t), around(ovaling)
    forms = ((("Wang, no slip", wang_thrust(t)), ("full solution", full[0])),
             (("Penzien, no slip", penzien_moment(t)), ("Wang, full slip", wang_moment(t)), ("full solution", full[1])),
             (("full solution", full[2]),))
    names = (("thrust", "kN"), ("moment", "kN m"), ("shear force", "kN"))
    for (name, unit), values, known in zip(names, found, forms):
        for form, amplitude in known:
            yield f"at rest: {name}", unit, form, strain * amplitude / 1e3, np.abs(values).max() / 1e3
    strain, h = np.abs(free_strain(shear_wave)).max(), shear_wave.histories
    for column, (name, unit), (form, amplitude) in (("pulled_thrust_N", names[0], forms[0][0]),
                                                    ("pulled_moment_Nm", names[1], forms[1][0])):
        yield f"wave: {name}", unit, form, strain * amplitude / 1e3, np.abs(h[column]).max() / 1e3
