"""A run that was stopped goes on, a finished one becomes longer, another one begins at a state at rest; what cannot go
on is refused by name."""

import json
import os
import re
import subprocess
import unittest

from programs import COUPLER, PATIENCE_S, coupler
from resume.resumed import BEDDED, CASES, CHECKPOINTS, GROUND, MAXWELL, ResumeTest, results_of

AT_THE_END = ("--set", "output.checkpoint={}")  # and after statics


def sealed(manifest):
    """The text with its own hash (64-bit FNV-1a of the text without it), as somebody would forge it."""
    content = re.sub(r',\n  "hash": "\w+"\n}\n$', "\n}", manifest)
    value = 0xCBF29CE484222325
    for byte in content.encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return content[:-2] + f',\n  "hash": "{value:016x}"\n}}\n'


class Checkpoints(ResumeTest):
    def test_stop_and_go_on(self):
        scene = CASES / "cantilever" / "coupled.yaml"
        slow = ("--set", "time.dt_factor=0.1", "--set", "time.duration=25 ms", "--set", "output.field_times=[20 ms]")
        whole = self.run_scene(scene, *slow, out="whole")
        run = self.stopped(scene, "run", *slow)
        self.assertEqual(self.summary(run)["resume"], f"coupler resume {run}")
        result = coupler("resume", run)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_same(run, whole)
        self.assertLessEqual(len(list((run / "checkpoints").iterdir())), 3)

    def test_a_finished_run_becomes_longer(self):
        scene = self.scene(GROUND % ("false", MAXWELL))
        sets = ("--set", "output.history_interval=1 ms", "--set", "output.field_times=[]", "--set", "time.dt=0.1 ms")
        whole = self.run_scene(scene, *sets, "--set", "time.duration=60 ms", out="whole")
        run = self.run_scene(scene, *sets, "--set", "time.duration=30 ms", *AT_THE_END)
        finished = results_of(run)
        self.assertEqual(coupler("resume", run).returncode, 0)  # nothing is left to do
        self.assertEqual(results_of(run), finished)
        result = coupler("resume", run, "--until", "60 ms")
        self.assertEqual(result.returncode, 0, result.stderr)
        for table in ("histories.csv", "spectra/surface_ax_response.csv"):
            self.assertEqual((run / table).read_text(), (whole / table).read_text())
        self.assertEqual(self.summary(run)["duration_s"], 0.06)
        result = coupler("resume", run, "--until", "20 ms")
        self.assertEqual(result.returncode, 2)
        self.assertIn("--until 20 ms lies before the checkpoint at 0.06 s", result.stderr)

    def test_a_lengthened_run_goes_on_with_its_earthquake(self):
        """Whatever moves the base does not follow from the duration."""
        for motion in ("synthetic: {seed: 1}, peak: 0.8 g", "sine: {frequency: 20 Hz, end: 40 ms}"):
            text = (GROUND % ("false", MAXWELL)).replace("ricker: {frequency: 10 Hz, time: 0.1 s}, peak: 0.8 g", motion)
            sets = ("--set", "output.history_interval=1 ms", "--set", "output.field_times=[]", "--set", "time.dt=0.1 ms")
            scene, name = self.scene(text), motion.split(":", maxsplit=1)[0]
            whole = self.run_scene(scene, *sets, "--set", "time.duration=60 ms", out=f"{name}_whole")
            run = self.run_scene(scene, *sets, "--set", "time.duration=30 ms", *AT_THE_END, out=name)
            self.assertEqual(coupler("resume", run, "--until", "60 ms").returncode, 0)
            self.assertEqual((run / "histories.csv").read_text(), (whole / "histories.csv").read_text())

    def test_other_earthquakes_begin_at_the_state_after_statics(self):
        scene = self.scene(GROUND % ("false", MAXWELL))
        short = ("--set", "time.duration=60 ms", "--set", "output.field_times=[]")
        base = self.run_scene(scene, *short, *AT_THE_END, out="base")
        stronger = (*short, "--set", "continuum.base.acceleration.peak=1.5 g", "--set", "time.duration=80 ms")
        whole = self.run_scene(scene, *stronger, out="whole")
        run = self.run_scene(scene, *stronger, "--from", base)
        self.assert_same(run, whole)
        for path, value in (("continuum.bolts[0].area", "6 cm^2"), ("statics.unbalanced_ratio", "1e-5"),
                            ("time.substeps", "2"), ("continuum.base.kind", "rigid")):
            result = coupler("run", scene, *short, "--from", base, "--set", f"{path}={value}", "--out",
                             self.folder / "refused")
            self.assertEqual(result.returncode, 2)
            self.assertIn(f"{path}: is another than in the run whose state at rest is taken", result.stderr)
            self.assertFalse((self.folder / "refused").exists())
        step = next((base / "checkpoints").glob("*_step_*"))
        result = coupler("run", scene, *short, "--from", step, "--out", self.folder / "refused")
        self.assertEqual(result.returncode, 2)
        self.assertIn("is no state after statics", result.stderr)

    def test_refuses_what_it_cannot_go_on_from(self):
        scene = self.scene(BEDDED % CASES)
        self.assertIn("has no checkpoint", coupler("resume", self.run_scene(scene, out="none")).stderr)
        run = self.run_scene(scene, *CHECKPOINTS)
        whole = results_of(run)
        newest = sorted((run / "checkpoints").iterdir())[-1]

        # A damaged checkpoint is passed over; given by name it is refused.
        state = (newest / "particles.state")
        content = bytearray(state.read_bytes())
        content[len(content) // 2] ^= 1
        state.write_bytes(content)
        result = coupler("resume", newest)
        self.assertEqual(result.returncode, 2)
        self.assertIn("particles.state is damaged", result.stderr)
        result = coupler("resume", run)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("warning: ", result.stderr)
        self.assertEqual(results_of(run), whole)

        any_other = next(folder for folder in sorted((run / "checkpoints").iterdir()) if folder != newest)

        def refused(folder, text):
            result = coupler("resume", folder)
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(text, result.stderr)

        manifest = any_other / "checkpoint.json"
        told = manifest.read_text()
        manifest.write_text(json.dumps({**json.loads(told), "release": "0.0.1"}))
        refused(any_other, "is of release 0.0.1")
        manifest.write_text(sealed(told.replace('"format": "dem_server', '"format": "other_server')))
        refused(any_other, "the state of `particles`")
        manifest.write_text(sealed(re.sub(r'"step": \d+', '"step": 1', told)))
        refused(any_other, "is of step 1, but its state of the coupler of step")
        manifest.write_text("{")
        refused(any_other, "checkpoint.json cannot be read")
        manifest.unlink()
        os.mkfifo(manifest)
        refused(any_other, "checkpoint.json is not a file")
        manifest.unlink()
        manifest.write_text(told)
        table = run / "histories.csv"
        rows = table.read_text()
        digit = next(k for k in range(rows.index("\n"), len(rows)) if rows[k] in "12345678")
        table.write_text(rows[:digit] + "9" + rows[digit + 1:])
        refused(any_other, "histories.csv is not what the run wrote until the checkpoint")
        table.write_text(rows)
        changed = run / "scene.yaml"
        changed.write_text(changed.read_text().replace("density: 2500", "density: 2400"))
        refused(any_other, "is not what it was when the run began")
        refused(self.folder / "nowhere", "scene.yaml")

    def test_a_damaged_manifest_is_never_another_run(self):
        """Whatever character of it becomes another one, the run is refused, or goes on to the same results."""
        run = self.run_scene(self.scene(BEDDED % CASES), *CHECKPOINTS)
        whole = results_of(run)
        checkpoint = sorted((run / "checkpoints").iterdir())[0]
        manifest = checkpoint / "checkpoint.json"
        told = manifest.read_bytes()
        numbers = [match.start(1) for match in re.finditer(rb'": (\d)', told)]
        some = range(0, len(told), len(told) // 40)
        for place in sorted({*numbers, *some}):
            flipped = bytearray(told)
            flipped[place] ^= 1
            manifest.write_bytes(flipped)
            with self.subTest(place=place, character=chr(told[place])):
                result = coupler("resume", checkpoint)
                if result.returncode == 0:
                    self.assertEqual(results_of(run), whole)
                else:
                    self.assertEqual(result.returncode, 2, result.stderr)
                    self.assertIn("checkpoint", result.stderr)
        without = re.sub(rb'  "wall_s": [^\n]*\n', b"", told)
        self.assertNotEqual(without, told)
        manifest.write_bytes(without)
        self.assertEqual(coupler("resume", checkpoint).returncode, 2)

    def test_a_state_of_another_step_is_refused(self):
        run = self.run_scene(self.scene(BEDDED % CASES), *CHECKPOINTS)
        one, other = sorted((run / "checkpoints").iterdir())[-2:]
        (one / "particles.state").write_bytes((other / "particles.state").read_bytes())
        its, others = (json.loads((folder / "checkpoint.json").read_text()) for folder in (one, other))
        its["files"] = [file if file["name"] != "particles" else
                        next(told for told in others["files"] if told["name"] == "particles") for file in its["files"]]
        (one / "checkpoint.json").write_text(json.dumps(its, indent=2))
        result = coupler("resume", one)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("checkpoint.json is damaged", result.stderr)

    def test_folders_are_found_however_they_are_written(self):
        """A slash at the end, `.`, a link, a name of blanks and other letters."""
        run = self.run_scene(self.scene(BEDDED % CASES), *CHECKPOINTS, out="größe 1")
        whole = results_of(run)
        newest = sorted((run / "checkpoints").iterdir())[-1]
        link = self.folder / "link"
        link.symlink_to(newest)
        for folder, where in ((f"{run}/", None), (f"{newest}/", None), (".", run), (".", newest), (link, None),
                              (f"{link}/", None), (newest.name, newest.parent)):
            with self.subTest(folder=folder, where=where):
                result = subprocess.run([COUPLER, "resume", folder], cwd=where, capture_output=True, text=True,
                                        timeout=PATIENCE_S)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual(results_of(run), whole)

    def test_the_command_to_go_on_names_the_servers(self):
        scene = CASES / "cantilever" / "coupled.yaml"
        run = self.stopped(scene, "run", "--set", "time.dt_factor=0.05", "--fdm-threads", "1")
        self.assertEqual(self.summary(run)["resume"], f"coupler resume {run} --fdm-threads 1")


if __name__ == "__main__":
    unittest.main()
