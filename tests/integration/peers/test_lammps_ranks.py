"""LAMMPS on one, two and four ranks, and through the conformance kit; takes minutes."""

import subprocess

from peers.test_lammps import BEAM, STRENGTH, LammpsTest, served
from programs import ADIT, CASE


class LammpsOnMoreRanks(LammpsTest):
    def test_both_beams_on_one_two_and_four_ranks(self):
        for beam in (BEAM, CASE / "coupled.yaml"):
            self.assertGreater(self.assert_same(beam, (1, 2, 4), *STRENGTH), 2)

    def test_conformance(self):
        command = [*ADIT, "conformance", "--dem", " ".join(served(2))]
        done = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stdout)
