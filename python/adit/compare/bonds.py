"""Force chains and bonds of several runs at the same instant, side by side: Figs 8 and 9 of the paper."""
import numpy as np

from adit import Unusable
from adit.plots import model_pictures


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


def force_chains(runs, instants):
    """A figure for each run; all have one scale of widths and one of lengths, so that they can be compared."""
    pieces, bounds = _alike(runs, instants)
    largest = max((np.nanmax(np.abs(each["bonds"]["normal_force_N"]), initial=0) for each in pieces), default=0)
    for run, number, each in zip(runs, instants, pieces):
        yield model_pictures.force_chains(run, run.instants[number][0], each, bounds, largest or None)


def bonds(runs, instants):
    """A figure for each run, intact bonds and cracks."""
    pieces, bounds = _alike(runs, instants)
    for run, number, each in zip(runs, instants, pieces):
        yield model_pictures.bonds(run, run.instants[number][0], each, bounds)


def _alike(runs, instants):
    """The pieces of each run, and bounds that hold what each would show; nothing if a file is damaged."""
    pieces = [run.pieces_at(number) for run, number in zip(runs, instants)]
    if not all("bonds" in each for each in pieces):
        return [], None
    found = np.array([model_pictures.close_up(each) for each in pieces])
    return pieces, (found[:, 0].min(), found[:, 1].max(), found[:, 2].min(), found[:, 3].max())
