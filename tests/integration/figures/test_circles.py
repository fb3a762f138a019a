"""Means over a circle of particles are those of its definition: stress of forces and branches, strain rate of a linear motion,
coordination by weight, porosity by area."""

import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.discs import DENSITY, driven, point, scene

STEP, END = 1e-4, 2e-3
CENTRE, CIRCLE = np.array([1.2, 0.9]), 2.0
PLACES = np.array([(i + 0.5 * (j % 2), 0.5 * np.sqrt(3) * j) for j in range(5) for i in range(5)]) - [0.7, 0.6]  # a lattice of discs that touch
GRADIENT = np.array([(3e-3, -5e-3), (1e-3, -2e-3)])  # of the velocity
QUANTITIES = {"stress_xx": "sxx_Pa", "stress_yy": "syy_Pa", "stress_xy": "sxy_Pa", "strain_rate_xx": "exx_per_s", "strain_rate_yy": "eyy_per_s",
              "shear_strain_rate_xy": "gxy_per_s", "coordination": "contacts", "porosity": "porosity"}


def weight(places):
    """3 (1 - r²/R²)² / πR² inside the circle."""
    inside = 1 - np.sum((places - CENTRE)**2, axis=-1) / CIRCLE**2
    return 3 / np.pi / CIRCLE**2 * np.maximum(inside, 0)**2


class Circles(ComputedTest):
    def test_of_a_lattice_that_is_strained(self):
        table = "x_m,y_m,radius_m\n" + "".join(f"{x},{y},0.5\n" for x, y in PLACES)
        self.computed(scene(
            END, STEP, bonds={"normal_stiffness": 1e8, "shear_stiffness": 4e7},
            motions=[driven(p, GRADIENT @ p) for p in PLACES],
            histories=[{"name": "c", "quantity": what, "at": point(CENTRE), "radius": CIRCLE} for what in QUANTITIES]), discs=table)
        found = {name: self.run.histories[f"c_{name}"][-1] for name in QUANTITIES.values()}
        fields = self.run.fields()
        bonds, particles = fields["bonds"], fields["particles"]
        now = particles.points + particles["displacement_m"][:, :2]
        first, second = now[bonds.cells[:, 0]], now[bonds.cells[:, 1]]
        branch = second - first
        n = branch / np.linalg.norm(branch, axis=1)[:, None]
        force = bonds["normal_force_N"][:, None] * n + bonds["shear_force_N"][:, None] * np.column_stack([-n[:, 1], n[:, 0]])  # on the first
        along = (np.arange(2000) + 0.5) / 2000
        mean = np.array([weight(a + along[:, None] * (b - a)).mean() for a, b in zip(first, second)])
        stress = np.einsum("k,ki,kj->ij", mean, force, branch)
        size = np.abs(stress).max()
        for name, value in (("sxx_Pa", stress[0, 0]), ("syy_Pa", stress[1, 1]), ("sxy_Pa", (stress[0, 1] + stress[1, 0]) / 2)):
            self.assertAlmostEqual(found[name], value, delta=1e-6 * size, msg=name)
        # That of the solid which the lattice is: lambda = sqrt(3)/4 (kn - ks), mu = sqrt(3)/4 (kn + ks).
        strain = END * (GRADIENT + GRADIENT.T) / 2
        solid = np.sqrt(3) / 4 * (6e7 * np.trace(strain) * np.eye(2) + 2 * 14e7 * strain)
        np.testing.assert_allclose([found["sxx_Pa"], found["syy_Pa"], found["sxy_Pa"]], [solid[0, 0], solid[1, 1], solid[0, 1]], atol=0.03 * size)
        for name, value in (("exx_per_s", GRADIENT[0, 0]), ("eyy_per_s", GRADIENT[1, 1]), ("gxy_per_s", GRADIENT[0, 1] + GRADIENT[1, 0])):
            self.assertAlmostEqual(found[name], value, delta=1e-7, msg=name)
        neighbours = np.bincount(bonds.cells.ravel(), minlength=len(now))
        np.testing.assert_array_equal(particles["coordination"], neighbours)
        self.assertAlmostEqual(found["contacts"], np.average(neighbours, weights=weight(now)), delta=1e-9)
        self.assertAlmostEqual(found["porosity"], self.porosity(now), delta=2e-3)
        self.stresses_of_particles(bonds, particles, first, second, force)

    @staticmethod
    def porosity(now):
        """The share of points of a fine net that no disc covers."""
        net = np.linspace(-CIRCLE, CIRCLE, 1201)
        x, y = np.meshgrid(net, net)
        points = np.column_stack([x.ravel(), y.ravel()])[x.ravel()**2 + y.ravel()**2 < CIRCLE**2] + CENTRE
        covered = np.zeros(len(points), bool)
        for place in now:
            covered |= np.sum((points - place)**2, axis=1) < 0.25
        return 1 - covered.mean()

    @staticmethod
    def stresses_of_particles(bonds, particles, first, second, force):
        """Each bears the forces at the places where it meets others, over its area."""
        moments = np.zeros((len(particles.points), 2, 2))
        middle = (first + second) / 2
        for (i, j), a, b, m, f in zip(bonds.cells, first, second, middle, force):
            moments[i] += np.outer(m - a, f)
            moments[j] += np.outer(m - b, -f)
        stress = (moments + moments.transpose(0, 2, 1)) / 2 / (np.pi * 0.25)
        expected = np.column_stack([stress[:, 0, 0], stress[:, 1, 1], stress[:, 0, 1]])
        np.testing.assert_allclose(particles["stress_Pa"], expected, atol=1e-6 * np.abs(expected).max())

    def test_the_energy_of_its_bonds(self):
        """Of two discs, kn e²/2 + ks s²/2."""
        first, second, velocity = (0, 0), (1, 0), (2e-3, 3e-3)
        self.computed(scene(END, STEP, bonds={"normal_stiffness": 1e8, "shear_stiffness": 4e7}, motions=[driven(first), driven(second, velocity)]),
                      discs="x_m,y_m,radius_m\n0,0,0.5\n1,0,0.5\n")
        t = self.time
        stored = (1e8 * velocity[0]**2 + 4e7 * velocity[1]**2) * t**2 / 2
        kinetic = DENSITY * np.pi * 0.25 / 2 * (velocity[0]**2 + velocity[1]**2)
        self.told_energies(size=stored[-1], tolerance=1e-4, contact_bonds=stored, motions=stored + np.where(t > 0, kinetic, 0))


if __name__ == "__main__":
    unittest.main()
