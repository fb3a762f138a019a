"""Reads a run's folder for the pictures: summary, histories, snapshots."""
import csv
import json
import re
from functools import cached_property
from pathlib import Path

import numpy as np
import yaml

from adit_plots.vtk_files import Piece, read_collection


class Unusable(Exception):
    """A file is missing or is not what it should be; the message is one sentence for the user."""


class Run:
    def __init__(self, folder):
        self.folder = Path(folder)
        self.name = self.folder.resolve().name
        self.summary = _read(self.folder / "summary.json", lambda path: json.loads(path.read_text()))
        self.histories = _read(self.folder / "histories.csv", _read_columns)

    @cached_property
    def scene(self):
        """The scene as it was computed, as mappings and lists in SI units."""
        return _read(self.folder / "scene.yaml", lambda path: yaml.load(path.read_text(), _SceneLoader))

    def snapshots(self):
        """Yields (time [s], {kind: Piece}) with the pieces of all models joined; nothing if no fields were written."""
        collection = self.folder / "fields" / "fields.pvd"
        if not collection.exists():
            return
        for time, files in _read(collection, read_collection):
            kinds = {}
            for name, path in files.items():  # `grid`, or `lining_grid` of the region `lining`
                kinds.setdefault(name.rpartition("_")[2], []).append(_read(path, Piece))
            yield time, {kind: Piece.joined(pieces) for kind, pieces in kinds.items()}

    def number(self, name):
        """A number of the summary; None if the run does not have it (null or absent)."""
        value = self.summary.get(name)
        return float(value) if isinstance(value, (int, float)) else None

    def overlap(self):
        """The points [m] at which particles begin and the continuum ends; None if the overlap is not a strip."""
        ends = ("particles_begin", "continuum_ends")
        values = [[self.number(f"overlap_{end}_{axis}_m") for axis in "xy"] for end in ends]
        return None if any(v is None for end in values for v in end) else np.array(values)


class _SceneLoader(yaml.SafeLoader):
    """Reads 3e+10 as a number, as YAML 1.2 does and PyYAML does not."""


_SceneLoader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"[-+]?\d+(\.\d*)?e[-+]?\d+$"), list("-+0123456789"))


def _read(path, reader):
    if not path.exists():
        raise Unusable(f"{path} does not exist: is {path.parent} the folder of a finished run?")
    try:
        return reader(path)
    except Exception as error:  # a damaged file can cause any error, and the user needs to know which file it is
        raise Unusable(f"{path} is damaged ({type(error).__name__}: {error}): run the scene again.") from error


def read_columns(path):
    """{name: values} of a table; columns that are not numbers stay texts."""
    return _read(path, _read_columns)


def _read_columns(path):
    with open(path, newline="") as file:
        header, *rows = csv.reader(file)
    rows = [row for row in rows if len(row) == len(header)]  # a killed run may end in half a row
    return {name: _column([row[i] for row in rows]) for i, name in enumerate(header)}


def _column(texts):
    try:
        return np.array(texts, float)
    except ValueError:
        return np.array(texts)
