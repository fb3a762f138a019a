"""The laboratory tests of cemented discs agree with theory, and the fit finds the wanted properties."""

import math
import subprocess
import unittest

from programs import ADIT, ProgramTest

from adit.calibrate import fit, laboratory
from adit.calibrate.laboratory import Micro, Specimen

COARSE = Specimen(radius_min=2.5e-3, radius_max=3.5e-3)


class Laboratory(ProgramTest):
    def test_a_coarse_rock_breaks_near_the_strength_of_its_cement(self):
        micro = Micro(62e9, 2.5, 157e6, 157e6)
        rock = laboratory.test(micro, COARSE, laboratory.grow(COARSE, self.folder / "packing"), self.folder / "rock")
        properties = rock.properties()
        # wide limits: 130 discs
        self.assertAlmostEqual(properties["young_modulus_Pa"] / micro.modulus, 1.0, delta=0.25)
        self.assertAlmostEqual(properties["poisson_ratio"], 0.25, delta=0.08)
        self.assertAlmostEqual(properties["uniaxial_compressive_strength_Pa"] / micro.cohesion, 1.2, delta=0.5)
        self.assertTrue(0.03 < properties["brazilian_tensile_strength_Pa"] / micro.tensile_strength < 0.4, properties)

    def test_stiffness_scales_with_the_modulus_and_strength_with_it(self):
        packing = laboratory.grow(COARSE, self.folder / "packing")
        soft, stiff = (laboratory.compress(Micro(e, 2.5, e / 400, e / 400), COARSE, packing, self.folder / f"{e / 1e9:.0f}_GPa", 5e-3)
                       for e in (1e9, 61.37e9))
        (e_soft, nu_soft), (e_stiff, nu_stiff) = soft.elastic_constants(), stiff.elastic_constants()
        self.assertAlmostEqual(e_stiff / e_soft / 61.37, 1, delta=1e-3)
        self.assertAlmostEqual(nu_stiff / nu_soft, 1, delta=1e-3)
        # which bonds break hangs on the last digits
        self.assertAlmostEqual(stiff.strength / soft.strength / 61.37, 1, delta=0.03)

    def test_the_search_finds_what_lies_within_its_limits_and_stops_at_them(self):
        found, value = fit.search(lambda x: 3 * x**0.7, 6.0, 1.0, (0.1, 10), 1e-3)
        self.assertAlmostEqual(found, 2 ** (1 / 0.7), delta=0.01)
        self.assertAlmostEqual(value, 6, delta=0.006)
        found, value = fit.search(lambda x: 3 * x**0.7, 100.0, 1.0, (0.1, 10), 1e-3)
        self.assertAlmostEqual(found, 10)
        self.assertAlmostEqual(value, 3 * math.pow(10, 0.7))

    def test_calibrate_refuses_what_is_no_rock(self):
        done = subprocess.run([*ADIT, "calibrate", "--young-modulus", "-1", "--poisson-ratio", "0.2",
                               "--compressive-strength", "1e8", "--tensile-strength", "1e7"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--young-modulus: -1 is not above 0", done.stderr)


if __name__ == "__main__":
    unittest.main()
