"""Keeps count of the numbers of a run that a test has compared with what they must be, so that none is left out."""

import numpy as np

# Keys of every summary that say where a run comes from or what it cost on this machine.
ORIGIN = {"case", "scene", "scene_hash", "versions", "started", "command", "folder", "revision", "inputs", "notes", "warnings"}
COST = {"wall_s", "steps_per_s", "coupler_cpu_s", "coupler_wait_s", "coupler_solve_s"} | {
    f"{side}_{what}_s" for side in ("continuum", "particles") for what in ("cpu", "compute", "hidden")}


class Told:
    """The numbers of one table, summary or piece; `left` are those that nothing was compared with yet."""

    def __init__(self, test, what, numbers, free=()):
        self.test, self.what, self.numbers = test, what, numbers
        self.left = set(numbers) - set(free)

    def equal(self, expected, tolerance=1e-9, size=None):
        """Each of {name: values}, to a share of `size`, or of the largest expected value."""
        for name, values in expected.items():
            self.test.assertIn(name, self.numbers, self.what)
            found = self.numbers[name]
            if values is None or isinstance(values, (str, dict)):
                self.test.assertEqual(found, values, f"{self.what}: {name}")
            else:
                scale = size or np.max(np.abs(values)) or 1e-3
                np.testing.assert_allclose(np.asarray(found, float), values, rtol=0, atol=tolerance * scale, err_msg=f"{self.what}: {name}")
            self.left.discard(name)

    def all_told(self):
        """Fails for a number that was not compared: whoever adds one says here what it must be."""
        self.test.assertEqual(self.left, set(), f"{self.what}: compare these numbers with what they must be, too")
