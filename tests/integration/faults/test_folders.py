"""What lies around a run: its folder, its terminal, the servers that it starts. Nothing of a user's is lost, and nothing that
cannot be shown ends a run."""

import contextlib
import os
import pathlib
import subprocess
import unittest

from faults.faulty import FaultTest
from programs import BUILD, CASE, COUPLER, PATIENCE_S, SOURCE, children_of, coupler

SIMPLIFIED = BUILD / "simplified" / "simplified"
COUPLED, GRID, BEAM = CASE / "coupled.yaml", CASE / "full_fdm.yaml", SOURCE / "cases" / "hzm" / "uniform_0.1g.yaml"


class Folders(FaultTest):
    def refused(self, *arguments):
        result = coupler(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        return result.stderr

    def test_one_process_at_a_time_writes_into_a_folder(self):
        run = self.started()
        words = f"is being written to by process {run.pid}"
        for command, scene in (("run", GRID), ("check", GRID)):
            self.assertIn(words, self.refused(command, scene, "--out", self.folder / "run"))
        beam = subprocess.run([SIMPLIFIED, "run", BEAM, "--out", self.folder / "run"],
                              capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(beam.returncode, 2, beam.stderr)
        self.assertIn(words, beam.stderr)
        run.kill()
        run.wait()
        self.run_scene(GRID)  # the servers that outlive it for a moment do not hold it

    def test_a_folder_in_which_no_run_has_written_keeps_what_it_holds(self):
        for name in ("pictures/sketch.png", "motion.csv", "scene.yaml", "summary.json"):
            mine = self.folder / name.replace("/", "_").split(".")[0] / name
            mine.parent.mkdir(parents=True)
            mine.write_text("{}")
            out = mine.parent.parent if "/" in name else mine.parent
            self.assertIn("neither `summary.json` nor `.lock` of a run", self.refused("run", GRID, "--out", out))
            self.assertEqual(mine.read_text(), "{}")

    def test_logs_begin_anew_and_are_not_written_through_links(self):
        run = self.run_scene(GRID)
        log = run / "fdm_server.log"
        log.write_text(log.read_text() + "of an older run\n" * 1000)
        self.run_scene(GRID)
        self.assertNotIn("older run", log.read_text())
        log.unlink()
        log.symlink_to(self.folder / "elsewhere")
        self.assertIn("is a link", self.refused("run", GRID, "--out", run))
        self.assertFalse((self.folder / "elsewhere").exists())

    def test_names_that_lead_out_of_the_folder(self):
        spectra = "output.spectra=[{history: %s, shortest_period: 1 ms, longest_period: 10 ms}]"
        for name in ("../../x", "a/b", ".hidden", "a\\nb", "x" * 101, "a b"):
            history = f'continuum.histories=[{{name: "{name}", quantity: acceleration_x, at: {{x: 0 m, y: 0.5 m}}}}]'
            message = self.refused("run", GRID, "--out", self.folder / "run", "--set", history, "--set", spectra % f'"{name}"')
            self.assertIn("continuum.histories[0].name: is ", message)
            self.assertIn("expected a name of letters", message)
        self.assertEqual(list(self.folder.rglob("*motion.csv")), [])

    def test_a_run_whose_words_nobody_hears_goes_on(self):
        for program, scene in ((COUPLER, COUPLED), (SIMPLIFIED, f"{BEAM} --set 'time.duration=1 s'")):
            for redirect in ("2>/dev/full", ">/dev/full 2>&1", "<&- >&- 2>&-", "2>&1 | true"):
                with self.subTest(f"{program.name} {redirect}"):
                    line = f'{program} run {scene} --out {self.folder / "run"}'
                    code = self.folder / "code"
                    subprocess.run(["bash", "-c", f"{{ {line}; echo $? >{code}; }} {redirect}"], timeout=PATIENCE_S, check=False,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                    self.assertEqual(code.read_text(), "0\n")
                    self.assertTrue((self.folder / "run" / "summary.json").exists())

    def test_servers_inherit_nothing_of_the_coupler(self):
        run = self.started()
        own = sockets_and_pipes(run.pid)
        self.assertEqual(len([name for name in own if name.startswith("socket")]), 2)
        for child in children_of(run.pid):
            self.assertEqual(sockets_and_pipes(child, beyond=2) & own, set())

    def test_thread_counts_that_no_machine_has(self):
        for count in ("-1", "1000000000", "two"):
            for option in ("--fdm-threads", "--dem-threads"):
                self.assertIn(f"{option}: ", self.refused("run", COUPLED, "--out", self.folder / "run", option, count))


def sockets_and_pipes(process, beyond=-1):
    """What a process has open, by its names in the kernel."""
    names = set()
    for path in pathlib.Path(f"/proc/{process}/fd").iterdir():
        if int(path.name) > beyond:
            with contextlib.suppress(FileNotFoundError):  # a file that was closed since the folder was listed
                names.add(os.readlink(path))
    return {name for name in names if name.startswith(("socket:", "pipe:"))}


if __name__ == "__main__":
    unittest.main()
