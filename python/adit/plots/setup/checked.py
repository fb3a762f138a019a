"""The undeformed model that `coupler check --out` leaves: its pieces, and the names of its parts in a legend."""
from pathlib import Path

import numpy as np

from adit import Piece, Run, Unusable
from adit.results.files import read
from adit.plots.setup import mesh_groups
from adit.plots.setup.areas import Group, inside


class Checked(Run):
    """The undeformed model that `coupler check --out` leaves, or a run at its first instant."""

    def __init__(self, folder):
        super().__init__(folder)
        self.name = self.scene.get("name") or self.name

    def pieces(self):
        """{name: Piece} as the models wrote them: `grid`, `particles`, or `lining_grid` of the region `lining`."""
        if not self.instants:
            raise Unusable(f"{self.folder} holds no fields: write them by coupler check SCENE --out {self.folder}.")
        return {name: read(path, Piece) for name, path in self.instants[0][1].items()}

    def members(self):
        """The models of the scene, grids and particles."""
        found = [Member("", kind, self.scene[kind], self.scene) for kind in ("continuum", "particles") if kind in self.scene]
        for region in self.scene.get("regions", []):
            kind = "continuum" if "continuum" in region else "particles"
            used = sum(member.colours for member in found if member.is_grid == (kind == "continuum"))
            found.append(Member(region["name"], kind, region[kind], self.scene, used))
        return found


class Member:
    """One model of a scene: its name (empty unless it is a region), its kind, its part of the scene."""

    def __init__(self, name, kind, model, scene, first_colour=0):
        self.model, self.first_colour = model, first_colour
        self.name = name
        self.piece = self.called("grid" if kind == "continuum" else kind)  # that it is drawn by
        self.is_grid = kind == "continuum"
        self.colours = 1 + len(model.get("materials" if self.is_grid else "groups", []))
        self.own_material = model.get("material", scene.get("material", {}))

    def called(self, kind):
        """The name of its piece of a kind, such as `linings` or `west_springs`."""
        return "_".join(filter(None, (self.name, kind)))

    def zone_groups(self, grid):
        """{name: Group} of the groups that areas may name: those of its mesh, or its named blocks."""
        path = self.model.get("mesh", {}).get("path")
        if path:
            return read(Path(path), mesh_groups.read)
        number, corners = grid.field("group"), grid.points[grid.cells]
        names = dict.fromkeys(block["name"] for block in self.model.get("blocks", []) if "name" in block)
        return {name: Group(corners[number == k]) for k, name in enumerate(names, 1)}

    def particle_groups(self, discs):
        """The number of the group of each particle when all stages have begun."""
        number = np.asarray(discs.field("group", np.zeros(len(discs.points))), int)
        found = number.copy()
        for k, group in enumerate(self.model.get("groups", []), 1):  # the last one that selects a particle has it
            found[inside(group["where"], discs.points) if group.get("stage") and "where" in group else number == k] = k
        return found

    def stage_of_group(self, number):
        """The stage in which the group of particles of this number is installed; 0 where it was always there."""
        groups = self.model.get("groups", [])
        return groups[number - 1].get("stage", 0) if 0 < number <= len(groups) else 0

    def material(self, number):
        """The name of the material of this number in a legend."""
        if number == 0:
            return _called(self.name, self.own_material)
        area = self.model["materials"][number - 1]
        return _called(area.get("where", {}).get("group", ""), area["material"])

    def group(self, number):
        """The name of the group of particles of this number in a legend."""
        if number == 0:
            return _called(self.name, self.own_material)
        group = self.model["groups"][number - 1]
        return _called(group["name"], group.get("material", self.own_material))


def in_stages(parts):
    """The end of a name in a legend that tells when these parts of the scene are installed; empty where they were always there."""
    stages = sorted({part.get("stage", 0) for part in parts})
    if not any(stages):
        return ""
    return f", stage {stages[0]}" if len(stages) == 1 else f", stages {', '.join(map(str, stages[:-1]))} and {stages[-1]}"


LAWS = {"mohr_coulomb": "Mohr-Coulomb", "hysteretic": "hysteretic", "weak_plane": "weak plane"}


def _called(name, material):
    young = material.get("young_modulus")
    words = [name] if name else []
    if young:
        unit, size = ("GPa", 1e9) if young >= 1e9 else ("MPa", 1e6)
        words.append(f"E = {young / size:.4g} {unit}")
    words += [called for law, called in LAWS.items() if law in material]
    return ", ".join(words)
