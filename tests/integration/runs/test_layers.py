"""Linings that lie on others: bonded they bend as one section, with an interface each by itself."""

import csv
import io
import subprocess
import unittest

import numpy as np

from programs import ADIT, PATIENCE_S, ProgramTest

from adit import Run, Unusable
from adit.plots import lining_pictures, png

HEIGHT, BEAM, FORCE = 3.0, 0.25, 40e3  # per metre
THICKNESS, YOUNG = np.array([0.3, 0.2]), np.array([20e9, 30e9])
# Ground that carries nothing holds the grid points of the first wall, which is pushed at its head.
SCENE = f"""\
plane: plane_stress
material: {{young_modulus: 10 kPa, poisson_ratio: 0, density: 10 kg/m^3}}
time: {{duration: 10 ms}}
statics: {{unbalanced_ratio: 1e-5, max_steps: 100000}}
continuum:
  block: {{x_min: -0.5 m, x_max: 0.5 m, y_min: 0 m, y_max: {HEIGHT} m, zones_x: 2, zones_y: {round(HEIGHT / BEAM)}}}
  linings:
    - name: shotcrete
      along: {{line: {{points: [{{x: 0, y: 0}}, {{x: 0, y: {HEIGHT} m}}]}}}}
      first_end_fixed: true
      thickness: {THICKNESS[0]} m
      young_modulus: {YOUNG[0]} Pa
      poisson_ratio: 0
    - name: concrete
      on: shotcrete
      thickness: {THICKNESS[1]} m
      young_modulus: {YOUNG[1]} Pa
      poisson_ratio: 0
  motions: [{{where: {{y_max: 0 m}}, velocity: {{x: 0, y: 0}}}}]
  point_loads: [{{where: {{x_min: -0.01 m, x_max: 0.01 m, y_min: {HEIGHT} m}}, force: {{x: {FORCE} N}}}}]
  histories:
"""
for _lining in ("shotcrete", "concrete"):
    for _quantity in ("thrust", "moment"):
        SCENE += f"    - {{name: {_lining}, quantity: {_quantity}, at: {{x: 0, y: {BEAM} m}}, lining: {_lining}}}\n"


class Layers(ProgramTest):
    def forces(self, change):
        rows = Run(self.run_scene(self.scene(change(SCENE)))).histories
        return (np.array([rows[f"{name}_thrust_N"][0] for name in ("shotcrete", "concrete")]),
                np.array([rows[f"{name}_moment_Nm"][0] for name in ("shotcrete", "concrete")]))

    def test_bonded_layers_are_one_section(self):
        thrusts, moments = self.forces(lambda scene: scene)
        # Along x, from the axis of the first; the path rises, so that the second lies on the side of negative x.
        places = np.array([0, -THICKNESS.sum() / 2])
        axial = YOUNG * THICKNESS
        centre = (axial * places).sum() / axial.sum()
        bending = YOUNG * THICKNESS**3 / 12
        stiffness = (bending + axial * (places - centre)**2).sum()
        # The force along x bends the wall to its right: the left is stretched, a negative moment.
        curvature = -FORCE * (HEIGHT - BEAM) / stiffness
        np.testing.assert_allclose(moments, bending * curvature, rtol=1e-5)
        np.testing.assert_allclose(thrusts, axial * (places - centre) * curvature, rtol=1e-5)

    def test_layers_that_slip_bend_by_themselves(self):
        slip = "on: shotcrete\n      first_end_fixed: true\n      interface: {tension: 1 GPa, normal_stiffness: 10 GPa/m}"
        thrusts, moments = self.forces(lambda scene: scene.replace("on: shotcrete", slip))
        bending = YOUNG * THICKNESS**3 / 12
        np.testing.assert_allclose(moments, -FORCE * (HEIGHT - BEAM) * bending / bending.sum(), rtol=0.01)
        np.testing.assert_allclose(thrusts, 0, atol=1)

    def test_layers_are_drawn_and_listed_by_their_names(self):
        run = Run(self.run_scene(self.scene(SCENE)))
        time, pieces = run.times[-1], run.fields()
        panels = png.figure(lining_pictures.lining_forces(run, time, pieces)).axes
        self.assertEqual([axes.get_ylabel().split("\n")[0] for axes in panels[::3]], ["shotcrete", "concrete"])
        fields, nodes = pieces["linings"], round(HEIGHT / BEAM) + 1
        for number, name in enumerate(("shotcrete", "concrete")):
            own = run.lining(name)
            np.testing.assert_array_equal(own["moment_Nm"], fields["moment_Nm"][number * nodes:][:nodes])
            np.testing.assert_allclose(own["y_m"], np.linspace(0, HEIGHT, nodes), atol=1e-12)
            told = subprocess.run([*ADIT, "table", run.folder, name, "--time", f"{time}"], capture_output=True, text=True, timeout=PATIENCE_S)
            rows = list(csv.DictReader(io.StringIO(told.stdout)))
            for column in ("angle_deg", "thrust_N", "peak_largest_moment_Nm"):
                np.testing.assert_allclose([float(row[column]) for row in rows], own[column], rtol=1e-8)
        with self.assertRaisesRegex(Unusable, "no lining `concret`.*concrete"):
            run.lining("concret")
        told = subprocess.run([*ADIT, "table", run.folder, "roof"], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(told.returncode, 2)
        self.assertIn("has no lining or member `roof`", told.stderr)


if __name__ == "__main__":
    unittest.main()
