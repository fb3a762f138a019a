"""The page: chapters in order, in one self-contained file smaller than LARGEST."""
import base64
import hashlib
from pathlib import Path
from string import Template

from adit.plots.instants import MOST
from adit.report import computed, instants, model, motions, origin, overview, response
from adit.report.markup import Markup, bullets, safe, tag
from adit.report.results import Results

LARGEST = 5_000_000  # bytes of a report
FEWER = (MOST, 4, 2, 1)  # instants, in turn, until the page is small enough
FOLDER = Path(__file__).parent


def of_run(folder):
    """Writes FOLDER/report.html and returns its path."""
    results = Results(folder)
    case = results.summary.get("case") or results.folder.resolve().parent.name
    before = [_unless_odd(results, chapter) for chapter in (
        overview.figures, computed.chapter, model.chapter, motions.chapter, response.histories, response.envelopes)]
    after = [_unless_odd(results, chapter) for chapter in (response.cracks, response.energy, origin.timing, origin.chapter)]
    shown, peaks = _unless_odd(results, instants.drawn) or ([], None)
    head, warned = _unless_odd(results, overview.state), overview.warnings(results)  # which lists the files that could not be read

    def chosen(most):
        return instants.chapter("The model at chosen instants", shown, len(results.instants), most, peaks)

    return write(results.folder / "report.html", lambda most: written(
        f"{case}: {results.name}", head, [warned, *before, chosen(most), *after]))


def _unless_odd(results, chapter):
    """The chapter; None if a file has impossible content. The page says so, and the other chapters are complete."""
    try:
        return chapter(results)
    except Exception as error:  # as many kinds as there are ways to damage a file
        what = f"{chapter.__module__.rpartition('.')[2]}, {chapter.__name__}"
        results.faults.append(f"A part of this page is left out ({what}: {type(error).__name__}: {error}); run the scene again.")
        return None


def write(path, whole):
    """Writes the page that whole(instants) makes with as many instants as LARGEST allows; returns the path."""
    for most in FEWER:
        text = whole(most)
        if len(text) <= LARGEST:
            break
    path.write_bytes(text)
    return path


def written(title, head, chapters):
    """The whole page, as bytes."""
    chapters = [chapter for chapter in chapters if chapter]
    script = (FOLDER / "page.js").read_text()
    names = [chapter.partition('id="')[2].partition('"')[0] for chapter in chapters]
    titles = [Markup(chapter.partition("<h2")[2].partition(">")[2].partition("</h2>")[0]) for chapter in chapters]
    return Template((FOLDER / "page.html").read_text()).substitute(
        title=safe(title), head=safe(head), body="\n".join(chapters), style=(FOLDER / "page.css").read_text(), script=script,
        script_hash=base64.b64encode(hashlib.sha256(script.encode()).digest()).decode(),
        chapters=bullets([tag("a", said, href=f"#{name}") for name, said in zip(names, titles)])).encode()
