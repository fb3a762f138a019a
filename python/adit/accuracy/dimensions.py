"""What of a scene can be made finer or coarser by itself: the zones of continua, the particles.

A level of 0 is the scene as stated; each level more halves lengths, each level less doubles them. The step follows: it is a share of
the critical one (`time.dt_factor`).
"""
from dataclasses import dataclass

COUNTS = ("zones", "zones_x", "zones_y")  # of zones along a side
LENGTHS = ("size", "ground_size", "radius", "radius_min", "radius_max")  # of particles
PACKINGS = ("cells", "packing", "square_packing", "random_packing", "finer")


@dataclass(frozen=True)
class Dimension:
    """`values`: {key as --set names it: value of the scene}."""
    name: str
    values: dict

    def settings(self, level):
        """{key: text} of the scene at a level; None where a number of zones cannot be halved any more."""
        found = {key: value * 2**level if self.name == "zones" else value / 2**level for key, value in self.values.items()}
        if any(isinstance(self.values[key], int) and (value < 1 or value != int(value)) for key, value in found.items()):
            return None
        return {key: f"{int(value)}" if isinstance(self.values[key], int) else f"{value:.12g}" for key, value in found.items()}


def name_of(levels):
    """Of a run at levels of its dimensions, such as `zones_x2`."""
    return ",".join(f"{name}_x{2.0**level:g}" for name, level in levels.items() if level) or "stated"


def dimensions_of(scene):
    """[Dimension] of a scene, given as mappings and lists in SI units, that has any."""
    zones, particles = {}, {}
    parts = [("continuum", scene.get("continuum")), ("particles", scene.get("particles"))]
    for number, region in enumerate(scene.get("regions", [])):
        parts += [(f"regions[{number}].{kind}", region.get(kind)) for kind in ("continuum", "particles")]
    for path, part in parts:
        if part is None:
            continue
        if path.endswith("continuum"):
            grids = {key: part[key] for key in ("block", "blocks") if key in part}
            _collect(grids, path, COUNTS, zones)
        else:
            _collect({key: part[key] for key in PACKINGS if key in part}, path, LENGTHS, particles)
    for number, tunnel in enumerate(scene.get("tunnels", [])):
        region = tunnel.get("particles", {})
        particles |= {f"tunnels[{number}].particles.{key}": region[key] for key in LENGTHS if key in region}
    return [Dimension(name, values) for name, values in (("zones", zones), ("particles", particles)) if values]


def _collect(part, path, names, found):
    for key, value in part.items():
        here = f"{path}.{key}"
        if key in names and isinstance(value, (int, float)):
            found[here] = value
        elif isinstance(value, dict) and key != "where":
            _collect(value, here, names, found)
        elif isinstance(value, list):
            for number, each in enumerate(value):
                if isinstance(each, dict):
                    _collect(each, f"{here}[{number}]", names, found)
