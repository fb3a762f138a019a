"""A study computes what its runs would compute one by one, goes on after any death, computes nothing twice, makes the same table wherever
it is computed, and says in one sentence what is wrong with it."""

import contextlib
import csv
import io
import os
import pathlib
import random
import signal
import subprocess
import time
import unittest
from unittest import mock

from programs import ADIT, BUILD, PATIENCE_S, ProgramTest, children_of, wait_until

from adit import Run, cli
from adit.runs import children
from network.machines import NEAR, Link, Machines, NotAllowed

COLUMN = """
time: {duration: 2.5 s, dt_factor: 0.9}
statics: {unbalanced_ratio: 1e-5}
material: {young_modulus: 100 MPa, poisson_ratio: 0.3, density: 2 t/m^3}
continuum:
  block: {x_min: 0 m, x_max: 1 m, y_min: 0 m, y_max: 20 m, zones_x: 1, zones_y: 10}
  body_loads: [{acceleration: {y: -1 g}}]
  free_field: {left: true, right: true}
  base: {kind: compliant, acceleration: {ricker: {frequency: 2 Hz, time: 1 s}, peak: 1}}
  histories:
    - {name: surface, quantity: acceleration_x, at: {x: 0 m, y: 20 m}}
    - {name: drift, quantity: displacement_x, at: {x: 0 m, y: 20 m}, relative_to: {x: 0 m, y: 0 m}}
output: {history_interval: 10 ms, field_times: []}
"""
MOTIONS = """
scene: column.yaml
motions:
  of:
    - {ricker: {frequency: 2 Hz, time: 1 s}}
    - {ricker: {frequency: 3 Hz, time: 1 s}}
    - {synthetic: {spectrum: ec8_type_1, ground: b, seed: 1}}
"""
STRIPES = MOTIONS + """
  stripes: {pga: [0.1 g, 0.2 g, 0.4 g]}
questions: [drift_ux_m]
damage: [{of: drift_ux_m, states: [{name: minor, above: 0.01}, {name: major, above: 0.02}]}]
"""
SOFT = """
random:
  - {name: stiffness, keys: [material.young_modulus], multiplies: true, lognormal: {median: 1, dispersion: 0.2}}
"""


class StudyTest(ProgramTest):
    def setUp(self):
        super().setUp()
        self.scene(COLUMN, "column.yaml")

    @staticmethod
    def command_in(folder, out, *options):
        return [*ADIT, "study", folder / "study.yaml", "--out", folder / out, "--no-pictures", "--jobs", "2", *options]

    def command(self, out, *options):
        return self.command_in(self.folder, out, *options)

    @classmethod
    def computed(cls, text):
        """The results of a study that all tests of a class read and none changes."""
        folder = cls.folder_for_all()
        (folder / "column.yaml").write_text(COLUMN)
        (folder / "study.yaml").write_text(text)
        subprocess.run(cls.command_in(folder, "out"), check=True, capture_output=True, timeout=PATIENCE_S * 3)
        return folder / "out"

    def study(self, text, *options, out="out", code=0, **others):
        self.scene(text, "study.yaml")
        done = subprocess.run(self.command(out, *options), capture_output=True, text=True, timeout=PATIENCE_S * 3, **others)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def rows(self, out="out"):
        with open(self.folder / out / "study.csv", newline="") as file:
            return list(csv.DictReader(file))

    def table(self, out="out"):
        return (self.folder / out / "study.csv").read_bytes()

    def refused(self, text, *options, code=2):
        done = self.study(text, *options, code=code)
        self.assert_one_line(done.stderr)
        return done.stderr


