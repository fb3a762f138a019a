"""Other particle codes and ours on the same beam of touching discs, one thread: Yade (bonds with shear and spin), LAMMPS (central
springs; discs that touch with history) and LIGGGHTS (discs that touch with history). Those that are not installed are
left out, saying so.

Their discs are spheres kept in a plane; a row of touching spheres has as many contacts as the beam has bonds. Measured
is the CPU time of the steps alone, so that other work on the machine does not count.
"""

import ctypes.util
import json
import math
import pathlib
import resource
import shutil
import subprocess
import sys
import tempfile

from benchmarks.peers.alternate import Pair

STEPS, STEPS_OF_YADE = 2000, 200
RADIUS, MASS, STIFFNESS = 0.5, 2000.0, 1.8e10
DT = 0.05 * math.sqrt(MASS / STIFFNESS)

HEAD = """
atom_style {style}
atom_modify map array
dimension 2
units si
boundary f f p
newton {newton}
{communicate}
read_data beam.data
neighbor 0.125 bin
"""
SPRINGS = HEAD + """
pair_style none
bond_style harmonic
bond_coeff 1 {half} 1.0
comm_modify cutoff 2.0
velocity all create 1e-3 4711 dist uniform
fix move all nve
fix plane all enforce2d
thermo 100000
timestep {dt}
run {steps}
"""
DISCS = HEAD + """
{contacts}
velocity all set 1e-3 0 0
fix move all nve/sphere
fix plane all enforce2d
thermo 100000
timestep {dt}
run {steps}
"""
LAMMPS_CONTACTS = f"pair_style gran/hooke/history {STIFFNESS} {STIFFNESS / 3} 0 0 0.5 0\npair_coeff * *"
LIGGGHTS_CONTACTS = """hard_particles yes
fix m1 all property/global youngsModulus peratomtype 1e9
fix m2 all property/global poissonsRatio peratomtype 0.2
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
fix m5 all property/global characteristicVelocity scalar 1.0
pair_style gran model hooke tangential history
pair_coeff * *"""


def pairs(root, discs, rows):
    """Each other code beside each engine of ours that computes such bonds."""
    places, bonds = beam(discs, rows)
    others = [(command, name, lambda command=command, script=script: len(bonds) * STEPS / measure(command, script, places, bonds))
              for command, name, script in scripts()]
    others.append((["yade"], "Yade bonds with shear and spin", lambda: len(bonds) * STEPS_OF_YADE / measure_yade(places, len(bonds))))
    return [Pair("beam of touching discs", len(places), "bond-steps/s", f"{engine} engine", lambda kind=kind: ours(root, kind, discs, rows), name, speed)
            for command, name, speed in others if installed(command, name)
            for engine, kind in (("lattice", "lattice"), ("general", "contact_bonds"))]


def ours(root, kind, discs, rows):
    """Bond-steps per second of one thread."""
    m = json.loads(subprocess.run([root / "build/release/tests/bench/particles_bench", kind, str(discs), str(rows), "1"],
                                  check=True, capture_output=True, text=True).stdout)
    return m["steps_per_s"] * m["bonds"]


def installed(command, name):
    program, there = ("liblammps0", ctypes.util.find_library("lammps")) if command == LAMMPS else (command[0], shutil.which(command[0]))
    if not there:
        print(f"{name}: {program} is not installed, left out: scripts/setup bench", file=sys.stderr)
    return there


VALUES = {"half": STIFFNESS / 2, "dt": DT, "steps": "STEPS"}
GRANULAR = DISCS.format(style="sphere", newton="off", communicate="comm_modify vel yes", contacts=LAMMPS_CONTACTS, **VALUES)
LAMMPS = ["/usr/bin/python3", str(pathlib.Path(__file__).with_name("lammps_input.py"))]


def scripts():
    yield LAMMPS, "LAMMPS central springs", SPRINGS.format(
        style="bond", newton="on", communicate="comm_modify vel yes", **VALUES)
    yield LAMMPS, "LAMMPS granular with history", GRANULAR
    yield ["liggghts", "-in"], "LIGGGHTS granular with history", DISCS.format(
        style="granular", newton="off", communicate="communicate single vel yes", contacts=LIGGGHTS_CONTACTS, **VALUES)


def beam(discs, rows):
    """Centres of the hexagonal packing, and pairs that touch."""
    places, index = [], {}
    for row in range(rows):
        for k in range(discs - row % 2):
            index[2 * k + row % 2, row] = len(places)
            places.append(((2 * k + row % 2 + 1) * RADIUS, (row + 0.5) * math.sqrt(3) * RADIUS))
    pairs = [(i, index[other]) for (x, row), i in index.items()
             for other in ((x + 2, row), (x + 1, row + 1), (x - 1, row + 1)) if other in index]
    return places, pairs


def measure(command, script, places, bonds):
    """Seconds of CPU time for the steps."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "beam.data").write_text(data(places, bonds, "atom_style bond" in script))
        return cpu_seconds(command, script, folder, STEPS) - cpu_seconds(command, script, folder, 0)


def measure_yade(places, bonds):
    """The same of Yade, which must have found all bonds."""
    result = in_yade({"places": places, "radius": RADIUS, "mass": MASS, "inertia": MASS * RADIUS**2 / 2,
                      "normal_stiffness": STIFFNESS, "shear_stiffness": STIFFNESS / 3, "dt": DT, "steps": STEPS_OF_YADE})
    if result["bonds"] != bonds:
        raise RuntimeError(f"yade found {result['bonds']} bonds in a beam of {bonds}")
    return result["cpu_s"]


def in_yade(beam):
    """The output of yade_beam.py for the beam."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = pathlib.Path(folder) / "beam.json", pathlib.Path(folder) / "result.json"
        source.write_text(json.dumps(beam))
        script = pathlib.Path(__file__).with_name("yade_beam.py")
        done = subprocess.run(["yade", "-x", "-n", "-j1", script, source, target], capture_output=True, text=True)
        if not target.exists():
            raise RuntimeError(f"yade failed:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        return json.loads(target.read_text())


def cpu_seconds(command, script, folder, steps):
    (pathlib.Path(folder) / "in.beam").write_text(script.replace("STEPS", str(steps)))
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    compute(command, folder)
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def compute(command, folder):
    """The output of the code for the input in.beam."""
    result = subprocess.run([*command, "in.beam"], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if result.returncode:
        raise RuntimeError(f"{command} failed:\n{result.stdout[-2000:]}{result.stderr[-2000:]}")
    return result.stdout


def data(places, bonds, bonded):
    x_max, y_max = (max(place[axis] for place in places) + 2 for axis in (0, 1))
    lines = ["beam", "", f"{len(places)} atoms", "1 atom types"]
    if bonded:
        lines += [f"{len(bonds)} bonds", "1 bond types", "6 extra bond per atom"]
    lines += [f"-2 {x_max} xlo xhi", f"-2 {y_max} ylo yhi", "-0.5 0.5 zlo zhi", ""]
    if bonded:
        lines += ["Masses", "", f"1 {MASS}", ""]
    lines += ["Atoms", ""]
    density = MASS / (math.pi / 6)
    for i, (x, y) in enumerate(places, 1):
        # discs overlap a little, so that all of them touch
        lines.append(f"{i} 1 1 {x} {y} 0" if bonded else f"{i} 1 {2 * RADIUS * 1.0001} {density} {x} {y} 0")
    if bonded:
        lines += ["", "Bonds", ""] + [f"{k} 1 {i + 1} {j + 1}" for k, (i, j) in enumerate(bonds, 1)]
    return "\n".join(lines) + "\n"
