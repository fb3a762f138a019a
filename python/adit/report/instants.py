"""The model at chosen instants behind a slider: displacement, force chains, cracks, yield, stress, forces of linings."""
from typing import NamedTuple

from adit.plots import colour_pictures, crack_pictures, lining_pictures, model_pictures, style
from adit.plots.cores import on_all_cores
from adit.plots.deformation import largest_factor, scale_of_run
from adit.plots.instants import MOST, spread
from adit.report import pictures
from adit.report.markup import Markup, section, tag

VIEWS = (colour_pictures.displacement, model_pictures.force_chains, model_pictures.bonds, crack_pictures.cracks, lining_pictures.lining_forces,
         lining_pictures.member_forces, lining_pictures.lining_joints, lining_pictures.interfaces,
         colour_pictures.principal_stress, colour_pictures.yield_state, colour_pictures.pore_pressure,
         colour_pictures.pressure_ratio)  # beside the deformed model


class Instant(NamedTuple):
    time: float  # [s]
    views: list  # pictures of the page
    calm: float  # the least is open at first


def drawn(results):
    """The Instants that are drawn, at most MOST, and the pictures of the peaks over time."""
    numbers = spread(range(len(results.instants)), MOST, results.last_pieces.values())
    read = {n: results.pieces_at(n) for n in numbers}
    found = [(results.instants[n][0], pieces) for n, pieces in read.items() if pieces]
    scale = scale_of_run(results, read)
    views = on_all_cores(lambda n: _views(results, *found[n], scale), len(found))
    peak = results.number("peak_bond_force_time_s")  # else the largest deformation counts
    shown = [Instant(time, each, largest_factor(pieces) if peak is None else abs(time - peak))
             for (time, pieces), each in zip(found, views)]
    return shown, _peaks(results, *found[-1]) if found else None


def chapter(title, shown, there, most, peaks=None):
    """At most so many of the Instants behind a slider; `there`: their number in the run. None if nothing is drawn."""
    if not any(each.views for each in shown):
        return None
    shown = spread(shown, most)
    first = min(range(len(shown)), key=lambda i: shown[i].calm)
    return section("instants", title, _note(len(shown), there), _slider(shown, first),
                   [_instant(each, i == first) for i, each in enumerate(shown)], peaks)


def _views(results, time, pieces, scale):
    drawings = [model_pictures.deformed(results, time, pieces, scale), *(view(results, time, pieces) for view in VIEWS)]
    return [pictures.figure(each) for each in drawings if each]


def _note(shown, all_of_them):
    if shown == all_of_them:
        return None
    return tag("p", f"{shown} of {all_of_them} instants are shown, so that this page stays small and is soon drawn; fields/ "
                    "holds all of them.", class_="note")


def _slider(shown, first):
    """Moved by a few lines of JavaScript; without it the instants open and close by themselves."""
    if len(shown) < 2:
        return None
    times = ";".join(style.instant(each.time) for each in shown)
    moved = Markup(f'<input type="range" id="instant" min="0" max="{len(shown) - 1}" value="{first}" data-times="{times}">')
    told = tag("output", f"t = {style.instant(shown[first].time)}", for_="instant")
    return tag("p", tag("label", "Instant", for_="instant"), " ", moved, " ", told, class_="slider", hidden=True)


def _instant(instant, is_open):
    return tag("details", tag("summary", f"t = {style.instant(instant.time)}"), instant.views, class_="instant", open=is_open)


def _peaks(results, time, pieces):
    if time == 0:  # a run that failed early has no peaks yet
        return None
    found = [pictures.figure(drawing) for _, drawing in colour_pictures.peaks(results, time, pieces)]
    return [tag("h3", "Peaks over time"), found] if found else None
