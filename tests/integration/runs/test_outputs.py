"""Histories, spectra and peaks over time that a run writes agree with theory and with each other."""

import csv
import math
import subprocess
import unittest

import numpy

from programs import ADIT, CASE, ProgramTest, coupler

from adit import Run

G = 9.80665
VELOCITY, FREQUENCY, END = 0.2, 4.0, 2.5  # of the base: ten cycles of a sine, half of one is 5 %

# A column of ground on a shaken base.
SCENE = f"""\
material: {{young_modulus: 100 MPa, poisson_ratio: 0.25, density: 2000 kg/m^3}}
time: {{duration: 3 s}}
continuum:
  block: {{x_min: 0 m, x_max: 4 m, y_min: 0 m, y_max: 10 m, zones_x: 4, zones_y: 10}}
  motions:
    - where: {{y_max: 0 m}}
      velocity: {{x: {VELOCITY} m/s, y: 0 m/s}}
      time: {{sine: {{frequency: {FREQUENCY} Hz, end: {END} s}}}}
    - where: {{y_min: 0.1 m}}
      velocity: {{y: 0 m/s}}
  histories:
    - {{name: base, quantity: acceleration_x, at: {{x: 1.7 m, y: 0 m}}}}
    - {{name: surface, quantity: acceleration_x, at: {{x: 2 m, y: 10 m}}}}
    - {{name: surface, quantity: displacement_x, at: {{x: 2 m, y: 10 m}}}}
    - {{name: surface, quantity: velocity_x, at: {{x: 2 m, y: 10 m}}}}
    - {{name: inside, quantity: stress_xy, at: {{x: 2.5 m, y: 4.5 m}}}}
    - {{name: inside, quantity: shear_strain_xy, at: {{x: 2.5 m, y: 4.5 m}}}}
"""
SPECTRA = "{history: base}, {history: surface, damping: [0.02, 0.05], relative_to: base, longest_period: 0.5 s}"


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        header, *rows = csv.reader(file)
    return dict(zip(header, numpy.array(rows, float).T))


