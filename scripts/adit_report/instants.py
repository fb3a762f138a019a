"""The model at chosen instants behind a slider: displacement, force chains, cracks, yield, stress, forces of linings."""
import numpy as np

from adit_plots import colour_pictures, lining_pictures, model_pictures, style
from adit_report import pictures
from adit_report.markup import Markup, section, tag

VIEWS = (model_pictures.force_chains, model_pictures.bonds, lining_pictures.lining_forces, colour_pictures.principal_stress,
         colour_pictures.yield_state)  # beside the deformed model
MOST = 8  # instants
FEW = 3  # instants of a model so large that they hold more than MOST_CELLS zones, particles and bonds: drawing takes time
MOST_CELLS = 800_000


def _spread(items, most, runs):
    """At most `most` of the items, spread evenly, the last among them; fewer for large models."""
    cells = max(1, sum(len(piece.cells) for run in runs for piece in run.last_pieces.values()))
    count = min(most, len(items), max(FEW, MOST_CELLS // cells))
    return [items[k] for k in sorted({round(k) for k in np.linspace(len(items) - 1, 0, count)})]


def chapter(results, most=MOST):
    if not results.instants:
        return None
    numbers = _spread(range(len(results.instants)), most, [results])
    found = [(results.instants[n][0], results.pieces_at(n)) for n in numbers]
    found = [(time, pieces) for time, pieces in found if pieces]
    scale = min((model_pictures.scale_of(pieces) for _, pieces in found), default=1)
    shown = [(time, _views(results, time, pieces, scale)) for time, pieces in found]
    if not any(views for _, views in shown):
        return None
    first = _first(results, found)
    return section("instants", "The model at chosen instants", _note(len(shown), len(results.instants)), _slider(shown, first),
                   [_instant(*one, i == first) for i, one in enumerate(shown)], _peaks(results, found[-1]))


def side_by_side(runs, most=MOST):
    """Force chains and cracks of several runs at the instants that all of those with particles have."""
    runs = [run for run in runs if "bonds" in run.last_pieces]
    if len(runs) < 2:
        return None
    numbers = [[_same(run, time) for run in runs] for time, _ in runs[0].instants]
    common = [each for each in numbers if None not in each]
    shown = [(runs[0].instants[each[0]][0], _compared(runs, each)) for each in _spread(common, most, runs)]
    if not shown:
        return None
    first = _first(runs[0], [(time, runs[0].last_pieces) for time, _ in shown])
    return section("instants", "Force chains and cracks at chosen instants", _note(len(shown), len(common)),
                   _slider(shown, first), [_instant(*one, i == first) for i, one in enumerate(shown)])


def _same(run, time):
    """The number of the instant of this time, steps of runs being of different length; nothing if it has none."""
    near = run.number("dt_s") or 0
    return next((n for n, (other, _) in enumerate(run.instants) if abs(other - time) <= near), None)


def _compared(runs, numbers):
    pieces = [run.pieces_at(number) for run, number in zip(runs, numbers)]
    return [pictures.figure(view(run, run.instants[number][0], each), of_model=True, of_run=run.name)
            for view in (model_pictures.force_chains, model_pictures.bonds) for run, number, each in zip(runs, numbers, pieces)]


def _views(results, time, pieces, scale):
    drawn = [model_pictures.deformed(results, time, pieces, scale), *(view(results, time, pieces) for view in VIEWS)]
    return [pictures.figure(each, of_model=True) for each in drawn if each is not None]


def _note(shown, all_of_them):
    if shown == all_of_them:
        return None
    return tag("p", f"{shown} of {all_of_them} instants are shown, so that this page stays small and is soon drawn; fields/ "
                    "holds all of them.", class_="note")


def _slider(shown, first):
    """Moved by a few lines of JavaScript; without it the instants open and close by themselves."""
    if len(shown) < 2:
        return None
    times = ";".join(style.instant(time) for time, _ in shown)
    moved = Markup(f'<input type="range" id="instant" min="0" max="{len(shown) - 1}" value="{first}" data-times="{times}">')
    told = tag("output", f"t = {style.instant(shown[first][0])}", for_="instant")
    return tag("p", tag("label", "Instant", for_="instant"), " ", moved, " ", told, class_="slider", hidden=True)


def _first(results, found):
    """The number of the instant that is open at first: that of the largest bond force, or of the largest displacement."""
    peak = results.number("peak_bond_force_time_s")
    if peak is not None:
        return int(np.argmin([abs(time - peak) for time, _ in found]))
    return int(np.argmin([model_pictures.scale_of(pieces) for _, pieces in found]))


def _instant(time, views, is_open):
    return tag("details", tag("summary", f"t = {style.instant(time)}"), views, class_="instant", open=is_open)


def _peaks(results, last):
    if last[0] == 0:  # a run that failed early has no peaks yet
        return None
    drawn = [pictures.figure(figure, of_model=True) for _, figure in colour_pictures.peaks(results, *last)]
    return [tag("h3", "Peaks over time"), drawn] if drawn else None
