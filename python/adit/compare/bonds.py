"""Force chains and bonds of several runs at the same instant, side by side: Figs 8 and 9 of the paper."""
import numpy as np

from adit import Unusable
from adit.plots import crack_pictures, model_pictures


def common_instants(runs):
    """[(time [s], [the number of the instant in each run])] of the instants that all runs have."""
    found = []
    for time, _ in runs[0].instants:
        try:
            found.append((time, [run.instant_at(time) for run in runs]))
        except Unusable:  # one of them has none there
            pass
    return found


def with_bonds(runs):
    """The runs that have particles, and wrote fields."""
    return [run for run in runs if any("bonds" in name for _, files in run.instants[-1:] for name in files)]


def side_by_side(runs, numbers):
    """{"force_chains", "bonds", "cracks": [a drawing for each run that has them]} at the instants of these numbers; nothing if a file is
    damaged. All have one scale of widths and one of lengths, so that they can be compared."""
    pieces = [run.pieces_at(number) for run, number in zip(runs, numbers)]
    if not all("bonds" in each for each in pieces):
        return {}
    found = np.array([model_pictures.close_up(each) for each in pieces])
    bounds = found[:, 0].min(), found[:, 1].max(), found[:, 2].min(), found[:, 3].max()
    largest = max(np.nanmax(np.abs(each["bonds"]["normal_force_N"]), initial=0) for each in pieces)
    models = [(run, run.instants[number][0], each) for run, number, each in zip(runs, numbers, pieces)]
    drawn = {"force_chains": [model_pictures.force_chains(*each, bounds, largest or None) for each in models],
             "bonds": [model_pictures.bonds(*each, bounds) for each in models],
             "cracks": [crack_pictures.cracks(*each, bounds) for each in models]}
    return {view: shown for view, several in drawn.items() if (shown := [each for each in several if each])}
