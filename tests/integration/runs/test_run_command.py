"""One command computes a scene or a study, from any folder."""

import contextlib
import io
import pathlib
import subprocess
import sys
import unittest
from unittest import mock

from programs import ADIT, CASE, PATIENCE, SOURCE, ProgramTest, wait_until

from adit.cli import COMMANDS
from adit.runs import coupled_runs


class RunCommand(ProgramTest):
    def test_a_relative_out_counts_from_the_folder_of_the_user(self):
        for arguments in ((CASE / "coupled.yaml",), (CASE / "coupled.yaml", "--vary", "time.dt_factor=0.4")):
            with self.subTest(arguments):
                out = f"out/{len(arguments)}"
                done = subprocess.run([SOURCE / "scripts" / "run", *arguments, "--out", out, "--no-pictures", "--set",
                                       "time.duration=2 ms", "--set", "output.field_times=[]"], cwd=self.folder,
                                      capture_output=True, text=True, timeout=120)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(len(list((self.folder / out).glob("**/summary.json"))), 1)

    def test_every_path_counts_from_the_folder_of_the_user(self):
        """The scene, the records of --set and --vary, and the results where no --out is given."""
        (self.folder / "record.csv").write_text("time_s,acceleration_g\n" + "".join(f"{k / 1000},{k % 2}\n" for k in range(5)))
        (self.folder / "own").mkdir()
        (self.folder / "own" / "scene.yaml").write_text(
            "material: {young_modulus: 1 GPa, poisson_ratio: 0.2, density: 2 t/m^3}\ntime: {duration: 2 ms}\n"
            "continuum:\n  block: {x_min: 0, x_max: 1, y_min: 0, y_max: 1, zones_x: 1, zones_y: 1}\n"
            "  base: {kind: rigid, acceleration: {sine: {frequency: 1 kHz, end: 1 ms}}}\n")
        path = "continuum.base.acceleration.file.path"
        for option, runs in (("--set", ["runs/own/scene"]), ("--vary", ["runs/own/scene_variants/path=record.csv"])):
            done = subprocess.run([SOURCE / "scripts" / "run", "own/scene.yaml", "--no-pictures", option, f"{path}=record.csv"],
                                  cwd=self.folder, capture_output=True, text=True, timeout=120 * PATIENCE)
            self.assertEqual(done.returncode, 0, done.stderr)
            for run in runs:
                self.assertIn(str(self.folder / "record.csv"), (self.folder / run / "scene.yaml").read_text())

    def test_every_front_door_tells_its_options(self):
        for words in ([], *([name] for name in COMMANDS)):
            with self.subTest(words):
                done = subprocess.run([*ADIT, *words, "--help"], cwd=self.folder, capture_output=True, text=True,
                                      timeout=60 * PATIENCE)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertGreater(len(done.stdout), 100)

    def adit(self, *words):
        return subprocess.run([*ADIT, *words], cwd=self.folder, capture_output=True, text=True, timeout=120 * PATIENCE)

    def test_the_reader_says_which_program_computes_a_scene(self):
        (self.folder / "a folder").mkdir()
        (self.folder / "a folder" / "base.yaml").write_text(f"extends: {SOURCE}/cases/hzm/uniform_0.1g.yaml\n")
        (self.folder / "extended.yaml").write_text('extends: "a folder/base.yaml"\n')
        for scene, program in ((CASE / "coupled.yaml", "coupler"), ("extended.yaml", "simplified")):
            self.assertEqual(self.adit("check", scene, "--which").stdout, f"{program}\n")
        (self.folder / "wrong.yaml").write_text("nothing: 1\n")
        done = self.adit("run", "wrong.yaml")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
        self.assertIn("nothing", done.stderr)

    def test_watch_tells_how_far_a_run_is(self):
        run = self.run_scene(CASE / "full_fdm.yaml", "--set", "time.duration=2 ms", "--set", "output.field_times=[]")
        done = self.adit("watch", run)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("completed at 0.002 s", done.stdout)
        (run / "summary.json").unlink()
        text = (run / "histories.csv").read_text().splitlines(keepends=True)
        (run / "histories.csv").write_text("".join(text[:len(text) // 2]))
        done = self.adit("watch", run, "--once")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\A0\.\d+ of 0\.002 s \(\d\d %\), ")

    def test_several_scenes_have_a_folder_each_below_out(self):
        case = self.folder / "case"
        case.mkdir()
        for name in ("a", "b"):
            (case / f"{name}.yaml").write_text(f"extends: {CASE}/full_fdm.yaml\n")
        done = self.adit("run", "case", "--out", "out", "--no-pictures", "--set", "time.duration=1 ms", "--set", "output.field_times=[]")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("a", "b"):
            self.assertTrue(self.summary(self.folder / "out" / name)["completed"])

    def run_with(self, server):
        return subprocess.run([SOURCE / "scripts" / "run", CASE / "full_fdm.yaml", "--fdm", server, "--out", self.folder / "run", "--no-pictures",
                               "--set", "time.duration=2 ms", "--set", "output.field_times=[]"], capture_output=True, text=True, timeout=120)

    def test_a_server_is_started_by_its_command_and_ends_with_the_run(self):
        started = self.folder / "process"
        done = self.run_with(f"bash -c 'echo $$ >{started}; exec {SOURCE}/adapters/python/continuum.py'")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("numpy_continuum", self.summary(self.folder / "run")["versions"])
        wait_until(lambda: not pathlib.Path(f"/proc/{started.read_text().strip()}").exists())

    def test_a_command_that_does_not_listen(self):
        done = self.run_with("echo hello")
        self.assertEqual(done.returncode, 2)
        self.assertIn("`echo hello` said `hello` where `listening on HOST:PORT` was expected", done.stderr)

    def test_a_study_names_the_scenes_that_it_computes(self):
        case, said = SOURCE / "cases" / "qingcaosha" / "ovaling", io.StringIO()
        with contextlib.chdir(SOURCE), contextlib.redirect_stdout(said), mock.patch.object(sys, "argv", ["study"]), \
                mock.patch.object(coupled_runs.subprocess, "run", return_value=mock.Mock(returncode=2)), self.assertRaises(SystemExit):
            coupled_runs.run_case(case, ("beams",), "")
        self.assertEqual(said.getvalue(), "run: cases/qingcaosha/ovaling/beams.yaml\n")

    def test_a_study_draws_each_run_and_reports_and_compares_them_unless_told_not_to(self):
        case = SOURCE / "cases" / "qingcaosha" / "ovaling"
        for words, after in (([], ["report", "compare"]), (["--no-report"], [])):
            with contextlib.redirect_stdout(io.StringIO()), mock.patch.object(sys, "argv", ["study", "--out", str(self.folder), *words]), \
                    mock.patch.object(coupled_runs.subprocess, "run", return_value=mock.Mock(returncode=0)) as done, \
                    mock.patch.object(coupled_runs, "Run"):
                coupled_runs.run_case(case, ("beams", "zones"), "")
            asked = [next(word for word in call.args[0] if word in ("run", "plot", "report", "compare")) for call in done.call_args_list]
            self.assertEqual(asked, ["run", "plot", "run", "plot", *after])


if __name__ == "__main__":
    unittest.main()
