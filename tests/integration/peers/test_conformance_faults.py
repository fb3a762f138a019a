"""Each line of adit conformance finds the fault that it is for: a participant with just this fault fails it."""

import unittest

from peers import broken_road
from programs import SOURCE, Server

from adit.conformance import CHECKS
from adit.conformance.client import Failure, Gone, Participant

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
