"""Any process of a run may be killed at any moment (nightly): the run resumes from its newest checkpoint, and all results are those of
the run that was never killed, bit for bit. ADIT_SEED repeats the moments and the victims of a night."""

import os
import random
import shutil
import signal
import time
import unittest

from programs import PATIENCE, PATIENCE_S, children_of
from resume.resumed import SCENES, ResumeTest

KILLS = 3  # of each scene
CHECKPOINTS = ("--set", "output.checkpoint.interval=0.2 s")


class Kills(ResumeTest):
    def complete(self, *command):
        process = self.start(*command)
        errors = process.communicate(timeout=600 * PATIENCE)[1]
        self.assertEqual(process.returncode, 0, errors)

    def kill(self, process, victim):
        """Kills a process of a run, by its place among them; returns whether the run had not ended."""
        if process.poll() is None:
            processes = [process.pid, *children_of(process.pid)]
            os.kill(processes[victim % len(processes)], signal.SIGKILL)
        process.communicate(timeout=PATIENCE_S)
        return process.returncode != 0

    def killed(self, chance, scene, options, out, victim, lasts):
        """A run of which one process was killed after its first checkpoint, at a moment by chance; that moment [s]."""
        while True:
            shutil.rmtree(out, ignore_errors=True)
            begin = time.monotonic()
            process = self.start("run", scene, "--out", out, *options, *CHECKPOINTS)
            time.sleep(chance.uniform(0, lasts))
            self.wait_for(lambda: any(out.glob("checkpoints/0*")), process)
            moment = time.monotonic() - begin
            if self.kill(process, victim):
                return moment

    def test_random_kills(self):
        seed = int(os.environ.get("ADIT_SEED", random.randrange(10**6)))
        print(f"ADIT_SEED={seed}")
        chance = random.Random(seed)
        resumed = 0
        for name in SCENES:
            scene, options = self.scene_of(name)
            whole, run = self.folder / "whole", self.folder / "run"
            begin = time.monotonic()
            self.complete("run", scene, "--out", whole, *options)
            lasts = time.monotonic() - begin
            for victim in range(KILLS):
                moment = self.killed(chance, scene, options, run, victim, lasts)
                self.complete("resume", run)
                step, = self.summary(run)["resumed_at_steps"]
                self.assert_same(run, whole)
                resumed += 1
                print(f"{name}: process {victim} killed after {moment:.2f} s, resumed at step {step}")
        print(f"{resumed} of {len(SCENES) * KILLS} resume to the bit")


if __name__ == "__main__":
    unittest.main()
