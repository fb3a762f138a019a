"""The Longxi tunnel, in a short and coarse version: an offset of the fault cuts the lining there and spares it far away."""

import unittest

import numpy as np

import references
from programs import SOURCE, ProgramTest

from adit import Run
from adit.cases.longxi import along, section

CASE = SOURCE / "cases" / "longxi"


def lever_of_annulus(ground, lining, inner=5.5, outer=6.0):
    """Moment over thrust [m] of an elastic annulus bonded to ground without end under far shear stress; each has (E, nu).

    Airy's function (A r^2 + B r^4 + C / r^2 + D) cos 2 theta (Michell); of the ground A is the far stress and B = 0.
    """
    def radial(r): return np.array([-2, 0, -6 / r**4, -4 / r**2])
    def shear(r): return np.array([2, 6 * r**2, -6 / r**4, -2 / r**2])
    def hoop(r): return np.array([2, 12 * r**2, 6 / r**4, 0])
    def outward(r, e, nu): return (1 + nu) / e * np.array([-2 * r, -4 * nu * r**3, 2 / r**3, 4 * (1 - nu) / r])
    def around(r, e, nu): return (1 + nu) / e * np.array([2 * r, (6 - 4 * nu) * r**3, 2 / r**3, -2 * (1 - 2 * nu) / r])

    rows = [np.append(f(inner), (0, 0)) for f in (radial, shear)]
    far = [0, 0]
    for of_lining, of_ground in ((radial(outer), radial(outer)), (shear(outer), shear(outer)),
                                 (outward(outer, *lining), outward(outer, *ground)), (around(outer, *lining), around(outer, *ground))):
        rows.append(np.append(of_lining, -of_ground[2:]))
        far.append(of_ground[0])
    constants = np.linalg.solve(rows, far)[:4]
    r = np.linspace(inner, outer, 2001)
    stress = np.array([hoop(x) @ constants for x in r])
    return np.trapz(stress * (r - (inner + outer) / 2), r) / np.trapz(stress, r)


class Longxi(ProgramTest):
    def test_the_lining_is_cut_at_the_fault_and_intact_four_diameters_away(self):
        run = Run(references.run_reduced(self, "longxi"))
        h = run.histories
        for axis, offset in (("x", 0.25), ("y", 0.433)):  # 0.5 m at 60 degrees
            self.assertAlmostEqual(h[f"hanging_wall_u{axis}_m"][-1] - h[f"footwall_u{axis}_m"][-1], offset, delta=0.05)
        lining = along.Lining(run)
        distance, share = lining.damage()
        self.assertGreater(share[abs(distance) < along.STRETCH].min(), 0.5)
        self.assertLess(lining.farthest_crack(), 4 * along.DIAMETER)
        by_diameter = [along.mean_within((abs(distance), share), k * along.DIAMETER, (k + 1) * along.DIAMETER) for k in range(4)]
        self.assertEqual(by_diameter, sorted(by_diameter, reverse=True))
        self.assertEqual(lining.bonds()[1].sum(), sum(group in ("crown", "invert") for group in self.groups_of_cracks(run)))
        self.assertIn(along.Lining(run).name, "\n".join(along.table([lining])))
        along.picture([lining]).savefig(self.folder / "picture.png")

    def test_forces_in_a_lining_of_zones_are_those_of_an_elastic_annulus(self):
        zones = Run(self.run_scene(CASE / "elastic" / "zones.yaml", "--set", "time.duration=0.35 s"))
        angle, thrust, moment = section.of_zones(zones, 0.347)
        lever = section.second_harmonic(angle, moment) / section.second_harmonic(angle, thrust)
        self.assertAlmostEqual(lever / abs(lever_of_annulus((8e9, 0.25), (28e9, 0.2))), 1, delta=0.03)

    def groups_of_cracks(self, run):
        return [line.split(",")[9] for line in (run.folder / "cracks.csv").read_text().splitlines()[1:]]


if __name__ == "__main__":
    unittest.main()
