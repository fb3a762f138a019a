"""An earthquake from a file, through the scene to the continuum's server and back into the results."""

import csv
import math
import os
import pathlib
import unittest

import numpy as np

from programs import ProgramTest, coupler

from adit import Run

RECORDS = pathlib.Path(os.environ.get("ADIT_RECORDS", ""))

SCENE = """\
material: {young_modulus: 200 MPa, poisson_ratio: 0.25, density: 2 t/m^3}
time: {duration: 500 ms}
continuum:
  block: {x_min: 0 m, x_max: 3 m, y_min: -10 m, y_max: 0 m, zones_x: 3, zones_y: 10}
  free_field: {left: true, right: true}
  base:
    kind: compliant
    acceleration: {file: {path: record.csv}, high_corner: 15 Hz, taper: 20 ms, peak: 0.2 g}
  damping: {rayleigh: {ratio: 0.02, low_frequency: 2 Hz, high_frequency: 20 Hz}}
  histories: [{name: surface, quantity: velocity_x, at: {x: 1 m, y: 0 m}}]
"""


# Ground that goes on as it is: its surface moves as the outcrop does, after the way of the wave.
BOTH = """\
material: {young_modulus: 200 MPa, poisson_ratio: 0.25, density: 2 t/m^3}
time: {duration: 1 s}
continuum:
  block: {x_min: 0 m, x_max: 2 m, y_min: -20 m, y_max: 0 m, zones_x: 1, zones_y: 40}
  free_field: {left: true, right: true}
  base:
    kind: %s
    acceleration: {ricker: {frequency: 4 Hz, time: 0.4 s}, peak: 0.2 g}
    across: {ricker: {frequency: 5 Hz, time: 0.3 s}, peak: 0.1 g}
  histories:
    - {name: surface, quantity: acceleration_x, at: {x: 1 m, y: 0 m}}
    - {name: surface, quantity: acceleration_y, at: {x: 1 m, y: 0 m}}
    - {name: base, quantity: acceleration_x, at: {x: 1 m, y: -20 m}}
    - {name: base, quantity: acceleration_y, at: {x: 1 m, y: -20 m}}
output: {history_interval: 1 ms}
"""


