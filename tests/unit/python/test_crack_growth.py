"""Cracks of linear elastic fracture mechanics grow as theory says."""

import math
import unittest

import numpy as np

from adit.cases import crack_growth, mixed_mode

HALF = 6  # of a plate that is drawn up and down, over half of its crack
PLATE = np.array([-HALF - 1j * HALF, HALF - 1j * HALF, HALF + 1j * HALF, -HALF + 1j * HALF, -HALF - 1j * HALF])


def tension(places):
    return np.where(np.abs(places.imag) > HALF - 1e-9, -1.0, 0.0)


class CrackGrowth(unittest.TestCase):
    def test_slip_alone_turns_a_crack_by_70_degrees(self):
        """Erdogan and Sih (1963): cos(angle) = 1 / 3."""
        for slip in (1, -1):
            self.assertAlmostEqual(crack_growth.turning(0, slip), -slip * math.acos(1 / 3))
        self.assertEqual(crack_growth.turning(1, 0), 0)

    def test_an_inclined_crack_in_a_plate_turns(self):
        """By 53 degrees where it lies at 45 degrees to the tension: as much slip as opening. Then it runs across the tension."""
        tip = np.exp(0.25j * np.pi)
        path = crack_growth.crack_path(PLATE, tension, np.array([-tip, tip]), 0.1, 0.6)
        turned = np.angle((path[1] - path[0]) / tip)
        self.assertAlmostEqual(math.degrees(turned), -math.degrees(2 * math.atan(0.5)), delta=2)
        self.assertAlmostEqual(np.angle(path[-1] - path[-2]), 0, delta=math.radians(8))

    def test_a_crack_across_the_tension_runs_straight(self):
        path = crack_growth.crack_path(PLATE, tension, np.array([-1 + 0j, 1]), 0.2, 0.6)
        np.testing.assert_allclose(path.imag, 0, atol=1e-6)

    def test_the_path_in_the_beam_does_not_depend_on_the_elements(self):
        """A crack beside the middle ends below the press."""
        path = mixed_mode.theory()
        finer = mixed_mode.theory(48)
        self.assertLess(crack_growth.distances(path[:-2], finer).max(), 0.01)
        self.assertAlmostEqual(path[0], -mixed_mode.ECCENTRICITY + 1j * mixed_mode.NOTCH)
        self.assertLess(abs(path[-1].real), 0.7 * mixed_mode.ECCENTRICITY)


if __name__ == "__main__":
    unittest.main()
