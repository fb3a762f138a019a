"""The Python templates compute what our servers compute, refuse what they do not compute, and know whom to serve."""

import socket
import unittest

import guide
from link import wire_pb2
from programs import CASE, SOURCE, Listening, ProgramTest, Server, coupler, cracks
from trusted import TrustTest
from wire import Gone, Link

# Both sides' arithmetic differs in its order only; a thousand steps make some hundred roundings of it.
TOLERANCE = 1e-9
SHORT = ("--set", "time.duration=12 ms", "--set", "output.field_times=[6 ms]")
BEAM = CASE / "variants/coupled_52x6.yaml"

SHAKEN_GROUND = """
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 10 ms}
continuum:
  block: {x_min: -1 m, x_max: 3 m, y_min: 0 m, y_max: 1 m, zones_x: 9, zones_y: 3}
  edge_loads: [{where: {y_min: 1 m, x_min: 0 m}, force: {x: 1 MN, y: -2 MN}, time: {table: {time: [0 s, 3 ms], value: [1, 0]}}}]
  body_loads: [{where: {x_max: 2 m}, acceleration: {y: -9.81 m/s^2}}]
  motions: [{where: {y_max: 0 m}, velocity: {x: 1 m/s, y: 0.3 m/s}, time: {sine: {frequency: 200 Hz, phase: 1}}}]
  histories:
    - {name: top, quantity: displacement_x, at: {x: 0.3 m, y: 1 m}}
    - {name: base, quantity: velocity_y, at: {x: 1.7 m, y: 0.2 m}}
"""

SHAKEN_PARTICLES = """
plane: plane_stress
material: {young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 10 ms}
particles:
  packing: {x_min: 0 m, x_max: 3 m, y_min: 0 m, y_max: 1 m, radius: 5 cm}
  bonds: {tensile_strength: 3 MN, shear_strength: 4 MN, normal_stiffness: 30 GN/m, shear_stiffness: 12 GN/m}
  loads: [{where: {x_max: 0.1 m}, force: {x: 1 MN, y: 4 MN}, time: {constant: 0.7}}]
  body_loads: [{acceleration: {y: -9.81 m/s^2}}]
  motions: [{where: {x_min: 2.9 m}, velocity: {x: 0.2 m/s, y: -0.3 m/s}, spin: 0.1, time: {sine: {frequency: 200 Hz, phase: 1}}}]
  histories:
    - {name: tip, quantity: displacement_y, at: {x: 0 m, y: 0.5 m}}
    - {name: middle, quantity: velocity_x, at: {x: 1.5 m, y: 0.5 m}}
"""


def template(name, *options):
    return Listening(["/usr/bin/python3", SOURCE / f"adapters/python/{name}.py", *options])


class TemplatesComputeAsOurServers(ProgramTest):
    def compare(self, scene, *arguments, fdm=False, dem=False):
        own = self.run_scene(scene, *arguments, out="own")
        addresses = []
        for wanted, option, name in ((fdm, "--fdm", "continuum"), (dem, "--dem", "particles")):
            if wanted:
                other = template(name)
                self.addCleanup(other.end)
                addresses += [option, other.address]
        run = self.run_scene(scene, *addresses, *arguments, out="template")
        self.assert_same_histories(own, run, TOLERANCE)
        return own, run

    def assert_same_cracks(self, own, run):
        self.assertGreater(len(cracks(own)), 2)
        self.assertEqual(cracks(own), cracks(run))

    def test_continuum_in_the_coupled_cantilever(self):
        _, run = self.compare(BEAM, *SHORT, fdm=True)
        self.assertTrue((run / "fields/grid_00000480.vtu").is_file())

    def test_continuum_with_an_overlap_across_its_zones_and_substeps(self):
        self.compare(BEAM, *SHORT, "--set", "interface.overlap.particles_begin.x=4.2 m", "--set", "time.substeps=2", fdm=True)

    def test_particles_in_the_coupled_cantilever_with_the_split_solve(self):
        self.compare(BEAM, *SHORT, "--set", "interface.solve=split", dem=True)

    def test_both_until_the_beam_is_cracked(self):
        own, run = self.compare(BEAM, *SHORT, "--set", "particles.bonds.tensile_strength=4 MN", fdm=True, dem=True)
        self.assert_same_cracks(own, run)

    def test_continuum_alone_under_loads_and_motions(self):
        _, run = self.compare(self.scene(SHAKEN_GROUND), fdm=True)
        self.assertLess(self.summary(run)["max_energy_drift"], 1e-9)

    def test_particles_alone_under_loads_and_motions(self):
        own, run = self.compare(self.scene(SHAKEN_PARTICLES), dem=True)
        self.assert_same_cracks(own, run)