class Computes(StudyTest):
    @classmethod
    def setUpClass(cls):
        cls.stripes = cls.computed(STRIPES)

    def test_each_run_is_that_of_its_scene_alone_though_all_begin_from_one_state_at_rest(self):
        rows = self.rows(self.stripes)
        self.assertEqual(len(rows), 9)
        self.assertEqual(len(list((self.stripes / "rest").glob("*[0-9a-f]"))), 1)
        for row in rows[::4]:
            kept = self.stripes / row["folder"]
            alone = self.run_scene(kept / "scene.yaml", out=row["run"])
            self.assertEqual((alone / "histories.csv").read_bytes(), (kept / "histories.csv").read_bytes())
            self.assertAlmostEqual(float(row["drift_ux_m"]), abs(Run(alone).histories["drift_ux_m"]).max(), 12)

    def test_motions_have_the_intensity_that_is_asked(self):
        for measure, levels, column in (("pga", "[0.5, 2]", "pga_m_per_s2"), ("pgv", "[0.05, 0.1]", "pgv_m_per_s"), ("arias", "[0.1, 0.4]", "arias_m_per_s"),
                                        ("sa", "[1, 3], period: 0.5 s", "sa(0.5s)_m_per_s2")):
            with self.subTest(measure):
                self.study(MOTIONS + f"  stripes: {{{measure}: {levels}}}\nquestions: [surface_ax_m_per_s2]\n", out=measure)
                for row in self.rows(measure):
                    self.assertAlmostEqual(float(row[column]) / float(row["level"]), 1, 9)

    def test_a_linear_column_answers_in_proportion_to_the_motion(self):
        by_level = {row["level"]: float(row["drift_ux_m"]) for row in self.rows(self.stripes) if row["motion"] == "ricker_2Hz"}
        first, second, third = by_level.values()
        self.assertAlmostEqual(second / first, 2, 4)  # rest has an unbalanced share of 1e-5
        self.assertAlmostEqual(third / first, 4, 4)

    def test_what_is_drawn_is_what_the_scene_has(self):
        self.study(STRIPES + SOFT)
        for row in self.rows()[::3]:
            modulus = Run(self.folder / "out" / row["folder"]).scene["material"]["young_modulus"]
            self.assertAlmostEqual(modulus / 100e6, float(row["stiffness"]), 12)

    def test_climbs_end_at_the_last_damage_state(self):
        self.study(STRIPES.replace("stripes: {pga: [0.1 g, 0.2 g, 0.4 g]}", "increments: {pga: [0.1 g, 0.2 g, 0.3 g, 0.4 g, 0.8 g, 1.6 g]}"))
        for name in {row["motion"] for row in self.rows()}:
            reached = [int(row["drift_ux_m_state"]) for row in self.rows() if row["motion"] == name]
            self.assertEqual(reached[-1], 2)
            self.assertNotIn(2, reached[:-1])

    def test_a_run_that_fails_is_one_row_with_its_reason(self):
        unstable = STRIPES + "\nset: [time.beyond_critical=true]\nrandom: [{name: dt, keys: [time.dt], discrete: {values: [1 ms, 20 ms], weights: [8, 1]}}]\n"
        self.study(unstable)
        failed = [row for row in self.rows() if row["failed"]]
        self.assertEqual({row["dt"] for row in failed}, {"20 ms"})
        self.assertEqual({row["dt"] for row in self.rows() if not row["failed"]}, {"1 ms"})

    def test_where_all_runs_fail_the_table_says_why(self):
        self.study(STRIPES + "set: [time.dt=20 ms]\n", code=1)
        for row in self.rows():
            self.assertIn("critical", row["failed"])

    def test_functions_are_asked_of_runs_with_what_was_drawn(self):
        (self.folder / "answers.py").write_text("def twice(run, drawn):\n    return 2 * drawn['capacity'] + 0 * run.summary['duration_s']\n")
        self.study(MOTIONS + "functions: [{name: twice, file: answers.py}]\nrandom: [{name: capacity, uniform: {from: 1, to: 2}}]\n")
        for row in self.rows():
            self.assertAlmostEqual(float(row["twice"]), 2 * float(row["capacity"]), 12)


