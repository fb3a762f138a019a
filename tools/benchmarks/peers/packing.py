"""LAMMPS and our general engine on the same packing: discs of many sizes press each other and four walls, with friction and
without bonds, and stay in contact. One thread; measured is the CPU time of the steps alone.

Our bench writes its discs, x y radius mass a line, for LAMMPS, whose contacts at the end must be about as many as ours.
"""

import json
import math
import pathlib
import subprocess
import tempfile

from benchmarks.peers.alternate import Pair
from benchmarks.peers.particles import DT, LAMMPS, STIFFNESS, compute, cpu_seconds, installed

STEPS = 100
NEAR = 0.05  # contacts at the end may differ by this share: our bench takes more steps, and the packing is not quite at rest
INPUT = """
atom_style sphere
dimension 2
units si
boundary f f p
newton off
comm_modify vel yes
read_data packing.data
neighbor 0.05 bin
pair_style gran/hooke/history {kn} {kt} 0 0 0.5 0
pair_coeff * *
fix left all wall/gran hooke/history {kn} {kt} 0 0 0.5 0 xplane 0 {x_max}
fix below all wall/gran hooke/history {kn} {kt} 0 0 0.5 0 yplane 0 {y_max}
fix move all nve/sphere
fix plane all enforce2d
compute touching all contact/atom
compute ends all reduce sum c_touching
thermo_style custom step c_ends
thermo 100000
timestep {dt}
run STEPS
"""


def pairs(root, discs, rows):
    name = "LAMMPS granular with history"
    if not installed(LAMMPS, name):
        return []
    packing = Packing(root, discs, rows)
    return [Pair("packing with friction", packing.ours()["particles"], "particle-steps/s", "general engine", packing.our_speed, name,
                 packing.peer_speed)]


class Packing:
    def __init__(self, root, discs, rows):
        self.program = root / "build/release/tests/bench/particles_bench"
        self.size = discs, rows
        self.folder = tempfile.TemporaryDirectory()
        self.discs = pathlib.Path(self.folder.name) / "discs"

    def ours(self):
        return json.loads(subprocess.run([self.program, "packing", *map(str, self.size), "1", self.discs],
                                         check=True, capture_output=True, text=True).stdout)

    def our_speed(self):
        m = self.ours()
        self.contacts = m["contacts"][1]
        return m["steps_per_s"] * m["particles"]

    def peer_speed(self):
        x_max, y_max = self.size[0], math.sqrt(3) / 2 * self.size[1]
        discs = self.discs.read_text().splitlines()
        script = INPUT.format(kn=STIFFNESS, kt=STIFFNESS / 3, dt=DT, x_max=x_max, y_max=y_max)
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "packing.data").write_text(data(discs, x_max, y_max))
            seconds = -cpu_seconds(LAMMPS, script, folder, 0) + cpu_seconds(LAMMPS, script, folder, STEPS)
            touching = contacts(compute(LAMMPS, folder))
        if abs(touching - self.contacts) > NEAR * self.contacts:
            raise RuntimeError(f"the packing ends with {touching} contacts in LAMMPS, and with {self.contacts} in ours")
        return len(discs) * STEPS / seconds


def contacts(printed):
    """Contacts of discs at the end of a run: each disc counts its own."""
    lines = printed.splitlines()
    last = next(k for k, line in enumerate(lines) if line.startswith("Loop time")) - 1
    return float(lines[last].split()[1]) / 2


def data(discs, x_max, y_max):
    lines = ["packing", "", f"{len(discs)} atoms", "1 atom types", f"0 {x_max} xlo xhi", f"0 {y_max} ylo yhi",
             "-0.5 0.5 zlo zhi", "", "Atoms", ""]
    for i, disc in enumerate(discs, 1):
        x, y, radius, mass = map(float, disc.split())
        lines.append(f"{i} 1 {2 * radius!r} {mass / (math.pi * 4 / 3 * radius**3)!r} {x!r} {y!r} 0")
    return "\n".join(lines) + "\n"
