"""Answers of adit run --within are as accurate as was asked: half of the scenes of the study in docs/accuracy.md."""
import subprocess
import sys
import unittest

from programs import SOURCE, ProgramTest

SCENES = ("cantilever", "block", "ovaling", "plate")
LONGEST_S = 1800


class Reliability(ProgramTest):
    def test_far_finer_results_are_within_the_accuracy_asked_for(self):
        scenes = [SOURCE / "studies" / "accuracy" / f"{name}.yaml" for name in SCENES]
        done = subprocess.run([sys.executable, SOURCE / "studies" / "reliability", *scenes, "--out", self.folder], capture_output=True, text=True,
                              timeout=LONGEST_S)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        rows = [row.split(" | ") for row in done.stdout.splitlines() if row.startswith(tuple(f"| {name} |" for name in SCENES))]
        self.assertEqual(len(rows), 2 * len(SCENES))
        for _, question, _, interval, error, *_ in rows:
            self.assertLessEqual(float(interval), 5, question)
            self.assertLessEqual(float(error), 5, question)


if __name__ == "__main__":
    unittest.main()
