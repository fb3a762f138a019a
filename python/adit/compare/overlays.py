"""Histories, cracks and envelopes of several runs, each in one picture."""
import numpy as np
from matplotlib.lines import Line2D

from adit.plots import style, time_pictures, tunnel_pictures
from adit.plots.drawing import Drawing, Panels, legend
from adit.report import around, motions

NOISE = 1e-6  # share of the largest history of a quantity, below which another one is noise
SHORT = 0.05  # of the longest run: the curves of a shorter one are hardly seen, and end in a cross
MODES = {"tensile": "x", "shear": "+"}  # markers of cracks


BESIDE = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.03)}  # of a panel: its legend


def drawn(title, runs):
    """{chapter of the page: {name of the file: drawing}}; chapters without a drawing are empty."""
    shared, found = shared_motions(runs), cracks(title, runs)
    return {"comparison": {quantity.replace(",", "").replace(" ", "_"): histories(title, quantity, *what)
                           for quantity, what in shared_histories(runs).items()},
            "motions": {"motions": motions.picture(title, shared)} if shared else {},
            "envelopes": dict(envelopes(title, runs)),
            "cracks": {"cracks": found} if found else {}}


def look(i):
    """Colour and dashes of run i; only the first is solid, so that curves that coincide show through."""
    dashes = ("-", (0, (5, 2)), (0, (1.5, 1.2)), (0, (6, 1.5, 1.5, 1.5)), (0, (9, 3)), (0, (3, 4)), (0, (1, 3)))
    return {"color": style.of_run(i), "ls": dashes[(i + i // len(style.OF_RUNS)) % len(dashes)],
            "lw": 1.2 if i == 0 else 1.5}


def shared_histories(runs):
    """{quantity: (its units, {column: [(number of the run, run, values)]})} of the columns that at least two runs have."""
    found = {}
    for i, run in enumerate(runs):
        for quantity, (units, lines) in time_pictures.quantities_of(run).items():
            for column, values in lines:
                found.setdefault(quantity, (units, {}))[1].setdefault(column, []).append((i, run, values))
    for quantity, (units, columns) in found.items():
        largest = {column: max(np.nanmax(np.abs(values), initial=0) for *_, values in lines) for column, lines in columns.items()}
        telling = {column: [line for line in lines if np.any(line[2])] for column, lines in columns.items()
                   if largest[column] > NOISE * max(largest.values())}
        found[quantity] = units, {column: lines for column, lines in telling.items() if len(lines) > 1}
    return {quantity: what for quantity, what in found.items() if what[1]}


def histories(title, quantity, units, columns):
    """A panel for each history of one quantity, the largest time_pictures.MOST_LINES of them. The largest bond force has a
    ring at the first crack of each run."""
    columns = dict(list(columns.items())[:time_pictures.MOST_LINES])
    every = [line for lines in columns.values() for line in lines]
    unit, size = time_pictures.unit_for(units, [values for *_, values in every])
    last = max((run.histories["time_s"] for _, run, _ in every), key=lambda times: times[-1])
    scale, label = style.time_axis(last)
    factor = scale[-1] / last[-1] if last[-1] else 1
    ends = {i: end_of(run.histories["time_s"], last[-1]) for i, run, _ in every}

    def paint(*panels):
        named = {}  # the legend's line of each run
        for axes, (column, lines) in zip(panels, columns.items()):
            for i, run, values in lines:
                told, mark = ends[i]
                named[i], = axes.plot(factor * run.histories["time_s"], values / size, label=style.literal(run.name + told), **mark, **look(i))
                if column == "max_bond_force_N":
                    _mark_first_crack(axes, run, factor, size, look(i)["color"], 6 + 3 * i)
            axes.set_ylabel(f"{style.literal(time_pictures.said(column))} [{unit}]")
            axes.grid(lw=0.3, color="#DDDDDD")
        handles = [named[i] for i in sorted(named)]
        if any(line.get_marker() == "o" for axes in panels for line in axes.get_lines()):
            handles.append(Line2D([], [], label="first crack, in the colour of its run", **_ring(style.BLACK, 7)))
        panels[-1].set(xlabel=label, xlim=(0, scale[-1] or 1))
        return [legend(panels[0], handles, loc="upper left", bbox_to_anchor=(1.01, 1.05), handlelength=3.2)]

    return Drawing(title, quantity, Panels(len(columns), 1, (8.0, 1.0 + 1.6 * len(columns)), sharex=True), paint)


def end_of(times, last):
    """(what a legend says of the end of a run that is short beside one until `last` [s], the mark of its last value)."""
    if not len(times) or times[-1] >= SHORT * last:
        return "", {}
    return f", ends at {style.instant(times[-1])}", {"marker": "x", "markevery": [len(times) - 1], "ms": 7, "mew": 1.6, "clip_on": False}


def _mark_first_crack(axes, run, factor, size, color, width):
    """Rings of different sizes, for first cracks that coincide."""
    time = run.number("first_crack_time_s")
    if time is not None:
        force = np.interp(time, run.histories["time_s"], run.histories["max_bond_force_N"])
        axes.plot(factor * time, force / size, zorder=6, **_ring(color, width))


def _ring(color, size):
    return {"ls": "", "marker": "o", "ms": size, "mfc": "none", "mec": color, "mew": 1.4}


def cracks(title, runs):
    """Number of cracks over time, and their places; None unless some run has cracks. Debonded bonds do not count."""
    found = [(i, run, _inside_bodies(run, table)) for i, run in enumerate(runs) if (table := run.table("cracks.csv"))]
    if not any(len(table["time_s"]) for *_, table in found):
        return None
    ends = [run.histories["time_s"][-1] for _, run, _ in found]
    scale, label = style.time_axis(np.array([max(ends)]))
    factor = scale[0] / max(ends)

    def paint(count, places):
        for (i, run, table), end in zip(found, ends):
            times = np.sort(table["time_s"])
            count.step(factor * np.array([0, *times, end]), [*range(len(times) + 1), len(times)], where="post",
                       label=f"{style.literal(run.name)}: {len(times):,}", **look(i))
            for mode, marker in MODES.items():
                chosen = table["mode"].astype(str) == mode
                if chosen.any():
                    places.plot(table["x_m"][chosen], table["y_m"][chosen], ls="", marker=marker, ms=5 + 2 * i, mew=1.2,
                                zorder=9 - i, color=look(i)["color"], label=f"{style.literal(run.name)}, {mode}")
        count.set(xlabel=label, ylabel="cracks", xlim=(0, scale[0]), ylim=(0, None))
        places.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", adjustable="datalim")
        for axes in (count, places):
            axes.grid(lw=0.3, color="#DDDDDD")
        return [legend(axes, **BESIDE) for axes in (count, places)]

    return Drawing(title, "cracks over time, and where they are", Panels(2, 1, (8.0, 6.0)), paint)


def _inside_bodies(run, broken):
    kept = ~run.debonded(broken)
    return {name: values[kept] for name, values in broken.items()}


def envelopes(title, runs):
    """Yields (name, drawing): along the axis of whole tunnels; around rings and linings, largest magnitudes over time."""
    tunnels = [run for run in runs if run.is_simplified and run.has("envelopes.csv")]
    if len(tunnels) > 1:
        yield "along_the_axis", tunnel_pictures.comparison(title, tunnels)
    found = {}
    for i, run in enumerate(runs):
        for what, places, peaks in around.largest(run):
            found.setdefault(what, []).append((i, run, places, peaks))
    for number, (what, several) in enumerate(found.items(), 1):
        if len(several) > 1:
            yield f"around_{number}", _around(title, what, several)


def _around(title, what, several):
    first = several[0][2]

    def paint(*panels):
        for i, run, places, peaks in several:
            for axes, values in zip(panels, peaks):
                axes.plot(places.at, values, marker=".", ms=3, label=style.literal(run.name), **look(i))
        around.label(panels, first)
        return [legend(panels[0], **BESIDE)]

    return Drawing(title, f"largest forces {around.words(first)} {what}, without sign", Panels(3, 1, (8.0, 6.0), sharex=True), paint)


def shared_motions(runs):
    """[Shown] of all motions, those of one run in its colour; empty if fewer than two runs have any."""
    last = max((run.spectra[name]["motion"]["time_s"][-1] for run in runs for name in run.spectra), default=0)
    found = [motions.Shown(run, name, f"{run.name}, {name}{end_of(run.spectra[name]['motion']['time_s'], last)[0]}", style.of_run(i),
                           time_pictures.LINES[::2][n % 2]) for i, run in enumerate(runs) for n, name in enumerate(run.spectra)]
    return found if len({each.run.name for each in found}) > 1 else []
