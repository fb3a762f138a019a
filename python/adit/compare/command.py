"""Compares runs: their main figures side by side, and their results in one picture each.

For several runs it writes into the folder that contains all of them, or into DIR:
    report.html     a page: figures with differences and ratios, histories, spectra, envelopes and cracks in one picture each,
                    force chains, and bonds or cracks, side by side at every instant that the runs share
    comparison/     the same pictures as files, and figures.csv: every figure of summary.json that differs
The first run is the reference. With --reference it compares each run with the reference.json of its case instead, prints a table,
and ends with exit code 1 if a figure is not within its tolerance.
"""
import os
import sys
from pathlib import Path

from adit import programs
from adit.compare import files, overlays, page, reference
from adit.report import overview
from adit.report.results import Results


def main(words):
    parser = programs.parser("compare", __doc__)
    parser.add_argument("folders", metavar="RUN_DIR", nargs="+", help="folder of a run")
    parser.add_argument("--out", metavar="DIR", type=Path, help="folder of the comparison")
    parser.add_argument("--reference", metavar="FILE", type=Path, help="reference.json of a case, as in cases/longxi")
    parser.add_argument("--no-report", action="store_true", help="write no report.html")
    parser.add_argument("--no-pictures", action="store_true", help="write figures.csv only: neither pictures nor report.html")
    options = parser.parse_args(words)
    if options.reference:
        runs = [Results(folder) for folder in options.folders]
        sys.exit(0 if agree(runs, reference.Reference(options.reference)) else 1)
    compare(options.folders, options.out, with_pictures=not options.no_pictures, with_report=not options.no_report)


def agree(runs, expected):
    """Prints how each run agrees with the reference; returns whether all figures are within their tolerances."""
    compared = [(run, expected.figures(run)) for run in runs]
    for run, figures in compared:
        print(*reference.lines(run, expected, figures), sep="\n")
    return all(figure.is_within() for _, figures in compared for figure in figures)


def compare(folders, out, with_pictures=True, with_report=True):
    """Prints the figures of runs side by side; writes the comparison of several into `out` or the folder that contains all."""
    runs = [Results(folder) for folder in folders]
    paths = [run.folder.resolve() for run in runs]
    common = Path(os.path.commonpath([path.parent for path in paths]))
    out = (out or common).resolve()
    if len({run.name for run in runs}) < len(runs):
        for run, path in zip(runs, paths):
            run.name = path.relative_to(common).as_posix()
    print(*overview.lines(runs), sep="\n", flush=True)
    if len(runs) > 1:
        files.write(runs, out / "comparison")
        if with_pictures:
            drawn = overlays.drawn(out.name, runs)
            files.draw(drawn, out / "comparison")
            side_by_side = files.draw_side_by_side(runs, out / "comparison", with_report)
        print(f"\ncomparison         {out / 'comparison'}", flush=True)
        if with_pictures and with_report:
            print(f"report             {page.write(out.name, runs, out, drawn, *side_by_side)}", flush=True)
