#!/usr/bin/python3
"""Yade as the particles of a coupled run: a hexagonal packing of equal discs whose bonds do not break.

    adapters/yade/participant.py --listen 127.0.0.1:4712 &
    coupler run cases/cantilever/variants/coupled_52x6.yaml --dem 127.0.0.1:4712

Yade finds the contacts, computes the forces of the bonds and integrates the motion. The template of a particle code
(adapters/python/particles.py) reads the scene and keeps the conversation, the loads and the energies.
"""
import contextlib
import os
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "python"))
from particles import COMPUTED, Particles, keys, scene  # noqa: E402
from wire import SceneError, serve  # noqa: E402

os.environ.setdefault("OMP_NUM_THREADS", "1")  # threads that wait for one another by spinning slow a small model down
sys.path += map(str, Path("/usr/lib").glob("*/yade-double/py"))
try:
    with contextlib.redirect_stdout(sys.stderr):  # standard output is for the address
        # As a module: the program `yade` listens at two ports of all networks, to whoever knows a cookie or nothing.
        from yade import (Bo1_Sphere_Aabb, CohFrictMat, ForceResetter, Ig2_Sphere_Sphere_ScGeom6D, InsertionSortCollider,
                          InteractionLoop, Ip2_CohFrictMat_CohFrictMat_CohFrictPhys, Law2_ScGeom6D_CohFrictPhys_CohesionMoment,
                          NewtonIntegrator, O, PyRunner, Vector3, utils)
except ImportError as reason:
    sys.exit(f"Yade cannot be used ({reason}): install the Debian package yade")

NEAR = 1.05  # discs closer than this times the sum of their radii are bonded


def in_plane(vectors):
    """x and y of Yade's vectors, a row for each."""
    return np.array([(vector[0], vector[1]) for vector in vectors])


class YadeParticles(Particles):
    def setup(self, request, model):
        super().setup(request, model)
        for name in ("tensile_strength", "shear_strength"):
            if np.isfinite(getattr(self.laws, name)):
                raise SceneError(f"particles.bonds.{name}", "is finite, but the bonds of this participant do not break; give inf, "
                                 "or use another participant")

    def weights(self, request, interface):
        super().weights(request, interface)
        O.reset()
        # Yade's contact of two equal spheres has kn = young R and ks = poisson kn.
        material = O.materials.append(CohFrictMat(young=self.kn / self.radius, poisson=self.ks / self.kn, frictionAngle=0,
                                                  normalCohesion=1e40, shearCohesion=1e40, momentRotationLaw=False, isCohesive=True))
        O.bodies.append([utils.sphere((x, y, 0), self.radius, material=material) for x, y in self.centres])
        self.states = [body.state for body in O.bodies]
        for state, (mass, _, inertia), fixed in zip(self.states, self.masses, self.inverse == 0):
            state.mass, state.inertia = mass, Vector3(inertia, inertia, inertia)
            state.blockedDOFs = "zXY" + "".join(name for name, held in zip("xyZ", fixed) if held)
        to_prescribe = PyRunner(command="running.before_kick()", iterPeriod=1, dead=True)
        O.engines = [
            ForceResetter(),
            InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=NEAR)], verletDist=0.05 * self.radius),
            InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=NEAR)],
                            [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)],
                            [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
            to_prescribe,
            NewtonIntegrator(damping=0)]
        O.dt = 1e-12
        O.step()  # finds the bonds, at rest
        self.contacts = [O.interactions[int(first), int(second)] for first, second in self.bonds]
        for contact, weight in zip(self.contacts, self.bond_weights):
            contact.phys.kn, contact.phys.ks = weight * self.kn, weight * self.ks
        globals()["running"], to_prescribe.dead = self, False

    def correct(self, impulses):
        """Yade has moved already, by the velocities that the impulses change."""
        predicted = self.v.copy()
        super().correct(impulses)
        for i in np.flatnonzero((self.v != predicted).any(axis=1)):
            change = Vector3(*(self.v[i] - predicted[i])[:2], 0)
            self.states[i].vel += change
            self.states[i].pos += self.dt * change

    def integrate(self, n):
        """A step of Yade ends with the move to n + 1: how far the discs are before it is the displacement at n."""
        self.u[:, :2] = in_plane(state.pos - state.refPos for state in self.states)
        applied = np.zeros_like(self.places)
        for load in self.loads:
            applied[load.points] += load.last * load.forces
        for i in np.flatnonzero(applied.any(axis=1)):
            O.forces.setPermF(int(i), Vector3(*applied[i], 0))
        O.dt, self.now = self.dt, n
        O.step()
        self.v = np.column_stack([in_plane(state.vel for state in self.states), [state.angVel[2] for state in self.states]])
        self.read_bonds()
        return self.forces()

    @staticmethod
    def forces():
        discs = range(len(O.bodies))
        return np.column_stack([in_plane(map(O.forces.f, discs)), [O.forces.t(i)[2] for i in discs]])

    def before_kick(self):
        """Called by Yade between its forces and Newton's law, where velocities still are those of n - 1/2."""
        v = -self.kick * self.inverse * self.forces() if self.now == 0 else self.v.copy()  # from rest v(-1/2) = -v(1/2)
        for motion in self.motions:
            v[motion.where] = motion.velocity * motion.factor((self.now + 0.5) * self.dt)
        for state, (x, y, spin) in zip(self.states, v):
            state.vel, state.angVel = Vector3(x, y, 0), Vector3(0, 0, spin)

    def read_bonds(self):
        """Tension and shear of each bond as without its weight [N]."""
        along = in_plane(contact.geom.normal for contact in self.contacts)
        across = np.stack([-along[:, 1], along[:, 0]], axis=1)
        self.normal = -np.sum(along * in_plane(contact.phys.normalForce for contact in self.contacts), axis=1) / self.bond_weights
        self.shear = np.sum(across * in_plane(contact.phys.shearForce for contact in self.contacts), axis=1) / self.bond_weights


if __name__ == "__main__":
    serve("yade_particles", YadeParticles, list(keys(scene.Scene.DESCRIPTOR, COMPUTED)))
