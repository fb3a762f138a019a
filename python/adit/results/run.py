"""The folder of a run."""
import json
import re
from functools import cached_property
from pathlib import Path

import numpy as np
import yaml

from adit.results import chains
from adit.results.files import Unusable, nearest, read
from adit.results.pieces import Fields, Piece, read_collection
from adit.results.tables import Table, read_table

NEAR = 0.05  # share of the time between two instants: fields are written at whole time steps, not at the exact stated time


class Run:
    """The results in a folder, read at first use. Run(folder) refuses a folder that is not that of a run."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.name = self.folder.resolve().name
        if not any(self.has(name) for name in ("scene.yaml", "summary.json")):
            raise Unusable(f"{self.folder} is not the folder of a run: it holds neither scene.yaml nor summary.json.")

    def has(self, name):
        """Whether the run has written this file."""
        return (self.folder / name).exists()

    @cached_property
    def summary(self):
        """The figures of summary.json by name; empty before the run has ended."""
        return self._read("summary.json", lambda path: _mapping(json.loads(path.read_text()))) if self.has("summary.json") else {}

    @property
    def completed(self):
        """Whether the whole duration was computed."""
        return bool(self.summary.get("completed"))

    @cached_property
    def scene(self):
        """The scene as it was computed, as mappings and lists in SI units."""
        return self._read("scene.yaml", lambda path: _mapping(yaml.load(path.read_text(), SceneLoader)))

    @cached_property
    def scene_as_written(self):
        """The scene as it was before its `tunnels` became grids, linings and particles."""
        name = "scene_as_written.yaml"
        return self._read(name, lambda path: _mapping(yaml.load(path.read_text(), SceneLoader))) if self.has(name) else self.scene

    @property
    def duration(self):
        """The duration [s] of the scene."""
        return float(self.scene["time"]["duration"])

    @cached_property
    def models(self):
        """[(name, part of the scene)] of the continuum, the particles and the regions."""
        own = [(name, self.scene[name]) for name in ("continuum", "particles") if name in self.scene]
        regions = [(region["name"], region.get("continuum") or region.get("particles") or {})
                   for region in self.scene.get("regions", [])]
        return own + regions

    @cached_property
    def is_simplified(self):
        """Whether it is a run of `simplified`: a whole tunnel along its axis."""
        return "model" in self.summary if self.summary else "simplified" in self.scene

    @cached_property
    def histories(self):
        """The Table of histories over "time_s"."""
        return self._read("histories.csv", _over_time) if self.has("histories.csv") else self.table("histories.csv")

    @cached_property
    def energies(self):
        """The Table of energies over "time_s": those of every model, their drift, and where the general particle engine ran,
        what each cause took."""
        ledger = {name: values for name, values in self.histories.items() if name.endswith("_J")}
        if not ledger:
            raise Unusable(f"{self.folder} has no energies over time: only runs of `coupler` write them.")
        columns = {name: self.histories[name] for name in ("time_s", *ledger, "energy_drift")}
        if self.has("energies.csv"):
            columns = self.table("energies.csv") | columns
        rows = min(map(len, columns.values()))  # a run that was killed may have written one of the files farther
        return Table({name: values[:rows] for name, values in columns.items()}, self.folder / "energies")

    @cached_property
    def cracks(self):
        """The Table of broken bonds in the order of time; only runs with particles have one."""
        return self.table("cracks.csv")

    @cached_property
    def crack_paths(self):
        """The Table of cracks between cells, joined to paths where they meet, the longest first; only runs with such cracks have one."""
        return self.table("crack_paths.csv")

    @cached_property
    def capacities(self):
        """{(kind, name): array of thrust [N] and moment [Nm]} of linings, members and sections of reinforced concrete: the limit
        states in order around the origin; per metre, of a member for the whole of it."""
        if not self.has("capacities.csv"):
            return {}
        rows = self.table("capacities.csv")
        states = np.column_stack((rows["thrust_N"], rows["moment_Nm"]))
        of = list(zip(rows["kind"].astype(str), rows["name"].astype(str)))
        return {each: states[[other == each for other in of]] for each in dict.fromkeys(of)}

    def debonded(self, broken):
        """Whether each bond of the Table of broken bonds joined two groups; the others are cracks inside one body."""
        groups = {name for key, names in self.summary.items() if key.endswith("_groups") for name in names}
        groups |= {group["name"] for _, model in self.models for group in model.get("groups", [])}
        return np.array(["-" in group and group not in groups for group in broken["group"].astype(str)], dtype=bool)

    def table(self, name):
        """The Table in a CSV file of the run, such as "envelopes.csv" of a whole tunnel."""
        if not self.has(name):
            there = sorted(path.relative_to(self.folder).as_posix() for path in self.folder.rglob("*.csv"))
            raise Unusable(f"{self.folder} has no {name}; {nearest(name, there)}")
        return self._read(name, read_table)

    @cached_property
    def spectra(self):
        """{motion: {what: Table}} of `output.spectra`. What: motion, response, fourier; input and reference, motion and
        response of what it came from; transfer, the amplification."""
        found = {}
        for path in sorted((self.folder / "spectra").glob("*.csv")):
            motion, _, what = path.stem.rpartition("_")
            found.setdefault(motion, {})[what] = self.table(path.relative_to(self.folder).as_posix())
        return found

    @cached_property
    def instants(self):
        """[(time [s], {name of a piece: file})] of the fields, in the order of time."""
        return self._read("fields/fields.pvd", read_collection) if self.has("fields/fields.pvd") else []

    @property
    def times(self):
        """The times [s] at which fields were written."""
        return np.array([time for time, _ in self.instants])

    def fields(self, time=None):
        """{kind: Piece} at a time [s] of `times`, the last where none is given. Kinds: grid, particles, bonds, contacts,
        linings, bolts, springs, … Pieces of several regions are joined."""
        return self.pieces_at(self.instant_at(time))

    def lining(self, name, time=None):
        """The Table of a lining at a time [s] of `times`, the last where none is given: x_m, y_m, angle_deg about its middle, and
        the fields of its nodes along its path, such as thrust_N, moment_Nm, peak_least_thrust_N."""
        return chains.table(self, self.fields(time)["linings"], name)

    def member(self, name, time=None):
        """The same of a member: a column, strut, slab or wall."""
        return chains.table(self, self.fields(time)["members"], name, "member")

    def snapshots(self):
        """Yields (time [s], fields) of all instants."""
        for number, (time, _) in enumerate(self.instants):
            yield time, self.pieces_at(number)

    def pieces_at(self, number):
        """{kind: Piece} at the instant of this number."""
        return self.pieces_of(self.instants[number][1])

    @staticmethod
    def pieces_of(files):
        """{kind: Piece} of one instant."""
        kinds = {}
        for name, path in files.items():  # `grid`, or `lining_grid` of the region `lining`
            kinds.setdefault(name.rpartition("_")[2], []).append(read(path, Piece))
        return Fields({kind: Piece.joined(pieces) for kind, pieces in kinds.items()})

    def number(self, name):
        """A number of the summary; None if the run does not have it (null or absent)."""
        value = self.summary.get(name)
        return float(value) if isinstance(value, (int, float)) else None

    def overlap(self):
        """The points [m] at which particles begin and the continuum ends; None if the overlap is not a strip."""
        ends = ("particles_begin", "continuum_ends")
        values = [[self.number(f"overlap_{end}_{axis}_m") for axis in "xy"] for end in ends]
        return None if any(v is None for end in values for v in end) else np.array(values)

    def _read(self, name, reader):
        return read(self.folder / name, reader)

    def instant_at(self, time=None):
        """The number of the instant of this time [s], -1 where none is given."""
        times = self.times
        if not len(times):
            raise Unusable(f"{self.folder} holds no fields: ask for them by output.field_times, and let the run reach them.")
        if time is None:
            return -1
        number = int(np.argmin(np.abs(times - time)))
        apart = np.diff(times).min() if len(times) > 1 else times[0]
        if abs(times[number] - time) > NEAR * apart:
            raise Unusable(f"{self.folder} has no fields at {time:g} s; they were written at "
                           f"{', '.join(f'{each:.6g}' for each in times)} s.")
        return number


def _mapping(contents):
    if not isinstance(contents, dict):
        raise TypeError("it holds no names with values")
    return contents


def _over_time(path):
    """A table whose columns are numbers, the times among them."""
    table = read_table(path)
    wrong = next((name for name in ("time_s", *table) if name not in table or table[name].dtype.kind != "f"), None)
    if wrong is not None:
        raise ValueError(f"its column {wrong} holds no numbers")
    return table


class SceneLoader(yaml.SafeLoader):
    """Reads 3e+10 as a number, and `on`, `off`, `yes` and `no` as texts, as YAML 1.2 does and PyYAML does not."""

    yaml_implicit_resolvers = {
        letter: [(tag, pattern) for tag, pattern in resolvers if tag != "tag:yaml.org,2002:bool"]
        for letter, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()}


SceneLoader.add_implicit_resolver("tag:yaml.org,2002:float", re.compile(r"[-+]?\d+(\.\d*)?e[-+]?\d+$"), list("-+0123456789"))
SceneLoader.add_implicit_resolver("tag:yaml.org,2002:bool", re.compile(r"(true|True|TRUE|false|False|FALSE)$"), list("tTfF"))
