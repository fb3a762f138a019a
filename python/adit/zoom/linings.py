"""Linings of `tunnels` that stand in the grid, and how much of their strength a run used."""
from dataclasses import dataclass
from functools import cached_property
import shlex
from pathlib import Path

import numpy as np

from adit.accuracy import scene as scenes
from adit.results import chains
from adit.results.files import Unusable
from adit.zoom.contours import Contour

USED = ("utilisation", "shear_utilisation")  # of a reinforced section
PROBE = "{size: 1, ground: 2, overlap: 1}"  # any particles: with cells a class of concrete states how it breaks


@dataclass
class Tunnel:
    """One of `tunnels`: its number, and what the scene states of it."""
    number: int
    given: dict

    @property
    def name(self):
        return self.given.get("name", "tunnel")

    @property
    def lining(self):
        return self.given["lining"]

    @property
    def path(self):
        return f"tunnels[{self.number}]"

    @property
    def of_beams(self):
        return self.lining.get("as") == "beam"

    @cached_property
    def contour(self):
        return Contour(self.given)

    @property
    def layers(self):
        """[(name in results, path, what the scene states)]."""
        if "layers" not in self.lining:
            return [(self.name, f"{self.path}.lining", self.lining)]
        return [(f"{self.name}_{layer['name']}", f"{self.path}.lining.layers[{k}]", layer) for k, layer in enumerate(self.lining["layers"])]

    @property
    def thickness(self):
        """Of all layers [m]."""
        return sum(thickness_of(layer) for _, _, layer in self.layers)

    @property
    def rings(self):
        """The same of its linings of beams, a second ring included."""
        rings = ("", "_second") if "second_ring" in self.lining else ("",)
        return [(name + ring, *layer) for name, *layer in self.layers for ring in rings]

    def zones(self, run, grid):
        """Flags of the zones of its lining."""
        groups = [name in {each for each, _, _ in self.layers} for name in run.summary.get("continuum_groups", [])]
        return np.array(groups, bool)[grid["group"].astype(int)] & (not self.of_beams) if any(groups) else np.zeros(len(grid.cells), bool)


def thickness_of(layer):
    return layer.get("section", layer)["thickness"]


@dataclass
class Use:
    """The largest share of its strength that a part used, and where."""
    demand: float
    x: float
    y: float

    @classmethod
    def of(cls, zones, demand):
        """The largest of zones."""
        return cls(demand.max(), *zones.centres[demand.argmax()])

    def __str__(self):
        return f"{self.demand:.3g} of its strength at ({self.x:.4g}, {self.y:.4g}) m"


def in_grid(run):
    """The Tunnels of a scene in which one has a lining of beams or a reinforced section, or is excavated in a stage. Other linings of zones
    are ground of another material, which places of cells take over."""
    tunnels = [Tunnel(number, given) for number, given in enumerate(run.scene_as_written.get("tunnels", []))]
    return tunnels if any(tunnel.of_beams or "section" in tunnel.lining or tunnel.given.get("stage", 0) for tunnel in tunnels) else []


def has_stages(run):
    """Whether zones are excavated in stages."""
    return any(excavation.get("stage", 0) for excavation in run.scene["continuum"].get("excavations", []))


def breaking(run, tunnels):
    """{number of a tunnel: the tunnel as its cells would break}: with the `material` of the concrete of each layer, and its `fracture`.
    Only the files of the scene know the class of a lining of beams without a section."""
    by_class = [tunnel for tunnel in tunnels if tunnel.of_beams and any("section" not in layer for _, _, layer in tunnel.layers)]
    settings = []
    for tunnel in tunnels:
        settings += ["--set", f"{tunnel.path}.particles={PROBE}"]
        for _, path, layer in tunnel.layers:
            if name := layer.get("section", {}).get("concrete", {}).get("class"):
                settings += ["--set", f"{path}.material={{concrete: {name}}}"]
    if by_class:
        source, sets = source_of(run)
        read = scenes.read(source, sets + settings)
    else:
        read = scenes.read(run.folder / "scene_as_written.yaml", settings)
    return {tunnel.number: Tunnel(tunnel.number, read["tunnels"][tunnel.number]) for tunnel in tunnels}


