"""What is too large for a machine, or for its numbers, is refused in a sentence, and the server goes on."""

import resource
import unittest

from programs import CASE, ProgramTest, Server, counts_resources, coupler

BAR = """
material: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 1 ms}
"""
PARTICLES = BAR + """particles:
  packing: {x_min: 0 m, x_max: 6 m, y_min: 0 m, y_max: 1 m, radius: 5 cm}
"""
GIB = 1 << 30


class Sizes(ProgramTest):
    def refused(self, scene, *texts):
        result = coupler("check", self.scene(scene))
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assert_one_line(result.stderr)
        for text in texts:
            self.assertIn(text, result.stderr)

    def test_as_many_zones_as_wrap_around_to_none(self):
        box = "{x_min: 0 m, x_max: 6 m, y_min: 0 m, y_max: 1 m"
        self.refused(f"{BAR}continuum:\n  block: {box}, zones_x: 4294967295, zones_y: 4294967295}}\n",
                     "continuum.block: makes 18446744073709551616 grid points")
        self.refused(f"{BAR}continuum:\n  blocks: [{{rectangle: {box}}}, along: {{zones: 4294967295}}, "
                     "across: {zones: 4294967295}}]\n", "continuum.blocks: makes 18446744073709551616 grid points")

    def test_more_groups_than_there_can_be_pairs_of(self):
        groups = "".join(f"    - {{name: g{i}, where: {{x_max: {1 + i} m}}}}\n" for i in range(20000))
        self.refused(PARTICLES + "  groups:\n" + groups, "particles.groups: has 20000 groups; at most 1000")

    def test_a_critical_step_that_is_no_number(self):
        self.refused(PARTICLES + "  bonds: {normal_stiffness: 1.7e308, shear_stiffness: 1.7e308}\n",
                     "particles: have a critical time step of 0 s")

    @counts_resources
    def test_more_threads_than_the_machine_allows(self):
        for program, scene in (("fdm_server", "full_fdm.yaml"), ("dem_server", "full_dem.yaml")):
            with Server(program, "127.0.0.1:0", "--threads", "512") as server:
                resource.prlimit(server.process.pid, resource.RLIMIT_AS, (2 * GIB, 2 * GIB))
                result = coupler("check", CASE / scene, "--" + program[:3], server.address)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn("cannot start 512 threads, only ", result.stderr)
                again = coupler("check", CASE / scene, "--" + program[:3], server.address)
                self.assertEqual(again.returncode, 2, again.stderr)


if __name__ == "__main__":
    unittest.main()
