"""A run that was killed or stopped at any step goes on, and every result is that of a run that was never stopped, bit
for bit. Each scene brings parts of the state that another does not have."""

import os
import random
import signal
import time
import unittest

from programs import PATIENCE, PATIENCE_S, children_of
from resume.resumed import CHECKPOINTS, ResumeTest


class Resume(ResumeTest):
    def kill_within(self, process, run, seed, victim, send=signal.SIGKILL):
        """Ends one process of the run a little after its next checkpoint; returns what was said."""
        folder = run / "checkpoints"
        before = {path.name for path in folder.glob("0*")} if folder.exists() else set()
        self.wait_for(lambda: folder.exists() and {path.name for path in folder.glob("0*")} - before, process)
        time.sleep(random.Random(seed).uniform(0, 0.1))
        if process.poll() is None:
            victims = [process.pid, *children_of(process.pid)]
            os.kill(victims[victim % len(victims)], send)
        said = process.communicate(timeout=PATIENCE_S)
        return process.returncode, said

    def assert_goes_on(self, name, kills=3):
        """Kills the run at random steps, each of its processes in turn, and compares with the run never stopped."""
        scene, arguments = self.scene_of(name)
        whole = self.run_scene(scene, *arguments, out="whole")
        run = self.folder / "run"
        process = self.start("run", scene, "--out", run, *arguments, *CHECKPOINTS)
        killed = 0
        for victim in range(kills):
            code, said = self.kill_within(process, run, 7 * victim + 1, victim)
            if code == 0:
                break
            killed += 1
            process = self.start("resume", run)
        output, errors = process.communicate(timeout=120 * PATIENCE)
        self.assertEqual(process.returncode, 0, errors)
        self.assertGreater(killed, 0, "the run ended before it was killed")
        self.assertEqual(len(self.summary(run)["resumed_at_steps"]), killed)
        self.assert_same(run, whole)
        return run, whole

    def test_lattice_that_cracks(self):
        self.assert_goes_on("lattice that cracks")

    def test_ground_that_yields(self):
        self.assert_goes_on("ground that yields")

    def test_ground_in_large_strain(self):
        self.assert_goes_on("ground in large strain")

    def test_ground_that_is_filled(self):
        self.assert_goes_on("ground that is filled")

    def test_beam_on_a_foundation(self):
        self.assert_goes_on("beam on a foundation")

    def test_grains(self):
        self.assert_goes_on("grains")

    def test_cells(self):
        self.assert_goes_on("cells")

    def test_ring_of_segments(self):
        self.assert_goes_on("ring of segments")

    def test_regions(self):
        self.assert_goes_on("regions")


if __name__ == "__main__":
    unittest.main()
