"""adit run SCENE --within, adit trade SCENE: results of far finer models lie inside the intervals that are told."""
import csv
import json
import subprocess
import unittest

from programs import ADIT, ProgramTest, coupler

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


SMALL = {"continuum": SCENE["continuum"] | {"block": SCENE["continuum"]["block"] | {"zones_x": 16, "zones_y": 16}}}
# A specimen of cells that is torn apart by two platens; where it cracks depends on the cells.
PLATEN = {"fracture": {"tensile_strength": 1e8, "fracture_energy": 1e6, "compressive_strength": 1e9}}
TORN = {
    "material": {"young_modulus": 30e9, "poisson_ratio": 0.2, "density": 2400.0,
                 "fracture": {"tensile_strength": 2.5e6, "fracture_energy": 10.0, "compressive_strength": 39e6}},
    "plane": "plane_stress", "time": {"duration": 5e-3},
    "particles": {"cells": {"x_min": 0.0, "x_max": 0.1, "y_min": -0.02, "y_max": 0.22, "size": 0.02},
                  "groups": [{"name": "lower", "where": {"y_max": 0.0}, "bonds": PLATEN}, {"name": "upper", "where": {"y_min": 0.2}, "bonds": PLATEN}],
                  "motions": [{"where": {"y_max": 0.0}, "velocity": {"x": 0.0, "y": 0.0}}, {"where": {"y_min": 0.2}, "velocity": {"x": 0.0, "y": 0.02}}]},
    "output": {"field_times": []}}


class Accuracy(ProgramTest):
    def adit(self, scene, command, *words):
        path = self.scene(json.dumps(scene))
        drawn = ("--no-pictures",) if command == "run" else ()
        return subprocess.run([*ADIT, command, path, "--out", self.folder / "out", *drawn, *words], capture_output=True, text=True, timeout=300)

    def rows(self, name):
        with open(self.folder / "out" / name, newline="") as file:
            return list(csv.DictReader(file))


class Within(Accuracy):
    def test_far_finer_results_lie_inside(self):
        done = self.adit(SCENE, "run", "--within", "3%", "--figure", THRUST, "--figure", MOMENT, "--budget", "4min")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("is reached", done.stdout)
        zones = 32 * 4 * float(self.rows("accuracy.csv")[-1]["run"].partition("_x")[2] or 1)
        truth = Run(self.run_scene(self.folder / "scene.yaml", "--set", f"continuum.block.zones_x={zones:g}", "--set",
                                   f"continuum.block.zones_y={zones:g}", out="truth")).summary
        told = {line.split(" = ")[0]: line.split() for line in done.stdout.splitlines() if " ± " in line}
        for question in (THRUST, MOMENT):
            value, interval = float(told[question][2]), float(told[question][4]) / 100
            self.assertLessEqual(interval, 0.03)
            self.assertLess(abs(abs(truth[question] / value) - 1), interval, question)

    def test_a_scene_may_ask_and_the_command_line_wins(self):
        asking = SCENE | SMALL | {"questions": [THRUST], "accuracy": {"within": "8 %", "budget": "1 min"}}
        done = self.adit(asking, "run")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("within 8 %", done.stdout)
        self.assertIn(f"{THRUST} = ", done.stdout)
        done = self.adit(asking, "run", "--within", "20%", "--figure", MOMENT)
        self.assertIn("within 20 %", done.stdout)
        self.assertNotIn(THRUST, done.stdout)
        self.assertIn(f"{MOMENT} = ", done.stdout)

    def test_a_scene_that_asks_is_computed_once_by_the_coupler(self):
        asking = SCENE | SMALL | {"questions": [THRUST], "accuracy": {"within": "8 %"}}
        self.assertTrue(Run(self.run_scene(self.scene(json.dumps(asking)))).completed)
        told = coupler("check", self.folder / "scene.yaml")
        self.assertRegex(told.stdout, r"accuracy +adit run refines the scene until 1 answers are within 8 %, for at most 20 min")

    def test_what_was_reached_is_told_where_the_budget_ends(self):
        done = self.adit(SCENE, "run", "--within", "0.01%", "--figure", THRUST, "--budget", "1s")
        self.assertEqual(done.returncode, 6, done.stdout + done.stderr)
        self.assertIn("is not reached within the budget", done.stdout)
        self.assertIn(f"{THRUST} = ", done.stdout)

    def test_what_scatters_is_told_as_a_median_with_its_range(self):
        done = self.adit(TORN, "run", "--within", "1%", "--figure", "peak_bond_force_N", "--budget", "20s")
        self.assertEqual(done.returncode, 6, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"peak_bond_force_N = \S+, from \S+ to \S+: it scatters, and this is the median of five packings")

    def test_what_cannot_be_asked_is_said_in_one_sentence(self):
        for scene, words, message in (
                (SCENE, ("--within", "3%"), "but of nothing; name figures"),
                (SCENE | {"accuracy": {"within": "5 %"}}, (), "accuracy: asks for an accuracy, but of nothing; name figures"),
                (SCENE | {"accuracy": {}, "questions": [THRUST]}, (), "accuracy.within"),
                (SCENE, ("--within", "3", "--figure", THRUST), "is no share between 0 and 1"),
                (SCENE, ("--within", "3%", "--figure", THRUST, "--budget", "soon"), "is no time"),
                (SCENE, ("--figure", THRUST), "belong to an accuracy, and none is asked for"),
                (SCENE, ("--within", "3%", "--figure", "lining_tunnel_largest_thrust"), "the nearest are lining_tunnel_largest_thrust_N"),
                (SCENE | {"questions": ["nothing"]}, ("--within", "3%"), "nothing is no figure of")):
            with self.subTest(words, message=message):
                done = self.adit(scene, "run", *words)
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(message, done.stderr)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertNotIn("stated:", done.stdout)  # before the scene itself is computed


class Trade(Accuracy):
    def test_finer_models_of_a_scene_are_nearer_to_the_finest(self):
        done = self.adit(SCENE | {"questions": [THRUST]}, "trade", "--budget", "2min")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rows = {row["model"]: row for row in self.rows("scene.csv")}
        finest = float(rows["zones_x2"][THRUST])
        errors = [abs(float(rows[name][THRUST]) / finest - 1) for name in ("zones_x0.25", "zones_x0.5", "stated")]
        self.assertEqual(errors, sorted(errors, reverse=True))
        self.assertIn("step_x0.5", rows)
        self.assertRegex((self.folder / "out" / "scene.md").read_text(), r"\| zones \| zones_x2 \| .*\(order \d\.?\d*\)")
        self.assertTrue((self.folder / "out" / "scene.png").exists())

    def test_what_cannot_be_traded_is_said_in_one_sentence(self):
        for words, message in (((), "has no `questions`"), (("--figure", THRUST, "--budget", "soon"), "is no time"),
                               (("--figure", "tunnel_thrust"), "tunnel_thrust is no figure of")):
            with self.subTest(words):
                done = self.adit(SCENE, "trade", *words)
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertIn(message, done.stderr)
        done = subprocess.run([*ADIT, "trade", "nowhere.yaml"], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 2)
        self.assertIn("nowhere.yaml is neither a scene nor one of cantilever, bar", done.stderr)


if __name__ == "__main__":
    unittest.main()
