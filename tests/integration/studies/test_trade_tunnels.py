"""adit trade measures models of a tunnel against the finest; the fault's beam agrees with integrals in closed form."""

import csv
import unittest

import numpy as np

from programs import ProgramTest
from studies.test_trade import trade

from adit.trade.tunnels.fault_beam import Beam


def integral(values, s):
    return np.sum((values[1:] + values[:-1]) / 2 * np.diff(s))


class FaultBeam(unittest.TestCase):
    """Both integrals over the wave number, turned to the imaginary axis of q, where they do not oscillate; a step that is spread
    over a width moves the beam as the mean of sharp steps there."""

    S = np.linspace(0, 60, 60_001)
    SPREAD = 0.5
    STEPS = (np.arange(20) + 0.5) / 20 * SPREAD - SPREAD / 2

    def thrust(self, x):
        """With EA = 4, kappa = 2, so that l = 2, of a step of 1/4."""
        return 4 * 0.25 / np.pi / 2 * integral(self.S * np.exp(-self.S * x / 2) / (1 + self.S**2), self.S)

    def moment(self, x):
        """With EI = 16, kappa = 2, so that l = 2, of a step of 1/2."""
        pole = np.exp(1j * np.pi / 3)
        turned = (2j * np.pi * np.exp(1j * pole * x / 2) / (3 * pole)).imag
        turned -= integral(self.S**4 * np.exp(-self.S * x / 2) / (1 + self.S**6), self.S)
        return -16 * 0.5 / np.pi / 4 * turned

    def test_forces(self):
        beam = Beam(axial=4.0, bending=16.0, kappa=2.0, spread=self.SPREAD)
        for x in (1.0, 3.0, 8.0):
            self.assertAlmostEqual(beam.thrust(x, 0.25) / np.mean([self.thrust(x + s) for s in self.STEPS]), 1, delta=0.002)
            self.assertAlmostEqual(beam.moment(x, 0.5) / np.mean([self.moment(x + s) for s in self.STEPS]), 1, delta=0.002)


class Tunnels(ProgramTest):
    def climb(self, case):
        result = trade(case, "--quick", "--out", self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        for name in (f"{case}.md", f"{case}.png"):
            self.assertTrue((self.folder / name).exists())
        with open(self.folder / f"{case}.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        computed = {row["model"]: row for row in rows if int(row["updates"])}
        for name, row in computed.items():
            for cost in ("cpu_s", "wall_s", "memory_bytes"):
                self.assertGreater(float(row[cost]), 0, f"{name}: {cost}")
        return computed

    def test_walls_of_zones_are_elastic_before_they_yield_and_regions_grow(self):
        rows = self.climb("longxi")
        elastic, yielding = rows["elastic zones"], rows["zones that yield"]
        for quantity in ("thrust 1 d", "thrust 2 d", "moment 1 d", "moment 2 d"):
            self.assertAlmostEqual(float(yielding[quantity]) / float(elastic[quantity]), 1, places=6)
        small, large = rows["particles within 0.5 d"], rows["particles within 1.25 d"]
        self.assertGreater(int(large["particles"]), int(small["particles"]))
        self.assertGreater(int(large["memory_bytes"]), int(small["memory_bytes"]))
        self.assertEqual({large[name] for name in large if name.endswith("error") and large[name]}, {"0.0"})

    def test_regions_of_cells_grow_in_height_and_are_whole_before_the_offset(self):
        low, tall = self.climb("longxi_cells").values()
        # as many cells more as 0.866 size^2 go into 6 m of height and 64.6 m of length
        self.assertAlmostEqual((int(tall["particles"]) - int(low["particles"])) * 0.866 * 0.386**2 / (6 * 64.6), 1, delta=0.03)
        for row in (low, tall):
            self.assertEqual(float(row["all"]), 0, "cracks")


if __name__ == "__main__":
    unittest.main()
