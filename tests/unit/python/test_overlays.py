"""Pictures that compare runs: colours, legends, and curves that can be seen."""

import types
import unittest

import numpy as np

from adit import Table
from adit.compare import overlays
from adit.plots import png, style

from pieces import PictureTest


def run_of(name, *motions, end=2.0, first=0.0):
    """A run with motions, histories over its duration and cracks."""
    time, period = np.linspace(0, end, 201), np.geomspace(0.05, 5, 30)
    wave = np.sin(9 * time + first)
    motion = {"time_s": time, "acceleration_m_per_s2": wave}
    response = {"period_s": period, "psa_5pct_m_per_s2": 1 / period}
    spectra = {each: {"motion": motion, "response": response, "input": motion, "reference": response} for each in motions}
    broken = Table({"time_s": np.array([0.1]), "mode": np.array(["shear"]), "x_m": np.array([1.0]), "y_m": np.array([2.0]),
                    "group": np.array(["lining"])}, "cracks.csv")
    return types.SimpleNamespace(
        name=name, spectra=spectra, histories={"time_s": time, "top_ux_m": wave, "lining_thrust_N": 1e5 * wave}, is_simplified=False,
        table=lambda name: broken, debonded=lambda found: np.zeros(len(found["time_s"]), bool), models=[], last_pieces={},
        number=lambda name: None)


def figures(runs):
    for drawings in overlays.drawn("case", runs).values():
        for name, drawing in drawings.items():
            yield name, png.figure(drawing)


class Overlays(PictureTest):
    def test_a_run_has_one_colour_in_all_pictures(self):
        runs = [run_of("linear", "top", "base"), run_of("still"), run_of("hysteretic", "top")]
        seen = set()
        for name, figure in figures(runs):
            for axes in figure.axes:
                for line in axes.get_lines():
                    owner = [i for i, run in enumerate(runs) if run.name in line.get_label()]
                    if owner:
                        self.assertEqual(line.get_color(), style.of_run(owner[0]), f"{name}: {line.get_label()}")
                        seen.add((name, owner[0]))
        self.assertEqual(seen, {(name, i) for name in ("displacement", "thrust", "cracks") for i in range(3)} | {("motions", 0), ("motions", 2)})

    def test_two_motions_of_a_run_have_lines_of_their_own(self):
        (_, figure), = [each for each in figures([run_of("linear", "top", "base"), run_of("other", "top")]) if each[0] == "motions"]
        styles = {line.get_label(): line.get_linestyle() for line in figure.axes[0].get_lines()}
        self.assertNotEqual(styles["linear, top"], styles["linear, base"])

    def test_a_run_that_is_short_beside_another_is_seen_and_told(self):
        """10 ms beside 2 s are less than a line is wide."""
        runs = [run_of("ovaling", "top", end=0.01, first=1), run_of("shear_wave", "top")]
        for name, figure in figures(runs):
            if name != "cracks":
                line = next(line for line in figure.axes[0].get_lines() if "ovaling, " in line.get_label() and "input" not in line.get_label())
                self.assertIn(", ends at 10 ms", line.get_label())
                self.assertTrue(name == "motions" or line.get_marker() == "x")
        long, _ = overlays.end_of(np.array([0.0, 1.9]), 2)
        self.assertEqual(long, "")

    def test_legends_cover_no_curves(self):
        for name, figure in figures([run_of("linear", "top"), run_of("hysteretic", "top")]):
            figure.canvas.draw()
            for axes in figure.axes:
                if axes.get_legend():
                    self.assertFalse(axes.get_legend().get_window_extent().overlaps(axes.get_window_extent()), name)


if __name__ == "__main__":
    unittest.main()
