"""One command computes both sides by other codes, each on two ranks of MPI, and draws the run."""

import shlex
import subprocess
import unittest

from peers import mpi_server, test_lammps
from programs import CASE, SOURCE, ProgramTest, cracks

SERVERS = ("--fdm", shlex.join(mpi_server.served(2)), "--dem", shlex.join(test_lammps.served(2)))


@mpi_server.needed
@unittest.skipUnless(test_lammps.PROGRAM.exists(), "adapters/lammps is left out")
class BothSwapped(ProgramTest):
    def both(self, scene, *arguments):
        out = self.folder / "both"
        done = subprocess.run([SOURCE / "scripts/run", scene, "--no-report", *SERVERS, "--out", out, *arguments], capture_output=True,
                              text=True, timeout=240)
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def test_a_run_until_it_is_cracked(self):
        arguments = ("--set", "particles.bonds.tensile_strength=2 MN", "--set", "time.duration=7 ms", "--set", "output.field_times=[7 ms]")
        ours = self.run_scene(CASE / "variants/coupled_52x6.yaml", *test_lammps.GENERAL, *arguments, out="ours")
        theirs = self.both(CASE / "variants/coupled_52x6.yaml", *test_lammps.GENERAL, *arguments)
        self.assertEqual(cracks(ours), cracks(theirs))
        self.assertGreater(len(cracks(ours)), 2)
        self.assert_same_histories(ours, theirs, test_lammps.TOLERANCE)
        self.assertTrue(list(theirs.glob("pictures/*.png")))


if __name__ == "__main__":
    unittest.main()
