"""A connection that is cut, before a frame or within it, by closing or by a reset, ends the run at once: exit code 3, the server
named, what was written whole. The server serves the next run."""

import unittest

from faults.faulty import SCENE, SHORT, FaultTest, at
from foreign import Cut
from programs import PATIENCE, coupler

# Of each: which server, which way, the share of the frame that arrives, whether the connection is reset.
CUTS = (("fdm", "requests", 0, False), ("dem", "requests", 0.5, True), ("fdm", "answers", 0.5, False), ("dem", "answers", 0, True))


def cut(kind, share, reset):
    def replace(data):
        yield data[:int(share * len(data))]
        raise Cut(reset)

    return at(kind, 5 if kind in ("advance", "predicted") else 1, replace)


class Cuts(FaultTest):
    @classmethod
    def setUpClass(cls):
        cls.serve()

    def assert_cut(self, request, answer, has_results=False, command=None):
        for which, way, share, reset in CUTS:
            kind = request if way == "requests" else answer
            with self.subTest(f"{which}: {share} of {kind}, {'reset' if reset else 'closed'}"):
                address, done, seconds = self.run_by(which, command=command, **{way: cut(kind, share, reset)})
                self.assert_lost(which, address, done)
                self.assertRegex(done.stderr, "closed the connection|the connection broke")
                self.assertLess(seconds, 10 * PATIENCE)
                self.assertEqual((self.folder / "run/summary.json").exists(), has_results)
                if has_results:
                    self.assert_unfinished(f"{which}_server at {address}")
                self.assert_serves(which)

    def test_cut_in_the_preamble(self):
        self.assert_cut("preamble", "preamble")

    def test_cut_in_hello(self):
        self.assert_cut("hello", "hello")

    def test_cut_in_setup(self):
        self.assert_cut("setup", "model")

    def test_cut_in_weights(self):
        self.assert_cut("weights", "interface")

    def test_cut_in_couple(self):
        self.assert_cut("couple", "operator")

    def test_cut_in_a_step(self):
        self.assert_cut("advance", "predicted", has_results=True)

    def test_cut_in_a_snapshot(self):
        self.assert_cut("snapshot_request", "snapshot", has_results=True)

    def test_cut_in_a_checkpoint(self):
        self.assert_cut("save", "state", has_results=True)

    def test_cut_at_the_end(self):
        self.assert_cut("finish", "bye", has_results=True)

    def test_cut_in_a_restore(self):
        """The results stay those of the run before, which can be resumed again."""
        run = self.run_scene(SCENE, *SHORT)
        before = (run / "histories.csv").read_bytes()
        for which, way, share, reset in CUTS:
            kind = "restore" if way == "requests" else "restored"
            with self.subTest(f"{which}: {share} of {kind}"):
                address, done, _ = self.run_by(which, command=("resume", run), **{way: cut(kind, share, reset)})
                self.assert_lost(which, address, done)
                self.assert_serves(which)
        self.assertEqual(coupler("resume", run).returncode, 0)
        self.assertEqual((run / "histories.csv").read_bytes(), before)


if __name__ == "__main__":
    unittest.main()
