"""The cases of the continuum, in short versions, agree with wave theory and closed forms."""

import subprocess

import numpy

from programs import ADIT, PATIENCE_S, ProgramTest, SOURCE

from adit import Run
from adit.cases import site_response
from adit.cases.tunnels import lined_tunnel, lined_tunnel_pictures

SITE, TUNNEL = SOURCE / "cases" / "site_response", SOURCE / "cases" / "lined_tunnel"
WAVELET = "continuum.base.acceleration={ricker: {frequency: 4 Hz, time: 0.5 s}, peak: %s}"


class SiteResponse(ProgramTest):
    def site(self, name, duration, peak):
        run = self.run_scene(SITE / f"{name}.yaml", "--set", f"time.duration={duration}", "--set", WAVELET % peak,
                             out=f"{name}_{peak.split()[0]}")
        self.assertLess(self.summary(run)["max_energy_drift"], 1e-9)
        return site_response.Site(Run(run))

    def test_linear_ground_amplifies_as_wave_theory_says(self):
        findings = site_response.compare(self.site("outcrop", "6 s", "0.1 g"), self.site("linear", "6 s", "0.1 g"))
        self.assertLess(abs(findings.doubling - 1), 0.01)
        self.assertGreater(findings.frequency[-1], 9)
        self.assertLess(findings.error, 0.01)
        self.assertEqual(len(findings.peaks()), 3)
        for (found, amplitude), (known, known_amplitude) in findings.peaks():
            self.assertAlmostEqual(found / known, 1, delta=0.01)
            self.assertAlmostEqual(amplitude / known_amplitude, 1, delta=0.01)

    def test_hysteretic_ground_is_linear_at_small_strains_and_weakens_at_large_ones(self):
        outcrop, small = self.site("outcrop", "3 s", "1e-6 g"), self.site("hysteretic", "3 s", "1e-6 g")
        large = self.site("hysteretic", "3 s", "0.3 g")
        known = abs(site_response.transfer(small.scene, numpy.array([2.06, 4.8])))
        for frequency, theory in zip((2.06, 4.8), known):
            linear, weak = (abs(site.fourier([frequency])[0] / outcrop.fourier([frequency])[0]) for site in (small, large))
            self.assertAlmostEqual(linear / theory, 1, delta=0.02)
            self.assertLess(weak * 1e-6 / 0.3, 0.8 * linear)
        self.assertLess(large.peak / small.peak, 0.8 * 0.3 / 1e-6)
        strain, stress = large.loop("clay")
        self.assertGreater(abs(strain).max(), 5e-4)
        modulus, reference = 164.3e6 / 2.6, 1.2e-3  # the clay's curve at the largest strain
        top = abs(strain).argmax()
        backbone = modulus * abs(strain[top]) / (1 + (abs(strain[top]) / reference) ** 0.919)
        self.assertAlmostEqual(abs(stress[top]) / backbone, 1, delta=0.02)

    def test_the_study_draws_what_the_readme_shows(self):
        done = subprocess.run([*ADIT, "run", SITE, "--out", self.folder / "study", "--no-report", "--set", "time.duration=1 s",
                               "--set", WAVELET % "0.1 g"], capture_output=True, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("resonance 1", done.stdout)
        self.assertEqual({path.name for path in (self.folder / "study" / "pictures").glob("*.png")},
                         {path.name for path in (SITE / "pictures").glob("*.png")})

    def test_the_study_ends_as_its_runs_do(self):
        done = subprocess.run([*ADIT, "run", SITE, "--out", self.folder / "study", "--set",
                               "continuum.base.acceleration.file.path=absent.AT2"], capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("there is no such file", done.stderr)


class LinedTunnel(ProgramTest):
    def test_forces_are_those_of_closed_forms_at_rest_and_under_the_wave(self):
        coarse = self.scene(f"extends: {TUNNEL / 'ovaling.yaml'}\ncontinuum:\n  blocks: [{{ring: {{centre: {{x: 0, y: 0}}, "
                            "inner_radius: 3 m, outer_side: 60 m}, along: {zones: 40}, across: {zones: 16, ratio: 1.15}}]\n")
        ovaling = Run(self.run_scene(coarse, "--set", "statics.unbalanced_ratio=1e-4", out="ovaling"))
        wave = Run(self.run_scene(TUNNEL / "shear_wave.yaml", "--set", "time.duration=1 s", out="shear_wave"))
        rows = list(lined_tunnel.compare(ovaling, wave))
        self.assertEqual(len(rows), 8)
        for what, _, form, theory, found in rows:
            self.assertAlmostEqual(found / theory, 1, delta=0.05, msg=f"{what}, {form}")
        for figure in (lined_tunnel_pictures.around(ovaling), lined_tunnel_pictures.over_time(wave)):
            figure.savefig(self.folder / "picture.png")
        subprocess.run([*ADIT, "plot", wave.folder], check=True, capture_output=True, timeout=120)
        self.assertTrue((wave.folder / "pictures" / "lining_forces_560ms.png").exists())