class GoesOn(StudyTest):
    def test_nothing_is_computed_twice_and_only_what_changed_again(self):
        self.study(STRIPES)
        table = self.table()
        self.assertNotIn("computed in", self.study(STRIPES).stdout)
        self.assertEqual(self.table(), table)
        done = self.study(STRIPES.replace("0.4 g]", "0.4 g, 0.5 g]"))
        self.assertIn("3 runs computed in", done.stdout)
        self.scene(COLUMN.replace("100 MPa", "110 MPa"), "column.yaml")
        self.assertIn("9 runs computed in", self.study(STRIPES).stdout)
        self.assertNotEqual(self.table(), table)

    def test_a_new_question_is_answered_from_what_is_there(self):
        self.study(STRIPES)
        done = self.study(STRIPES.replace("questions: [drift_ux_m]", "questions: [drift_ux_m, surface_ax_m_per_s2]"))
        self.assertNotIn("computed in", done.stdout)
        self.assertGreater(float(self.rows()[0]["surface_ax_m_per_s2"]), 0.5)

    def test_whatever_is_killed_the_table_is_the_same(self):
        longer = STRIPES + SOFT + "set: [time.duration=8 s]\n"
        self.study(longer, out="whole")
        dice = random.Random(3)
        killed = {"study": 0, "coupler": 0, "fdm_server": 0}
        while True:
            process = subprocess.Popen(self.command("out"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            if sum(killed.values()) >= 10:
                process.wait(PATIENCE_S * 3)
                break
            time.sleep(dice.uniform(0.8, 1.6))
            name, pid = dice.choice([("study", process.pid), *(each for each in self.programs_of(process.pid) if each[0] in killed)])
            killed[name] += self.kill(pid)
            if name != "study" and dice.random() < 0.5:
                killed["study"] += self.kill(process.pid)
            process.wait(PATIENCE_S)
        print(killed)
        self.assertEqual(self.table(), self.table("whole"))
        self.assertEqual(list((self.folder / "out" / "work").glob("*")), [])

    def programs_of(self, pid):
        for child in children_of(pid):
            try:
                yield pathlib.Path(f"/proc/{child}/comm").read_text().strip(), child
            except OSError:
                continue
            yield from self.programs_of(child)

    @staticmethod
    def kill(pid):
        try:
            os.kill(pid, signal.SIGKILL)
            return 1
        except ProcessLookupError:
            return 0


class Wherever(StudyTest):
    @classmethod
    def setUpClass(cls):
        cls.whole = cls.computed(STRIPES + SOFT)

    def test_a_worker_of_dask_on_another_machine_makes_the_same_table(self):
        self.scene(STRIPES + SOFT, "study.yaml")
        try:
            machines = self.enterContext(Machines(BUILD / "tests/bench/network_link", Link()))
        except NotAllowed as reason:
            self.skipTest(f"network namespaces are not allowed here: {reason}")
        address = f"{NEAR}:8786"
        self.start("Scheduler at:", machines.on_near, "dask_scheduler", "--host", address)
        self.start("Registered to", machines.on_far, "dask_worker", address, "--nthreads", "2")
        done = subprocess.run(machines.on_near(*self.command("out", "--dask", address)), capture_output=True, text=True, timeout=PATIENCE_S * 3)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("9 runs computed in", done.stdout)
        self.assertEqual(self.table(), self.table(self.whole))

    def start(self, said, place, program, *options):
        """Starts a program of Dask on a machine, and waits for what it says when it is ready."""
        command = place("/usr/bin/python3", "-m", f"distributed.cli.{program}", *options, "--no-dashboard")
        environment = dict(os.environ, PYTHONPATH=f"{os.environ['ADIT_SOURCE']}/python")
        with open(self.folder / f"{program}.log", "w") as log:
            process = subprocess.Popen(command, env=environment, cwd=self.folder, stdout=log, stderr=log)
        self.addCleanup(process.wait)
        self.addCleanup(process.terminate)
        wait_until(lambda: said in (self.folder / f"{program}.log").read_text(), PATIENCE_S)

    def test_an_array_of_slurm_makes_the_same_table(self):
        self.study(STRIPES + SOFT, "--slurm", "3")
        job = self.folder / "out" / "job.sh"
        self.assertIn("#SBATCH --array=0-2", job.read_text())
        tools = self.folder / "tools"
        tools.mkdir()
        (tools / "sbatch").write_text('#!/usr/bin/env bash\necho "$*" >>"$ASKED"\n')
        (tools / "sbatch").chmod(0o755)
        environment = dict(os.environ, PATH=f"{tools}:{os.environ['PATH']}", ASKED=str(self.folder / "asked"), SLURM_ARRAY_JOB_ID="7")
        for part in (2, 0, 1):
            subprocess.run(["bash", job], env=environment | {"SLURM_ARRAY_TASK_ID": str(part)}, check=True, capture_output=True, timeout=PATIENCE_S * 3)
        asked = (self.folder / "asked").read_text()
        self.assertEqual(asked.split(), ["--dependency=afterany:7", "--array=0", f"--output={self.folder}/out/table.log", str(job), "table"])
        done = subprocess.run(["bash", job, "table"], env=environment, check=True, capture_output=True, text=True, timeout=PATIENCE_S * 3)
        self.assertNotIn("computed in", done.stdout)
        self.assertEqual(self.table(), self.table(self.whole))


class Until(StudyTest):
    def test_runs_are_added_until_a_median_is_known(self):
        climbing = MOTIONS.partition("    - {ricker: {frequency: 2")[0] + "    - {synthetic: {spectrum: ec8_type_1, ground: b, seed: 1}}\n" + (
            "  increments: {pga: [0.05 g, 0.1 g, 0.15 g, 0.2 g, 0.3 g, 0.4 g, 0.6 g, 0.8 g]}\n"
            "questions: [drift_ux_m]\ndamage: [{of: drift_ux_m, states: [{name: major, above: 0.01}]}]\nset: [time.duration=3 s]\n")
        done = self.study(climbing, "--until", "median within 30 %")
        self.assertIn("every median is known within 30 %", done.stdout)
        self.assertGreater(len({row["motion"] for row in self.rows()}), 2)

    def test_where_all_further_runs_are_the_same_that_is_said(self):
        same = STRIPES.replace("    - {synthetic: {spectrum: ec8_type_1, ground: b, seed: 1}}\n", "")
        self.assertIn("further runs would be the same", self.study(same, "--until", "median within 1 %").stdout)


class WhatIsWrong(StudyTest):
    def test_is_told_in_one_sentence(self):
        soft = SOFT.replace("material.young_modulus", "material.youngs_modulus")
        for text, said in (
                (STRIPES + soft, "youngs_modulus, but the scene states no number there"),
                (STRIPES + soft.replace("multiplies: true, ", ""), "did you mean `young_modulus`?"),
                (STRIPES + SOFT.replace("multiplies: true, lognormal: {median: 1, dispersion: 0.2}", "unit: MPa, normal: {mean: 50, deviation: 200}"),
                 "expected a pressure above 0 Pa; cut the distribution off"),
                (STRIPES + SOFT.replace("multiplies: true,", "unit: m,"), "is a length"),
                (STRIPES.replace("stripes: {", "largest_factor: 1.01\n  stripes: {"), "no motion can be scaled to any of the levels by a factor of at most 1.01"),
                (STRIPES.replace("questions: [drift_ux_m]", "questions: [drift_u_m]"), "damage.of: drift_ux_m is not asked of a run"),
                (MOTIONS + "questions: [drift_u_m]\n", "no run has drift_u_m; did you mean `drift_ux_m`?"),
                (STRIPES.replace("minor, above: 0.01", "minor, above: 0.03"), "the thresholds do not rise"),
                (STRIPES.replace("  stripes:", "  intensity: {at: surfac}\n  stripes:"), "surfac is no history of acceleration_x of the scene"),
                (MOTIONS + "  folder: nowhere\nquestions: [drift_ux_m]\n", "is no folder"),
                ("scene: column.yaml\nquestions: [drift_ux_m]\n", "nothing varies from run to run")):
            with self.subTest(said):
                self.assertIn(said, self.refused_here(text))
        for text, said in (  # by the coupler, which reads the scene
                (STRIPES.replace("column.yaml", "colum.yaml"), "there is no such file"),
                (MOTIONS.replace("frequency: 2 Hz, time: 1 s}", "frequency: 2 Hz}") + "questions: [drift_ux_m]\n", "motions.of[0].ricker.time")):
            with self.subTest(said):
                self.assertIn(said, self.refused(text))

    def refused_here(self, text):
        """What is said, without the start of a program for each."""
        self.scene(text, "study.yaml")
        errors = io.StringIO()
        with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(errors), \
                mock.patch.object(children, "end_with_this_process"), self.assertRaises(SystemExit) as end:
            cli.run("study", [str(word) for word in self.command("out")[len(ADIT) + 1:]])
        self.assertEqual(end.exception.code, 2)
        self.assert_one_line(errors.getvalue())
        return errors.getvalue()

    def test_two_studies_in_one_folder_are_refused(self):
        self.study(MOTIONS + "questions: [drift_ux_m]\n")
        (self.folder / "study.yaml").rename(self.folder / "other.yaml")
        done = subprocess.run([*ADIT, "study", self.folder / "other.yaml", "--out", self.folder / "out"], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 2)
        self.assertIn("holds the study", done.stderr)

    def test_a_study_that_is_computed_at_this_moment_is_left_alone(self):
        self.scene(STRIPES, "study.yaml")
        first = subprocess.Popen(self.command("out"), stdout=subprocess.DEVNULL)
        wait_until((self.folder / "out" / "runs").exists)
        first.send_signal(signal.SIGSTOP)  # or it might end before it is met
        self.assertIn("another process computes this study", self.refused(STRIPES))
        first.send_signal(signal.SIGCONT)
        self.assertEqual(first.wait(PATIENCE_S * 3), 0)


if __name__ == "__main__":
    unittest.main()
