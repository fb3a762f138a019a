"""The page that compares the runs of a case: figures side by side, histories in one picture, links to their reports."""
from pathlib import Path

from adit_plots import style, time_pictures, tunnel_pictures
from adit_report import instants, motions, overview, page, pictures
from adit_report.markup import bullets, section, table, tag
from adit_report.quantities import figure
from adit_report.results import Results

IN_THE_FIRST = ("tip_uy_m", "max_bond_force_N")  # columns of time_pictures.comparison
MOST = 8  # histories


def of_runs(folders):
    """Writes report.html beside the runs and returns its path."""
    runs = [Results(folder) for folder in folders]
    place = Path(folders[0]).resolve().parent
    finished = sum(bool(run.summary.get("completed")) for run in runs)
    told = tag("p", f"{len(runs)} runs are compared; {finished} of them are complete.",
               class_="state" if finished == len(runs) else "state failed")
    with pictures.narrow():
        before = [_runs(runs, place), _figures(runs), _pictures(place.name, runs), motions.compared(runs)]
        return page.write(place / "report.html", lambda most: page.written(
            f"{place.name}: {len(runs)} runs compared", told, [*before, instants.side_by_side(runs, most), _sizes(runs)]))


def _runs(runs, place):
    return section("runs", "The runs", bullets([_run(run, place) for run in runs]))


def _run(run, place):
    own = run.folder.resolve() / "report.html"
    linked = own.exists() and own.is_relative_to(place)
    name = tag("a", run.name, href=own.relative_to(place).as_posix()) if linked else run.name
    description = run.scene.get("description")
    return [name, f": {description}" if description else None, "" if run.summary.get("completed") else " (not complete)"]


def _figures(runs):
    return section("figures", "Main figures", _side_by_side("From each summary.json", overview.main_figures(), runs))


def _sizes(runs):
    known = [("zones", "zones"), ("particles", "particles"), ("bonds", "bonds"), ("time step", "dt_s"), ("steps", "steps"),
             ("programs", "versions"), ("hash of the scene", "scene_hash")]
    return section("sizes", "Sizes, versions and hashes", _side_by_side("From each summary.json, too", known, runs))


def _side_by_side(caption, known, runs):
    rows = [(said, *(figure(run.summary, key) for run in runs)) for said, key in known
            if any(run.summary.get(key) is not None for run in runs)]
    return table(caption, ("", *(run.name for run in runs)), rows)


def _pictures(case, runs):
    tunnels = [run for run in runs if run.is_simplified and run.table("envelopes.csv")]
    first = tunnel_pictures.comparison(case, tunnels) if tunnels else None
    if not tunnels and any("max_bond_force_N" in run.histories for run in runs):
        first = time_pictures.comparison(case, runs)
    return section("comparison", "The runs in one picture", pictures.figure(first), map(pictures.figure, _shared(runs, first)))


def _shared(runs, first):
    """A figure for each history that several runs have, without those of the first picture; MOST at most."""
    drawn = IN_THE_FIRST if first else ()
    found = {}
    for i, run in enumerate(runs):
        for quantity, (units, lines) in time_pictures.quantities_of(run).items():
            for column, values in lines:
                found.setdefault(column, (quantity, units, []))[2].append((i, run, values))
    shared = [(column, *what) for column, what in found.items() if len(what[2]) > 1 and column not in drawn]
    return [_one(*each) for each in shared[:MOST]]


def _one(column, quantity, units, lines):
    name, size = time_pictures.unit_for(units, [values for *_, values in lines])
    drawn, axes = style.plt.subplots(figsize=(8.0, 2.6))
    _, label = style.time_axis(max((run.histories["time_s"] for _, run, _ in lines), key=lambda times: times[-1]))
    for i, run, values in lines:
        times = run.histories["time_s"] * (1 if label == "t [s]" else 1e3)
        axes.plot(times, values / size, label=run.name, **time_pictures.look(i))
    axes.set(xlabel=label, ylabel=f"{quantity} [{name}]")
    axes.set_title(f"runs: {quantity} of {style.literal(time_pictures.said(column))}", loc="left")
    axes.legend()
    return drawn
