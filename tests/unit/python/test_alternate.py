"""Other codes beside ours (tools/bench NAME --peers): speeds are taken in turn, and a ratio is that of one turn."""

import os
import unittest


from benchmarks.peers import alternate


class Turns(unittest.TestCase):
    def setUp(self):
        self.said = []

    def code(self, name, speeds):
        """A code that has these speeds, one a turn."""
        left = iter(speeds)

        def speed():
            self.said.append((name, len(os.sched_getaffinity(0))))
            return next(left)
        return speed

    def compared(self, ours, peers):
        return alternate.compare(alternate.Pair("beam", 10, "bond-steps/s", "lattice engine", self.code("ours", ours),
                                                "other", self.code("theirs", peers)))

    def test_both_take_turns_on_one_core(self):
        before = os.sched_getaffinity(0)
        self.compared([1] * alternate.ROUNDS, [1] * alternate.ROUNDS)
        self.assertEqual(self.said, [("ours", 1), ("theirs", 1)] * alternate.ROUNDS)
        self.assertEqual(os.sched_getaffinity(0), before)

    def test_a_ratio_is_that_of_one_turn(self):
        # A machine that is ten times slower in some turns: the ratio of the medians would be 20.
        compared = self.compared([40e6, 4e6, 40e6, 40e6, 4e6], [20e6, 2e6, 2e6, 2e6, 2e6])
        self.assertEqual(compared.ratios, [2, 2, 20, 20, 2])
        ratio = alternate.records(compared)[-1]
        self.assertEqual((ratio["value"], ratio["unit"]), (2, "1"))
        self.assertEqual(alternate.row(compared), "| beam | 10 | lattice engine | 40 | other | 2 | 2 (2 to 20) |")


if __name__ == "__main__":
    unittest.main()
