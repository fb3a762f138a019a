"""Yade and dem_server compute the same motion of a bonded cantilever during a whole period after sudden loading."""

import csv
import json
import math
import shutil
import sys
import unittest

from programs import SOURCE, ProgramTest

sys.path.insert(0, str(SOURCE / "scripts"))
from adit_bench.peers import particles as peers  # noqa: E402

DISCS, ROWS, RADIUS, DENSITY = 52, 6, 10 / 104, 2500.0
NORMAL, SHEAR, FORCE = 2.6e10, 1.3e10, 1e5  # [N/m], [N/m], [N]
SCENE = f"""
material: {{young_modulus: 25 GPa, poisson_ratio: 0.2, density: {DENSITY}}}
plane: plane_stress
time: {{duration: 200 ms, dt_factor: 0.35}}
particles:
  packing: {{x_min: 0, x_max: 10, y_min: 0, y_max: {ROWS * math.sqrt(3) * RADIUS}, radius: {RADIUS!r}}}
  bonds: {{normal_stiffness: {NORMAL}, shear_stiffness: {SHEAR}, tensile_strength: inf}}
  loads:
    - {{where: {{x_max: 0.1}}, force: {{y: {FORCE}}}}}
  motions:
    - {{where: {{x_min: 9.9}}, velocity: {{x: 0, y: 0}}, spin: 0}}
  histories:
    - {{name: tip, quantity: displacement_x, at: {{x: {RADIUS!r}, y: {2.5 * math.sqrt(3) * RADIUS!r}}}}}
    - {{name: tip, quantity: displacement_y, at: {{x: {RADIUS!r}, y: {2.5 * math.sqrt(3) * RADIUS!r}}}}}
output: {{history_interval: 0.5 ms}}
"""


@unittest.skipUnless(shutil.which("yade"), "the Debian package yade is not installed")
class SameBeamInYade(ProgramTest):
    def test_histories_of_the_tip_agree(self):
        run = self.run_scene(self.scene(SCENE))
        summary = json.loads((run / "summary.json").read_text())
        with open(run / "histories.csv", newline="") as file:
            rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
        self.assertGreater(len(rows), 390)
        yade = self.in_yade(summary["dt_s"], summary["steps"])
        self.assertEqual(yade["bonds"], summary["bonds"])
        for axis, name in enumerate(("tip_ux_m", "tip_uy_m")):
            pairs = [(row[name], yade["displacement"][round(row["time_s"] / summary["dt_s"])][axis]) for row in rows]
            largest = max(abs(own) for own, _ in pairs)
            apart = max(abs(own - other) for own, other in pairs) / largest
            print(f"{name}: at most {largest:.4g} m, Yade within {apart:.2g} of it")
            self.assertGreater(largest, 1e-6)
            self.assertLess(apart, 1e-3)

    def in_yade(self, dt, steps):
        places, _ = peers.beam(DISCS, ROWS)
        places = [(x * RADIUS / peers.RADIUS, y * RADIUS / peers.RADIUS) for x, y in places]
        ends = [[i for i, (x, _) in enumerate(places) if chosen(x)] for chosen in (lambda x: x < 0.1, lambda x: x > 9.9)]
        mass = 2 * math.sqrt(3) * RADIUS**2 * DENSITY
        return peers.in_yade({
            "places": places, "radius": RADIUS, "mass": mass, "inertia": mass * RADIUS**2 / 2, "normal_stiffness": NORMAL,
            "shear_stiffness": SHEAR, "dt": dt, "steps": steps, "fixed": ends[1], "watched": 2 * DISCS - 1,
            "load": {"discs": ends[0], "force": [0, FORCE / len(ends[0])]}})


if __name__ == "__main__":
    unittest.main()
