"""Response spectra that the report computes from motions and displacements agree with closed forms of the oscillator."""

import unittest

import numpy as np

from adit.plots import oscillators

PERIOD, INTERVAL = 0.5, 0.005
TIME = np.arange(0, 40, INTERVAL)
SINE = np.sin(2 * np.pi * TIME / PERIOD)  # acceleration of the base [m/s²]


class Oscillators(unittest.TestCase):
    def test_an_oscillator_at_resonance_magnifies_by_half_the_inverse_of_its_damping(self):
        for damping in (0.02, 0.05, 0.1):
            found, = oscillators.pseudo_acceleration(SINE, INTERVAL, [PERIOD], damping)
            self.assertAlmostEqual(found * 2 * damping, 1, delta=5e-3)

    def test_a_stiff_oscillator_moves_with_its_base_and_a_soft_one_stays_behind(self):
        stiff, = oscillators.pseudo_acceleration(SINE, INTERVAL, [PERIOD / 25])
        self.assertAlmostEqual(stiff, 1, delta=5e-3)
        # A pulse much shorter than the period gives the oscillator its velocity; damping takes exp(-ζ atan(1/ζ)) of the peak.
        pulse, soft = np.where(TIME < 0.01, 1.0, 0.0), 4.0
        found, = oscillators.pseudo_acceleration(pulse, INTERVAL, [soft])
        peak = 2 * np.pi / soft * 0.01 * np.exp(-0.05 * np.arctan(1 / 0.05))
        self.assertAlmostEqual(found / peak, 1, delta=1e-2)

    def test_a_displacement_gives_the_spectrum_of_its_acceleration(self):
        displacement = -(PERIOD / (2 * np.pi))**2 * SINE
        for rows, loss in ((10, 0.034), (40, 0.003)):  # (sin x / x)² with x = π / rows
            every = int(PERIOD / rows / INTERVAL)
            interval = every * INTERVAL
            periods, found = oscillators.of_displacement(displacement[::every], interval)
            self.assertGreaterEqual(periods[0], 10 * interval - 1e-12)
            true = oscillators.pseudo_acceleration(SINE, INTERVAL, periods)
            self.assertAlmostEqual(found.max() / true.max(), 1 - loss, delta=5e-3)


if __name__ == "__main__":
    unittest.main()
