"""The largest forces over time around linings and along whole tunnels: fractiles of the runs."""
import numpy as np

from adit.plots.drawing import Drawing, legend
from adit.plots.tunnel_pictures import QUANTITIES
from adit.report import around
from adit.report.quantities import prefix
from adit.study.pictures import axes as axis
from adit.study.pictures.chosen import chosen, draw


def envelopes(outcome, out):
    """Yields (name, Drawing) of linings whose fields were kept, and of tunnels whose envelopes were."""
    kept = set(outcome.study.keep) & {"fields", "envelopes.csv"}
    if not kept:
        return
    runs, which = chosen(outcome, out)
    if "fields" in kept:
        yield from around_linings([run for run in runs if run.instants and run.times[-1] > 0], which)
    if "envelopes.csv" in kept:
        yield from along_the_axis([run for run in runs if run.has("envelopes.csv")], which)


def around_linings(runs, which):
    found = {}
    for run in runs:
        files = {name: path for name, path in run.instants[-1][1].items() if name.endswith("linings")}
        piece = run.pieces_of(files).get("linings")
        for name, places, least, greatest in around.lining_envelopes(runs[0], piece):  # names are the same in all runs
            found.setdefault(name, []).append((places, [np.maximum(np.abs(low), np.abs(high)) for low, high in zip(least, greatest)]))
    for name, each in found.items():
        places = each[0][0]
        yield f"{around.words(places)}_{name.replace(' ', '_')}", of_lining(name, which, places, [at_places(places, *one) for one in each])


def at_places(places, own, values):
    """Values of a run at the places of another one: by the angle, or by the distance."""
    return [np.interp(places.at, own.at, each, period=360 if own.closed else None) for each in values]


def of_lining(name, which, places, values):
    def paint(*panels):
        for panel, of_runs in zip(panels, zip(*values)):
            draw(panel, places.at, np.array(of_runs))
        around.label(panels, places)
        return [legend(panels[0], **axis.BESIDE)]

    return Drawing("", f"largest forces {around.words(places)} {name}: fractiles of {which}", axis.rows(3, 1.8), paint)


def along_the_axis(runs, which):
    if not runs:
        return
    tables = [run.table("envelopes.csv") for run in runs]
    chainage = tables[0]["chainage_m"]
    shown = [each for each in QUANTITIES if f"{each[0]}_max_{each[1]}" in tables[0]]
    values = {column: np.array([np.interp(chainage, table["chainage_m"], largest(table, column, unit)) for table in tables])
              for column, unit, *_ in shown}

    def paint(*panels):
        for panel, (column, _, label, unit) in zip(panels, shown):
            symbol, size = prefix(values[column].max(), unit)
            draw(panel, chainage / 1e3, values[column] / size)
            panel.set_ylabel(f"{label} [{symbol}{unit}]")
            panel.grid(**axis.GRID)
        panels[-1].set(xlabel="chainage [km]", xlim=(chainage[0] / 1e3, chainage[-1] / 1e3))
        return [legend(panels[0], **axis.BESIDE)]

    yield "along_the_axis", Drawing("", f"largest values along the axis: fractiles of {which}", axis.rows(len(shown), 1.6), paint)


def largest(table, column, unit):
    return np.maximum(*(np.abs(table[f"{column}_{end}_{unit}"]) for end in ("min", "max")))
