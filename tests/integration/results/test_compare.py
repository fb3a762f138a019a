"""adit compare lays runs side by side, and scripts/run --vary computes variants of a scene and compares them."""

import csv
import pathlib
import re
import shutil
import subprocess
import unittest

from browser import FAULTS, page
from programs import ADIT, BUILD, CASE, PATIENCE, ProgramTest, SOURCE, children_of, wait_until

from adit.compare import bonds
from adit.plots import model_pictures, png
from adit.report.results import Results
from adit.runs import variants

CRACKED = ("--set", "time.duration=32 ms", "--set", "output.field_times=[28 ms, 32 ms]")
TUNNEL = SOURCE / "cases" / "hzm" / "uniform_0.1g.yaml"


def compare(*arguments):
    return subprocess.run([*ADIT, "compare", *map(str, arguments)], capture_output=True, text=True, timeout=200)


class Compare(ProgramTest):
    def compared(self, *arguments):
        done = compare(*arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def beams(self):
        return [self.run_scene(CASE / f"{name}.yaml", *CRACKED, out=name) for name in ("full_dem", "coupled")]

    def test_figures_stand_beside_each_other_with_differences_and_ratios(self):
        alone, coupled = self.beams()
        said = self.compared(alone, coupled, "--no-report")
        self.assertFalse((self.folder / "report.html").exists())
        with open(self.folder / "comparison" / "figures.csv", newline="") as file:
            rows = {row["figure"]: row for row in csv.DictReader(file)}
        first, second = self.summary(alone), self.summary(coupled)
        for key in ("peak_bond_force_N", "particles", "first_crack_time_s"):
            self.assertEqual(float(rows[key]["coupled - full_dem"]), second[key] - first[key])
            self.assertEqual(float(rows[key]["coupled / full_dem"]), second[key] / first[key])
        self.assertEqual(rows["zones"]["coupled / full_dem"], "", "no ratio to 0")
        self.assertNotIn("duration_s", rows, "it is the same in both")
        self.assertRegex(said, rf"peak bond force \[kN\] +{first['peak_bond_force_N'] / 1e3:,.0f} +{second['peak_bond_force_N'] / 1e3:,.0f}\n")

    def test_pictures_and_page_show_histories_cracks_and_bonds_at_the_same_instants(self):
        alone, coupled = self.beams()
        self.compared(alone, coupled)
        drawn = {path.stem for path in (self.folder / "comparison").glob("*.png")}
        self.assertEqual(drawn, {"displacement", "force", "cracks", "force_chains_28ms", "force_chains_32ms", "bonds_28ms", "bonds_32ms"})
        text = (self.folder / "report.html").read_text()
        for title in ("Histories of the runs in one picture", "Cracks over time, and where they are",
                      "full_dem: Normal forces in the bonds at t = 32 ms", "coupled: Normal forces in the bonds at t = 32 ms"):
            self.assertIn(title, text)
        for width in (390, 1400):
            with page(self.folder / "report.html", width) as driver:
                driver.execute_script("document.querySelectorAll('details:not(.instant)').forEach(d => { d.open = true; })")
                self.assertEqual(driver.execute_script(FAULTS), [])

    def test_force_chains_of_all_runs_have_one_scale(self):
        """A third of the load bends an elastic beam by a third, so its lines are a third as wide."""
        load = "continuum.edge_loads[0].force.y"
        runs = [Results(self.run_scene(CASE / "coupled.yaml", *CRACKED, "--set", f"{load}={force}", out=force.replace(" ", "_")))
                for force in ("1 MN", "3 MN")]
        instants = bonds.common_instants(runs)
        self.assertEqual([round(1e3 * time) for time, _ in instants], [28, 32])
        figures = [png.figure(drawing) for drawing in bonds.side_by_side(runs, instants[0][1])["force_chains"]]
        widest = [max(line.get_linewidth() for line in figure.axes[0].get_lines() if line.get_marker() == "None")
                  for figure in figures]
        self.assertAlmostEqual(widest[0] / widest[1], 1 / 3, delta=1 / model_pictures.LEVELS)
        self.assertEqual(figures[0].axes[0].get_xlim(), figures[1].axes[0].get_xlim())

    def test_runs_of_any_kind_can_be_compared(self):
        coupled = self.run_scene(CASE / "coupled.yaml", "--set", "time.duration=5 ms", "--set", "output.field_times=[5 ms]")
        tunnels = []
        for peak in ("0.1 g", "0.05 g"):
            tunnels.append(self.folder / "tunnels" / peak.replace(" ", ""))
            subprocess.run([BUILD / "simplified" / "simplified", "run", TUNNEL, "--set", "time.duration=1 s", "--set",
                            f"simplified.excitation.motion.peak={peak}", "--out", tunnels[-1]], check=True, capture_output=True)
        (coupled / "summary.json").unlink()  # as of a run that was killed
        self.compared(coupled, *tunnels)
        self.assertTrue((self.folder / "comparison" / "along_the_axis.png").exists())
        self.assertIn("run: cantilever of Fig. 7, coupled (not complete)", re.sub("<[^>]*>", "", (self.folder / "report.html").read_text()))

    def test_what_is_no_run_is_refused(self):
        done = compare(self.folder)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        self.assertIn("is not the folder of a run", done.stderr)


class Vary(ProgramTest):
    def vary(self, *arguments):
        return subprocess.run([*ADIT, "run", CASE / "coupled.yaml", "--out", self.folder / "out", "--no-report", "--set",
                               "time.duration=2 ms", "--set", "output.field_times=[]", *arguments], capture_output=True, text=True,
                              timeout=200)

    def test_every_combination_is_computed_in_a_folder_of_its_own_and_compared(self):
        done = self.vary("--vary", "time.dt_factor=0.25,0.5", "--vary", "interface.solve=consistent,lumped", "--no-pictures")
        self.assertEqual(done.returncode, 0, done.stderr)
        for factor in (0.25, 0.5):
            for solve in ("consistent", "lumped"):
                summary = self.summary(self.folder / "out" / f"dt_factor={factor},solve={solve}")
                self.assertEqual(summary["solve"], solve)
                self.assertLessEqual(summary["dt_s"], factor * summary["critical_dt_s"])
                self.assertGreater(summary["dt_s"], 0.7 * factor * summary["critical_dt_s"])
        with open(self.folder / "out" / "comparison" / "figures.csv", newline="") as file:
            header = next(csv.reader(file))
        self.assertEqual(header[1], "dt_factor=0.25,solve=consistent")

    def test_results_are_those_of_a_run_alone(self):
        self.assertEqual(self.vary("--vary", "time.dt_factor=0.3,0.4", "--no-pictures").returncode, 0)
        alone = self.run_scene(CASE / "coupled.yaml", "--set", "time.duration=2 ms", "--set", "output.field_times=[]", "--set",
                               "time.dt_factor=0.4")
        self.assertEqual((self.folder / "out" / "dt_factor=0.4" / "histories.csv").read_bytes(),
                         (alone / "histories.csv").read_bytes())

    def test_a_variant_that_fails_is_named_and_the_others_are_computed(self):
        done = self.vary("--vary", "interface.solve=consistent,exact", "--no-pictures")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stdout, r"solve=exact: failed \(exit code 2\): .*interface\.solve.*consistent")
        self.assertTrue(self.summary(self.folder / "out" / "solve=consistent")["completed"])

    def test_values_may_hold_commas_in_brackets_and_units(self):
        self.assertEqual(variants.values_of("output.field_times=[1 ms, 2 ms],[3 ms]"),
                         ("output.field_times", ["[1 ms, 2 ms]", "[3 ms]"]))
        self.assertEqual(list(variants.variants([("a.peak", ["0.1 g", "0.2 g"])])), ["peak=0.1_g", "peak=0.2_g"])
        self.assertEqual(list(variants.variants([("a.x", ["1"]), ("b.x", ["2"])])), ["a.x=1,b.x=2"])

    def test_keys_of_one_option_change_together(self):
        tied = variants.values_of("a.block.zones_x,a.block.zones_y=8:4,16:8")
        self.assertEqual(variants.variants([tied]), {"zones_x=8,zones_y=4": {"a.block.zones_x": "8", "a.block.zones_y": "4"},
                                                     "zones_x=16,zones_y=8": {"a.block.zones_x": "16", "a.block.zones_y": "8"}})
        self.assertEqual(len(variants.variants([tied, ("b", ["{x: 1}", "{x: 2}"])])), 4)

    def test_folders_have_short_names_that_do_not_depend_on_the_other_variants(self):
        record, long = ("m.file.path", ["/a/b/first.AT2", "/a/c/second.AT2"]), ("m.text", ["[" + "1, " * 60 + "2]", "[" + "1, " * 60 + "3]"])
        self.assertEqual(list(variants.variants([record])), ["path=first.AT2", "path=second.AT2"])
        both = list(variants.variants([record, long]))
        self.assertEqual(len(set(both)), 4)
        self.assertLessEqual(max(map(len, both)), variants.LONGEST)
        self.assertEqual(list(variants.variants([record, (long[0], long[1][1:])])), both[1::2])
        same = list(variants.variants([("m.file.path", ["/a/b/x.AT2", "/a/c/x.AT2"])]))
        self.assertEqual(len(set(same)), 2)

    def test_many_variants_are_drawn_in_comparison_only_and_none_on_request(self):
        self.assertEqual(self.vary("--vary", "time.dt_factor=0.3,0.4").returncode, 0)
        self.assertTrue((self.folder / "out" / "dt_factor=0.3" / "pictures" / "histories.png").exists())
        shutil.rmtree(self.folder / "out")
        done = self.vary("--vary", "time.dt_factor=0.3,0.35,0.4,0.45,0.5")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("5 variants are drawn in comparison only", done.stdout)
        self.assertFalse((self.folder / "out" / "dt_factor=0.3" / "pictures").exists())
        self.assertTrue((self.folder / "out" / "comparison" / "force.png").exists())
        with open(self.folder / "out" / "variants.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["time.dt_factor"] for row in rows], ["0.3", "0.35", "0.4", "0.45", "0.5"])
        self.assertEqual({row["exit_code"] for row in rows}, {"0"})
        shutil.rmtree(self.folder / "out")
        self.assertEqual(self.vary("--vary", "time.dt_factor=0.3,0.4", "--no-pictures").returncode, 0)
        self.assertEqual(list((self.folder / "out").rglob("*.png")), [])
        self.assertTrue((self.folder / "out" / "comparison" / "figures.csv").exists())

    def test_programs_end_when_the_variants_are_stopped(self):
        started = subprocess.Popen([*ADIT, "run", CASE / "coupled.yaml", "--out", self.folder / "out", "--set", "time.duration=100 s",
                                    "--set", "output.field_times=[]", "--vary", "time.dt_factor=0.3,0.4"], stdout=subprocess.DEVNULL)
        self.addCleanup(started.kill)
        wait_until(lambda: len(list((self.folder / "out").glob("*/histories.csv"))) > 0)
        programs = children_of(started.pid)
        self.assertTrue(programs)
        started.terminate()
        self.assertEqual(started.wait(30 * PATIENCE), 143)
        wait_until(lambda: not any(pathlib.Path(f"/proc/{each}").exists() for each in programs))

    def test_what_cannot_be_varied_is_refused_in_one_sentence(self):
        for wrong, said in (("time.dt_factor", "is not KEY=VALUE,VALUE"), ("time.dt_factor=0.5,", "is not KEY=VALUE,VALUE"),
                            ("a,b=1:2,3", "is not KEY=VALUE,VALUE"), ("a,=1", "is not KEY=VALUE,VALUE"),
                            ("time.dt_factor=0.5,0.5", "two variants would lie in the folder dt_factor=0.5")):
            done = self.vary("--vary", wrong)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
            self.assertIn(said, done.stderr)


if __name__ == "__main__":
    unittest.main()
