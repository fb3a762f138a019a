"""The page that compares runs: figures side by side, histories, spectra, envelopes and cracks in one picture each, force chains
and bonds side by side."""
from adit.compare import differences, overlays
from adit.report import instants, motions, overview, page, pictures
from adit.report.markup import bullets, section, table, tag
from adit.report.quantities import figure


def write(title, runs, place, drawn, shown, common):
    """Writes report.html into the folder `place` and returns its path. `drawn`: what overlays.drawn returned; `shown`: Instants of
    the runs side by side, of so many that they have in `common`."""
    finished = sum(run.completed for run in runs)
    told = tag("p", f"{len(runs)} runs are compared; {finished} of them are complete.",
               class_="state" if finished == len(runs) else "state failed")
    overlaid = {chapter: [pictures.figure(each) for each in drawings.values()] for chapter, drawings in drawn.items()}
    motions_too = motions.measures(overlays.shared_motions(runs)) if drawn["motions"] else None
    before = [_runs(runs, place), _figures(runs), section("comparison", "Histories of the runs in one picture", overlaid["comparison"]),
              section("motions", "Motions in and out", overlaid["motions"], motions_too),
              section("envelopes", "Envelopes", overlaid["envelopes"]), section("cracks", "Cracks", overlaid["cracks"])]
    return page.write(place / "report.html", lambda most: page.written(f"{title}: {len(runs)} runs compared", told, [
        *before, instants.chapter("Force chains and cracks at chosen instants", shown, common, most), _sizes(runs)]))


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
    found = [(said, key) for said, key in known if any(run.summary.get(key) for run in runs)]
    return section("sizes", "Sizes, versions and hashes", _beside("From each summary.json, too", found, runs))


def _beside(caption, known, runs):
    rows = [(said, *(figure(run.figures, key) for run in runs)) for said, key in known
            if any(run.figures.get(key) is not None for run in runs)]
    return table(caption, ("", *(run.name for run in runs)), rows)
