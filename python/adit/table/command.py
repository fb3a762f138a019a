"""Writes what the nodes of a lining or member bear, along its path, as CSV.

%(prog)s RUN_DIR NAME
    at the last time of the fields: place, angle about the middle, thrust, moment and shear force, their least and largest so far
    with their signs, and what a reinforced section or joints tell.
%(prog)s RUN_DIR NAME --time '2.5 s'
    at another time of output.field_times.
"""
import argparse
import csv
import re
import sys

from adit import Run, Unusable, programs
from adit.results import chains
from adit.results.files import nearest


def rows(run, name, time=None):
    """The header and the rows of the lining or member of this name."""
    pieces = run.fields(time)
    known = {each: kind for kind in ("lining", "member") if f"{kind}s" in pieces for each, _ in chains.chains(run, pieces[f"{kind}s"], kind)}
    if name not in known:
        raise Unusable(f"{run.folder} has no lining or member `{name}`; {nearest(name, known)}" if known
                       else f"{run.folder} has no linings and no members.")
    table = chains.table(run, pieces[f"{known[name]}s"], name, known[name])
    columns = {field: values for field, values in table.items() if values.ndim == 1}
    return list(columns), zip(*columns.values())


def seconds(text):
    """A time [s], in s where it has no unit."""
    try:
        value, unit = re.fullmatch(r"\s*(\S+?)\s*(s|ms|)\s*", text).groups()
        return float(value) * (1e-3 if unit == "ms" else 1)
    except (AttributeError, ValueError):
        raise argparse.ArgumentTypeError(f"`{text}` is no time; write for example `2.5 s`") from None


def main(words):
    parser = programs.parser("table", __doc__)
    parser.add_argument("folder", metavar="RUN_DIR", help="folder of a run")
    parser.add_argument("name", metavar="NAME", help="name of a lining or member")
    parser.add_argument("--time", type=seconds, metavar="TIME", help="a time of the fields, such as `2.5 s`; the last one if it is left out")
    options = parser.parse_args(words)
    header, values = rows(Run(options.folder), options.name, options.time)
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(header)
    writer.writerows([f"{value:.9g}" for value in row] for row in values)