class Outputs(ProgramTest):
    def run_with(self, output):
        return self.run_scene(self.scene(SCENE + f"output: {output}\n"))

    def refusal(self, scene):
        result = coupler("check", scene)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assert_one_line(result.stderr)
        return result.stderr

    def refused_output(self, output):
        return self.refusal(self.scene(SCENE + f"output: {output}\n"))

    def test_measures_of_a_sine_are_its_closed_forms(self):
        summary = self.summary(self.run_with(f"{{spectra: [{SPECTRA}]}}"))
        w = 2 * math.pi * FREQUENCY
        pga = VELOCITY * w
        for measure, exact, tolerance in (("pga_m_per_s2", pga, 1e-3), ("pgv_m_per_s", VELOCITY, 2e-3),
                                          ("pgd_m", 2 * VELOCITY / w, 2e-3),
                                          ("arias_m_per_s", math.pi * pga**2 * END / (4 * G), 5e-3),
                                          ("cav_m_per_s", 2 * pga * END / math.pi, 5e-3),
                                          ("significant_duration_s", 0.9 * END, 5e-3)):
            self.assertAlmostEqual(summary[f"base_ax_{measure}"] / exact, 1, delta=tolerance, msg=measure)
        self.assertLessEqual(summary["spectra_sampling_interval_s"], 0.05 / 20)

    def test_spectra_of_the_surface_agree_with_its_histories(self):
        run = self.run_with(f"{{spectra: [{SPECTRA}]}}")
        summary, rows = self.summary(run), table(run / "histories.csv")
        motion = table(run / "spectra" / "surface_ax_motion.csv")
        self.assertAlmostEqual(summary["surface_ax_pga_m_per_s2"] / abs(rows["surface_ax_m_per_s2"]).max(), 1, delta=1e-9)
        # The acceleration integrates to the recorded velocity, of half a step before, and displacement.
        for column, recorded, lag in (("velocity_m_per_s", "surface_vx_m_per_s", summary["dt_s"] / 2),
                                      ("displacement_m", "surface_ux_m", 0)):
            error = numpy.interp(rows["time_s"] - lag, motion["time_s"], motion[column]) - rows[recorded]
            self.assertLess(abs(error).max(), 2e-3 * abs(rows[recorded]).max(), column)
        fourier = table(run / "spectra" / "surface_ax_fourier.csv")
        self.assertAlmostEqual(fourier["frequency_Hz"][0], fourier["frequency_Hz"][1] / 2)  # 0 Hz is no shaking
        response = table(run / "spectra" / "surface_ax_response.csv")
        self.assertEqual((response["period_s"][0], response["period_s"][-1]), (0.05, 0.5))
        self.assertGreater(response["psa_2pct_m_per_s2"].max(), 1.2 * response["psa_5pct_m_per_s2"].max())
        w = 2 * math.pi / response["period_s"]
        numpy.testing.assert_allclose(response["psa_5pct_m_per_s2"], w**2 * response["sd_5pct_m"], rtol=1e-12)
        # A linear column on a rigid base amplifies most at its own frequency, vs / (4 H).
        own = math.sqrt(100e6 / 2.5 / 2000) / 40
        self.assertAlmostEqual(summary["surface_ax_largest_amplification_Hz"] / own, 1, delta=0.1)
        self.assertGreater(summary["surface_ax_largest_amplification"], 3)

    def test_input_stands_beside_the_response_and_amplification_is_masked_where_it_has_nothing(self):
        run = self.run_with(f"{{spectra: [{SPECTRA}]}}")
        reference = table(run / "spectra" / "surface_ax_reference.csv")
        base = table(run / "spectra" / "base_ax_response.csv")
        inside = base["period_s"] <= 0.5
        self.assertAlmostEqual(reference["psa_5pct_m_per_s2"].max() / base["psa_5pct_m_per_s2"][inside].max(), 1, delta=0.02)
        transfer = table(run / "spectra" / "surface_ax_transfer.csv")
        below = transfer["base_ax_amplitude_m_per_s"]
        numpy.testing.assert_array_equal(numpy.isnan(transfer["ratio"]), below < 0.03 * below.max())
        self.assertTrue(numpy.isnan(transfer["ratio"]).any())
        self.assertEqual(self.summary(run)["surface_ax_largest_amplification"], numpy.nanmax(transfer["ratio"]))

    def test_motion_of_the_base_stands_beside_the_response(self):
        scene = SCENE[:SCENE.index("  motions:")] + """\
  base: {kind: compliant, acceleration: {ricker: {frequency: 4 Hz, time: 0.5 s}, peak: 0.1 g}}
  histories: [{name: surface, quantity: acceleration_x, at: {x: 2 m, y: 10 m}}]
"""
        run = self.run_scene(self.scene(scene + "output: {spectra: [{history: surface}]}\n"))
        reference = table(run / "spectra" / "surface_ax_reference.csv")
        # An oscillator that is stiff beside the wavelet has its peak acceleration.
        self.assertAlmostEqual(reference["psa_5pct_m_per_s2"][0] / (0.1 * G), 1, delta=0.1)
        motion = table(run / "spectra" / "surface_ax_input.csv")
        top = abs(motion["acceleration_m_per_s2"]).argmax()
        self.assertAlmostEqual(abs(motion["acceleration_m_per_s2"][top]) / (0.1 * G), 1, delta=1e-2)
        self.assertAlmostEqual(motion["time_s"][top], 0.5, delta=0.01)

    def test_rows_come_at_the_interval(self):
        run = self.run_with("{history_interval: 5 ms}")
        time = table(run / "histories.csv")["time_s"]
        numpy.testing.assert_allclose(time, 0.005 * numpy.arange(601), rtol=1e-12, atol=0)

    def test_peaks_are_the_largest_of_dense_histories(self):
        run = self.run_with("{peaks: {}, history_interval: 1 us, field_times: []}")
        rows = table(run / "histories.csv")
        (_, pieces), = Run(run).snapshots()
        grid = pieces["grid"]
        surface = int(numpy.argmin(numpy.hypot(*(grid.points - [2, 10]).T)))
        for field, column in (("peak_displacement_m", "surface_ux_m"), ("peak_velocity_m_per_s", "surface_vx_m_per_s"),
                              ("peak_acceleration_m_per_s2", "surface_ax_m_per_s2")):
            self.assertAlmostEqual(grid.field(field)[surface] / abs(rows[column]).max(), 1, delta=1e-9, msg=field)
        zone = 4 * 4 + 2
        self.assertAlmostEqual(grid.field("peak_shear_strain")[zone] / abs(rows["inside_gxy"]).max(), 1, delta=1e-3)
        shear = abs(rows["inside_sxy_Pa"]).max()
        self.assertAlmostEqual(grid.field("peak_largest_principal_stress_Pa")[zone] / shear, 1, delta=2e-2)
        self.assertAlmostEqual(-grid.field("peak_smallest_principal_stress_Pa")[zone] / shear, 1, delta=2e-2)

    def test_peaks_of_a_band_are_at_most_a_hundredth_lower_and_off_without_being_asked(self):
        every = self.run_with("{peaks: {}}")
        band = self.run_scene(self.scene(SCENE + "output: {peaks: {highest_frequency: 20 Hz}}\n"), out="band")
        fields = []
        for run in (every, band):
            (_, pieces), = Run(run).snapshots()
            fields.append(pieces["grid"].field("peak_displacement_m"))
        self.assertTrue((fields[1] <= fields[0]).all())
        self.assertTrue((fields[1] >= 0.987 * fields[0]).all())
        off = self.run_scene(self.scene(SCENE), out="off")
        self.assertNotIn("peak_", next((off / "fields").glob("grid_*.vtu")).read_text())

    def test_every_new_output_has_its_picture(self):
        run = self.run_with(f"{{peaks: {{highest_frequency: 10 Hz}}, spectra: [{SPECTRA}]}}")
        subprocess.run([*ADIT, "plot", run], check=True, capture_output=True, timeout=120)
        drawn = {path.stem for path in (run / "pictures").glob("*.png")}
        wanted = {"histories", "peak_displacement", "peak_velocity", "peak_acceleration", "peak_shear_strain",
                  "peak_largest_principal_stress", "peak_smallest_principal_stress", "surface_ax_motion",
                  "surface_ax_response", "surface_ax_fourier", "surface_ax_transfer", "base_ax_response"}
        self.assertEqual(wanted - drawn, set())

    def test_spectra_of_no_history(self):
        message = self.refused_output("{spectra: [{history: surfase}]}")
        self.assertIn("output.spectra[0].history: is `surfase`, but no history has this name; did you mean `surface`?",
                      message)

    def test_spectra_of_something_else_than_acceleration(self):
        message = self.refused_output("{spectra: [{history: inside}]}")
        self.assertIn("is `inside`, whose histories are of stress_xy, shear_strain_xy; add one of acceleration_x", message)

    def test_spectra_relative_to_no_acceleration(self):
        message = self.refused_output("{spectra: [{history: surface, relative_to: inside}]}")
        self.assertIn("output.spectra[0].relative_to: is `inside`, whose histories are of", message)

    def test_spectra_asked_twice(self):
        message = self.refused_output("{spectra: [{history: base}, {history: base, damping: [0.1]}]}")
        self.assertIn("output.spectra[1].history: is `base` a second time; give all of its `damping` at once", message)

    def test_spectra_without_periods(self):
        message = self.refused_output("{spectra: [{history: base, shortest_period: 2 s, longest_period: 1 s}]}")
        self.assertIn("output.spectra[0].longest_period: is 1 s, expected a time above `shortest_period` = 2 s", message)

    def test_rows_too_far_apart_for_the_spectra(self):
        message = self.refused_output("{history_interval: 10 ms, spectra: [{history: base}]}")
        self.assertIn("output.history_interval: makes rows 0.0", message)
        self.assertIn("output.spectra[0].shortest_period = 0.05 s needs 0.0025 s; shorten the interval", message)

    def test_time_steps_too_long_for_the_spectra(self):
        message = self.refused_output("{spectra: [{history: base, shortest_period: 1 ms}]}")
        self.assertIn("output.spectra[0].shortest_period: is 0.001 s, which needs samples 5e-05 s apart, but the time step",
                      message)

    def test_damping_out_of_range(self):
        self.assertIn("damping", self.refused_output("{spectra: [{history: base, damping: [1.5]}]}"))

    def test_a_history_outside_the_model(self):
        message = self.refusal(self.scene(SCENE.replace("x: 1.7 m, y: 0 m", "x: 1.7 m, y: -2 m")))
        self.assertIn("continuum.histories[0].at: is (1.7, -2) m, where the continuum has no zone", message)

    def test_a_quantity_that_particles_do_not_have(self):
        scene = (CASE / "full_dem.yaml").read_text().replace("quantity: displacement_y", "quantity: strain_xx")
        message = self.refusal(self.scene(scene))
        self.assertIn("particles.histories[0].quantity: is strain_xx, which particles do not have", message)

    def test_aliasing_is_told(self):
        # A short hammer blow at the base, sampled as coarsely as the spectra allow.
        scene = SCENE.replace(f"sine: {{frequency: {FREQUENCY} Hz, end: {END} s}}",
                              "table: {time: [0 s, 1 ms, 2 ms], value: [0, 1, 0]}")
        run = self.run_scene(self.scene(scene + "output: {history_interval: 20 ms, spectra: "
                                        "[{history: base, shortest_period: 0.4 s}]}\n"))
        self.assertIn("it may be aliased", self.summary(run)["warnings"][0])


if __name__ == "__main__":
    unittest.main()
