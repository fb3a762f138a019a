"""One command runs a scene, also with servers that somebody has started; the results are the same to the bit."""

import csv
import unittest

from programs import CASE, ProgramTest, Server, coupler

SHORT = ("--set", "time.duration=5 ms", "--set", "output.field_times=[2 ms]")
# What the cost of a run depends on, and the place where it ran.
MACHINE = {"wall_s", "steps_per_s", "coupler_cpu_s", "continuum_cpu_s", "particles_cpu_s", "coupler_wait_s",
           "coupler_solve_s", "continuum_compute_s", "particles_compute_s", "continuum_hidden_s", "particles_hidden_s",
           "hidden_share", "solve_factor_s"}
INVOCATION = {"started", "command", "folder"}  # when and how a run was asked for
REQUIRED = """case scene_hash versions started command folder inputs steps dt_s wall_s steps_per_s coupler_cpu_s continuum_cpu_s particles_cpu_s
particles bonds zones coupling_points particle_updates zone_updates peak_bond_force_N peak_bond_force_time_s
peak_bond_force_x_m first_crack_time_s first_crack_x_m first_crack_y_m crack_count max_energy_drift max_constraint_residual warnings""".split()


class Runs(ProgramTest):
    def results(self, run):
        """All that must repeat: every file but the logs, without the figures of the machine."""
        summary = {k: v for k, v in self.summary(run).items() if k not in MACHINE | INVOCATION}
        files = {p.relative_to(run): p.read_bytes() for p in sorted(run.rglob("*"))
                 if p.is_file() and p.name != "summary.json" and p.suffix != ".log"}
        return summary, files

    def test_repeated_runs_and_servers_started_by_hand_agree_to_the_last_bit(self):
        scene = CASE / "coupled.yaml"
        first = self.results(self.run_scene(scene, *SHORT, out="first"))
        self.assertEqual(first, self.results(self.run_scene(scene, *SHORT, out="again")))
        with Server("fdm_server") as fdm, Server("dem_server") as dem:
            by_hand = ("--fdm", fdm.address, "--dem", dem.address)
            # Twice: a server serves one run after another.
            for out in ("by_hand", "by_hand_again"):
                self.assertEqual(first, self.results(self.run_scene(scene, *SHORT, *by_hand, out=out)))

    def test_threads_change_no_bit(self):
        fine = ("--set", "continuum.block.zones_x=320", "--set", "continuum.block.zones_y=32", "--set",
                "time.duration=0.2 ms", "--set", "output.field_times=[0.1 ms]")
        one, three = (self.results(self.run_scene(CASE / "full_fdm.yaml", *fine, "--fdm-threads", count, out=count))
                      for count in ("1", "3"))
        self.assertEqual(one[0]["zones"], 10240)
        self.assertEqual(one, three)

    def test_threads_of_particles_change_no_bit(self):
        fine = ("--set", "particles.packing.radius=0.0158", "--set", "particles.bonds.tensile_strength=5 kN", "--set",
                "time.duration=2 ms", "--set", "output.field_times=[1 ms]")
        one, three = (self.results(self.run_scene(CASE / "full_dem.yaml", *fine, "--dem-threads", count, out=count))
                      for count in ("1", "3"))
        self.assertGreater(one[0]["particles"], 10000)
        self.assertGreater(one[0]["crack_count"], 0)
        self.assertEqual(one, three)

    def test_summary_holds_what_the_readme_promises(self):
        summary = self.summary(self.run_scene(CASE / "coupled.yaml", *SHORT))
        self.assertEqual([name for name in REQUIRED if name not in summary], [])
        self.assertTrue(summary["completed"])
        self.assertEqual((summary["particles"], summary["coupling_points"], summary["zones"]), (419, 140, 48))
        self.assertEqual(summary["particle_updates"], summary["particles"] * summary["steps"])
        self.assertEqual(summary["zone_updates"], summary["zones"] * summary["steps"])

    def test_one_participant_takes_the_same_path(self):
        for scene, count, other in (("full_dem", "particles", "zones"), ("full_fdm", "zones", "particles")):
            summary = self.summary(self.run_scene(CASE / f"{scene}.yaml", *SHORT, out=scene))
            self.assertGreater(summary[count], 0)
            self.assertEqual((summary[other], summary["coupling_points"]), (0, 0))
            self.assertEqual([name for name in REQUIRED if name not in summary and not name.endswith("_cpu_s")], [])

    def test_histories_end_on_the_duration_and_fields_are_listed(self):
        run = self.run_scene(CASE / "coupled.yaml", *SHORT)
        rows = list(csv.DictReader((run / "histories.csv").read_text().splitlines()))
        self.assertAlmostEqual(float(rows[-1]["time_s"]), 5e-3, delta=1e-15)
        self.assertIn("tip_uy_m", rows[0])
        self.assertIn("max_bond_force_N", rows[0])
        listed = (run / "fields" / "fields.pvd").read_text()
        for piece in ("grid", "particles", "bonds"):
            self.assertEqual(listed.count(f'file="{piece}_'), 2)
            self.assertEqual(len(list((run / "fields").glob(f"{piece}_*"))), 2)

    def test_the_scene_in_the_results_computes_the_same_again(self):
        first = self.run_scene(CASE / "coupled.yaml", *SHORT, out="first")
        copy = self.scene((first / "scene.yaml").read_text(), "copy.yaml")
        again = self.run_scene(copy, out="again")
        self.assertEqual((first / "histories.csv").read_bytes(), (again / "histories.csv").read_bytes())
        self.assertEqual(self.summary(first)["scene_hash"], self.summary(again)["scene_hash"])

    def test_check_validates_without_computing(self):
        result = coupler("check", CASE / "coupled.yaml")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
