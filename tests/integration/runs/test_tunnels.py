"""Scenes with tunnels: the run's `scene.yaml` shows what they became, and the cases of tunnels can be computed."""

import unittest

import numpy

import references
from programs import ProgramTest, coupler
from runs.test_cases import LARGE

from adit import Run
from adit.cases.tunnels import ring_ovaling

SCENE = """\
material: {young_modulus: 1 GPa, poisson_ratio: 0.2, density: 2 t/m^3}
time: {duration: 2 ms}
tunnels:
  - name: tube
    centre: {x: 0 m, y: 0 m}
    circle: {radius: 2 m}
    lining: {thickness: 50 cm, material: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: 2.5 t/m^3}}
    particles: {radius: 10 cm, ground: 2 m, overlap: 1 m}
    sections: 0
continuum:
  block: {x_min: -10 m, x_max: 10 m, y_min: -10 m, y_max: 10 m, zones_x: 40, zones_y: 40}
"""


class Tunnels(ProgramTest):
    def test_the_expansion_stands_in_the_results_and_reads_back(self):
        run = self.run_scene(self.scene(SCENE))
        expanded = (run / "scene.yaml").read_text()
        self.assertNotIn("tunnels:", expanded)
        self.assertIn('name: "tube"', expanded)
        self.assertIn("tunnels:", (run / "scene_as_written.yaml").read_text())
        note, = self.summary(run)["notes"]
        self.assertIn("tube: 2 rows of particles lie over the lining's thickness", note)
        again = self.run_scene(run / "scene.yaml", out="again")
        self.assertEqual((again / "histories.csv").read_bytes(), (run / "histories.csv").read_bytes())

    def test_what_a_server_refuses_is_told_at_the_tunnel(self):
        wrong = SCENE.replace("overlap: 1 m}", "overlap: 1 m, bonds: {tensile_strength: 1 MN, parallel: "
                              "{normal_stiffness: 1 GPa/m, shear_stiffness: 1 GPa/m}}}")
        result = coupler("check", self.scene(wrong))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(":4:", result.stderr)
        self.assertIn("tunnels[0]: becomes `particles.bonds.tensile_strength`, which is given beside `parallel`",
                      result.stderr)

    def test_the_large_scenes_are_read(self):
        for scene in LARGE:
            with self.subTest(scene):
                result = coupler("check", scene, "--which")
                self.assertEqual((result.returncode, result.stdout), (0, "coupler\n"), result.stderr)

    def test_a_ring_between_neighbours_bears_the_ground_and_its_shear(self):
        run = Run(references.run_reduced(self, "qingcaosha"))
        angle, thrust = ring_ovaling.around(run, "thrust_N")
        # at rest: the mean stress of the ground at the axis, of which the ring bears what its excavation did not release
        vertical = 9.81 * (9.6 * 1800 + 5.1 * 1750)
        borne = 0.7 * (1 + 0.6) / 2 * vertical * 3.4
        self.assertAlmostEqual(-thrust[0].mean() / borne, 1, delta=0.1)
        # under the wave, by the strain of the free field: that of an annulus bonded to the clay, while joints are closed
        history = run.histories
        strain = (history["free_above_ux_m"] - history["free_below_ux_m"]) / 6.8
        by_strain = numpy.polyfit(strain, [ring_ovaling.amplitude(angle, row) for row in thrust - thrust[0]], 1)[0]
        clay, shear_modulus = (129.9e6, 0.45), 44.8e6
        thrust_of_annulus, _ = ring_ovaling.annulus((35.5e9, 0.2), clay, 2.92, 3.4, shear_modulus)
        self.assertAlmostEqual(by_strain / thrust_of_annulus, 1, delta=0.05)


if __name__ == "__main__":
    unittest.main()