def source_of(run):
    """(file, options) of the scene that was computed, which must be what it was."""
    source = Path(run.summary["folder"]) / next(iter(run.summary["inputs"]))
    sets = scenes.sets_of(shlex.split(run.summary["command"]))
    if not source.exists():
        raise Unusable(f"{source}, the scene of {run.folder}, is gone, and only it states the class of concrete of the linings; "
                       "bring it back.")
    ours = {key: part for key, part in scenes.read(source, sets).items() if key != "name"}
    if ours != {key: part for key, part in run.scene_as_written.items() if key != "name"}:
        raise Unusable(f"{source}, the scene of {run.folder}, or what it extends has changed since; run it again.")
    return source, sets


def material_of(layer):
    """Of the concrete of a layer, with its strength [Pa] where the scene states one; `layer` as cells would have it."""
    stated = layer.get("section", {}).get("concrete", {})
    if "compressive_strength" not in stated:
        return layer.get("material", {})
    energy = 73 * (stated["compressive_strength"] / 1e6)**0.18  # fib Model Code 2010, eq. 5.1-9
    return {"young_modulus": stated["young_modulus"], "poisson_ratio": 0.2, "fracture": {"fracture_energy": energy} | {
        key: stated[key] for key in ("tensile_strength", "compressive_strength")}}


def used(run, tunnel, breaks, grid):
    """The largest Use of a Tunnel's lining; `breaks`: as its cells would break."""
    uses = [use for ring in breaks.rings for use in _in_beams(run, *ring)] if tunnel.of_beams else _in_zones(run, tunnel, grid)
    return max(uses, key=lambda use: use.demand)


def _in_beams(run, name, path, layer):
    if f"lining_{name}_largest_utilisation" in run.summary:
        for kind in USED:
            yield Use(*(run.summary[f"lining_{name}_largest_{kind}{of}"] for of in ("", "_x_m", "_y_m")))
        return
    fracture = material_of(layer).get("fracture")
    if not fracture:
        raise Unusable(f"{run.folder}: {path}.material states no strength to compare with; give it a class of `concrete`, "
                       "or the lining a `section`.")
    nodes = chains.table(run, run.fields()["linings"], name)
    demand = edge_demand(nodes, thickness_of(layer), fracture)
    worst = demand.argmax()
    yield Use(demand[worst], nodes["x_m"][worst], nodes["y_m"][worst])


def edge_demand(nodes, thickness, fracture):
    """Of a rectangle, N/t +- 6 M/t^2 over the strengths, per metre: as if the peaks of thrust and moment came together, on the
    safe side."""
    bending = 6 / thickness**2 * np.maximum(np.abs(nodes["peak_largest_moment_Nm"]), np.abs(nodes["peak_least_moment_Nm"]))
    return np.maximum((nodes["peak_largest_thrust_N"] / thickness + bending) / fracture["tensile_strength"],
                      (bending - nodes["peak_least_thrust_N"] / thickness) / fracture["compressive_strength"])


def _in_zones(run, tunnel, grid):
    """By the strength of the zones, and by what sections across them tell."""
    own, demand = tunnel.zones(run, grid), grid.field("peak_demand", np.zeros(len(grid.cells)))
    columns = [(f"{section['name']}_utilisation", section["from"]) for section in run.scene["continuum"].get("sections", [])
               if section["name"].startswith(f"{tunnel.name}_")]
    uses = [Use(run.histories[column].max(), place["x"], place["y"]) for column, place in columns if column in run.histories]
    if not uses and not demand[own].any():
        raise Unusable(f"{run.folder}: {tunnel.path}.lining states no strength to compare with; give its material a class of `concrete`, "
                       "or its section bars and the tunnel `sections`.")
    worst = np.where(own, demand, -1).argmax()
    return [*uses, Use(demand[worst], *grid.points[grid.cells[worst]].mean(axis=0))]
