"""The scene with tunnels of particles, as differences to the scene as it was written."""
import copy

import numpy as np

from adit.results.files import Unusable
from adit.zoom.linings import material_of
from adit.zoom.places import ACROSS
from adit.zoom.scene import CELL_AREA, KEPT, begin, require_fine, size_of, softening_size

CELLS_IN_LINING = 4  # over its thickness, where no size is given
GROWTH = 0.25  # of the size of cells, by the distance from the lining
SHELLS = 400  # for the number of cells


def as_particles(run, zones, reach, breaks, share, size=None):
    """(what the scene states of the tunnel with a lining of cells, number of cells). `breaks`: as its cells would break; `size` of the
    lining's cells [m], which follows from lining, zones and materials where it is None."""
    tunnel, stated = reach.tunnel, copy.deepcopy(reach.tunnel.given)
    stated.pop("zones", None)
    material = material_of(breaks.layers[0][2])
    if "section" in tunnel.lining:
        stated["lining"]["section"].pop("elastic", None)
    else:
        stated["lining"]["material"] = {key: material[key] for key in KEPT if key in material}
    stated["lining"] |= {"as": "particles", "to_ground": {}}  # tied, by the weaker of both
    of_lining, of_ground = _sizes(run, zones, reach, material, size)
    stated["particles"] = {"size": of_lining, "ground": reach.ground, "overlap": reach.overlap}
    if of_ground > of_lining:
        stated["particles"]["ground_size"] = of_ground
    if "section" not in tunnel.lining and not any("time" in load for load in run.scene["continuum"].get("body_loads", [])):
        stated["particles"]["begin"] = begin(share)  # bars do not wait
    return stated, _count(reach, of_lining, of_ground)


def _sizes(run, zones, reach, material, size):
    """(of the lining's cells, of the ground's) [m]."""
    continuum, grid = run.scene["continuum"], run.fields()["grid"]
    materials = [continuum.get("material", run.scene.get("material")), *(area["material"] for area in continuum.get("materials", []))]
    numbers, own = grid["material"].astype(int), reach.tunnel.zones(run, grid)
    around = (reach.tunnel.contour.away(zones.centres) < reach.outer) & ~own
    of_ground = min(size_of(reach.overlap / ACROSS, materials[number]) for number in np.unique(numbers[around]))
    if size and size >= (1 - 1e-6) * reach.tunnel.thickness / 2:
        raise Unusable(f"--size {size:g} is not below half of the thickness of the lining of tunnel `{reach.tunnel.name}`, "
                       f"{reach.tunnel.thickness:g} m; give less.")
    require_fine(size, float(np.median(zones.shortest[around])), reach.tunnel.contour.centre)
    of_lining = size or min(reach.tunnel.thickness / CELLS_IN_LINING, softening_size(material), of_ground)
    return float(f"{of_lining:.3g}"), of_ground


def _count(reach, size, largest):
    """How many cells there will be: they grow with the distance from the lining. Before a stage they fill the opening too."""
    tunnel = reach.tunnel
    inner = -min(tunnel.contour.half, tunnel.contour.below) if tunnel.given.get("stage", 0) else 0
    offsets = np.linspace(inner, reach.outer, SHELLS)
    middles = (offsets[1:] + offsets[:-1]) / 2
    sizes = np.minimum(size + GROWTH * np.maximum(0, np.maximum(-middles, middles - tunnel.thickness)), max(size, largest))
    return float((np.diff([tunnel.contour.area(offset) for offset in offsets]) / sizes**2).sum() / CELL_AREA)


def without_lost(scene, found):
    """(what the scene states otherwise without the histories and sections that the particles of the Reaches take, [notes])."""
    continuum, notes, changes = scene["continuum"], [], {}
    rings = {name for reach in found for name, _, _ in reach.tunnel.rings}

    def lies_within(*places):
        points = np.array([[place.get("x", 0.0), place.get("y", 0.0)] for place in places if place])
        return len(points) and any(reach.within(points).any() for reach in found)

    cuts = [section["name"] for section in continuum.get("sections", []) if lies_within(section["from"], section["to"])]
    lost = [history for history in continuum.get("histories", []) if history.get("lining") in rings or history.get("section") in cuts
            or "lining" not in history and lies_within(history.get("at"), history.get("relative_to"))]
    if lost:
        changes["continuum"] = {"histories": [history for history in continuum["histories"] if not any(history is each for each in lost)]}
        notes += [f"the history `{history['name']}` of {history['quantity']} is left out: it lies among the particles of a tunnel, "
                  "which has its own histories" for history in lost]
    if cuts:
        changes.setdefault("continuum", {})["sections"] = [section for section in continuum["sections"] if section["name"] not in cuts]
        notes += [f"the section `{name}` is left out: it lies among the particles of a tunnel" for name in cuts]
    left = {history["name"] for history in (continuum | changes.get("continuum", {})).get("histories", [])}
    spectra = scene.get("output", {}).get("spectra", [])
    staying = [each for each in spectra if {each["history"], each.get("relative_to", each["history"])} <= left]
    if lost and len(staying) < len(spectra):
        changes["output"] = {"spectra": staying}
    return changes, notes
