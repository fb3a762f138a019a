"""A notched beam of cells with one bar, bent until the bar yields, follows a hand calculation by strain compatibility, and the
beam of its section."""

import unittest

import numpy as np

from programs import ProgramTest

from adit import Run

SPAN, HEIGHT, DEPTH = 1.2, 0.2, 0.16  # of the bar below the upper side [m]
DIAMETER, SPACING = 12e-3, 0.15
CONCRETE, STRENGTH, TENSION, STEEL, YIELD = 33e9, 38e6, 2.9e6, 200e9, 550e6  # B500B: 1.1 x 500 MPa in the mean
ROCK = f"young_modulus: {CONCRETE} Pa, poisson_ratio: 0.2, density: 2.4 t/m^3"
CUT = 0.06  # from the middle [m]
SCENE = f"""\
plane: plane_stress
time: {{duration: 0.09 s, dt_factor: 0.8}}
material:
  {{{ROCK}, fracture: {{tensile_strength: {TENSION} Pa, fracture_energy: 140 J/m^2, compressive_strength: {STRENGTH} Pa, friction_angle: 35 deg}}}}
particles:
  cells: {{x_min: -0.7 m, x_max: 0.7 m, y_min: 0 m, y_max: {HEIGHT} m, size: 25 mm}}
  damping: {{local: 0.2}}
  joints: [{{from: {{x: 0 m, y: 0 m}}, to: {{x: 0 m, y: 0.025 m}}, open: true}}]
  bars:
    - along: {{line: {{points: [{{x: -0.7 m, y: {HEIGHT - DEPTH} m}}, {{x: 0.7 m, y: {HEIGHT - DEPTH} m}}]}}}}
      diameter: {DIAMETER} m
      spacing: {SPACING} m
      steel: {{class: B500B}}
  groups: [{{name: plate, where: {{x_min: -0.05 m, x_max: 0.05 m, y_min: 0.17 m}}, material: {{{ROCK}}}}}]
  motions:
    - {{where: {{x_min: {-SPAN / 2 - 0.02} m, x_max: {-SPAN / 2 + 0.02} m, y_max: 0.02 m}}, velocity: {{y: 0 m/s}}}}
    - {{where: {{x_min: {SPAN / 2 - 0.02} m, x_max: {SPAN / 2 + 0.02} m, y_max: 0.02 m}}, velocity: {{y: 0 m/s}}}}
    - {{where: {{x_min: -0.02 m, x_max: 0.02 m, y_min: 0.18 m}}, velocity: {{y: -50 mm/s}}}}
  histories:
    - {{name: middle, quantity: displacement_y, at: {{x: 0 m, y: 0.1 m}}}}
    - {{name: cut, quantity: moment, section: cut}}
    - {{name: notch, quantity: bar_stress, at: {{x: 0 m, y: {HEIGHT - DEPTH} m}}}}
    - {{name: notch, quantity: bar_slip, at: {{x: 0.02 m, y: {HEIGHT - DEPTH} m}}}}
  sections: [{{name: cut, from: {{x: {-CUT} m, y: 0.21 m}}, to: {{x: {-CUT} m, y: -0.01 m}}}}]
output: {{history_interval: 1 ms}}
"""
AREA = np.pi / 4 * DIAMETER**2 / SPACING


# The same beam as a lining of its section, whose beams follow its fibres; ground that carries nothing holds their grid points.
FIBRES = f"""\
plane: plane_stress
time: {{duration: 0.3 s, dt: 0.05 ms}}
material: {{young_modulus: 1 kPa, poisson_ratio: 0, density: 10 kg/m^3}}
continuum:
  block: {{x_min: {-SPAN / 2} m, x_max: {SPAN / 2} m, y_min: -0.1 m, y_max: 0.1 m, zones_x: 24, zones_y: 2}}
  linings:
    - name: beam
      along: {{line: {{points: [{{x: {-SPAN / 2} m, y: 0}}, {{x: {SPAN / 2} m, y: 0}}]}}}}
      section:
        thickness: {HEIGHT} m
        cover: {HEIGHT - DEPTH - DIAMETER / 2} m
        concrete: {{class: C30/37}}
        steel: {{class: B500B}}
        outer: {{diameter: {DIAMETER} m, spacing: {SPACING} m}}
  motions:
    - {{where: {{x_max: {-SPAN / 2} m, y_min: -0.01 m, y_max: 0.01 m}}, velocity: {{y: 0}}}}
    - {{where: {{x_min: {SPAN / 2} m, y_min: -0.01 m, y_max: 0.01 m}}, velocity: {{y: 0}}}}
    - {{where: {{x_min: -0.01 m, x_max: 0.01 m, y_min: -0.01 m, y_max: 0.01 m}}, velocity: {{y: -15 mm/s}}}}
  histories:
    - {{name: middle, quantity: displacement_y, at: {{x: 0, y: 0}}}}
    - {{name: quarter, quantity: moment, lining: beam, at: {{x: {-SPAN / 4} m, y: 0}}}}
output: {{history_interval: 1 ms}}
"""


