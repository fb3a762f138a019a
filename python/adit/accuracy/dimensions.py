"""What of a scene can be made finer or coarser by itself.

A level of 0 is the scene as stated; each level more makes a dimension finer by two, each level less coarser by two. `refining` are
those that a search refines, because the results approach a limit with them; a step that is a share of the critical one
(`time.dt_factor`) follows both. The others are choices between models: finer zones and particles do not remove what they change.
"""
import math
from dataclasses import dataclass, field

from adit.accuracy.scene import collected, parts_of

COUNTS = ("zones", "zones_x", "zones_y")  # of zones along a side
RATIOS = ("ratio",)  # of the sizes of zones that follow one another
LENGTHS = ("size", "ground_size", "radius", "radius_min", "radius_max")  # of particles
PACKINGS = ("cells", "packing", "square_packing", "random_packing")
LININGS = ("beam", "zones", "particles")  # from the cheapest to the finest
STATED = "stated"
COLUMN_SPACING = 100.0  # where a whole tunnel's ground states none [m]
WHOLE_TUNNELS = {"beam": "chain", "chain": "beam"}  # the other model of each


@dataclass(frozen=True)
class Dimension:
    """`values`: {key as --set names it: value of the scene}; `power`: of two, by which a level more multiplies their distance from
    `origins` (0 where there is none); `whole`: whether they are whole numbers; `most`: their limit; `what`: a level more and a level less, in
    words."""
    name: str
    values: dict
    power: int
    what: tuple
    whole: bool = False
    most: float = float("inf")
    origins: dict = field(default_factory=dict)

    def words(self, level):
        return self.what[level < 0]

    def settings(self, level):
        """{key: text} of the scene at a level; None where a whole number would not be one any more, or a limit is passed."""
        origins = {key: self.origins.get(key, 0) for key in self.values}
        found = {key: origins[key] + (value - origins[key]) * 2.0**(self.power * level) for key, value in self.values.items()}
        if any(value > self.most or self.whole and (value < 1 or value != int(value)) for value in found.values()):
            return None
        return {key: f"{value:.12g}" for key, value in found.items()}


@dataclass(frozen=True)
class Zones(Dimension):
    """`ratios`: {key: of the sizes of neighbouring zones}. Their roots divide each zone in two: finer zones lie within the coarser.
    Numbers that cannot be halved are rounded up: the coarsest models need not be exact."""
    ratios: dict = field(default_factory=dict)

    def settings(self, level):
        counts = {key: f"{math.ceil(count * 2.0**level)}" for key, count in self.values.items()}
        return counts | {key: f"{ratio**(2.0**-level):.15g}" for key, ratio in self.ratios.items()}


@dataclass(frozen=True)
class Lining:
    """The model of the linings of tunnels: a level less leads to the next cheaper one, a level more to the next finer one. Particles
    cannot be added, because the scene does not say which."""
    name: str
    values: dict  # {path of a tunnel: model}
    what: tuple = ("a finer model", "a cheaper model")

    def words(self, level):
        return self.what[level < 0]

    def settings(self, level):
        found = {}
        for path, stated in self.values.items():
            place = LININGS.index(stated) + level
            if not 0 <= place < len(LININGS) or place > LININGS.index(stated) and LININGS[place] == "particles":
                return None
            found[f"{path}.lining.as"] = LININGS[place]
            if stated == "particles" and level:
                found[f"{path}.particles"] = "null"
        return found


@dataclass(frozen=True)
class Other:
    """Another value of keys, at level 1."""
    name: str
    values: dict  # {key as --set names it: text}
    what: str

    def words(self, level):
        return self.what

    def settings(self, level):
        return self.values if level == 1 else {} if level == 0 else None


def name_of(levels):
    """Of a run at levels of its dimensions, such as `zones_x2`."""
    return ",".join(f"{name}_x{2.0**level:g}" for name, level in levels.items() if level) or STATED


def settings_of(dimensions, levels):
    """{key: text} of the scene at levels of dimensions; None where it cannot be made so."""
    found = {}
    for dimension in dimensions:
        changed = dimension.settings(levels.get(dimension.name, 0)) if levels.get(dimension.name, 0) else {}
        if changed is None:
            return None
        found |= changed
    return found


