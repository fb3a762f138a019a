"""LAMMPS under MPI in the place of dem_server: the same motions, the same bonds in the same order, no rank lost unnamed."""

import csv
import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

from programs import BUILD, CASE, ProgramTest, children_of, coupler, wait_until

PROGRAM = BUILD / "adapters/lammps/adit_lammps"
# Of the largest value; both compute the same pairs, and ranks add them up in another order.
TOLERANCE = 1e-9
GENERAL = ("--set", "particles.engine=general")
# The first of its bonds breaks at 8 ms.
STRENGTH = ("--set", "particles.bonds.tensile_strength=4 MN")
WEAK = (*STRENGTH, "--set", "time.duration=12 ms", "--set", "output.field_times=[12 ms]")
BEAM = CASE / "variants/coupled_52x6.yaml"

FALLING_GRAINS = """
plane: plane_strain
material: {young_modulus: 1 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 10 ms}
particles:
  random_packing: {x_min: 0 m, x_max: 3 m, y_min: 0 m, y_max: 1 m, radius_min: 4 cm, radius_max: 6 cm, stress: 100 kPa}
  groups:
    - {name: cemented, where: {x_max: 1.5 m},
       bonds: {parallel: {normal_stiffness: 20 GPa/m, shear_stiffness: 8 GPa/m, tensile_strength: 200 kPa, cohesion: 300 kPa}}}
  contacts: {friction: 0.4, normal_damping: 0.2, shear_damping: 0.1}
  body_loads: [{acceleration: {y: -9.81 m/s^2}}]
  loads: [{where: {x_max: 0.3 m}, force: {x: 200 kN}}]
  motions: [{where: {y_max: 0.1 m}, velocity: {x: 0 m/s, y: 0 m/s}, spin: 0 rad/s}]
  histories:
    - {name: end, quantity: displacement_x, at: {x: 0.2 m, y: 0.5 m}}
    - {name: grain, quantity: velocity_y, at: {x: 2.5 m, y: 0.9 m}}
output: {history_interval: 0.5 ms, field_times: [10 ms]}
"""


def mpirun(ranks):
    return ["mpirun", "-np", str(ranks), "--oversubscribe", "--bind-to", "none", *(["--allow-run-as-root"] if os.geteuid() == 0 else []), PROGRAM]


def grandchildren_of(pid):
    return {child for parent in children_of(pid) for child in [parent, *grandchildren_of(parent)]}


class Ranks:
    """The participant on so many ranks, listening."""

    def __init__(self, ranks):
        self.process = subprocess.Popen([*mpirun(ranks), "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        text=True)
        self.address = re.fullmatch(r"listening on (\S+)\n", self.process.stdout.readline())[1]

    def processes(self):
        """Of the ranks, without mpirun: in the order of their ids."""
        return sorted(grandchildren_of(self.process.pid))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.communicate()


def columns(run):
    with open(run / "histories.csv", newline="") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, zip(*[[float(value) for value in row] for row in rows])))


def cracks(run):
    with open(run / "cracks.csv", newline="") as file:
        return list(csv.DictReader(file))


@unittest.skipUnless(PROGRAM.exists(), "adapters/lammps is left out: needs the Debian packages liblammps-dev, libopenmpi-dev, openmpi-bin")
class LammpsTest(ProgramTest):
    def assert_same(self, scene, ranks, *arguments):
        """All rows within the tolerance, and the same cracks in the same order; returns how many of these."""
        ours = self.run_scene(scene, *GENERAL, *arguments, out="ours")
        for count in ranks:
            with self.subTest(ranks=count), Ranks(count) as lammps:
                theirs = self.run_scene(scene, *GENERAL, *arguments, "--dem", lammps.address, out=f"ranks_{count}")
                self.compare(ours, theirs)
        return len(cracks(ours))

    def compare(self, ours, theirs):
        broken = [[(row["step"], row["mode"], row["parent_a"], row["parent_b"]) for row in cracks(run)] for run in (ours, theirs)]
        self.assertEqual(*broken)
        mine, others = columns(ours), columns(theirs)
        self.assertEqual(mine.keys(), others.keys())
        worst = 0
        for name in mine.keys() - {"energy_drift"}:  # which is rounding itself
            self.assertEqual(len(mine[name]), len(others[name]))
            largest = max(map(abs, mine[name]))
            apart = max(abs(a - b) for a, b in zip(mine[name], others[name]))
            self.assertLessEqual(apart, TOLERANCE * largest, name)
            worst = max(worst, apart / largest if largest else 0)
        print(f"within {worst:.2g} of the largest value, {len(broken[0])} cracks")


class LammpsComputesAsDemServer(LammpsTest):
    def test_the_coupled_beam_until_it_is_cracked(self):
        self.assertGreater(self.assert_same(BEAM, (2,), *WEAK), 2)

    def test_grains_that_part_and_slide(self):
        self.assertGreater(self.assert_same(self.scene(FALLING_GRAINS), (2,)), 2)


class LammpsRefusesWhatItDoesNotCompute(LammpsTest):
    def test_walls_and_statics_by_name(self):
        wall = FALLING_GRAINS.replace("output:", "  walls: [{name: floor, from: {x: 0 m, y: 0 m}, to: {x: 3 m, y: 0 m}}]\noutput:")
        with Ranks(1) as lammps:
            for text, key in ((wall, "particles.walls"), (FALLING_GRAINS + "statics: {}\n", "statics")):
                result = coupler("run", self.scene(text), "--dem", lammps.address, "--out", self.folder / "run")
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn(f"{key}: is not computed by lammps", result.stderr)


class LammpsLosesARank(LammpsTest):
    """Requirement: who waits for a rank that is gone says so within 10 s, and nothing hangs."""

    def lose(self, blow):
        with Ranks(2) as lammps:
            run = subprocess.Popen([BUILD / "coupler/coupler", "run", BEAM, *GENERAL, "--set", "time.duration=100 s", "--dem",
                                    lammps.address, "--out", self.folder / "run"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   text=True)
            time.sleep(2)
            lost = lammps.processes()[1]
            os.kill(lost, blow)
            begin = time.monotonic()
            told = run.communicate(timeout=20)[1]
            took = time.monotonic() - begin
            lammps.process.communicate(timeout=20)
            self.assertEqual(run.returncode, 3, told)
            self.assertLess(took, 10)
            wait_until(lambda: not pathlib.Path(f"/proc/{lost}").exists())
            print(f"named after {took:.1f} s: {told.strip().splitlines()[-1]}")
        return told

    def test_a_killed_one(self):
        self.assertIn("dem_server at 127.0.0.1", self.lose(signal.SIGKILL))

    def test_a_stopped_one(self):
        self.assertRegex(self.lose(signal.SIGSTOP), r"rank 1 \(process \d+ on \S+\) has given no sign of life for 4 s")
