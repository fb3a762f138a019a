"""Envelopes around rings, against the angle, and along other linings, against the distance: forces of sections and linings."""
import re
from typing import NamedTuple

import numpy as np

from adit.plots import style
from adit.plots.drawing import Drawing, Panels, legend
from adit.results.chains import angles, chains

FORCES = (("thrust_N", "thrust N", "kN/m"), ("moment_Nm", "moment M", "kN m/m"), ("shear_N", "shear force Q", "kN/m"))


class Places(NamedTuple):
    """Where the sections or nodes of a ring or lining are: their order, and the angle [°] or the distance [m] of each."""
    order: np.ndarray
    at: np.ndarray
    closed: bool


def of_sections(results):
    """Yields a drawing for each ring of sections: least and greatest thrust, moment and shear force over time."""
    for ring, places, least, greatest in _section_envelopes(results):
        yield _drawn(f"envelopes around {ring}", places, least, greatest)


def largest(results):
    """Yields (which ring or lining, its Places, [largest magnitudes of each of FORCES over time]) of all of a run."""
    for ring, places, least, greatest in _section_envelopes(results):
        yield ring, places, _magnitudes(least, greatest)
    for which, places, least, greatest in lining_envelopes(results, results.last_pieces.get("linings")):
        yield which, places, _magnitudes(least, greatest)


def _section_envelopes(results):
    for ring, sections in _rings(results).items():
        middles = np.array([[(s["from"][axis] + s["to"][axis]) / 2 for axis in "xy"] for s in sections])
        places = _around(middles)
        columns = [[results.histories[f"{sections[i]['name']}_{force}"] / 1e3 for i in places.order] for force, *_ in FORCES]
        least, greatest = ([find(series, axis=1) for series in columns] for find in (np.nanmin, np.nanmax))
        yield ring, places, least, greatest


def _magnitudes(least, greatest):
    return [np.maximum(np.abs(low), np.abs(high)) for low, high in zip(least, greatest)]


def columns(results):
    """The columns of histories.csv that these figures show."""
    return {f"{section['name']}_{force}" for ring in _rings(results).values() for section in ring for force, *_ in FORCES}


def of_linings(run, linings):
    """Yields a drawing for each lining: its least and greatest forces so far, around its middle or along its path."""
    for which, places, least, greatest in lining_envelopes(run, linings):
        yield _drawn(f"envelopes {words(places)} {which}", places, least, greatest)


def lining_envelopes(run, linings):
    """Yields (which lining, its Places, least of each of FORCES over time, greatest) of a piece of linings."""
    if linings is None or len(linings.cells) == 0 or linings.field("peak_largest_thrust_N") is None:
        return
    for name, nodes in chains(run, linings):
        places = _around(linings.points[nodes]) if _is_closed(linings, nodes) else _along(linings.points[nodes])
        least, greatest = ([linings.field(f"peak_{end}_{force}")[nodes][places.order] / 1e3 for force, *_ in FORCES]
                           for end in ("least", "largest"))
        yield f"lining {name}", places, least, greatest


def _rings(results):
    """{ring: its sections} whose forces were recorded; `tube_section_7` is of the ring `tube`."""
    found = {}
    for _, model in results.models:
        for section in model.get("sections", []):
            if all(f"{section['name']}_{force}" in results.histories for force, *_ in FORCES):
                ring = re.sub(r"_?(section)?_?\d+$", "", section["name"]) or "the ring"
                found.setdefault(ring, []).append(section)
    return {ring: sections for ring, sections in found.items() if len(sections) > 3}


def _around(points):
    """The Places of points by their angle about their middle."""
    angle = angles(points)
    order = np.argsort(angle)
    return Places(order, angle[order], True)


def _along(points):
    """The Places of points that follow one another, by the distance from the first."""
    return Places(np.arange(len(points)), np.append(0, np.cumsum(np.hypot(*np.diff(points[:, :2], axis=0).T))), False)


def _is_closed(linings, nodes):
    """Whether as many beams as nodes join these nodes."""
    return np.count_nonzero(np.isin(linings.cells, nodes).all(axis=1)) >= len(nodes)


def words(places):
    return "around" if places.closed else "along"


def _drawn(title, places, least, greatest):
    def paint(*panels):
        for axes, low, high in zip(panels, least, greatest):
            axes.fill_between(places.at, low, high, color=style.SKY, alpha=0.35, lw=0)
            axes.plot(places.at, low, color=style.BLUE, marker=".", ms=3, lw=1, label="least")
            axes.plot(places.at, high, color=style.RED, marker=".", ms=3, lw=1, label="greatest")
        label(panels, places)
        return [legend(panels[0])]

    return Drawing("", title, Panels(3, 1, (8.0, 6.0), sharex=True), paint)


def label(panels, places):
    """Labels the panels of FORCES at these Places."""
    for axes, (_, what, unit) in zip(panels, FORCES):
        axes.axhline(0, color=style.GREY, lw=0.4, zorder=0)
        axes.set_ylabel(f"{what} [{unit}]")
        axes.grid(lw=0.3, color="#DDDDDD")
    if places.closed:
        panels[-1].set(xlabel="angle from x, counter-clockwise [°]", xlim=(0, 360), xticks=range(0, 361, 45))
    else:
        panels[-1].set(xlabel="distance along the path [m]", xlim=(0, places.at[-1]))
