"""Each line of scripts/conformance finds the fault that it is for: a participant with just this fault fails it."""

import sys
import unittest

from peers import broken_road
from programs import SOURCE, Server

sys.path.insert(0, str(SOURCE / "scripts"))
from adit_conformance import CHECKS  # noqa: E402
from adit_conformance.client import Failure, Gone, Participant  # noqa: E402

BROKEN = SOURCE / "tests/integration/peers/broken_template.py"


class Faults(unittest.TestCase):
    def test_every_line_finds_the_fault_that_it_is_for(self):
        with Server("fdm_server") as server:
            for check in CHECKS:
                name = check.__name__
                if name in broken_road.FAULTS:
                    broken = Participant("continuum", broken_road.broken(server, name))
                else:
                    role = "particles" if name == "strongest" else "continuum"
                    broken = Participant(role, f"/usr/bin/python3 {BROKEN} {name}")
                with self.subTest(name):
                    with self.assertRaises((Failure, Gone, OSError)) as found:
                        check(broken)
                    print(f"{name}: {found.exception}")
                broken.stop()


if __name__ == "__main__":
    unittest.main()
