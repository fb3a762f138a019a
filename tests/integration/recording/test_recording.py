"""A recording holds all that coupler and servers said. A server alone is replayed against it, and two of them are compared."""

import math
import pathlib
import secrets
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from foreign import Listener, between
from programs import CASE, COUPLER, ProgramTest, Server, coupler
from recording import recorded

SHORT = ("--set", "time.duration=1 ms", "--set", "output.field_times=[0.5 ms]")
CONTINUUM, PARTICLES = 0, 1


class Recording(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.shared = pathlib.Path(tempfile.mkdtemp(prefix="adit_"))
        cls.addClassCleanup(shutil.rmtree, cls.shared)
        cls.recording = cls.shared / "recording"
        result = coupler("run", CASE / "coupled.yaml", "--out", cls.shared / "run", *SHORT, "--record", cls.recording)
        assert result.returncode == 0, result.stderr

    def record(self, name, *options, scene="coupled.yaml"):
        """A further recording, and the result of its run."""
        result = coupler("run", CASE / scene, "--out", self.folder / f"{name}_run", *SHORT, *options, "--record", self.folder / name)
        return self.folder / name, result

    def assert_ends(self, result, code, *words):
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        for word in words:
            self.assertIn(word, result.stdout + result.stderr)

    def test_it_holds_every_frame_of_both_conversations(self):
        speakers = [content.decode().split("\n")[:3] for _, _, kind, content in recorded.entries(self.recording)
                    if kind == recorded.PARTICIPANT]
        self.assertEqual(speakers, [["continuum", "continuum", "fdm_server"], ["particles", "particles", "dem_server"]])
        steps = self.summary(self.shared / "run")["steps"]
        for participant in (CONTINUUM, PARTICLES):
            asked, answered = ([frame.WhichOneof("content") for frame in recorded.frames(self.recording, participant, kind)]
                               for kind in (recorded.REQUEST, recorded.ANSWER))
            self.assertEqual(asked[:4], ["setup", "weights", "couple", "advance"])
            self.assertEqual(answered[:4], ["model", "interface", "operator", "predicted"])
            self.assertEqual(asked.count("advance"), steps + 1)
            self.assertEqual((asked[-1], answered[-1]), ("finish", "bye"))
            self.assertEqual(len(asked), len(answered))
        times = [entry[0] for entry in recorded.entries(self.recording)]
        self.assertEqual(times, sorted(times))

    def test_results_are_those_of_a_run_that_is_not_recorded(self):
        own = self.run_scene(CASE / "coupled.yaml", *SHORT)
        for name in ("histories.csv", "cracks.csv"):
            self.assertEqual((self.shared / "run" / name).read_bytes(), (own / name).read_bytes())

    def test_each_server_answers_as_recorded(self):
        self.assert_ends(coupler("replay", self.recording), 0, "continuum", "particles", "not compared")
        self.assert_ends(coupler("replay", self.recording, "--only", "continuum", "--fdm-threads", 2), 0, "equal: ")
        with Server("dem_server") as server:
            for _ in range(2):  # one replay after another
                result = coupler("replay", self.recording, "--dem", server.address)
                self.assert_ends(result, 0, "equal: ", server.address)
                self.assertNotIn("continuum", result.stdout)

    def test_an_answer_that_differs_in_one_bit_is_named(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "predicted" and frame.predicted.step == 12:
                frame.predicted.velocities[3] = math.nextafter(frame.predicted.velocities[3], math.inf)

        was = [frame.predicted.velocities[3] for frame in recorded.frames(self.recording, PARTICLES, recorded.ANSWER)
               if frame.WhichOneof("content") == "predicted" and frame.predicted.step == 12][0]
        with Server("dem_server") as server:
            result = coupler("replay", self.recording, "--dem", Listener(between(server, tamper)).address)
        self.assert_ends(result, 1, "first difference in the answer to step 12: predicted.velocities[3] is ", f"recorded {was!r}")

    def test_an_error_in_the_place_of_an_answer_is_a_difference(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "predicted" and frame.predicted.step == 3:
                frame.error.message = "tired"

        with Server("dem_server") as server:
            result = coupler("replay", self.recording, "--dem", Listener(between(server, tamper)).address)
        self.assert_ends(result, 1, "answer to step 3: the message is error: tired, recorded predicted")

    def test_an_error_that_was_recorded_is_replayed(self):
        """An unstable run ends with the participant's error, which the server repeats."""
        beyond = ("--set", "time.dt=1 ms", "--set", "time.beyond_critical=true", "--set", "time.duration=1 s")
        recording, result = self.record("unstable", *beyond, scene="full_dem.yaml")
        self.assertEqual(result.returncode, 4, result.stderr)
        self.assert_ends(coupler("replay", recording), 0, "equal: ")

    def test_two_recordings_of_one_scene_are_equal(self):
        """Whatever the threads, the folders and the states that were saved."""
        other, result = self.record("other", "--fdm-threads", 2, "--dem-threads", 2, "--set", "output.checkpoint={}")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_ends(coupler("diff", self.recording, other), 0, "continuum", "particles", "equal: ", "up to finish")
        self.assert_ends(coupler("replay", other), 0, "equal: ")

    def test_the_first_differences_of_two_scenes_are_named(self):
        heavier, result = self.record("heavier", "--set", "continuum.edge_loads[0].force.y=5.1 MN")
        self.assertEqual(result.returncode, 0, result.stderr)
        result = coupler("diff", self.recording, heavier)
        self.assert_ends(result, 1, "request of setup: setup.scene.continuum.edge_loads[0].force.y is 5000000 in A, 5100000 in B",
                         "answer to step 9: predicted.velocities[0] is ", "request of step 10: advance.impulses[0] is ")
        stiffer, result = self.record("stiffer", "--set", "material.young_modulus=26 GPa")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_ends(coupler("diff", self.recording, stiffer), 1,
                         "setup.scene.material.young_modulus is 25000000000 in A, 26000000000 in B", "answer to setup: model.critical_dt")

    def test_a_killed_run_leaves_what_was_said(self):
        recording = self.folder / "killed"
        run = subprocess.Popen([COUPLER, "run", CASE / "coupled.yaml", "--out", self.folder / "run", "--set", "time.duration=50 s",
                                "--record", recording], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(run.kill)
        end = time.monotonic() + 30
        while (not recording.exists() or recording.stat().st_size < 500_000) and time.monotonic() < end:
            time.sleep(0.01)
        run.send_signal(signal.SIGKILL)
        run.wait()
        self.assert_ends(coupler("replay", recording, "--only", "particles"), 0, "equal: ")
        data = recording.read_bytes()
        recording.write_bytes(data[:-7])
        self.assert_ends(coupler("replay", recording, "--only", "particles"), 0, "equal: ", "in the middle of an entry")
        self.assert_ends(coupler("diff", self.recording, recording), 1, "setup.scene.time.duration")

    def test_it_holds_no_secret(self):
        secret = self.folder / "secret"
        secret.write_text(secrets.token_hex(32) + "\n")
        secret.chmod(0o600)
        with Server("dem_server", "127.0.0.1:0", "--secret-file", secret) as server:
            trusted = ("--dem", server.address, "--secret-file", secret)
            recording, result = self.record("secret_run", *trusted, scene="full_dem.yaml")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assert_ends(coupler("replay", recording, *trusted), 0, "equal: ")
        self.assertNotIn(secret.read_bytes().strip(), recording.read_bytes())
        for kind in (recorded.REQUEST, recorded.ANSWER):
            for frame in recorded.frames(recording, 0, kind):
                self.assertNotIn(frame.WhichOneof("content"), ("hello", "proof"))

    def test_bad_input_ends_with_one_sentence(self):
        text = self.scene("years of work", "thesis.txt")
        damaged = self.folder / "damaged"
        data = bytearray(self.recording.read_bytes())
        data[len(data) // 2] ^= 1
        damaged.write_bytes(data)
        absent = self.folder / "absent"
        for arguments, word in ((("replay", absent), "there is no such file"),
                                (("replay", text), "this is no recording"),
                                (("replay", damaged), "damaged at byte"),
                                (("diff", self.recording, damaged), "damaged at byte"),
                                (("diff", self.recording, text), "this is no recording"),
                                (("replay", self.recording, "--only", "lining"), "--only names `lining`"),
                                (("replay", self.recording, "--server", "lining=localhost:1"), "no `lining`"),
                                (("run", CASE / "coupled.yaml", *SHORT, "--record", text), "this is no recording, and it is kept"),
                                (("run", CASE / "coupled.yaml", *SHORT, "--record", absent / "file"), "cannot write")):
            out = ("--out", self.folder / "bad") if arguments[0] == "run" else ()
            result = coupler(*arguments, *out)
            self.assert_ends(result, 2, word)
            self.assert_one_line(result.stderr)
        self.assertEqual(text.read_text(), "years of work")


if __name__ == "__main__":
    unittest.main()
