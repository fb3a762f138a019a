"""Concrete that is torn fast is stronger (`fracture.rate_exponent`), by its rate of strain; slow concrete, and concrete without the key, does
not know of it."""

import copy
import unittest

import numpy as np

from figures.computed import ComputedTest
from figures.test_crack_widths import HEIGHT, SPECIMEN

EXPONENT = 0.018  # fib Model Code 2010, 5.1.11.2.1: (rate / 1e-6 per second) to this power
STRAIN = 2.5e6 / 30e9  # by which a slow specimen breaks


class RateEffect(ComputedTest):
    def torn(self, rate, exponent, stretch):
        """The largest thrust of the specimen that is stretched by so much, at this rate of strain [1/s]; [N/m]."""
        scene = copy.deepcopy(SPECIMEN)
        scene["material"]["fracture"]["rate_exponent"] = exponent
        scene["time"] = {"duration": stretch / rate}
        particles = scene["particles"]
        particles["motions"][1]["velocity"]["y"] = rate * HEIGHT
        del particles["damping"]
        particles["sections"] = [{"name": "middle", "from": {"x": 0.0, "y": HEIGHT / 2}, "to": {"x": 0.1, "y": HEIGHT / 2}}]
        particles["histories"] = [{"name": "force", "quantity": "thrust", "section": "middle"}]
        scene["output"] = {"history_interval": stretch / rate / 200}
        self.computed(scene)
        return self.run.histories["force_thrust_N"].max()

    def test_strength_grows_with_the_rate_of_strain(self):
        """The start of the platen shakes the specimen: facets are strained as fast as it is, or up to six times as fast."""
        for rate in (0.001, 0.02):
            stated, raised = (self.torn(rate, exponent, 1.6 * STRAIN) for exponent in (0.0, EXPONENT))
            for times, compare in ((0.9, self.assertGreater), (6, self.assertLess)):
                compare(raised / stated, (times * rate / 1e-6) ** EXPONENT)

    def test_statics_are_slow(self):
        scene = copy.deepcopy(SPECIMEN)
        scene["statics"] = {"unbalanced_ratio": 1e-5}
        answers = []
        for exponent in (0.0, EXPONENT):
            loaded = copy.deepcopy(scene)
            loaded["material"]["fracture"]["rate_exponent"] = exponent
            particles = loaded["particles"]
            loaded["time"] = {"duration": 1e-5}
            loaded["output"] = {}
            particles["motions"] = [{"where": {"y_max": 0.0}, "velocity": {"x": 0.0, "y": 0.0}}]
            particles["loads"] = [{"where": {"y_min": HEIGHT}, "force": {"y": 0.97 * 2.5e6 * 0.1}}]
            answers.append(self.computed(loaded).summary)
        self.assertEqual(answers[0]["peak_bond_force_N"], answers[1]["peak_bond_force_N"])
        np.testing.assert_equal(answers[0]["crack_count"], answers[1]["crack_count"])


if __name__ == "__main__":
    unittest.main()
