"""Reads a run's folder for the pictures: summary, histories, snapshots."""
import csv
import json
import re
from functools import cached_property
from pathlib import Path

import numpy as np
import yaml

from adit_plots import mesh_groups
from adit_plots.vtk_files import Piece, read_collection


class Unusable(Exception):
    """A file is missing or is not what it should be; the message is one sentence for the user."""


class Folder:
    """What a run and a checked model both leave: the scene and fields."""

    def __init__(self, folder):
        self.folder = Path(folder)

    @cached_property
    def scene(self):
        """The scene as it was computed, as mappings and lists in SI units."""
        return _read(self.folder / "scene.yaml", lambda path: yaml.load(path.read_text(), _SceneLoader))

    def files(self):
        """[(time [s], {piece name: file})] in the order of time; nothing if no fields were written."""
        collection = self.folder / "fields" / "fields.pvd"
        return _read(collection, read_collection) if collection.exists() else []


class Run(Folder):
    def __init__(self, folder):
        super().__init__(folder)
        self.name = self.folder.resolve().name
        self.summary = _read(self.folder / "summary.json", lambda path: json.loads(path.read_text()))
        self.histories = _read(self.folder / "histories.csv", _read_columns)

    def snapshots(self):
        """Yields (time [s], {kind: Piece}) with the pieces of all models joined."""
        for time, files in self.files():
            yield time, self.pieces_of(files)

    @staticmethod
    def pieces_of(files):
        """{kind: Piece} of one instant, with the pieces of all models joined."""
        kinds = {}
        for name, path in files.items():  # `grid`, or `lining_grid` of the region `lining`
            kinds.setdefault(name.rpartition("_")[2], []).append(_read(path, Piece))
        return {kind: Piece.joined(pieces) for kind, pieces in kinds.items()}

    def number(self, name):
        """A number of the summary; None if the run does not have it (null or absent)."""
        value = self.summary.get(name)
        return float(value) if isinstance(value, (int, float)) else None

    def overlap(self):
        """The points [m] at which particles begin and the continuum ends; None if the overlap is not a strip."""
        ends = ("particles_begin", "continuum_ends")
        values = [[self.number(f"overlap_{end}_{axis}_m") for axis in "xy"] for end in ends]
        return None if any(v is None for end in values for v in end) else np.array(values)


class Checked(Folder):
    """The undeformed model that `coupler check --out` leaves."""

    @property
    def name(self):
        return self.scene.get("name") or self.folder.resolve().name

    def pieces(self):
        """{name: Piece} as the models wrote them: `grid`, `particles`, or `lining_grid` of the region `lining`."""
        files = self.files()
        if not files:
            raise Unusable(f"{self.folder} holds no fields: write them by coupler check SCENE --out {self.folder}.")
        return {name: _read(path, Piece) for name, path in files[0][1].items()}

    def members(self):
        """The models of the scene, grids and particles."""
        found = [Member("", kind, self.scene[kind], self.scene) for kind in ("continuum", "particles") if kind in self.scene]
        for region in self.scene.get("regions", []):
            kind = "continuum" if "continuum" in region else "particles"
            found.append(Member(region["name"], kind, region[kind], self.scene, len(found)))
        return found


class Member:
    """One model of a scene: its name (empty unless it is a region), its kind, its part of the scene."""

    def __init__(self, name, kind, model, scene, first_colour=0):
        self.model, self.first_colour = model, first_colour
        self.name = name
        self.piece = "_".join(filter(None, (name, "grid" if kind == "continuum" else kind)))  # that it is drawn by
        self.is_grid = kind == "continuum"
        self.own_material = model.get("material", scene.get("material", {}))

    @cached_property
    def mesh_groups(self):
        """The groups of its mesh (mesh_groups.py); none without a mesh."""
        path = self.model.get("mesh", {}).get("path")
        return _read(Path(path), mesh_groups.read) if path else {}

    def material(self, number):
        """What the material of this number is called in a legend."""
        if number == 0:
            return _called(self.name, self.own_material)
        area = self.model["materials"][number - 1]
        return _called(area.get("where", {}).get("group", ""), area["material"])

    def group(self, number):
        """What the group of particles of this number is called in a legend."""
        if number == 0:
            return _called(self.name, self.own_material)
        group = self.model["groups"][number - 1]
        return _called(group["name"], group.get("material", self.own_material))


LAWS = {"mohr_coulomb": "Mohr-Coulomb", "hysteretic": "hysteretic", "weak_plane": "weak plane"}


def _called(name, material):
    young = material.get("young_modulus")
    words = [name] if name else []
    if young:
        unit, size = ("GPa", 1e9) if young >= 1e9 else ("MPa", 1e6)
        words.append(f"E = {young / size:.4g} {unit}")
    words += [called for law, called in LAWS.items() if law in material]
    return ", ".join(words)


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
