"""Yade and dem_server compute the same motion of a bonded cantilever during a whole period after sudden loading, and Yade can take
the place of dem_server in a coupled run."""

import math
import shutil
import subprocess
import unittest

from programs import ADIT, CASE, Listening, ProgramTest, SOURCE, columns, coupler

from benchmarks.peers import particles as peers

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


@unittest.skipUnless(shutil.which("yade"), "needs the Debian packages yade (scripts/setup adapters)")
class SameBeamInYade(ProgramTest):
    def test_histories_of_the_tip_agree(self):
        run = self.run_scene(self.scene(SCENE))
        summary = self.summary(run)
        histories = columns(run)
        self.assertGreater(len(histories["time_s"]), 390)
        yade = self.in_yade(summary["dt_s"], summary["steps"])
        self.assertEqual(yade["bonds"], summary["bonds"])
        for axis, name in enumerate(("tip_ux_m", "tip_uy_m")):
            pairs = [(value, yade["displacement"][round(time / summary["dt_s"])][axis])
                     for time, value in zip(histories["time_s"], histories[name])]
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


@unittest.skipUnless(shutil.which("yade"), "needs the Debian packages yade (scripts/setup adapters)")
class YadeAsParticles(ProgramTest):
    BEAM = CASE / "variants/coupled_52x6.yaml"
    SHORT = ("--set", "time.duration=6 ms", "--set", "output.field_times=[3 ms]")

    def served(self):
        """The address of adapters/yade."""
        yade = Listening([SOURCE / "adapters/yade/participant.py"])
        self.addCleanup(yade.end)
        return yade.address

    def test_it_computes_the_coupled_cantilever(self):
        """Both sum in another order, and Yade keeps places of 10 m, of which a displacement of 10 mm has 13 digits."""
        own = self.run_scene(self.BEAM, *self.SHORT, out="own")
        run = self.run_scene(self.BEAM, *self.SHORT, "--dem", self.served(), out="yade")
        for name in ("tip_uy_m", "particles_strain_J", "particles_kinetic_J", "max_bond_force_N"):
            ours, theirs = (columns(folder)[name] for folder in (own, run))
            apart = max(abs(a - b) for a, b in zip(ours, theirs)) / max(map(abs, ours))
            print(f"{name}: within {apart:.2g} of the largest value")
            self.assertLess(apart, 1e-3)
        self.assertLess(self.summary(run)["max_energy_drift"], 1e-5)

    def test_bonds_that_break_are_refused(self):
        done = coupler("run", self.BEAM, *self.SHORT, "--set", "particles.bonds.tensile_strength=4 MN", "--dem", self.served(),
                       "--out", self.folder / "run")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("particles.bonds.tensile_strength", done.stderr)
        self.assertIn("do not break", done.stderr)

    def test_it_passes_the_conformance_checks(self):
        done = subprocess.run([*ADIT, "conformance", "--dem", SOURCE / "adapters/yade/participant.py"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertNotIn("FAILED", done.stdout)


if __name__ == "__main__":
    unittest.main()
