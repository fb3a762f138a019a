"""The report of a study: one page that is readable without network."""
from adit.report import page, pictures, study as of_studies
from adit.report.markup import bullets, details, paragraphs, section, table, tag
from adit.report.quantities import digits
from adit.report.results import Results
from adit.study.page import answers, detail, fragility, stated
from adit.study.pictures import axes as axis

LISTED = 20  # rows of long tables
FILES = ("study.csv", "study.h5", "detail.csv", "fragility.csv", "indices.csv", "*.xml", "*_pelicun.csv")


def write(outcome, drawn, out):
    """Writes OUT/report.html and returns its path. `drawn`: what pictures.draw() returned."""
    shown = {chapter: [pictures.figure(drawing) for drawing in drawings.values()] for chapter, drawings in drawn.items()}
    chapters = [
        section("fragility", "Fragility", fragility.told(outcome), shown["fragility"]),
        section("answers", "Answers", answers.shares(outcome), answers.spread(outcome), shown["answers"], answers.at_levels(outcome)),
        section("detail", "The worst places in detail", detail.told(outcome), shown["detail"]),
        section("inputs", "Which input matters", answers.indices(outcome), shown["inputs"]),
        section("time", "Answers over time", shown["time"]),
        section("linings", "Forces along linings", shown["linings"]),
        section("motions", "Ground motions", stated.motions(outcome)),
        section("random", "What is random", stated.random(outcome.study)),
        section("failed", "Runs that failed", failed(outcome)),
        section("files", "Files", files(outcome, out)),
        section("origin", "Versions and how to repeat the study", of_studies.origin(out, Results(out / outcome.good[0]["folder"])),
                details("The file of the study", tag("pre", outcome.study.path.read_text(errors="replace"), tabindex=0)))]
    title = f"{outcome.study.name}: {runs(len(outcome.listed))} of {outcome.study.scene.name}"
    path = out / "report.html"
    path.write_bytes(page.written(title, head(outcome), chapters))
    return path


def runs(count):
    return "one run" if count == 1 else f"{count:,} runs"


def head(outcome):
    """What the study is, and whether all runs are complete."""
    if outcome.failed:
        told = [tag("strong", f"{outcome.failed} of {runs(len(outcome.listed))} failed"), " and count nowhere on this page; ",
                tag("a", "the reasons", href="#failed"), " stand below."]
    else:
        told = "The only run is complete." if len(outcome.listed) == 1 else f"All {runs(len(outcome.listed))} are complete."
    return [*paragraphs([outcome.study.read.get("description")]), tag("p", told, class_="state failed" if outcome.failed else "state")]


def failed(outcome):
    """Why runs failed, of the first LISTED."""
    wrong = [row for row in outcome.listed if row["failed"]]
    if not wrong:
        return None
    columns = ("motion", "level", "sample") if outcome.study.motions else ("sample",)
    rows = [(row["run"], *(_known_by(outcome.study, row, column) for column in columns), tag("td", row["failed"], class_="anywhere"))
            for row in wrong[:LISTED]]
    more = f"{len(wrong) - LISTED:,} more stand in study.csv." if len(wrong) > LISTED else None
    return [table("Why runs have no answers", ("run", *columns, "reason"), rows), *paragraphs([more])]


def _known_by(study, row, column):
    return axis.of_level(study, row["level"]) if column == "level" and study.levels else _cell(row[column])


def files(outcome, out):
    """Links to what was written, and the first LISTED rows of the table."""
    found = [path for pattern in FILES for path in sorted(out.glob(pattern))]
    names = [name for name in outcome.listed[0] if name != "folder"]
    rows = [[_cell(row[name]) for name in names] for row in outcome.listed[:LISTED]]
    return [bullets([tag("a", path.name, href=path.name) for path in found]),
            details(f"The first {runs(len(rows))} of the table", table("study.csv; names end in their units", names, rows))]


def _cell(value):
    return "–" if value is None or value == "" else digits(value) if isinstance(value, float) else str(value)
