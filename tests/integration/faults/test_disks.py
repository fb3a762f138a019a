"""Folders and disks that cannot be written to: exit code 2 or 5, the file and the reason named, nothing half written."""

import os
import shutil
import subprocess
import unittest

from faults.faulty import SCENE, SHORT, FaultTest
from programs import COUPLER, PATIENCE, PATIENCE_S, coupler, wait_until

NOBODY = ("setpriv", "--reuid=65534", "--regid=65534", "--clear-groups")


class Disks(FaultTest):
    def mounted(self, mount, command):
        """Runs a shell's command where `mount` has been done; nobody else sees that."""
        if subprocess.run(["unshare", "-rm", "sh", "-c", mount], capture_output=True).returncode:
            self.skipTest("no file system can be mounted here")
        return subprocess.run(["unshare", "-rm", "sh", "-c", f"{mount}; {command}"], capture_output=True, text=True, timeout=100 * PATIENCE)

    def words(self, options):
        return " ".join(f"'{word}'" for word in options)

    def assert_refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assert_said(done.stderr, *words)

    def test_a_read_only_disk(self):
        disk = self.folder / "disk"
        disk.mkdir()
        command = f"{COUPLER} run {SCENE} --out {disk}/run {self.words(SHORT)}"
        self.assert_refused(self.mounted(f"mount -t tmpfs -o ro none {disk}", command), f"{disk}/run cannot be created: Read-only file system",
                            "--out")

    def test_results_on_a_disk_that_became_read_only(self):
        run = self.run_scene(SCENE, *SHORT)
        before = (run / "histories.csv").read_bytes()
        for command in (f"run {SCENE} --out {run} {self.words(SHORT)}", f"resume {run}"):
            done = self.mounted(f"mount --bind {run} {run} && mount -o remount,ro,bind {run}", f"{COUPLER} {command}")
            self.assert_refused(done, f"{run} cannot be locked (Read-only file system)")
        self.assertEqual((run / "histories.csv").read_bytes(), before)

    def of_nobody(self, *command):
        """A command of a user who may not do everything, in a folder that is theirs."""
        if os.getuid() != 0 or subprocess.run([*NOBODY, "test", "-x", COUPLER]).returncode:
            self.skipTest("no other user can run the programs here")
        self.folder.chmod(0o755)
        return [*map(str, (*NOBODY, *command))]

    def test_a_folder_of_somebody_else(self):
        command = self.of_nobody(COUPLER, "run", SCENE, "--out", self.folder / "run", *SHORT)
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE_S)
        self.assert_refused(done, f"{self.folder}/run cannot be created: Permission denied", "--out")

    def test_a_scene_of_somebody_else(self):
        scene = self.scene("name: mine\n")
        scene.chmod(0o600)
        done = subprocess.run(self.of_nobody(COUPLER, "check", scene), capture_output=True, text=True, timeout=PATIENCE_S)
        self.assert_refused(done, f"{scene}: the file cannot be opened; check its permissions")

    def test_results_in_the_place_of_a_file(self):
        (self.folder / "file").touch()
        for out in ("file", "file/run"):
            self.assert_refused(coupler("run", SCENE, "--out", self.folder / out), "cannot be created: Not a directory")

    def test_a_folder_that_is_removed_in_a_run(self):
        run = self.started("--set", "output.checkpoint.interval=0.2 s")
        shutil.rmtree(self.folder / "run", ignore_errors=True)
        errors = run.communicate(timeout=20 * PATIENCE)[1]
        self.assertEqual(run.returncode, 2, errors)
        self.assert_said(errors, "No such file or directory", str(self.folder / "run"))

    def test_a_folder_that_becomes_read_only_in_a_run(self):
        mine = self.folder / "mine"
        mine.mkdir()
        os.chown(mine, *((65534, 65534) if os.getuid() == 0 else (-1, -1)))
        command = self.of_nobody(COUPLER, "run", SCENE, "--out", mine / "run", "--set", "time.dt_factor=0.05", "--set",
                                 "output.checkpoint.interval=0.2 s")
        run = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(run.kill)
        wait_until(lambda: any((mine / "run/checkpoints").glob("0*/checkpoint.json")))
        for folder in (mine / "run/checkpoints", mine / "run"):
            folder.chmod(0o555)
        errors = run.communicate(timeout=20 * PATIENCE)[1]
        self.assertEqual(run.returncode, 2, errors)
        self.assert_said(errors, "Permission denied", str(mine / "run"))
        self.assert_whole_rows(mine / "run")
        for folder in (mine / "run", mine / "run/checkpoints"):
            folder.chmod(0o755)
        self.assertEqual(coupler("resume", mine / "run").returncode, 0)

    def test_a_disk_that_a_checkpoint_fills(self):
        """The checkpoint before it stays, and the run goes on from it where there is room."""
        disk, kept = self.folder / "disk", self.folder / "kept"
        disk.mkdir()
        options = self.words(("--set", "output.checkpoint.interval=5 ms", "--set", "output.field_times=[]", "--set", "output.history_interval=5 ms",
                              "--set", "time.duration=0.2 s"))
        done = self.mounted(
            f"mount -t tmpfs -o size=16m none {disk}",
            f"{COUPLER} run {SCENE} --out {disk}/run {options} & "
            f"while ! ls {disk}/run/checkpoints/0*/checkpoint.json >/dev/null 2>&1 && kill -0 $!; do sleep 0.01; done; "
            f"kill -STOP $!; head -c 30M /dev/zero >{disk}/other 2>/dev/null; kill -CONT $!; wait $!; code=$?; cp -r {disk}/run {kept}; exit $code")
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assert_said(done.stderr, "No space left on device")
        self.assert_unfinished("No space left on device", run="kept")
        result = coupler("resume", kept)
        self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()
