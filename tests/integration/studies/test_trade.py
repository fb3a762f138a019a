"""adit trade measures how accuracy falls with cost."""

import csv
import os
import subprocess
import unittest

from programs import ADIT, PATIENCE_S, ProgramTest


def trade(*arguments, **environment):
    return subprocess.run([*ADIT, "trade", *map(str, arguments)], capture_output=True, text=True,
                          timeout=PATIENCE_S, env=os.environ | environment)


class Trade(ProgramTest):
    def test_a_scene_that_comes_with_adit_has_its_name_and_questions(self):
        """The tip of the cantilever moves less where its zones are longer."""
        result = trade("cantilever", "--budget", "20s", "--out", self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((self.folder / "cantilever.png").exists())
        with open(self.folder / "cantilever.csv", newline="", encoding="utf-8") as file:
            rows = {row["model"]: row for row in csv.DictReader(file)}
        tip = [float(rows[model]["tip_uy_m"]) for model in ("zones_x0.25", "zones_x0.5", "stated")]
        self.assertEqual(tip, sorted(set(tip)))

    def test_names_the_missing_program(self):
        result = trade("--quick", "--out", self.folder, ADIT_BUILD=str(self.folder))
        self.assertEqual(result.returncode, 2)
        self.assertIn(f"{self.folder / 'coupler' / 'coupler'} does not exist", result.stderr)

    def test_options_that_do_not_go_together_are_told(self):
        for words, message in ((("longxi", "--budget", "1min"), "--budget and --figure belong to a scene; name one."),
                               (("bar", "--quick"), "--quick belongs to a tunnel; --budget ends the models of a scene."),
                               (("bar", "--page"), "--page takes all results; it goes with --out only.")):
            with self.subTest(words):
                result = trade(*words, "--out", self.folder)
                self.assertEqual(result.returncode, 2)
                self.assertIn(message, result.stderr)


if __name__ == "__main__":
    unittest.main()
