"""Packings in whole runs: the summary describes them, and particles can be read from tables and from results."""

import unittest

from programs import ProgramTest, coupler

SCENE = """\
material: {{young_modulus: 10 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}}
time: {{duration: 1 ms}}
particles: {{{particles}}}
"""
TABLE = "x_m,y_m,radius_m,group\n0,0,0.5,1\n1,0,0.5,2\n0.5,0.9,0.5,2\n"


class Packings(ProgramTest):
    def scene_of(self, particles):
        return self.scene(SCENE.format(particles=particles))

    def refusal(self, particles):
        result = coupler("run", self.scene_of(particles), "--out", self.folder / "run")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assert_one_line(result.stderr)
        return result.stderr

    def test_a_random_packing_is_stated(self):
        scene = self.scene_of("random_packing: {x_min: 0, x_max: 2 m, y_min: 0, y_max: 1 m, radius_min: 3 cm, "
                              "radius_max: 5 cm, stress: 1 MPa}")
        result = coupler("run", scene, "--out", self.folder / "run")
        self.assertEqual(result.returncode, 0, result.stderr)
        note = self.summary(self.folder / "run")["notes"][0]
        self.assertIn("note               " + note, result.stdout)
        for words in ("porosity 0.1", "(1e+06 Pa wanted)", "contacts a particle", "floaters taken away"):
            self.assertIn(words, note)

    def test_a_table_lies_beside_the_scene_and_results_can_be_placed_again(self):
        (self.folder / "discs.csv").write_text(TABLE)
        first = self.run_scene(self.scene_of("placed: {path: discs.csv}, contacts: {}"))
        self.assertEqual(self.summary(first)["particles"], 3)
        written = next((first / "fields").glob("particles_*.vtp"))
        (self.folder / "again.vtp").write_bytes(written.read_bytes())
        again = self.run_scene(self.scene_of("placed: {path: again.vtp}, bonds: {}"))
        self.assertEqual(self.summary(again)["particles"], 3)
        self.assertEqual(self.summary(again)["bonds"], 1)

    def test_a_table_that_cannot_be_read(self):
        (self.folder / "discs.csv").write_text(TABLE + "5,5,none,1\n")
        message = self.refusal("placed: {path: discs.csv}")
        self.assertIn(":3:", message)
        self.assertIn("particles.placed.path: line 5: `none` is not a number", message)
        self.assertIn("there is no such file", self.refusal("placed: {path: disks.csv}"))

    def test_a_group_that_is_misspelt(self):
        message = self.refusal("square_packing: {x_min: 0, x_max: 4, y_min: 0, y_max: 2, radius: 0.5}, "
                               "groups: [{name: gouge, where: {x_max: 2}}], between: [{first: gauge, second: particles}]")
        self.assertIn("particles.between[0].first: `gauge` is no group", message)
        self.assertIn("did you mean `gouge`?", message)


if __name__ == "__main__":
    unittest.main()
