"""The worst run of a study of a whole tunnel is computed in detail by the same command, as it would be step by step, and only once."""

import csv
import os
import signal
import subprocess
import unittest

from programs import ADIT, BUILD, PATIENCE_S, ProgramTest, wait_until

from studies.test_zoom_study import SCENE

STUDY = """
scene: tunnel.yaml
set: [time.duration=1.2 s, simplified.zoom.width=45 m]
motions:
  of: [{ricker: {frequency: 2 Hz, time: 0.6 s}}, {ricker: {frequency: 3 Hz, time: 0.6 s}}]
  stripes: {pga: [0.1 g, 0.3 g]}
questions: [element_joint_max_opening_m]
detail: {of: element_joint_max_opening_m}
"""
ANSWER = "element_joint_max_opening_m"
PLACE = "worst-opening"


class Detail(ProgramTest):
    def setUp(self):
        super().setUp()
        self.scene(SCENE, "tunnel.yaml")
        self.scene(STUDY, "study.yaml")

    def command(self, out="out"):
        return [*ADIT, "study", self.folder / "study.yaml", "--out", self.folder / out, "--no-pictures", "--jobs", "2"]

    def study(self, out="out"):
        done = subprocess.run(self.command(out), capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def rows(self, name, out="out"):
        with open(self.folder / out / name, newline="") as file:
            return list(csv.DictReader(file))

    def test_the_worst_run_is_computed_as_it_would_be_step_by_step(self):
        """The section has the histories, to the last bit, of the scene that `simplified run --zoom` writes; its joint opens as that of the
        beam within 10 %, and that of the beam as in the study."""
        told = self.study()
        (row,) = self.rows("detail.csv")
        largest = max(self.rows("study.csv"), key=lambda each: float(each[ANSWER]))
        self.assertEqual((row["run"], row["motion"], row["level"], row[ANSWER]), tuple(largest[key] for key in ("run", "motion", "level", ANSWER)))
        self.assertIn(f"in detail          run {row['run']}, {row['motion']} at 0.3 g, element_joint at {float(row['chainage_m']):g} m: edge opening", told)
        self.assertAlmostEqual(float(row["beam_edge_opening_m"]) / float(row[ANSWER]), 1, 1)
        self.assertAlmostEqual(float(row["section_edge_opening_m"]) / float(row["beam_edge_opening_m"]), 1, delta=0.1)
        zoomed = self.run_simplified(self.folder / "out" / row["beam"] / "scene.yaml")
        alone = self.run_scene(zoomed / "zoom" / f"{PLACE}.yaml")
        self.assertEqual((alone / "histories.csv").read_bytes(), (self.folder / "out" / row["section"] / "histories.csv").read_bytes())

    def run_simplified(self, scene):
        out = self.folder / "zoomed"
        done = subprocess.run([BUILD / "simplified/simplified", "run", scene, "--zoom", PLACE, "--out", out],
                              capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def test_a_study_that_is_killed_in_detail_goes_on_there(self):
        process = subprocess.Popen(self.command(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_until(lambda: list((self.folder / "out").glob("work/*_section.*/histories.csv")))
        os.kill(process.pid, signal.SIGKILL)
        process.wait(PATIENCE_S)
        self.assertFalse((self.folder / "out" / "detail.csv").exists())
        self.assertIn("  1 runs computed in", self.study())
        table = (self.folder / "out" / "detail.csv").read_bytes()
        self.assertEqual(list((self.folder / "out").glob("work")), [])
        self.assertNotIn("computed in", self.study())
        self.assertEqual((self.folder / "out" / "detail.csv").read_bytes(), table)

    def test_what_cannot_be_computed_in_detail_is_refused_before_the_first_run(self):
        for text, said in ((STUDY.replace("simplified.zoom.width=45 m", "simplified.zoom=null"), "tunnel.yaml has no simplified.zoom"),
                           (STUDY.replace("simplified.zoom.width=45 m", "simplified.tunnel.joints=null"), "is no scene of a whole tunnel with joints"),
                           (STUDY.replace("detail: {of: element_joint", "detail: {of: segment_joint"), "is not asked of a run; did you mean")):
            with self.subTest(said):
                self.scene(text, "study.yaml")
                done = subprocess.run(self.command(), capture_output=True, text=True, timeout=PATIENCE_S)
                self.assertEqual(done.returncode, 2)
                self.assert_one_line(done.stderr)
                self.assertIn(said, done.stderr)
                self.assertFalse((self.folder / "out" / "runs").exists())


if __name__ == "__main__":
    unittest.main()
