"""Tables of a run: columns by name."""
import csv

import numpy as np

from adit.results.files import Unusable, nearest


class Table(dict):
    """{name: values}, numpy arrays of one length; names end in their units. `source` is where it comes from."""

    def __init__(self, columns, source):
        super().__init__(columns)
        self.source = source

    def __missing__(self, name):
        raise Unusable(f"{self.source} has no `{name}`; {nearest(name, self)}")

    def frame(self):
        """The table as a pandas.DataFrame; the components of vectors become columns NAME_0, NAME_1, …"""
        try:
            import pandas
        except ImportError:
            raise Unusable("pandas is not installed: install python3-pandas, or use the arrays.") from None
        columns = {}
        for name, values in self.items():
            columns |= {name: values} if values.ndim == 1 else {f"{name}_{i}": each for i, each in enumerate(values.T)}
        return pandas.DataFrame(columns)


def read_table(path):
    """A CSV file as a Table; columns that are not numbers stay texts."""
    with open(path, newline="") as file:
        header, *rows = csv.reader(file)
        if not "".join(header):
            raise ValueError("it has no names of columns")
    rows = [row for row in rows if len(row) == len(header)]  # a run that was killed may end in half a row
    return Table({name: _column([row[i] for row in rows]) for i, name in enumerate(header)}, path)


def _column(texts):
    try:
        return np.array(texts, float)
    except ValueError:
        return np.array(texts)
