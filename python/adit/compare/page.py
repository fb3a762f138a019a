"""The page that compares runs: figures side by side, histories, spectra, envelopes and cracks in one picture each, force chains
and bonds side by side."""
from adit.compare import bonds, differences, overlays
from adit.plots.cores import on_all_cores
from adit.plots.instants import spread
from adit.report import instants, motions, overview, page, pictures
from adit.report.markup import bullets, section, table, tag
from adit.report.quantities import figure


def write(title, runs, place):
    """Writes report.html into the folder `place` and returns its path."""
    finished = sum(run.completed for run in runs)
    told = tag("p", f"{len(runs)} runs are compared; {finished} of them are complete.",
               class_="state" if finished == len(runs) else "state failed")
    with pictures.narrow():
        before = [_runs(runs, place), _figures(runs), _histories(title, runs), _motions(runs), _envelopes(title, runs),
                  _cracks(title, runs)]
        return page.write(place / "report.html", lambda most: page.written(
            f"{title}: {len(runs)} runs compared", told, [*before, _side_by_side(runs, most), _sizes(runs)]))


def _runs(runs, place):
    return section("runs", "The runs", bullets([_run(run, place) for run in runs]))


def _run(run, place):
    own = run.folder.resolve() / "report.html"
    linked = own.exists() and own.is_relative_to(place)
    name = tag("a", run.name, href=own.relative_to(place).as_posix()) if linked else run.name
    description = run.scene.get("description")
    return [name, f": {description}" if description else None, "" if run.completed else " (not complete)"]


def _figures(runs):
    return section("figures", "Main figures", _beside("From each summary.json", overview.main_figures(*runs), runs),
                   differences.chapter(runs))


def _sizes(runs):
    known = [("zones", "zones"), ("particles", "particles"), ("bonds", "bonds"), ("time step", "dt_s"), ("steps", "steps"),
             ("programs", "versions"), ("hash of the scene", "scene_hash")]
    return section("sizes", "Sizes, versions and hashes", _beside("From each summary.json, too", known, runs))


def _beside(caption, known, runs):
    rows = [(said, *(figure(run.summary, key) for run in runs)) for said, key in known
            if any(run.summary.get(key) is not None for run in runs)]
    return table(caption, ("", *(run.name for run in runs)), rows)


def _histories(title, runs):
    return section("comparison", "Histories of the runs in one picture",
                   [pictures.figure(overlays.histories(title, quantity, *what))
                    for quantity, what in overlays.shared_histories(runs).items()])


def _motions(runs):
    found = overlays.shared_motions(runs)
    return section("motions", "Motions in and out", pictures.figure(motions.picture(found)),
                   motions.measures(found)) if found else None


def _envelopes(title, runs):
    return section("envelopes", "Envelopes", [pictures.figure(each) for _, each in overlays.envelopes(title, runs)])


def _cracks(title, runs):
    return section("cracks", "Cracks", pictures.figure(overlays.cracks(title, runs)))


def _side_by_side(runs, most):
    """Force chains and cracks at the instants that all runs with particles have."""
    runs = bonds.with_bonds(runs)
    common = bonds.common_instants(runs) if len(runs) > 1 else []
    if not common:
        return None
    chosen = spread(common, most, [piece for run in runs for piece in run.last_pieces.values()])
    compared = on_all_cores(lambda n: _compared(runs, chosen[n][1]), len(chosen))
    shown = [(time, figures) for (time, _), figures in zip(chosen, compared)]
    peak = runs[0].number("peak_bond_force_time_s")
    first = len(shown) - 1 if peak is None else min(range(len(shown)), key=lambda n: abs(shown[n][0] - peak))
    return section("instants", "Force chains and cracks at chosen instants",
                   instants.behind_a_slider(shown, first, len(common)))


def _compared(runs, numbers):
    return [pictures.figure(each, of_model=True, of_run=run.name)
            for view in (bonds.force_chains, bonds.bonds) for run, each in zip(runs, view(runs, numbers))]
