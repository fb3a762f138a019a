"""Whatever is left of a run, and however little happens in it, scripts show what there is or say in one sentence why they cannot."""

import contextlib
import io
import os
import pathlib
import shutil
import subprocess
import unittest
from unittest import mock

from programs import BUILD, SOURCE, ProgramTest, coupler

from adit import cli
from adit.plots import style
from adit.report import pictures

COARSE = 20  # dots per inch: this is about whether pictures are drawn

MATERIAL = "material: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}\n"
GRID = MATERIAL + """
time: {duration: 1 ms}
continuum:
  block: {x_min: 0 m, x_max: 2 m, y_min: 0 m, y_max: 1 m, zones_x: 2, zones_y: 1}
  linings: [{name: l, along: {line: {points: [{x: 2 m, y: 1 m}, {x: 0 m, y: 1 m}]}}, thickness: 0.1 m, young_modulus: 30 GPa, density: 2500 kg/m^3}]
  histories:
    - {name: a, quantity: acceleration_x, at: {x: 2 m, y: 1 m}}
    - {name: a, quantity: displacement_x, at: {x: 2 m, y: 1 m}}
output: {field_times: [1 ms], spectra: [{history: a, shortest_period: 4 ms}]}
"""
BAR = MATERIAL + """
time: {duration: 1 ms}
particles:
  packing: {x_min: 0 m, x_max: 2 m, y_min: 0 m, y_max: 1 m, radius: 0.2 m}
  bonds: {tensile_strength: 1 N, shear_strength: 1 N}
  histories: [{name: a, quantity: velocity_x, at: {x: 1 m, y: 0.5 m}}]
output: {field_times: [1 ms]}
"""
DISC = MATERIAL + """
time: {duration: 1 ms}
particles: {placed: {path: disc.csv}, contacts: {friction: 0.5}}
output: {field_times: [1 ms]}
"""
TUNNEL = SOURCE / "cases" / "hzm" / "uniform_0.1g.yaml"
AT_REST = {"grid": GRID, "zone": GRID.replace("zones_x: 2", "zones_x: 1"), "bar": BAR, "disc": DISC}
ONE_STEP = {"grid_step": GRID, "bar_step": BAR}


def keep_rows(count):
    """Histories of a run that was killed after so many rows; the run has no summary then."""
    def change(run):
        path = run / "histories.csv"
        path.write_text("".join(path.read_text().splitlines(keepends=True)[:1 + count]))
        (run / "summary.json").unlink()
    return change


def cut(name, share):
    def change(run):
        for path in run.glob(name):
            path.write_bytes(path.read_bytes()[:int(share * path.stat().st_size)])
    return change


def nan_columns(run):
    path = run / "histories.csv"
    head, *rows = path.read_text().splitlines()
    path.write_text("\n".join([head, *(",".join([row.split(",")[0], *["nan"] * head.count(",")]) for row in rows)]) + "\n")


DAMAGES = {"first_row": keep_rows(1), "no_row": keep_rows(0), "half_a_name": cut("histories.csv", 0.02),
           "empty_histories": cut("histories.csv", 0), "nan": nan_columns}


def called(name, *arguments):
    """(exit code, standard error) of a command of `adit`, in this process, since loading matplotlib takes longer than most drawing."""
    said, code = io.StringIO(), 0
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(io.StringIO()), mock.patch.object(pictures, "DOTS", COARSE), \
            style.plt.rc_context({"savefig.dpi": COARSE}):
        try:
            cli.run(name, [str(word) for word in arguments])
        except SystemExit as end:
            code = end.code or 0
    return code, said.getvalue()


class OddRuns(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """Runs in which nothing happens, and one in which something does."""
        cls.runs = cls.folder_for_all()
        (cls.runs / "disc.csv").write_text("x_m,y_m,radius_m\n0,0,0.5\n")
        moved = {"moved_bar": (BAR, "particles.body_loads=[{acceleration: {x: 1 g}}]")}
        one_step = ("time.duration=10 us", "output.field_times=[0]")
        for name, (text, *sets) in ({name: (text,) for name, text in AT_REST.items()} | moved |
                                    {name: (text, *one_step) for name, text in ONE_STEP.items()}).items():
            scene = cls.runs / f"{name}.yaml"
            scene.write_text(text)
            done = coupler("run", scene, "--out", cls.runs / name, *(word for each in sets for word in ("--set", each)))
            assert done.returncode == 0, done.stderr
        (cls.runs / "rest.csv").write_text("time_s,acceleration_g\n" + "".join(f"{k / 10},0\n" for k in range(5)))
        scene = cls.runs / "tunnel.yaml"
        scene.write_text(f"extends: {TUNNEL}\ntime: {{duration: 0.2 s}}\n"
                         "simplified: {excitation: {motion: {sine: {frequency: 1 Hz, end: 1 s}, peak: 1}}}\n")
        subprocess.run([BUILD / "simplified" / "simplified", "run", scene, "--out", cls.runs / "tunnel"], check=True, capture_output=True)

    def assert_shown_or_told(self, script, *arguments):
        with self.subTest(" ".join([script, *(pathlib.Path(each).name for each in arguments)])):
            code, said = called(script, *arguments)
            self.assertIn(code, (0, 2), said)
            self.assertEqual(said.count("\n"), 1 if code else 0, said)
            if code:
                self.assertRegex(said, rf"^scripts/adit {script}: ")
            return code

    def test_runs_in_which_nothing_happens_are_shown(self):
        for name in (*AT_REST, *ONE_STEP, "tunnel"):
            for script in ("plot", "report"):
                self.assertEqual(self.assert_shown_or_told(script, self.runs / name), 0)
            self.assert_shown_or_told("paraview", self.runs / name)
            self.assertEqual(self.assert_shown_or_told("compare", self.runs / name, self.runs / name, "--out", self.folder), 0)

    def test_what_is_left_of_a_run_is_shown_or_told(self):
        for name, damage in DAMAGES.items():
            run = self.folder / name
            shutil.copytree(self.runs / "moved_bar", run)
            damage(run)
            for script in ("plot", "report"):
                self.assert_shown_or_told(script, run)

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_folders_that_may_not_be_written_are_told(self):
        run = self.folder / "run"
        shutil.copytree(self.runs / "grid", run)
        run.chmod(0o555)
        self.addCleanup(run.chmod, 0o755)
        for script in ("plot", "report"):
            self.assertEqual(self.assert_shown_or_told(script, run), 2)

    def test_a_file_where_a_folder_is_to_be_written_is_told(self):
        file = self.folder / "file"
        file.write_text("")
        run = self.folder / "run"
        shutil.copytree(self.runs / "grid", run)
        (run / "pictures").write_text("")
        self.assertEqual(self.assert_shown_or_told("plot", run), 2)
        (run / "report.html").mkdir()
        self.assertEqual(self.assert_shown_or_told("report", run), 2)
        shutil.rmtree(run / "fields")
        shutil.copytree(self.runs / "grid" / "fields", run / "fields")
        (run / "fields" / "paraview.py").mkdir()
        self.assertEqual(self.assert_shown_or_told("paraview", run), 2)
        self.assertEqual(self.assert_shown_or_told("compare", self.runs / "grid", self.runs / "zone", "--out", file), 2)
        for script, *arguments in (("trade", "bar", "--quick"), ("cluster", self.runs / "grid.yaml", "--nodes", "1")):
            with mock.patch.dict(os.environ, ADIT_BUILD=str(BUILD)):
                self.assertEqual(self.assert_shown_or_told(script, *arguments, "--out", file), 2)


if __name__ == "__main__":
    unittest.main()