class GroundMotion(ProgramTest):
    def record(self, name="record.csv", step=0.01, rows=101):
        lines = [f"{i * step:.3f},{math.sin(40 * i * step):.6f}" for i in range(rows)]
        (self.folder / name).write_text("\n".join(["time_s,acceleration_m/s^2", *lines]) + "\n")

    def refusal(self, *arguments):
        result = coupler("run", *arguments, "--out", self.folder / "run")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assert_one_line(result.stderr)
        self.assertFalse((self.folder / "run" / "summary.json").exists())
        return result.stderr

    @staticmethod
    def ricker(frequency, time, peak, t):
        a = (math.pi * frequency * (t - time)) ** 2
        return peak * 9.80665 * (1 - 2 * a) * np.exp(-a)

    def test_motions_along_and_across_arrive_with_their_waves(self):
        run = Run(self.run_scene(self.scene(BOTH % "compliant")))
        h, t = run.histories, run.histories["time_s"]
        shear, bulk = 200e6 / 2.5, 200e6 / (3 * 0.5)
        for axis, modulus, motion in (("x", shear, (4, 0.4, 0.2)), ("y", bulk + 4 / 3 * shear, (5, 0.3, 0.1))):
            way = 20 / math.sqrt(modulus / 2000)
            np.testing.assert_allclose(h[f"surface_a{axis}_m_per_s2"], self.ricker(*motion, t - way), rtol=0, atol=0.02 * motion[2] * 9.81)
        self.assertLess(run.summary["max_energy_drift"], 1e-10)

    def test_a_rigid_base_moves_along_and_across(self):
        h = Run(self.run_scene(self.scene(BOTH % "rigid"))).histories
        for axis, motion in (("x", (4, 0.4, 0.2)), ("y", (5, 0.3, 0.1))):
            np.testing.assert_allclose(h[f"base_a{axis}_m_per_s2"], self.ricker(*motion, h["time_s"]), rtol=0, atol=0.02 * motion[2] * 9.81)

    def test_a_motion_across_needs_one_along(self):
        scene = (BOTH % "compliant").replace("acceleration: {ricker: {frequency: 4 Hz, time: 0.4 s}, peak: 0.2 g}", "velocity: {amplitude: 1 m/s}")
        self.assertIn("continuum.base.across: goes beside `acceleration` only", self.refusal(self.scene(scene)))

    def test_scene_of_the_results_reads_back_to_the_same_run(self):
        self.record()
        run = self.run_scene(self.scene(SCENE))
        self.assertLess(self.summary(run)["max_energy_drift"], 1e-10)
        with open(run / "histories.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(max(abs(float(row["surface_vx_m_per_s"])) for row in rows), 0.01)
        self.assertGreater(float(rows[-1]["continuum_dissipated_J"]), 0)
        again = self.run_scene(run / "scene.yaml", out="again")
        self.assertEqual((run / "histories.csv").read_bytes(), (again / "histories.csv").read_bytes())

    def test_record_of_the_command_line(self):
        self.record("other.csv")
        self.run_scene(self.scene(SCENE), "--set",
                       f"continuum.base.acceleration.file.path={self.folder / 'other.csv'}")

    def test_record_shorter_than_the_run(self):
        self.record(rows=20)
        message = self.refusal(self.scene(SCENE))
        self.assertIn("scene.yaml:8:", message)
        self.assertIn("continuum.base.acceleration.file.path: the motion ", message)
        self.assertIn("record.csv lasts 0.19 s, but 0.5 s are asked for", message)

    def test_a_cut_is_told_and_the_shorter_run_is_the_beginning_of_the_longer_one(self):
        self.record(rows=301)
        scene = self.scene(SCENE.replace("peak: 0.2 g}", "peak: 0.2 g, from: 100 ms}")
                           .replace("time: {duration: 500 ms}", "time: {duration: 500 ms}\noutput: {history_interval: 5 ms}"))
        checked = coupler("check", scene)
        self.assertEqual(checked.returncode, 0, checked.stderr)
        self.assertIn("continuum: base.acceleration: the motion is used up to 0.6 s, inside its shaking", checked.stdout)
        tables = []
        for duration in ("20 ms", "500 ms", "1 s"):
            run = self.run_scene(scene, "--set", f"time.duration={duration}", out=duration.replace(" ", "_"))
            self.assertIn("is used from 0.1 s on, inside its shaking", self.summary(run)["notes"][0])
            with open(run / "histories.csv", newline="", encoding="utf-8") as file:
                tables.append([(float(row["time_s"]), float(row["surface_vx_m_per_s"])) for row in csv.DictReader(file)])
        for i, (time, velocity) in enumerate(tables[1]):
            self.assertAlmostEqual(time, 0.005 * i, delta=1e-12)
            self.assertAlmostEqual(velocity, tables[2][i][1], delta=1e-12)
        self.assertEqual(tables[0], tables[2][:5])

    def test_file_of_another_kind(self):
        (self.folder / "record.csv").write_text("not a table\n")
        self.assertIn("continuum.base.acceleration.file.path: ", self.refusal(self.scene(SCENE)))

    def test_frequency_not_positive(self):
        self.record()
        message = self.refusal(self.scene(SCENE), "--set", "continuum.base.acceleration.high_corner=-15 Hz")
        self.assertIn("above 0 Hz", message)

    @unittest.skipUnless(RECORDS.is_dir() and RECORDS.name, "the PEER records are not on this machine (ADIT_RECORDS)")
    def test_peer_records_of_every_header_and_the_wrong_one(self):
        path = self.scene(SCENE)
        field = "continuum.base.acceleration.file.path"
        for name in ("NIS090.AT2", "RSN1106_KOBE_KJM000.AT2", "RSN4346_UBMARCHE.P_A-BEV000.AT2"):
            self.run_scene(path, "--set", f"{field}={RECORDS / name}", out=name)
        message = self.refusal(path, "--set", f"{field}={RECORDS / 'KOBE_NS1_wrong_header.AT2'}")
        self.assertIn("states 10102 points, but 2567 values follow", message)

    @unittest.skipUnless(RECORDS.is_dir() and RECORDS.name, "the PEER records are not on this machine (ADIT_RECORDS)")
    def test_outcrop_has_the_displacement_of_the_record_for_any_duration(self):
        outcrop = self.scene("""\
material: {young_modulus: 3.8 GPa, poisson_ratio: 0.3, density: 2.3 t/m^3}
time: {duration: 18 s, dt_factor: 0.9}
continuum:
  block: {x_min: 0 m, x_max: 2 m, y_min: -5 m, y_max: 0 m, zones_x: 1, zones_y: 5}
  free_field: {left: true, right: true}
  base: {kind: compliant, acceleration: {file: {path: record.AT2}, peak: 0.3 g}}
  histories: [{name: surface, quantity: acceleration_x, at: {x: 1 m, y: 0 m}}]
output: {field_times: [], spectra: [{history: surface}]}
""")
        record = (RECORDS / "RSN1106_KOBE_KJM000.AT2").read_bytes()
        (self.folder / "record.AT2").write_bytes(record)
        # `peak` is that of the curve between the values; the record's velocity and displacement, 0.330 m/s and 0.076 m where the
        # largest value is 0.3 g, are smaller by as much as the curve rises above that value.
        values = np.array(b" ".join(record.splitlines()[4:]).split(), float)
        curve = 16 * np.fft.irfft(np.fft.rfft(values, 2 * len(values)), 32 * len(values))  # band-limited, zeros behind the record
        rise = np.abs(curve).max() / np.abs(values).max()
        pgv, pgd = 0.330 / rise, 0.076 / rise
        for duration in ("18 s", "30 s"):
            summary = self.summary(self.run_scene(outcrop, "--set", f"time.duration={duration}", out=duration.replace(" ", "_")))
            self.assertAlmostEqual(summary["surface_ax_pgv_m_per_s"] / pgv, 1, delta=0.01)
            self.assertAlmostEqual(summary["surface_ax_pgd_m"] / pgd, 1, delta=0.01)
        later = self.summary(self.run_scene(outcrop, "--set", "time.duration=14 s", "--set",
                                            "continuum.base.acceleration.from=4 s", out="later"))
        self.assertAlmostEqual(later["surface_ax_pgv_m_per_s"] / pgv, 1, delta=0.01)
        self.assertAlmostEqual(later["surface_ax_pgd_m"] / pgd, 1, delta=0.01)


if __name__ == "__main__":
    unittest.main()
