"""From a whole immersed tunnel to its worst joint in one command: the coupled model agrees with the beam."""

import csv
import subprocess
import unittest

from programs import ADIT, BUILD, PATIENCE_S, SOURCE, ProgramTest

# Three elements of the HZM tunnel on linear springs that slip, shaken by a wavelet that passes along them.
SCENE = """\
time: {duration: 4 s, dt: 10 ms}
simplified:
  model: beam
  tunnel:
    sections:
      - {from: 0 m, to: 540 m, width: 37.95 m, height: 11.4 m, area: 165 m^2, lateral_inertia: 22000 m^4,
         vertical_inertia: 3000 m^4, shear_area: 60 m^2, young_modulus: 34.5 GPa, mass: 422 t/m, element_length: 22.5 m}
    joints:
      - name: element_joint
        at: [180 m, 360 m]
        gasket:
          compression: [0 mm, 50 mm, 100 mm, 130 mm, 160 mm, 200 mm]
          force: [0 MN, 25 MN, 90 MN, 171 MN, 330 MN, 800 MN]
          installed_force: 171 MN
        lateral_keys: {stiffness: 3 GN/m, clearance: 0.2 mm}
        vertical_keys: {stiffness: 3 GN/m, clearance: 1 mm}
      - name: segment_joint
        from: 22.5 m
        to: 517.5 m
        spacing: 22.5 m
        gasket: {compression: [0 mm, 10 mm], force: [0 MN, 200 MN], installed_force: 171 MN}
        cables: {stiffness: 1 GN/m}
        lateral_keys: {stiffness: 20 GN/m}
        vertical_keys: {stiffness: 20 GN/m}
  soil_springs: {axial: 170 MPa, lateral: 170 MPa, vertical: 170 MPa, dashpot_time: 20 ms, slip_force: 3 MN/m, hardening: 0.05}
  excitation:
    motion: {ricker: {frequency: 0.8 Hz, time: 1.5 s}, peak: 0.2 g}
    axial: 0.7
    lateral: 0.7
    incidence: {apparent_velocity: 500 m/s}
  zoom: {width: 90 m}
"""


class Zoom(ProgramTest):
    def test_a_joint_of_particles_moves_as_that_of_the_beam(self):
        """Openings and forces of the joint within 10 % of the beam's at their largest; the opening also at any time."""
        scene = self.scene(SCENE, "reduced.yaml")
        done = subprocess.run([*ADIT, "run", SOURCE / "cases/hzm/zoom", scene, "--out", self.folder / "out"], capture_output=True,
                              text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "out/zoom/comparison.csv", newline="", encoding="utf-8") as file:
            found = {row["quantity"]: {key: float(row[key]) for key in ("beam", "model", "difference")}
                     for row in csv.DictReader(file)}
        self.assertGreater(found["opening"]["beam"], 5)  # mm
        self.assertGreater(found["key force"]["beam"], 1)  # MN: the clearance is used up
        for quantity in ("opening", "opening of the edge", "offset", "axial force", "key force", "moment"):
            with self.subTest(quantity):
                values = found[quantity]
                self.assertAlmostEqual(values["model"] / values["beam"], 1, delta=0.1)
        self.assertLess(found["opening"]["difference"], 0.1 * found["opening"]["beam"])

    def test_what_cannot_be_zoomed_is_refused_before_the_run(self):
        scene = self.scene(SCENE)
        for place, text in (("worst-joint", "worst-opening, worst-moment, worst-shear or worst-strain"), ("opening", "is no place")):
            done = subprocess.run([BUILD / "simplified/simplified", "run", scene, "--zoom", place, "--out", self.folder / "run"],
                                  capture_output=True, text=True, timeout=PATIENCE_S)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(text, done.stderr)
            self.assertFalse((self.folder / "run").exists())


if __name__ == "__main__":
    unittest.main()
