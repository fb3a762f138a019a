"""Motions in and out: accelerations over time and response spectra in one picture, and their measures."""
from typing import NamedTuple

import numpy as np

from adit.plots import oscillators, spectra_pictures, style, time_pictures
from adit.plots.drawing import Drawing, Panels, legend
from adit.plots.spectra_pictures import GRAVITY
from adit.report import pictures
from adit.report.markup import section, table, tag
from adit.report.quantities import figure

DAMPING = "5pct"  # drawn where it was computed, otherwise the first
MEASURES = (("PGA", "pga_m_per_s2"), ("PGV", "pgv_m_per_s"), ("PGD", "pgd_m"), ("Arias intensity", "arias_m_per_s"),
            ("CAV", "cav_m_per_s"), ("significant duration", "significant_duration_s"),
            ("largest amplification", "largest_amplification"), ("at", "largest_amplification_Hz"))

NOISE = 1e-6  # of the largest displacement, below which a station does not move in this direction
BESIDE = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.03)}  # of a panel: its legend, so that it covers no curve
MOST = 6  # amplifications; pictures/ holds all


class Shown(NamedTuple):
    """A motion of a run in a picture."""
    run: object
    name: str
    said: str  # in a legend
    color: str
    line: str  # style of its line; the motion from which it came is dashed


def chapter(results):
    if results.is_simplified:
        told = (f"Spectra of the stations follow from their displacements, from {oscillators.ROWS} rows of histories.csv to a "
                "period on.")
        drawn = pictures.figure(_of_tunnel(results), tag("p", told, class_="note"))
        return section("motions", "Motions in and out", drawn)
    names = list(results.spectra)
    if not names:
        told = "The scene asks for no spectra (output.spectra), so that motions stand among the histories only."
        return section("motions", "Motions in and out", tag("p", told))
    colors = spectra_pictures.COLORS
    found = [Shown(results, name, name, colors[i % len(colors)], "-") for i, name in enumerate(names)]
    return section("motions", "Motions in and out", pictures.figure(picture("", found)), measures(found), _amplifications(results))


def _amplifications(results):
    found = [drawing for name, drawing in spectra_pictures.motions(results) if name.endswith("_transfer")]
    return [pictures.figure(drawing) for drawing in found[:MOST]]


def _of_tunnel(results):
    """The motion of the scene, below it how the stations of the tunnel move, and the response spectra of both."""
    motion, moved = results.table("motion.csv"), time_pictures.quantities_of(results).get("displacement")
    if not motion or not moved:
        return None
    acceleration, time = motion["acceleration_m_per_s2"], results.histories["time_s"]
    response = oscillators.pseudo_acceleration(acceleration, motion["time_s"][1], oscillators.PERIODS)
    largest = max(np.abs(values).max() for _, values in moved[1])
    stations = [(style.literal(f"out: {time_pictures.said(column)}"), values, oscillators.of_displacement(values, time[1])
                 if len(time) > 2 and np.abs(values).max() > NOISE * largest else None) for column, values in moved[1]]

    def paint(before, after, spectra):
        before.plot(motion["time_s"], acceleration, color=style.BLACK, lw=0.9, label="in: the motion of the scene")
        spectra.plot(oscillators.PERIODS, response / GRAVITY, color=style.BLACK, label="in: the motion of the scene, 5 %")
        for i, (said, values, spectrum) in enumerate(stations):
            round_of, colour = divmod(i, len(spectra_pictures.COLORS))
            look = {"lw": 1, "color": spectra_pictures.COLORS[colour], "ls": time_pictures.LINES[round_of % len(time_pictures.LINES)]}
            after.plot(time, 1e3 * values, label=said, **look)
            if spectrum:
                spectra.plot(spectrum[0], spectrum[1] / GRAVITY, label=f"{said}, 5 %", **look)
        before.set(xlabel="t [s]", ylabel="acceleration [m/s²]", xlim=(time[0], time[-1] or 1))
        after.set(xlabel="t [s]", ylabel="displacement [mm]", xlim=(time[0], time[-1] or 1))
        return _legends(before, after, spectra)

    return Drawing("", "motions in and out", Panels(3, 1, (8.0, 7.2)), paint)


def _legends(*panels):
    """Labels the last panel, of spectra; returns the legends of all."""
    panels[-1].set(xlabel="period [s]", ylabel="pseudo acceleration [g]", xscale="log")
    spectra_pictures.plain_decades(panels[-1])
    return [legend(axes, **BESIDE) for axes in panels]


def measures(found):
    used = [(said, key) for said, key in MEASURES
            if any(each.run.summary.get(f"{each.name}_{key}") is not None for each in found)]
    return table("Measures of the motions, from summary.json", ("motion", *(said for said, _ in used)), [
        (each.said, *(figure(each.run.summary, f"{each.name}_{key}") for _, key in used)) for each in found])


def picture(of, found):
    """Several Shown, over time and as response spectra."""
    end = max(each.run.spectra[each.name]["motion"]["time_s"][-1] for each in found)

    def paint(over_time, spectra):
        for each in found:
            _draw(each, over_time, spectra)
        over_time.set(xlabel="t [s]", ylabel="acceleration [m/s²]", xlim=(0, end or 1))
        over_time.grid(lw=0.3, color="#DDDDDD")
        return _legends(over_time, spectra)

    return Drawing(of, "motions in and out", Panels(2, 1, (8.0, 5.4)), paint)


def _draw(shown, over_time, spectra):
    """The motion in its line; dashed, the one from which it came."""
    tables, said, color = shown.run.spectra[shown.name], shown.said, shown.color
    for kind, label, look in (("input", "input of ", {"ls": "--", "lw": 0.9, "alpha": 0.8}), ("motion", "", {"lw": 1, "ls": shown.line})):
        motion = tables.get(kind)
        if motion:
            over_time.plot(motion["time_s"], motion["acceleration_m_per_s2"], color=color, label=style.literal(label + said), **look)
    for kind, label, look in (("reference", "input of ", {"ls": "--", "lw": 0.9}), ("response", "", {"lw": 1.2, "ls": shown.line})):
        response = tables.get(kind)
        if response:
            column = _column(response)
            share = column.removeprefix("psa_").partition("pct")[0]
            spectra.plot(response["period_s"], response[column] / GRAVITY, color=color,
                         label=style.literal(f"{label}{said}, {share} %"), **look)


def _column(response):
    dampings = [column for column in response if column.startswith("psa_")]
    return next((column for column in dampings if DAMPING in column), dampings[0])
