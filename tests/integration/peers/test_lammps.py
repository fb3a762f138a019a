"""LAMMPS under MPI in the place of dem_server: the same motions, the same bonds in the same order, no rank lost unnamed."""

import os
import pathlib
import signal
import subprocess
import time
import unittest

from peers.mpi_server import Ranks, mpirun
from programs import BUILD, CASE, ProgramTest, children_of, coupler, cracks, wait_until

from benchmarks.peers import held

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

RANKS_PATIENCE_S = 900  # ranks that share their cores lose a turn in every step


def served(ranks):
    return [*mpirun(ranks), str(PROGRAM), "--listen", "127.0.0.1:0"]


def grandchildren_of(pid):
    return {child for parent in children_of(pid) for child in [parent, *grandchildren_of(parent)]}


@unittest.skipUnless(PROGRAM.exists(), "adapters/lammps is left out: needs the Debian packages liblammps-dev, libopenmpi-dev, openmpi-bin")
class LammpsTest(ProgramTest):
    def assert_same(self, scene, ranks, *arguments):
        """All rows within the tolerance, and the same cracks in the same order; returns how many of these."""
        ours = self.run_scene(scene, *GENERAL, *arguments, out="ours")
        for count in ranks:
            with self.subTest(ranks=count), Ranks(served(count)) as lammps:
                theirs = self.run_scene(scene, *GENERAL, *arguments, "--dem", lammps.address, out=f"ranks_{count}",
                                        timeout=RANKS_PATIENCE_S)
                self.assertEqual(cracks(ours), cracks(theirs))
                self.assert_same_histories(ours, theirs, TOLERANCE)
        return len(cracks(ours))


class LammpsComputesAsDemServer(LammpsTest):
    def test_the_coupled_beam_until_it_is_cracked(self):
        self.assertGreater(self.assert_same(BEAM, (2,), *WEAK), 2)

    def test_grains_that_part_and_slide(self):
        self.assertGreater(self.assert_same(self.scene(FALLING_GRAINS), (2,)), 2)


class LammpsRefusesWhatItDoesNotCompute(LammpsTest):
    def test_walls_and_statics_by_name(self):
        wall = FALLING_GRAINS.replace("output:", "  walls: [{name: floor, from: {x: 0 m, y: 0 m}, to: {x: 3 m, y: 0 m}}]\noutput:")
        with Ranks(served(1)) as lammps:
            for text, key in ((wall, "particles.walls"), (FALLING_GRAINS + "statics: {}\n", "statics")):
                result = coupler("run", self.scene(text), "--dem", lammps.address, "--out", self.folder / "run")
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn(f"{key}: is not computed by lammps", result.stderr)


class LammpsLosesARank(LammpsTest):
    """Requirement: who waits for a rank that is gone says so within 10 s, and nothing hangs."""

    def lose(self, blow):
        with Ranks(served(2)) as lammps:
            run = subprocess.Popen([BUILD / "coupler/coupler", "run", BEAM, *GENERAL, "--set", "time.duration=100 s", "--dem",
                                    lammps.address, "--out", self.folder / "run"], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                   text=True)
            time.sleep(2)
            lost = sorted(grandchildren_of(lammps.process.pid))[1]  # the ranks, in the order of their ids
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
        self.assertIn("lammps at 127.0.0.1", self.lose(signal.SIGKILL))

    def test_a_stopped_one(self):
        self.assertRegex(self.lose(signal.SIGSTOP), r"rank 1 \(process \d+ on \S+\) has given no sign of life for 4 s")


@unittest.skipUnless(PROGRAM.exists(), "adapters/lammps is left out")
class CodesTakeTurns(unittest.TestCase):
    """tools/bench ranks: servers and LAMMPS's own discs hold their models, and compute steps of them in turn."""

    def test_on_one_rank_and_two(self):
        described = ("plane: PLANE_STRESS time { duration: 1 } material { young_modulus: 2e7 poisson_ratio: 0.2 density: 2000 } "
                     "particles { engine: GENERAL packing { x_min: 0 x_max: 6 y_min: 0 y_max: 4 radius: 0.5 } bonds {} }")
        with held.Server("particles", served(1), described) as one, held.Server("particles", served(2), described) as two, \
                held.Granular(6, 4) as discs:
            for code in (one, two, discs, one):
                self.assertGreater(code.seconds(3), 0)
        self.assertEqual((one.at, two.at), (8, 4))
        for ended in (one.participant.process, two.participant.process, discs.process):
            self.assertEqual(ended.returncode, 0)


if __name__ == "__main__":
    unittest.main()
