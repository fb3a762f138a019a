"""FEniCSx over two ranks of MPI keeps the protocol, computes what fdm_server computes, and names a rank that is lost."""

import os
import signal
import subprocess
import sys
import unittest
from unittest.mock import Mock

import numpy as np
from google.protobuf import text_format
from peers.mpi_server import LostTest, MpiServer, needed
from programs import ADIT, CASE, ProgramTest, SOURCE, coupler

from adit.conformance.client import Participant, scene, wire  # noqa: E402

sys.path.insert(0, str(SOURCE / "adapters/fenicsx"))
from serve import relay  # noqa: E402

# Of the largest value. The zones are the same; only the order of sums differs, which thousands of steps make grow.
TOLERANCE = 1e-9
SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[1 ms]")
# test_fenicsx_guards has all of them.
CHECKS = ("operator rows", "mass")

LAYERED_GROUND = """
plane: plane_strain
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 2 ms}
continuum:
  block: {x_min: -1 m, x_max: 3 m, y_min: 0 m, y_max: 1 m, zones_x: 9, zones_y: 4}
  materials:
    - {where: {y_max: 0.5 m}, material: {young_modulus: 10 GPa, poisson_ratio: 0.3, density: 2000 kg/m^3}}
    - {where: {y_max: 0.25 m}, material: {young_modulus: 40 GPa, poisson_ratio: 0.1, density: 2600 kg/m^3}}
  quiet: [{where: {x_max: -1 m}}, {where: {y_max: 0 m}, normal: false}]
  edge_loads: [{where: {y_min: 1 m, x_min: 0 m}, force: {x: 1 MN, y: -2 MN}, time: {table: {time: [0 s, 1 ms], value: [1, 0]}}}]
  point_loads: [{where: {x_min: 3 m, y_min: 0.4 m}, force: {x: 1 MN, y: 0.4 MN}, time: {sine: {frequency: 800 Hz}}}]
  body_loads: [{acceleration: {y: -9.81 m/s^2}}]
  motions: [{where: {y_max: 0 m}, velocity: {y: 0.3 m/s}, time: {sine: {frequency: 200 Hz, phase: 1}}}]
  histories:
    - {name: top, quantity: displacement_x, at: {x: 0.3 m, y: 1 m}}
    - {name: base, quantity: velocity_y, at: {x: 1.7 m, y: 0.2 m}}
output: {history_interval: 0.1 ms}
"""

SQUARE = """
time {{ duration: 1 }} material {{ young_modulus: 2e7 poisson_ratio: 0.2 density: 2000 }}
continuum {{
  block {{ x_min: 0 x_max: 1 y_min: 0 y_max: 1 zones_x: {zones} zones_y: {zones} }}
  motions {{ where {{ x_max: 0 }} velocity {{ x: 0 }} }} motions {{ where {{ x_min: 1 }} velocity {{ x: 0 }} }}
  motions {{ where {{ y_max: 0 }} velocity {{ y: 0 }} }} motions {{ where {{ y_min: 1 }} velocity {{ y: 0 }} }}
}}"""


