"""The report of a study: its question, its tables and pictures, and the origin of its runs."""
import shlex
import sys

from adit.report import page, pictures
from adit.report.markup import paragraphs, section, table, tag


def write(folder, title, told, tables, drawings, run):
    """Writes FOLDER/report.html and returns its path. `told`: the docstring of the study; `tables`: [(caption, head, rows)];
    `run`: any run of the study, for the versions of the programs."""
    chapters = [section("tables", "Tables", [table(*each) for each in tables]),
                section("pictures", "Pictures", [pictures.figure(each) for each in drawings]),
                section("origin", "Versions and how to repeat the study", origin(folder, run))]
    text = page.written(title, paragraphs(told.strip().split("\n\n")[:1]), chapters)
    path = folder / "report.html"
    path.write_bytes(text)
    return path


def origin(folder, run):
    """A table of what computed a study with this run."""
    known = [("programs", run.summary["versions"]), ("commit of the source", run.summary.get("revision")),
             ("command", shlex.join(sys.argv)), ("runs", f"in folders of their own in {folder}, each with its scene.yaml")]
    return table("Where the results come from", None, [(what, tag("td", said, class_="anywhere")) for what, said in known if said])
