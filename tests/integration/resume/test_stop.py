"""A signal, or a full disk, ends a run with all that it has computed until then."""

import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

from programs import ADIT, BUILD, CASE, COUPLER, PATIENCE, SOURCE, ProgramTest, children_of, wait_until

LONG = ("--set", "time.duration=50 s", "--set", "output.history_interval=0.1 ms", "--set", "output.field_times=[1 ms]")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
SIMPLIFIED = BUILD / "simplified" / "simplified"


class Stop(ProgramTest):
    def start(self, *command):
        # What runs the tests in the background may ignore signals, which children would inherit.
        process = subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                   preexec_fn=lambda: [signal.signal(s, signal.SIG_DFL) for s in SIGNALS])
        self.addCleanup(process.kill)
        return process

    def started(self, scene="coupled.yaml"):
        """A long run that has begun to step."""
        process = self.start(COUPLER, "run", CASE / scene, "--out", self.folder / "run", *LONG)
        end = time.monotonic() + 60
        while not (self.folder / "run" / "fields" / "fields.pvd").exists():
            self.assertLess(time.monotonic(), end)
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        return process

    def test_a_coupler_that_ends_while_its_servers_start_leaves_none(self):
        """Neither a process nor the folder of a socket."""
        killed = []
        for k in range(20):
            process = self.start(COUPLER, "run", CASE / "coupled.yaml", "--out", self.folder / f"run_{k}", *LONG)
            servers = []

            def started():
                servers.extend(children_of(process.pid))
                return servers or process.poll() is not None
            wait_until(started)
            process.kill()
            self.assertTrue(servers, "the coupler ended by itself")
            killed.append((process, servers))
        for process, servers in killed:
            process.communicate()
            for pid in servers:
                wait_until(lambda: not pathlib.Path(f"/proc/{pid}").exists())
                self.assertEqual(list(pathlib.Path("/tmp").glob(f"adit-{pid}-*")), [])

    def test_signals_end_a_run_at_its_next_step(self):
        for number in SIGNALS:
            name = number.name
            with self.subTest(name):
                shutil.rmtree(self.folder / "run", ignore_errors=True)
                process = self.started()
                # A terminal or a scheduler sends it to the servers, too.
                for pid in [*children_of(process.pid), process.pid]:
                    os.kill(pid, number)
                out, errors = process.communicate(timeout=20 * PATIENCE)
                run = self.folder / "run"
                self.assertEqual(process.returncode, 128 + number, errors)
                summary = self.summary(run)
                self.assertFalse(summary["completed"])
                self.assertEqual(summary["error"], f"ended by {name}")
                self.assertEqual(errors.strip().splitlines()[-1], f"ended by {name}")
                self.assertIn(f"coupler resume {run}", out)
                self.assertEqual(summary["resume"], f"coupler resume {run}")
                self.assert_whole_rows(run, more_than=5)
                step = summary["steps"]
                self.assertTrue((run / "fields" / f"particles_{step:08}.vtp").exists())
                self.assertTrue(list((run / "checkpoints").glob(f"*_step_{step}/checkpoint.json")))
                self.assertFalse((run / "reserve").exists())

    def test_a_second_signal_ends_it_at_once(self):
        process = self.started()
        servers = children_of(process.pid)
        os.kill(servers[0], signal.SIGSTOP)  # a step that takes long
        time.sleep(0.2)
        process.send_signal(signal.SIGTERM)
        time.sleep(0.3)
        self.assertIsNone(process.poll())
        process.send_signal(signal.SIGINT)
        process.wait(timeout=2)
        self.assertEqual(process.returncode, -signal.SIGINT)
        os.kill(servers[0], signal.SIGCONT)

    def test_ignored_signals_stay_ignored(self):
        process = self.started_by_nohup()
        process.send_signal(signal.SIGHUP)
        time.sleep(0.5)
        self.assertIsNone(process.poll())

    def started_by_nohup(self):
        process = self.start("nohup", COUPLER, "run", CASE / "coupled.yaml", "--out", self.folder / "run", *LONG)
        while not (self.folder / "run" / "fields" / "fields.pvd").exists():
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        return process

    def test_simplified_ends_with_a_summary(self):
        run = self.folder / "run"
        process = self.start(SIMPLIFIED, "run", SOURCE / "cases" / "hzm" / "wave_1000_0.1g.yaml", "--out", run,
                             "--set", "time.dt=1 ms")
        while not (run / "reserve").exists():
            self.assertIsNone(process.poll())
            time.sleep(0.005)
        time.sleep(0.3)
        process.send_signal(signal.SIGTERM)
        errors = process.communicate(timeout=20 * PATIENCE)[1]
        self.assertEqual(process.returncode, 128 + signal.SIGTERM, errors)
        summary = self.summary(run)
        self.assertFalse(summary["completed"])
        self.assertEqual(summary["error"], "ended by SIGTERM")
        self.assertEqual(summary["case"], "hzm")

    def test_full_disk(self):
        disk, kept = self.folder / "disk", self.folder / "kept"
        disk.mkdir()
        mount = f"mount -t tmpfs -o size=1800k none {disk}"
        if subprocess.run(["unshare", "-rm", "sh", "-c", mount], capture_output=True).returncode:
            self.skipTest("no file system can be mounted here")
        settings = " ".join(f"'{word}'" for word in (*LONG, "--set", "output.history_interval=1 us"))
        done = subprocess.run(
            ["unshare", "-rm", "sh", "-c",
             f"{mount}; {COUPLER} run {CASE / 'coupled.yaml'} --out {disk}/run {settings}; code=$?; cp -r {disk}/run {kept}; exit $code"],
            capture_output=True, text=True, timeout=120 * PATIENCE)
        self.assertEqual(done.returncode, 5, done.stderr)
        self.assertRegex(done.stderr.strip().splitlines()[-1], "^error: cannot write .*: No space left on device; make room")
        summary = self.summary(kept)
        self.assertFalse(summary["completed"])
        self.assertIn("No space left", summary["error"])
        self.assert_whole_rows(kept, more_than=5)
        self.assertEqual(list(kept.rglob("*.part")), [])

    def test_pictures_report_and_comparison_of_an_unfinished_run(self):
        process = self.started("full_fdm.yaml")
        time.sleep(0.5)
        process.send_signal(signal.SIGTERM)
        process.communicate(timeout=20 * PATIENCE)
        run = self.folder / "run"
        other = shutil.copytree(run, self.folder / "other")
        for script in ("plot", "report", "compare"):
            runs = [run, other] if script == "compare" else [run]
            done = subprocess.run([*ADIT, script, *runs], capture_output=True, text=True,
                                  timeout=200 * PATIENCE, cwd=self.folder)
            self.assertEqual(done.returncode, 0, f"{script}: {done.stderr}")
        page = (run / "report.html").read_text()
        self.assertIn("The run was stopped", page)
        self.assertIn(f"coupler resume {run}", page)


if __name__ == "__main__":
    unittest.main()
