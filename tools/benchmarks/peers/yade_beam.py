"""Runs inside Yade: yade -x -n yade_beam.py BEAM.json RESULT.json. A beam of discs that unbreakable bonds join.

BEAM: places [[x, y], …] and radius [m], mass [kg], inertia [kg m^2], normal_stiffness and shear_stiffness [N/m],
dt [s], steps; if any, fixed (numbers of discs that stay where they are), load {discs, force: [x, y] of each [N]}
from time 0, and watched, a number. RESULT: cpu_s of the steps, bonds, and displacement, (x, y) of the watched disc at
the times 0, dt, 2 dt, … [m].
"""

import json
import os
import sys
import time

from yade import (Bo1_Sphere_Aabb, CohFrictMat, ForceResetter, Ig2_Sphere_Sphere_ScGeom6D, InsertionSortCollider,
                  InteractionLoop, Ip2_CohFrictMat_CohFrictMat_CohFrictPhys, Law2_ScGeom6D_CohFrictPhys_CohesionMoment,
                  NewtonIntegrator, O, Vector3, utils)

NEAR = 1.05  # discs closer than this times the sum of their radii are bonded and count as neighbours


def build(beam):
    stiffness, radius = beam["normal_stiffness"], beam["radius"]
    # Yade's contact of two equal spheres has kn = young R and ks = poisson kn.
    material = O.materials.append(CohFrictMat(young=stiffness / radius, poisson=beam["shear_stiffness"] / stiffness,
                                              normalCohesion=1e40, shearCohesion=1e40, momentRotationLaw=False,
                                              isCohesive=True))
    discs = [utils.sphere((x, y, 0), radius, material=material) for x, y in beam["places"]]
    O.bodies.append(discs)
    for disc in discs:
        disc.state.mass, disc.state.inertia = beam["mass"], Vector3(1, 1, 1) * beam["inertia"]
        disc.state.blockedDOFs = "zXY"
    for i in beam.get("fixed", []):
        discs[i].state.blockedDOFs = "xyzXYZ"
    load = beam.get("load", {"discs": []})
    for i in load["discs"]:
        force = Vector3(*load["force"], 0)
        O.forces.setPermF(i, force)
        # The leap-frog's start from rest: v(-1/2) = -v(1/2).
        discs[i].state.vel = -force * beam["dt"] / (2 * beam["mass"])
    O.dt = beam["dt"]
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=NEAR)], verletDist=0.05 * radius),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=NEAR)],
                        [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)],
                        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
        NewtonIntegrator(damping=0)]


def run(beam):
    if "watched" not in beam:
        O.run(2, True)  # finds the contacts and bonds them
        start = time.process_time()
        O.run(beam["steps"], True)
        return {"cpu_s": time.process_time() - start}
    watched, path = O.bodies[beam["watched"]].state, [[0.0, 0.0]]
    for _ in range(beam["steps"]):
        O.step()
        moved = watched.pos - watched.refPos
        path.append([moved[0], moved[1]])
    # A step of Yade ends with the move: the first one, by v(1/2), to the time dt.
    return {"displacement": path}


source, target = sys.argv[-2:]
with open(source, encoding="utf-8") as file:
    described = json.load(file)
build(described)
result = run(described)
result["bonds"] = sum(1 for contact in O.interactions if contact.isReal)
with open(target, "w", encoding="utf-8") as file:
    json.dump(result, file)
os._exit(0)  # skips Yade's own exit, which waits for its prompt
