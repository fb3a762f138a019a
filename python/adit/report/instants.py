"""The model at chosen instants behind a slider: displacement, force chains, cracks, yield, stress, forces of linings."""
import numpy as np

from adit.plots import colour_pictures, lining_pictures, model_pictures, style
from adit.plots.cores import on_all_cores
from adit.plots.deformation import scale_of
from adit.plots.instants import MOST, spread
from adit.report import pictures
from adit.report.markup import Markup, section, tag

VIEWS = (colour_pictures.displacement, model_pictures.force_chains, model_pictures.bonds, lining_pictures.lining_forces,
         colour_pictures.principal_stress, colour_pictures.yield_state)  # beside the deformed model


def chapter(results, most=MOST):
    if not results.instants:
        return None
    numbers = spread(range(len(results.instants)), most, results.last_pieces.values())
    found = [(results.instants[n][0], results.pieces_at(n)) for n in numbers]
    found = [(time, pieces) for time, pieces in found if pieces]
    scale = min((scale_of(pieces) for _, pieces in found), default=1)
    views = on_all_cores(lambda n: _views(results, *found[n], scale), len(found))
    shown = [(time, each) for (time, _), each in zip(found, views)]
    if not any(views for _, views in shown):
        return None
    return section("instants", "The model at chosen instants",
                   behind_a_slider(shown, _first(results, found), len(results.instants)), _peaks(results, found[-1]))


def behind_a_slider(shown, first, of):
    """[(time, pictures)], of which the one of number `first` is open; `of`: how many instants there are."""
    return _note(len(shown), of), _slider(shown, first), [_instant(*one, i == first) for i, one in enumerate(shown)]


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
    return int(np.argmin([scale_of(pieces) for _, pieces in found]))


def _instant(time, views, is_open):
    return tag("details", tag("summary", f"t = {style.instant(time)}"), views, class_="instant", open=is_open)


def _peaks(results, last):
    if last[0] == 0:  # a run that failed early has no peaks yet
        return None
    drawn = [pictures.figure(figure, of_model=True) for _, figure in colour_pictures.peaks(results, *last)]
    return [tag("h3", "Peaks over time"), drawn] if drawn else None
