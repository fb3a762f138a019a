"""`from adit import Run` reads what runs of every kind have written, and says in one sentence what they have not."""

import csv
import json
import os
import subprocess
import sys
import types
import unittest

import numpy

from programs import ADIT, BUILD, CASE, PATIENCE_S, ProgramTest, SOURCE

from adit import Run, Unusable

SHORT = ("--set", "time.duration=12 ms", "--set", "output.field_times=[4 ms, 8 ms, 12 ms]")
PULLED = "--set", "particles.bonds.tensile_strength=1 MN"  # so weak that it cracks at once

# Discs that touch: the general engine, whose energies are told by cause.
TOUCHING = "--set", "particles.contacts={friction: 0.5}"


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Reading(ProgramTest):
    def coupled(self, *arguments):
        return Run(self.run_scene(CASE / "coupled.yaml", *SHORT, *arguments))

    def test_histories_cracks_and_summary_are_what_the_files_say(self):
        run = self.coupled(*PULLED)
        rows = rows_of(run.folder / "histories.csv")
        for name, values in run.histories.items():
            self.assertEqual(list(values), [float(row[name]) for row in rows], name)
        cracks = rows_of(run.folder / "cracks.csv")
        self.assertGreater(len(cracks), 0)
        self.assertEqual(list(run.cracks["mode"]), [row["mode"] for row in cracks])
        self.assertEqual(list(run.cracks["x_m"]), [float(row["x_m"]) for row in cracks])
        self.assertEqual(run.summary, json.loads((run.folder / "summary.json").read_text()))
        self.assertEqual(run.summary["crack_count"], len(cracks))
        self.assertTrue(run.completed)

    def test_energies_balance_and_are_told_by_cause(self):
        run = self.coupled(*TOUCHING)
        energies = run.energies
        work, stored = (sum(energies[f"{side}_{kind}_J"] for side in ("continuum", "particles") for kind in kinds)
                        for kinds in (["external_work"], ["kinetic", "strain", "released", "dissipated"]))
        peak = stored.max()
        self.assertGreater(peak, 0)
        numpy.testing.assert_allclose(stored / peak, work / peak, atol=2 * run.summary["max_energy_drift"] + 1e-12)
        by_cause = rows_of(run.folder / "energies.csv")
        self.assertIn("particles_contact_bonds_J", set(energies))
        self.assertEqual(list(energies["particles_contact_bonds_J"]), [float(row["particles_contact_bonds_J"]) for row in by_cause])

    def test_fields_are_those_of_the_instant_asked_for(self):
        run = self.coupled()
        numpy.testing.assert_allclose(run.times, (0.004, 0.008, 0.012), rtol=1e-9)
        tip = run.histories["tip_uy_m"]
        for time in run.times:
            grid = run.fields(time)["grid"]
            at_the_tip = numpy.argmin(numpy.hypot(*(grid.points - [0, 0.5]).T))
            self.assertAlmostEqual(grid["displacement_m"][at_the_tip, 1],
                                   numpy.interp(time, run.histories["time_s"], tip), delta=1e-3 * abs(tip).max())
        numpy.testing.assert_array_equal(run.fields()["grid"]["displacement_m"], grid["displacement_m"])
        self.assertEqual(len(run.fields()["particles"].points), run.summary["particles"])

    def test_the_scene_is_as_it_was_computed(self):
        scene = self.coupled().scene
        self.assertEqual(scene["time"]["duration"], 0.012)
        self.assertEqual(scene["interface"]["overlap"]["continuum_ends"], {"x": 6, "y": 0})

    def test_a_run_that_was_killed_has_what_was_written(self):
        run = self.coupled(*TOUCHING)
        whole = run.histories
        (run.folder / "summary.json").unlink()
        text = (run.folder / "histories.csv").read_text()
        (run.folder / "histories.csv").write_text(text[:len(text) // 2])  # it ends in half a row
        stopped = Run(run.folder)
        self.assertEqual(stopped.summary, {})
        self.assertFalse(stopped.completed)
        rows = len(stopped.histories["time_s"])
        self.assertIn(rows, range(2, len(whole["time_s"])))
        for name, values in stopped.histories.items():
            numpy.testing.assert_array_equal(values, whole[name][:rows], name)
        self.assertEqual({len(values) for values in stopped.energies.values()}, {rows})
        self.assertEqual(len(stopped.times), 3)

    def test_a_run_that_was_killed_has_its_pictures(self):
        run = self.coupled()
        (run.folder / "summary.json").unlink()
        done = subprocess.run([*ADIT, "plot", run.folder], capture_output=True, text=True, timeout=200)
        self.assertEqual(done.returncode, 0, done.stderr)
        drawn = {path.stem for path in (run.folder / "pictures").glob("*.png")}
        self.assertLessEqual({"histories", "energy", "deformed_12ms", "bonds_4ms", "displacement_8ms"}, drawn)

    def test_a_single_model_and_a_whole_tunnel_are_read_alike(self):
        particles = Run(self.run_scene(CASE / "full_dem.yaml", *SHORT, out="particles"))
        self.assertNotIn("grid", particles.fields())
        self.assertFalse(particles.is_simplified)
        tunnel = self.folder / "tunnel"
        subprocess.run([BUILD / "simplified" / "simplified", "run", SOURCE / "cases" / "hzm" / "uniform_0.1g.yaml",
                        "--set", "time.duration=1 s", "--out", tunnel], check=True, capture_output=True, timeout=PATIENCE_S)
        tunnel = Run(tunnel)
        self.assertTrue(tunnel.is_simplified)
        envelopes = tunnel.table("envelopes.csv")
        largest = max(abs(envelopes["axial_force_max_N"]).max(), abs(envelopes["axial_force_min_N"]).max())
        self.assertAlmostEqual(largest / tunnel.summary["max_axial_force_N"], 1, delta=1e-9)

    def test_tables_become_frames_where_pandas_is_installed(self):
        run = self.coupled()
        stand_in = types.SimpleNamespace(DataFrame=lambda columns: columns)
        try:
            import pandas
            self.assertEqual(list(run.histories.frame()["tip_uy_m"]), list(run.histories["tip_uy_m"]))
            self.assertIsInstance(run.cracks.frame(), pandas.DataFrame)
        except ImportError:
            with self.assertRaisesRegex(Unusable, "pandas is not installed: install python3-pandas"):
                run.histories.frame()
        known, sys.modules["pandas"] = sys.modules.get("pandas"), stand_in
        self.addCleanup(lambda: sys.modules.update(pandas=known) if known else sys.modules.pop("pandas"))
        grid = run.fields()["grid"].point_fields.frame()
        self.assertEqual(list(grid["displacement_m_1"]), list(run.fields()["grid"]["displacement_m"][:, 1]))

    def test_what_a_run_does_not_have_is_said_in_one_sentence(self):
        run = self.coupled()
        for asked, said in (
                (lambda: Run(self.folder), "is not the folder of a run: it holds neither scene.yaml nor summary.json"),
                (lambda: run.histories["tip_uym"], "histories.csv has no `tip_uym`; did you mean `tip_uy_m`?"),
                (lambda: run.fields(0.006), "has no fields at 0.006 s; they were written at 0.004, 0.008, 0.012 s"),
                (lambda: run.fields()["linings"], "the fields have no `linings`; there is grid, particles, bonds"),
                (lambda: run.fields()["grid"]["stres_Pa"], "has no field `stres_Pa`; did you mean `stress_Pa`?"),
                (lambda: run.table("envelopes.csv"), "has no envelopes.csv; there is cracks.csv, histories.csv")):
            with self.assertRaises(Unusable) as caught:
                asked()
            self.assertIn(said, str(caught.exception))
        damaged = next((run.folder / "fields").glob("grid_*.vtu"))
        damaged.write_text(damaged.read_text()[:300])
        with self.assertRaisesRegex(Unusable, rf"{damaged.name} is damaged \(ParseError: .*\): run the scene again"):
            run.fields(0.004)


class Example(ProgramTest):
    def test_the_example_says_what_the_runs_hold_and_draws(self):
        for name in ("full_dem", "coupled"):
            self.run_scene(CASE / f"{name}.yaml", "--set", "time.duration=35 ms", "--set", "output.field_times=[32 ms]", out=name)
        done = subprocess.run([sys.executable, SOURCE / "docs" / "read_results.py", self.folder], capture_output=True, text=True,
                              timeout=120, env=os.environ | {"PYTHONPATH": str(SOURCE / "python")})
        self.assertEqual(done.returncode, 0, done.stderr)
        count, force = self.summary(self.folder / "coupled")["crack_count"], self.summary(self.folder / "coupled")["peak_bond_force_N"]
        self.assertIn(f"coupled: {count} cracks, largest bond force {force / 1e3:.0f} kN", done.stdout)
        self.assertIn("overlap: from x = 4 m to 6 m", done.stdout)
        self.assertTrue((self.folder / "deflection.png").read_bytes().startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
