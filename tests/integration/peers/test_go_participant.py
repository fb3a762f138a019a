"""A participant in Go, written from docs/protocol.md alone, keeps the protocol and computes what fdm_server computes."""

import pathlib
import shutil
import subprocess
import unittest

from programs import ADIT, CASE, Listening, ProgramTest, SOURCE, columns

# Of the largest displacement. Both have the same zones; only the order of their sums differs.
TOLERANCE = 0.01
SHORT = ("--set", "time.duration=12 ms", "--set", "output.field_times=[12 ms]")
LIBRARY = pathlib.Path("/usr/share/gocode/src/google.golang.org/protobuf")
# One of frames, one of the operator, one of physics; together all of them take half a minute.
CHECKS = ("malformed", "operator rows", "energy ledger")
NEEDED = ("go", "protoc", "protoc-gen-go")

PUSHED_GROUND = """
plane: plane_stress
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 10 ms}
continuum:
  block: {x_min: -1 m, x_max: 3 m, y_min: 0 m, y_max: 1 m, zones_x: 9, zones_y: 3}
  edge_loads: [{where: {y_min: 1 m, x_min: 0 m}, force: {x: 1 MN, y: -2 MN}, time: {table: {time: [0 s, 3 ms], value: [1, 0]}}}]
  body_loads: [{acceleration: {y: -9.81 m/s^2}}]
  motions: [{where: {y_max: 0 m}, velocity: {x: 1 m/s, y: 0.3 m/s}, time: {sine: {frequency: 200 Hz, phase: 1}}}]
  histories:
    - {name: tip, quantity: displacement_y, at: {x: 0.3 m, y: 1 m}}
output: {history_interval: 0.1 ms}
"""


@unittest.skipUnless(all(map(shutil.which, NEEDED)) and LIBRARY.is_dir(),
                     "needs the Debian packages golang-go, protoc-gen-go, golang-google-protobuf-dev")
class GoParticipant(ProgramTest):
    @classmethod
    def setUpClass(cls):
        folder = cls.folder_for_all()
        subprocess.run([SOURCE / "adapters/go/build", folder], check=True)
        cls.program = folder / "grid"

    def listening(self):
        other = Listening([self.program])
        self.addCleanup(other.end)
        return other.address

    def assert_same_tip(self, scene, *arguments):
        tips, drifts = [], []
        for out, address in (("ours", ()), ("go", ("--fdm", self.listening()))):
            run = self.run_scene(scene, *arguments, *address, out=out)
            drifts.append(self.summary(run)["max_energy_drift"])
            tips.append(columns(run)["tip_uy_m"])
        ours, theirs = tips
        self.assertEqual(len(ours), len(theirs))
        apart, largest = max(abs(a - b) for a, b in zip(ours, theirs)), max(map(abs, ours))
        self.assertLess(apart, TOLERANCE * largest)
        self.assertLess(drifts[1], 1.01 * drifts[0] + 1e-12)
        print(f"within {apart / largest:.2g} of the largest value")

    def test_conformance(self):
        for check in CHECKS:
            with self.subTest(check):
                command = [*ADIT, "conformance", "--fdm", self.program, "--only", check]
                done = subprocess.run(command, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stdout)
                self.assertRegex(done.stdout, " ok ")

    def test_tip_of_the_coupled_cantilever(self):
        self.assert_same_tip(CASE / "variants/coupled_52x6.yaml", *SHORT)

    def test_tip_with_substeps_and_an_overlap_across_zones(self):
        self.assert_same_tip(CASE / "variants/coupled_52x6.yaml", *SHORT, "--set", "time.substeps=2",
                             "--set", "interface.overlap.particles_begin.x=4.2 m")

    def test_ground_under_loads_and_motions(self):
        self.assert_same_tip(self.scene(PUSHED_GROUND))


if __name__ == "__main__":
    unittest.main()
