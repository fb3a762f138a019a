"""The folder of a run for its report, also of a run that failed or was stopped."""
from functools import cached_property

import numpy as np

from adit import Run, Table, Unusable

OF_EVERY_MOTION = {"motion", "response", "fourier"}
NEEDED = {  # figures that mean nothing where the summary has 0 of what they count
    "bonds": ("crack_count", "debonded_count"), "coupling_points": ("multiplier_work_J", "coupler_solve_s")}


class Results(Run):
    """A run some of whose files may be missing or damaged: they are left out, and `faults` names them in sentences."""

    def __init__(self, folder):
        self.faults = []
        super().__init__(folder)

    summary = cached_property(lambda self: self._unless_damaged("summary", {}))
    scene = cached_property(lambda self: self._unless_damaged("scene", {}))
    instants = cached_property(lambda self: self._unless_damaged("instants", []))

    @cached_property
    def figures(self):
        """The figures of the summary that mean something for what was computed: no cracks where there are no bonds."""
        idle = {figure for needed, figures in NEEDED.items() if self.summary.get(needed) == 0 for figure in figures}
        if not self._has_groups_of_particles():
            idle.add("debonded_count")
        return {key: value for key, value in self.summary.items() if key not in idle}

    def _has_groups_of_particles(self):
        """Whether bonds could join two groups."""
        return any(model.get("groups") or "ring" in model for _, model in self.models)

    @cached_property
    def histories(self):
        found = self._unless_damaged("histories", None) if self.has("histories.csv") else None
        return found or Table({"time_s": np.array([])}, self.folder / "histories.csv")

    def table(self, name):
        """A table of the run; None if it is not there or damaged."""
        try:
            return super().table(name) if self.has(name) else None
        except Unusable as reason:
            self._note(reason)

    @cached_property
    def spectra(self):
        """Spectra of the motions whose tables can all be read."""
        found = {name: {what: table for what, table in tables.items() if table} for name, tables in super().spectra.items()}
        return {name: tables for name, tables in found.items() if OF_EVERY_MOTION <= tables.keys()}

    def pieces_at(self, number):
        """{kind: Piece} at the instant of this number; empty if a file of it is missing or damaged."""
        try:
            return super().pieces_at(number)
        except Unusable as reason:
            self._note(reason)
            return {}

    @cached_property
    def last_pieces(self):
        return self.pieces_at(-1) if self.instants else {}

    @property
    def reached(self):
        """The last time [s] in histories.csv; None if there is none."""
        times = self.histories["time_s"]
        return float(times[-1]) if len(times) else None

    def acted(self, key):
        """The number that acted where another one is stated by this key of the scene; None where the stated one did."""
        return next((each["acted"] for each in self.summary.get("stated", []) if each["key"] == key), None)

    def path_of(self, model):
        """Where a model stands in the scene: `continuum`, or `regions[1].continuum`."""
        for i, region in enumerate(self.scene.get("regions", [])):
            if region["name"] == model:
                return f"regions[{i}].{'continuum' if 'continuum' in region else 'particles'}"
        return model

    def _unless_damaged(self, name, otherwise):
        try:
            return getattr(super(), name)
        except Unusable as reason:
            self._note(reason)
            return otherwise

    def _note(self, reason):
        """The page names the folder, so its sentences do not."""
        self.faults.append(str(reason).replace(f"{self.folder}/", ""))