@needed
class TwoRanks(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.server = MpiServer()
        cls.addClassCleanup(cls.server.end)

    def assert_same(self, scene, *arguments):
        own = self.run_scene(scene, *arguments, out="ours")
        run = self.run_scene(scene, "--fdm", self.server.address, *arguments, out="fenicsx")
        self.assert_same_histories(own, run, TOLERANCE)
        return run

    def test_coupled_cantilever(self):
        run = self.assert_same(CASE / "variants/coupled_52x6.yaml", *SHORT)
        text = next(run.glob("fields/grid_*.vtu")).read_bytes()
        self.assertIn(b'"rank"', text)

    def test_layers_loads_and_quiet_boundaries(self):
        run = self.assert_same(self.scene(LAYERED_GROUND))
        self.assertLess(self.summary(run)["max_energy_drift"], 1e-9)

    def test_what_it_does_not_compute_is_refused(self):
        scene = self.scene(LAYERED_GROUND + "statics: {}\n")
        result = coupler("run", scene, "--fdm", self.server.address, "--out", self.folder / "run")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("statics: is not computed by fenicsx_continuum; leave it out", result.stderr)

    def test_an_unstable_run(self):
        scene = self.scene(LAYERED_GROUND)
        beyond = ("--set", "time.dt=1 ms", "--set", "time.beyond_critical=true", "--set", "time.duration=2 s")
        result = coupler("run", scene, "--fdm", self.server.address, "--out", self.folder / "run", *beyond)
        self.assertEqual(result.returncode, 4, result.stderr)

    def test_conformance(self):
        for check in CHECKS:
            with self.subTest(check):
                command = [*ADIT, "conformance", "--fdm", self.server.address, "--only", check]
                done = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertRegex(done.stdout, " ok ")

    def error(self, participant, zones, wave, direction):
        """Of the velocities after 3/4 of a period of a mode of a square on rollers, over the largest one."""
        with participant.run() as run:
            run.set_up(text_format.Parse(SQUARE.format(zones=zones), scene.Scene()))
            run.weigh()
            run.couple(run.points)
            inverse = np.reshape(run.operator.inverse_masses, (-1, 2))[list(run.operator.columns)]
            held = inverse == 0
            x, y = np.pi * (run.points * wave).T
            mode = np.stack([direction[0] * np.sin(x) * np.cos(y), direction[1] * np.cos(x) * np.sin(y)], axis=1)
            speed = run.model.p_wave_speed if np.cross(direction, wave) == 0 else run.model.s_wave_speed
            frequency = speed * np.pi * np.hypot(*wave)
            steps = int(np.ceil(1.5 * np.pi / frequency / (0.5 * run.model.critical_dt)))
            dt = 1.5 * np.pi / frequency / steps
            run.step(0, dt)
            answer = run.step(1, dt, np.where(held, 0, mode * np.cos(frequency * dt / 2) / np.where(held, 1, inverse)))
            for n in range(2, steps):
                answer = run.step(n, dt)
            expected = mode * np.cos(frequency * (steps - 0.5) * dt)
            return abs(np.reshape(answer.velocities, (-1, 2)) - expected).max() / abs(mode).max()

    def test_waves_converge_by_the_square_of_the_size_of_zones(self):
        participant, wave = Participant("continuum", self.server.address), np.array([1, 2])
        for name, direction in (("P", wave), ("S", np.array([2, -1]))):
            with self.subTest(name):
                errors = [self.error(participant, zones, wave, direction) for zones in (8, 16)]
                order = np.log2(errors[0] / errors[1])
                print(f"{name}: errors {errors}, order {order:.2f}")
                self.assertLess(errors[1], 0.05)
                self.assertAlmostEqual(order, 2, delta=0.15)


class LongMessages(unittest.TestCase):
    def test_they_pass_through_the_guard_undecoded(self):
        """No heartbeat can be sent while Python decodes. These bytes begin as frames of the protocol, but are none."""
        weights, interface = (bytes([field << 3 | 2]) + b"\xff" * 100 for field in (4, 5))
        heartbeat, finish, bye = (wire.Frame(**{name: {}}).SerializeToString() for name in ("heartbeat", "finish", "bye"))
        link = Mock(next_payload=Mock(side_effect=[heartbeat, weights, heartbeat, finish]))
        crew = Mock(ask=Mock(side_effect=[interface, bye]))
        relay(link, crew)
        self.assertEqual([call.args[0] for call in crew.ask.call_args_list], [weights, finish])
        self.assertEqual([call.args[0] for call in link.send_payload.call_args_list], [interface, bye])


# In a process of its own: mpirun does not start from one that has initialised MPI.
POINTS_OF_GRAVITY = """
from divided import Continuum
from google.protobuf import text_format
from mpi4py import MPI
from wire import scene, wire

continuum = Continuum(MPI.COMM_SELF)
continuum.setup(wire.Setup(scene=text_format.Parse(%r, scene.Scene())), wire.Model())
continuum.weights(wire.Weights(), wire.Interface())
print(continuum.loads[0].points)
""" % SQUARE.format(zones=8).replace("motions", "body_loads { acceleration { y: -10 } } motions", 1)


@needed
class OwnPoints(unittest.TestCase):
    def test_a_load_on_all_points_takes_them_as_they_lie_in_memory(self):
        """In another order they doubled the time of a step of 10^6 zones, and a second rank gained a third of it instead of a half."""
        folders = ":".join(str(SOURCE / "adapters" / name) for name in ("fenicsx", "python"))
        done = subprocess.run(["/usr/bin/python3", "-c", POINTS_OF_GRAVITY], env={**os.environ, "PYTHONPATH": folders}, capture_output=True,
                              text=True)
        self.assertEqual(done.stdout.strip(), "slice(0, 81, None)", done.stderr)


class OneRankIsLost(LostTest):
    def test_killed(self):
        self.assert_named(lambda server: server.rank(1), signal.SIGKILL, r"rank 1 of 2, process \d+ on \S+, was killed by SIGKILL")

    def test_stopped(self):
        self.assert_named(lambda server: server.rank(1), signal.SIGSTOP, r"rank 1 of 2, process \d+ on \S+, was stopped by SIGSTOP")


if __name__ == "__main__":
    unittest.main()
