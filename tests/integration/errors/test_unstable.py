"""A time step above the limit is refused; forced, the run stops within 100 steps and says at which one and where.

Limits are bounds. They are sharp for zones much higher than wide without lateral strain, and for a single row of
particles; otherwise a model may be stable some way beyond (a lattice of many rows up to about 1.4 times)."""

import re
import unittest

from programs import ProgramTest, coupler

GRID = """
continuum:
  block: {x_min: 0 m, x_max: 8 m, y_min: 0 m, y_max: 1 m, zones_x: 80, zones_y: 2}
  point_loads: [{where: {x_max: 0 m}, force: {x: 1 kN}, time: {sine: {frequency: 100 Hz, end: 5 ms}}}]
"""
ROW = """
particles:
  packing: {x_min: 0 m, x_max: 8 m, y_min: 0 m, y_max: 0.0866025404 m, radius: 0.05 m}
  bonds: {normal_stiffness: 1 GN/m, shear_stiffness: 0 N/m}
  loads: [{where: {x_max: 0.1 m}, force: {x: 1 kN}, time: {sine: {frequency: 100 Hz, end: 5 ms}}}]
"""
# Soft particles: the grid's step is the smaller one.
BOTH = """
continuum:
  block: {x_min: 0 m, x_max: 5 m, y_min: 0 m, y_max: 1.0392304845 m, zones_x: 25, zones_y: 1}
  point_loads: [{where: {x_max: 0 m}, force: {x: 1 kN}, time: {sine: {frequency: 100 Hz, end: 5 ms}}}]
particles:
  packing: {x_min: 2 m, x_max: 8 m, y_min: 0 m, y_max: 1.0392304846 m, radius: 0.05 m}
  bonds: {normal_stiffness: 10 MN/m, shear_stiffness: 1 MN/m}
interface: {overlap: {particles_begin: {x: 3 m, y: 0 m}, continuum_ends: {x: 4.5 m, y: 0 m}}}
"""
COMMON = """
plane: plane_stress
material: {young_modulus: 1 GPa, poisson_ratio: 0, density: 2000 kg/m^3}
time: {duration: 50 ms}
"""


class Unstable(ProgramTest):
    def limit(self, scene):
        refused = coupler("run", scene, "--out", self.folder / "refused", "--set", "time.dt=1 ms")
        self.assertEqual(refused.returncode, 2, refused.stderr)
        return float(re.search(r"above (\S+) s, the critical time step", refused.stderr)[1])

    def run_at(self, scene, share, *more):
        dt = f"time.dt={share * self.limit(scene):.9g} s"
        return coupler("run", scene, "--out", self.folder / "run", "--set", dt, *more)

    def check(self, model, rows=((), ("--set", "output.history_interval=50 ms"))):
        scene = self.scene(COMMON + model)
        stable = self.run_at(scene, 0.99)
        self.assertEqual(stable.returncode, 0, stable.stderr)
        self.assertLess(self.summary(self.folder / "run")["max_energy_drift"], 1e-4)
        refused = self.run_at(scene, 1.01)
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn("time.dt", refused.stderr)
        for interval in rows:  # rows of every few steps, then rows of start and end alone
            forced = self.run_at(scene, 1.01, "--set", "time.beyond_critical=true", *interval)
            self.assertEqual(forced.returncode, 4, forced.stderr)
            self.assertRegex(forced.stderr, r"energy of the model exceeds .* fastest point is at \(\S+, \S+\) m")
            self.assertLessEqual(int(re.search(r"step (\d+) ", forced.stderr)[1]), 100)

    def test_grid(self):
        self.check(GRID)

    def test_row_of_particles(self):
        self.check(ROW)

    def test_both(self):
        self.check(BOTH, rows=((),))

    def test_both_with_few_rows(self):
        """The energy of the unstable zones then swings through 0 where it is looked at: the first force that is no
        longer finite ends the run."""
        forced = self.run_at(self.scene(COMMON + BOTH), 1.01, "--set", "time.beyond_critical=true",
                             "--set", "output.history_interval=50 ms")
        self.assertEqual(forced.returncode, 4, forced.stderr)
        self.assertRegex(forced.stderr, r"step \d+.*\(\S+, \S+\) m")


if __name__ == "__main__":
    unittest.main()
