"""The undeformed model that `coupler check --out` leaves: its pieces, and the names of its parts in a legend."""
from functools import cached_property
from pathlib import Path

from adit import Piece, Run, Unusable
from adit.results.files import read
from adit.plots.setup import mesh_groups


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
        return read(Path(path), mesh_groups.read) if path else {}

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


LAWS = {"mohr_coulomb": "Mohr-Coulomb", "hysteretic": "hysteretic", "weak_plane": "weak plane"}


def _called(name, material):
    young = material.get("young_modulus")
    words = [name] if name else []
    if young:
        unit, size = ("GPa", 1e9) if young >= 1e9 else ("MPa", 1e6)
        words.append(f"E = {young / size:.4g} {unit}")
    words += [called for law, called in LAWS.items() if law in material]
    return ", ".join(words)
