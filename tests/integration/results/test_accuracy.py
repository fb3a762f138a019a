"""adit run SCENE --within: the results of far finer models lie inside the intervals that it tells."""
import csv
import json
import subprocess
import unittest

from programs import ADIT, ProgramTest

from adit import Run

HALF = 16.0
THRUST, MOMENT = "lining_tunnel_least_thrust_N", "lining_tunnel_largest_moment_Nm"
# A ring of beams in ground that is sheared and pressed, at rest.
SCENE = {
    "material": {"young_modulus": 500e6, "poisson_ratio": 0.3, "density": 2000.0}, "time": {"duration": 1e-3},
    "statics": {"unbalanced_ratio": 1e-5, "max_steps": 20000, "damping": "adaptive"},
    "tunnels": [{"centre": {"x": 0.0, "y": 0.0}, "circle": {"radius": 3.0},
                 "lining": {"as": "beam", "thickness": 0.4, "material": {"young_modulus": 30e9, "poisson_ratio": 0.2, "density": 2500.0}}}],
    "continuum": {
        "block": {"x_min": -HALF, "x_max": HALF, "y_min": -HALF, "y_max": HALF, "zones_x": 32, "zones_y": 32},
        "edge_loads": [{"where": {"y_min": HALF}, "force": {"x": 50e3 * 2 * HALF, "y": -200e3 * 2 * HALF}}],
        "motions": [{"where": {"y_max": -HALF}, "velocity": {"x": 0.0, "y": 0.0}}]},
    "output": {"field_times": []}}


class Within(ProgramTest):
    def asked(self, *words):
        scene = self.scene(json.dumps(SCENE))
        return subprocess.run([*ADIT, "run", scene, "--out", self.folder / "out", "--no-pictures", *words], capture_output=True, text=True, timeout=300)

    def test_far_finer_results_lie_inside(self):
        done = self.asked("--within", "3%", "--figure", THRUST, "--figure", MOMENT, "--budget", "4min")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("is reached", done.stdout)
        with open(self.folder / "out" / "accuracy.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        finest = max(rows, key=lambda row: float(row["run"].partition("_x")[2] or 1))
        zones = 32 * 4 * float(finest["run"].partition("_x")[2] or 1)
        truth = Run(self.run_scene(self.folder / "scene.yaml", "--set", f"continuum.block.zones_x={zones:g}", "--set",
                                   f"continuum.block.zones_y={zones:g}", out="truth")).summary
        told = {line.split(" = ")[0]: line.split() for line in done.stdout.splitlines() if " ± " in line}
        for question in (THRUST, MOMENT):
            value, interval = float(told[question][2]), float(told[question][4]) / 100
            self.assertLessEqual(interval, 0.03)
            self.assertLess(abs(truth[question] / value - 1), interval, question)

    def test_what_was_reached_is_told_where_the_budget_ends(self):
        done = self.asked("--within", "0.01%", "--figure", THRUST, "--budget", "1s")
        self.assertEqual(done.returncode, 6, done.stdout + done.stderr)
        self.assertIn("is not reached within the budget", done.stdout)
        self.assertIn(f"{THRUST} = ", done.stdout)

    def test_what_cannot_be_asked_is_said_in_one_sentence(self):
        for words, message in ((("--within", "3%"), "but of nothing; name figures"), (("--within", "3", "--figure", THRUST), "is no share between 0 and 1"),
                               (("--within", "3%", "--figure", THRUST, "--budget", "soon"), "is no time"),
                               (("--within", "3%", "--figure", "lining_tunnel_largest_thrust"), "did you mean `lining_tunnel_largest_thrust_N`?")):
            with self.subTest(words):
                done = self.asked(*words)
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(message, done.stderr)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
