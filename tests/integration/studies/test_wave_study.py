"""The study of waves through the overlap writes its table, with plausible numbers, and its pictures."""

import csv
import subprocess

from browser import FAULTS, page
from programs import ADIT, SOURCE, ProgramTest

CASE = SOURCE / "cases" / "wave_bar"
COLUMNS = """solve h_over_a overlap_over_h lambda_over_h dt_factor angle_deg side reflected transmitted lost""".split()


class WaveStudy(ProgramTest):
    def study(self, pattern):
        return subprocess.run([*ADIT, "run", CASE, "--only", pattern, "--out", self.folder / "study"],
                              capture_output=True, text=True)

    def test_two_rows_become_a_table_and_a_picture(self):
        done = self.study("bar_P_[ls]*_h10_overlap5_lambda1_dt0.5_*_particles_m1")
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.folder / "study" / "reflection.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0])[:len(COLUMNS)], COLUMNS)
        self.assertEqual([(row["solve"], float(row["lambda_over_h"])) for row in rows], [("lumped", 1), ("split", 1)])
        for row in rows:  # a wave much too short for the grid: none passes, nearly all is absorbed
            shares = [float(row[name]) for name in ("reflected", "transmitted", "lost")]
            self.assertAlmostEqual(sum(shares), 1, delta=2e-6)
            self.assertLess(shares[1], 1e-4)
            self.assertGreater(shares[2], 0.95)
        self.assertTrue((self.folder / "study" / "pictures" / "over_wavelength.png").stat().st_size > 0)
        text = (self.folder / "study" / "report.html").read_text()
        for said in ("Sends waves through the overlap", "Reflected and lost in the bar over the wavelength", "coupler ",
                     f"<td>{100 * float(rows[0]['reflected']):.2f}/{100 * float(rows[0]['lost']):.1f}</td>"):
            self.assertIn(said, text)
        with page(self.folder / "study" / "report.html", 390) as driver:
            self.assertEqual(driver.execute_script(FAULTS), [])

    def test_a_pattern_without_rows_is_refused(self):
        done = self.study("nothing")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no row's name matches nothing; names look like bar_P_consistent", done.stderr)
