"""Writes the reports of runs: one page each, readable without network.

%(prog)s RUN_DIR...
    writes RUN_DIR/report.html for each run, also of a run that failed or was stopped. `adit compare` writes one that
    compares several runs.
"""
from adit import programs
from adit.report import page


def main(words):
    parser = programs.parser("report", __doc__)
    parser.add_argument("folders", metavar="RUN_DIR", nargs="+", help="folder of a run")
    options = parser.parse_args(words)
    for folder in options.folders:
        print(f"report             {page.of_run(folder)}")