def cracked(stress):
    """Moment and curvature of the section without tension of the concrete, at a stress of the bar up to yield: strains are plane and
    concrete is linear, so that x^2 / 2 = n (d - x)."""
    n = STEEL / CONCRETE * AREA
    x = -n + np.sqrt(n * n + 2 * n * DEPTH)
    return AREA * stress * (DEPTH - x / 3), stress / STEEL / (DEPTH - x)


class Bars(ProgramTest):
    def test_notched_beam(self):
        self.computed = Run(self.run_scene(self.scene(SCENE)))
        h = self.computed.histories
        self.deflection, self.stress, self.slip = -h["middle_uy_m"], h["notch_bar_stress_Pa"], h["notch_bar_slip_m"]
        self.moment = h["cut_moment_Nm"] * (SPAN / 2) / (SPAN / 2 - CUT)  # in the middle, of three-point bending
        for requirement in (self.bends_as_the_section, self.deflects_as_the_section, self.tells_its_bars):
            with self.subTest(requirement.__name__):
                requirement()

    def bends_as_the_section(self):
        """The moment is that of the cracked section at the stress of the bar; beyond yield with a crushed zone of f_c."""
        elastic = (self.stress > 0.4 * YIELD) & (self.stress < YIELD)
        self.assertGreater(elastic.sum(), 30)
        self.assertLess(abs(np.median(self.moment[elastic] / cracked(self.stress[elastic])[0]) - 1), 0.1)
        yielded = self.stress > YIELD
        self.assertGreater(yielded.sum(), 30)
        force = AREA * self.stress[yielded]
        self.assertLess(np.abs(self.moment[yielded] / (force * (DEPTH - force / STRENGTH / 2)) - 1).max(), 0.1)
        self.assertLess(self.stress.max(), 1.06 * YIELD)

    def deflects_as_the_section(self):
        """Load by deflection is that of beams of the same section, in the mean over each half millimetre from 1 mm on: up to there one
        crack alone grows from the notch, which the fibres do not know. The bar yields at 2.6 mm."""
        fibres = Run(self.run_scene(self.scene(FIBRES, "fibres.yaml"), "--fdm-threads", "1", out="fibres")).histories
        for begin in np.arange(1e-3, 4.4e-3, 0.5e-3):
            within = (self.deflection >= begin) & (self.deflection < begin + 0.5e-3)
            expected = np.interp(self.deflection[within], -fibres["middle_uy_m"], 2 * np.abs(fibres["quarter_moment_Nm"]))
            with self.subTest(begin=begin):
                self.assertGreater(within.sum(), 5)
                self.assertLess(abs(self.moment[within].mean() / expected.mean() - 1), 0.1)

    def tells_its_bars(self):
        summary = self.computed.summary
        bars = self.computed.fields()["bars"]
        self.assertAlmostEqual(summary["bars_largest_force_N"], AREA * summary["bars_largest_stress_Pa"], delta=1)
        self.assertLess(abs(summary["bars_largest_stress_x_m"]), 0.05)
        self.assertGreater(summary["bars_largest_strain"], YIELD / STEEL)
        self.assertGreaterEqual(abs(summary["bars_largest_slip_m"]), np.abs(self.slip).max())
        self.assertGreaterEqual(summary["bars_largest_stress_Pa"], bars.field("stress_Pa").max())
        self.assertEqual(set(bars.field("bar")), {0})


if __name__ == "__main__":
    unittest.main()
