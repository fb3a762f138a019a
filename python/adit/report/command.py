"""Writes a report of runs: one page with all that an engineer hands on, readable without network.

%(prog)s RUN_DIR...
    writes RUN_DIR/report.html for each run, also of a run that failed or was stopped. `adit compare` writes one that
    compares several runs.
"""
import argparse

from adit import programs
from adit.report import page


def main(words):
    parser = argparse.ArgumentParser(prog=programs.command("report"), description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", metavar="RUN_DIR", nargs="+", help="folder of a run")
    options = parser.parse_args(words)
    with programs.refusals_told("report"):
        for folder in options.folders:
            print(f"report             {page.of_run(folder)}")
