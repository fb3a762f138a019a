"""adit conformance passes our servers and the templates, and keeps what participants print apart from its table."""

import shlex
import subprocess
import unittest

from programs import ADIT, BUILD, SOURCE

from adit.conformance import CHECKS, states, statics  # noqa: E402

PYTHON = "/usr/bin/python3"
NO_TEMPLATE = [check.__name__.replace("_", " ") for check in (*statics.CHECKS, *states.CHECKS)]


TALKS = f"""
import runpy, sys
sys.path.insert(0, "{SOURCE}/adapters/python")
import wire
def greet(*given, greet=wire.Link.greet):
    print("much " * 50000, flush=True)
    print("a warning", file=sys.stderr)
    greet(*given)
wire.Link.greet = greet
runpy.run_path(sys.argv.pop(1), run_name="__main__")
"""


def conformance(option, command, *arguments):
    return subprocess.run([*ADIT, "conformance", option, command, *arguments], capture_output=True, text=True)


class Conformance(unittest.TestCase):
    def assert_conforms(self, option, command, not_computed):
        done = conformance(option, command)
        self.assertEqual(done.returncode, 0, done.stdout)
        lines = [line for line in done.stdout.splitlines() if not line.startswith(" ")]
        self.assertEqual(len(lines), len(CHECKS))
        self.assertEqual([line[:24].strip() for line in lines if line[24] == "-"], not_computed)

    def test_fdm_server(self):
        self.assert_conforms("--fdm", f"{BUILD}/fdm_server/fdm_server --log-level off", ["strongest"])

    def test_dem_server(self):
        self.assert_conforms("--dem", f"{BUILD}/dem_server/dem_server --log-level off", ["rigid rotation"])

    def test_the_continuum_template(self):
        self.assert_conforms("--fdm", f"{PYTHON} {SOURCE}/adapters/python/continuum.py", ["strongest", *NO_TEMPLATE])

    def test_the_particle_template(self):
        self.assert_conforms("--dem", f"{PYTHON} {SOURCE}/adapters/python/particles.py", ["operator rows", "rigid rotation", *NO_TEMPLATE])

    def test_what_a_participant_prints_is_no_part_of_the_table(self):
        done = conformance("--fdm", shlex.join([PYTHON, "-c", TALKS, f"{SOURCE}/adapters/python/continuum.py"]), "--only", "energy ledger")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual([line[24:26] for line in done.stdout.splitlines()], ["ok"])

    def test_what_a_participant_printed_is_shown_where_a_check_failed(self):
        broken = f"exec {PYTHON} {SOURCE}/tests/integration/peers/broken_template.py mass"
        done = conformance("--fdm", shlex.join(["sh", "-c", f"echo a warning >&2; {broken}"]), "--only", "mass")
        self.assertEqual(done.returncode, 1, done.stdout)
        table, _, printed = done.stdout.partition("\nThe participant printed:\n")
        self.assertIn("a warning\n", printed)
        self.assertNotIn("a warning", table)

    def test_a_command_that_does_not_listen(self):
        done = conformance("--fdm", "sh -c 'echo no such library >&2'")
        self.assertEqual(done.returncode, 1)
        self.assertIn("ended before it printed `listening on HOST:PORT`\nno such library", done.stderr)


if __name__ == "__main__":
    unittest.main()