class TemplatesRefuseWhatTheyDoNotCompute(ProgramTest):
    """Otherwise a user would get another model's results, and exit code 0."""

    def assert_refused(self, name, scene, path):
        with template(name) as other:
            option = "--fdm" if name == "continuum" else "--dem"
            result = coupler("run", scene, option, other.address, "--out", self.folder / "run")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn(path, result.stderr)
            self.assertIn(f"is not computed by numpy_{name}; leave it out", result.stderr)
            self.assertFalse((self.folder / "run" / "histories.csv").exists())

    def test_a_law_beyond_elasticity(self):
        strong = SHAKEN_GROUND.replace("kg/m^3}", "kg/m^3, mohr_coulomb: {cohesion: 1 MPa, friction_angle: 0.5}}")
        self.assert_refused("continuum", self.scene(strong), "material.mohr_coulomb")

    def test_a_boundary(self):
        self.assert_refused("continuum", self.scene(SHAKEN_GROUND + "  quiet: [{where: {x_max: -1 m}}]\n"), "continuum.quiet")

    def test_statics(self):
        self.assert_refused("particles", self.scene(SHAKEN_PARTICLES + "statics: {}\n"), "statics")

    def test_friction(self):
        self.assert_refused("particles", self.scene(SHAKEN_PARTICLES + "  contacts: {friction: 0.5}\n"), "particles.contacts")

    def test_a_circle_in_an_area(self):
        circle = SHAKEN_GROUND.replace("where: {y_max: 0 m}", "where: {circle: {centre: {x: 1, y: 0}, radius: 1}}")
        self.assert_refused("continuum", self.scene(circle), "continuum.motions[0].where.circle")


class TemplatesKnowWhomToServe(TrustTest):
    def run_by(self, other, *options):
        return coupler("run", self.scene(SHAKEN_GROUND), "--out", self.folder / "run", "--fdm", other.address, *options)

    def test_who_knows_the_secret(self):
        secret = self.secret()
        with template("continuum", "--secret-file", secret) as other:
            self.assert_refused(self.run_by(other), "serves only clients that know its secret")
            self.assert_refused(self.run_by(other, "--secret-file", self.secret("other")), "its secret is another one")
            result = self.run_by(other, "--secret-file", secret)
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_who_has_a_certificate_of_the_authority(self):
        folder, other = self.certificates(), self.certificates("theirs")
        with template("continuum", "--tls", folder / "localhost") as server:
            self.assert_refused(self.run_by(server, "--tls", other / "laptop"), "was signed by another authority")
            self.assertNotEqual(self.run_by(server).returncode, 0)
            result = self.run_by(server, "--tls", folder / "laptop")
            self.assertEqual(result.returncode, 0, result.stderr)

    def test_their_proofs_are_those_of_our_servers(self):
        """A client in Python is served by our server, and believes no other."""
        path = self.secret()
        secret = path.read_bytes().strip()

        def greet(server, secret):
            with socket.create_connection(("127.0.0.1", int(server.address.rpartition(":")[2]))) as connected:
                link = Link(connected)
                link.greet("probe", secret=secret, end=b"client")
                link.send(wire_pb2.Frame(setup=wire_pb2.Setup(run_id="probe")))
                return link.next_answer()

        with Server("fdm_server", "127.0.0.1:0", "--secret-file", path) as server:
            self.assertEqual(greet(server, secret).error.kind, wire_pb2.Error.SCENE)  # an empty scene, of a client it knows
            with self.assertRaisesRegex(Gone, "its secret is another one"):
                greet(server, b"x" * 64)
        with Server("fdm_server") as server, self.assertRaisesRegex(Gone, "has no secret"):
            greet(server, secret)


class TheGuide(unittest.TestCase):
    def test_the_code_that_it_shows_is_that_of_the_templates(self):
        templates = "".join(path.read_text() for path in sorted((SOURCE / "adapters/python").glob("*.py")))
        shown = [content for language, content in guide.blocks((SOURCE / "docs/your_code.md").read_text()) if language == "python"]
        self.assertGreater(len(shown), 5)
        for content in shown:
            self.assertIn(content, templates)


if __name__ == "__main__":
    unittest.main()
