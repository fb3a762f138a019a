"""Zones of FEniCSx: their form, their division among the ranks, their forces."""
import numpy as np
import ufl
from dolfinx import fem
from dolfinx.fem import petsc
from dolfinx.mesh import create_mesh
from mpi4py import MPI
from petsc4py import PETSc

ELEMENT = ufl.VectorElement("Lagrange", ufl.quadrilateral, 1)
CORNERS = [0, 1, 3, 2]  # counter-clockwise ones in the order of FEniCSx


def stiffness(space, kappa, mu):
    """The mean strain of a zone, and in-plane bending without shear (adapters/python/continuum.py): exx and eyy of a rectangle
    less their means are its bending. `kappa` and `mu` are the moduli of stress in the plane [Pa]."""
    u, v = ufl.TrialFunction(space), ufl.TestFunction(space)
    middle, four = (ufl.dx(metadata={"quadrature_degree": degree}) for degree in (1, 2))  # points of the quadrature
    strain, virtual = ufl.sym(ufl.grad(u)), ufl.sym(ufl.grad(v))
    stress = (kappa - mu) * ufl.tr(strain) * ufl.Identity(2) + 2 * mu * strain
    young = 4 * kappa * mu / (kappa + mu)  # of uniaxial stress in the plane
    bending = young * (strain[0, 0] * virtual[0, 0] + strain[1, 1] * virtual[1, 1])
    return ufl.inner(stress, virtual) * middle + bending * four - bending * middle


class Zones:
    """A mesh divided among the ranks. `own` and `zones` are the numbers in the whole grid of this rank's points and zones;
    arrays over its points have the order of `own`."""

    def __init__(self, ranks, points, zones, kappa, mu):
        def share(array):
            return np.array_split(array, ranks.size)[ranks.rank]

        mesh = create_mesh(ranks, share(zones[:, CORNERS].astype(np.int64)), share(points), ufl.Mesh(ELEMENT))
        space, constants = fem.FunctionSpace(mesh, ELEMENT), fem.FunctionSpace(mesh, ("DG", 0))
        number = np.array(mesh.topology.original_cell_index)
        self.zones = number[:mesh.topology.index_map(2).size_local]
        point_of = np.empty(len(mesh.geometry.x), np.int64)
        point_of[space.dofmap.list.array] = np.array(mesh.geometry.input_global_indices)[mesh.geometry.dofmap.array]
        self.own = point_of[:space.dofmap.index_map.size_local]

        moduli = fem.Function(constants), fem.Function(constants)
        for function, values in zip(moduli, (kappa, mu)):
            function.x.array[constants.dofmap.list.array] = values[number]
        form = fem.form(stiffness(space, *moduli))
        self.matrix = petsc.create_matrix(form, "baij")  # of 2 x 2 blocks: a third faster than one without
        petsc.assemble_matrix(self.matrix, form)
        self.matrix.assemble()
        self.found = self.matrix.createVecLeft()

    def follow(self, displacements):
        """Forces are those at what this array holds."""
        self.displacements = PETSc.Vec().createWithArray(displacements, bsize=2, comm=self.matrix.comm)

    def forces(self):
        """Of the zones on this rank's points [N], until the next call."""
        self.matrix.mult(self.displacements, self.found)
        return np.negative(self.found.array, out=self.found.array).reshape(-1, 2)


def highest_eigenvalue(size, kappa, mu, density):
    """Of one zone with a quarter of its mass at each corner [1/s^2]. No eigenvalue of a grid is above the highest of its zones,
    whatever their weights, which multiply both stiffness and mass (Irons and Treharne)."""
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]]) * size
    zone = Zones(MPI.COMM_SELF, corners, np.array([[0, 1, 2, 3]]), np.array([kappa]), np.array([mu]))
    return np.linalg.eigvalsh(zone.matrix[:, :])[-1] / (density * size.prod() / 4)
