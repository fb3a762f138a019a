"""scripts/conformance passes our servers and the templates."""

import subprocess
import sys
import unittest

from programs import BUILD, SOURCE

sys.path.insert(0, str(SOURCE / "scripts"))
from adit_conformance import CHECKS, states, statics  # noqa: E402

PYTHON = "/usr/bin/python3"
NO_TEMPLATE = [check.__name__.replace("_", " ") for check in (*statics.CHECKS, *states.CHECKS)]


class Conformance(unittest.TestCase):
    def assert_conforms(self, option, command, not_computed):
        done = subprocess.run([PYTHON, SOURCE / "scripts/conformance", option, command], capture_output=True, text=True)
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


if __name__ == "__main__":
    unittest.main()
