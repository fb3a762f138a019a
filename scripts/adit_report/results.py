"""The folder of a run for its report, also of a run that failed or was stopped."""
import json
from functools import cached_property

import numpy as np

from adit_plots import tunnel_pictures
from adit_plots.run_folder import Folder, Run, Unusable, read_columns

NO_TIME = {"time_s": np.array([])}


class Results(Run):
    """A run some of whose files may be missing or damaged."""

    def __init__(self, folder):
        Folder.__init__(self, folder)
        if not (self.folder / "scene.yaml").exists() and not (self.folder / "summary.json").exists():
            raise Unusable(f"{self.folder} is not the folder of a run: it holds neither scene.yaml nor summary.json.")
        self.name = self.folder.resolve().name
        self.faults = []  # what cannot be read, in sentences
        self.summary = self._found("summary.json", lambda path: json.loads(path.read_text())) or {}
        self.histories = self.table("histories.csv") or NO_TIME

    def table(self, name):
        """A table of the run; None if it is not there or damaged."""
        return self._found(name, read_columns)

    def _found(self, name, reader):
        path = self.folder / name
        try:
            return reader(path) if path.exists() else None
        except Exception as error:  # a damaged file can cause any error; the report is about what can be read
            self.faults.append(f"{name} is damaged and left out ({type(error).__name__}).")
            return None

    @cached_property
    def given(self):
        """The scene as mappings and lists; empty if it cannot be read."""
        try:
            return self.scene
        except Unusable as reason:
            self.faults.append(str(reason))
            return {}

    @cached_property
    def is_tunnel(self):
        return tunnel_pictures.is_tunnel(self) or "simplified" in self.given

    @cached_property
    def models(self):
        """[(name, part of the scene)] of the continuum, the particles and the regions."""
        own = [(name, self.given[name]) for name in ("continuum", "particles") if name in self.given]
        regions = [(region["name"], region.get("continuum") or region.get("particles") or {})
                   for region in self.given.get("regions", [])]
        return own + regions

    @cached_property
    def instants(self):
        """[(time [s], files)] of the fields that were written; none if their list is damaged."""
        return self._found("fields/fields.pvd", lambda path: self.files()) or []

    def pieces_at(self, number):
        """{kind: Piece} at the instant of this number; empty if a file of it is missing or damaged."""
        _, files = self.instants[number]
        try:
            return self.pieces_of(files)
        except Unusable as reason:
            self.faults.append(str(reason))
            return {}

    @cached_property
    def last_pieces(self):
        return self.pieces_at(-1) if self.instants else {}

    @property
    def reached(self):
        """The last time [s] in histories.csv; None if there is none."""
        times = self.histories["time_s"]
        return float(times[-1]) if len(times) else None
