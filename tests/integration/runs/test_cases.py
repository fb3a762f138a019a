"""The large scenes of the cases of tunnels can be computed as they are (nightly). By day they are read (test_tunnels.py), and coarser ones
of most of these cases are computed (references.py)."""

import unittest

from programs import SOURCE, ProgramTest, coupler

CASES = SOURCE / "cases"
LONGXI = CASES / "longxi"
LARGE = [*sorted(LONGXI.glob("*.yaml")), *sorted(LONGXI.glob("variants/*.yaml")), LONGXI / "elastic" / "particles.yaml",
         *(CASES / scene for scene in ("shield_ring/ring.yaml", "fault_section/fault.yaml", "cavern/crown_invert.yaml",
                                       "qingcaosha/section.yaml"))]


class Cases(ProgramTest):
    def test_the_large_scenes_can_be_computed(self):
        for scene in LARGE:
            with self.subTest(scene.relative_to(CASES)):
                result = coupler("check", scene)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn("can be computed", result.stdout)


if __name__ == "__main__":
    unittest.main()