def refining(scene):
    """[Dimension]: zones and particles, or elements of a whole tunnel and its columns of ground, where a scene, given as mappings and
    lists in SI units, states them."""
    zones, ratios, particles = {}, {}, {}
    for path, part in parts_of(scene):
        if path.endswith("continuum"):
            grids = {key: part[key] for key in ("block", "blocks") if key in part}
            zones |= collected(grids, path, COUNTS)
            ratios |= collected(grids, path, RATIOS)
        else:
            particles |= collected({key: part[key] for key in PACKINGS if key in part}, path, LENGTHS)
    for path, region in _tunnel_regions(scene):
        particles |= {f"{path}.{key}": region[key] for key in LENGTHS if key in region}
    whole = scene.get("simplified", {})
    elements = collected(whole.get("tunnel", {}), "simplified.tunnel", ("element_length",))
    columns = {"simplified.ground.column_spacing": whole["ground"].get("column_spacing", COLUMN_SPACING)} if "ground" in whole else {}
    for number, tunnel in enumerate(scene.get("tunnels", [])):
        zones |= collected(tunnel.get("zones", {}), f"tunnels[{number}].zones", ("across",))
    found = (Zones("zones", zones, 1, ("half as long zones", "zones twice as long"), ratios=ratios),
             Dimension("particles", particles, -1, ("half as large particles", "particles twice as large")),
             Dimension("elements", elements, -1, ("half as long elements", "elements twice as long")),
             Dimension("columns", columns, -1, ("columns half as far apart", "columns twice as far apart")))
    return [dimension for dimension in found if dimension.values]


def rest(scene):
    """[Dimension] of how near to rest a scene with statics comes; an eighth of the unbalanced force a level."""
    ratio = scene["statics"].get("unbalanced_ratio", 1e-5) if "statics" in scene else None
    return [Dimension("rest", {"statics.unbalanced_ratio": ratio}, -3, ("nearer to rest", "farther from rest"))] if ratio else []


def _way_to_rest(scene):
    """[Other]: ground that yields remembers how it came to rest."""
    if "statics" not in scene:
        return []
    damping = "adaptive" if scene["statics"].get("damping", "kinetic") == "kinetic" else "kinetic"
    return [Other("damping", {"statics.damping": damping}, f"{damping} damping of the statics")]


def choices(scene):
    """[Dimension, Lining or Other] of the choices between models that a scene states."""
    time = scene.get("time", {})
    joins = [("interface", scene.get("interface", {}))] + [(f"interfaces[{n}]", each) for n, each in enumerate(scene.get("interfaces", []))]
    regions = _tunnel_regions(scene)
    coupled = regions or any(join for _, join in joins)
    widths = {f"{path}.overlap.width": join["overlap"]["width"] for path, join in joins if "width" in join.get("overlap", {})}
    widths |= {f"{path}.overlap": region["overlap"] for path, region in regions}
    strips = [(f"{path}.overlap", join["overlap"]) for path, join in joins if "continuum_ends" in join.get("overlap", {})]
    begins = {f"{path}.continuum_ends.{axis}": value for path, strip in strips for axis, value in strip["particles_begin"].items()}
    ends = {f"{path}.continuum_ends.{axis}": value for path, strip in strips for axis, value in strip["continuum_ends"].items()}
    found = [
        _step(time, "simplified" in scene),
        Dimension("substeps", {"time.substeps": time.get("substeps", 1)} if coupled and time.get("substeps", 1) else {}, -1,
                  ("half of them", "twice as many"), whole=True),
        Dimension("overlap", widths | ends, 1, ("twice as wide", "half as wide"), origins=begins),
        Dimension("reach", {f"{path}.ground": region["ground"] for path, region in regions}, 1, ("twice as far", "half as far"))]
    linings = {f"tunnels[{n}]": tunnel["lining"].get("as", "particles") for n, tunnel in enumerate(scene.get("tunnels", []))}
    model = scene.get("simplified", {}).get("model")
    other = [Other("model", {"simplified.model": WHOLE_TUNNELS[model]}, f"the {WHOLE_TUNNELS[model]}")] if model in WHOLE_TUNNELS else []
    return [dimension for dimension in found if dimension.values] + ([Lining("lining", linings)] if linings else []) + other + _way_to_rest(scene)


def _step(time, implicit):
    """An explicit step that is stated in seconds is limited by the size of zones and particles, which is not told here."""
    words = ("half of it", "twice as long a step")
    if implicit:
        return Dimension("step", {"time.dt": time["dt"]} if "dt" in time else {}, -1, words)
    return Dimension("step", {} if "dt" in time else {"time.dt_factor": time.get("dt_factor", 0.5)}, -1, words, most=1.0)


def _tunnel_regions(scene):
    return [(f"tunnels[{number}].particles", tunnel["particles"]) for number, tunnel in enumerate(scene.get("tunnels", [])) if "particles" in tunnel]
