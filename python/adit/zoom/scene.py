"""The coupled scene, as differences to the scene of the continuum."""
import numpy as np

from adit.results.files import Unusable
from adit.zoom.outlines import loops

CELLS_IN_ZONE = (2, 8)  # along a side, where no size is given: as few as soften stably
SOFTENING = 0.25  # of the length E' G_f / f_t^2: larger facets snap (docs/cells.md)
CELL_AREA = 0.866  # of a cell, over its size squared
ALIKE = 0.8  # sizes from which on cells need not be finer in a part
ROUND = 10  # digits of places
KEPT = ("young_modulus", "poisson_ratio", "density", "fracture")  # of a material, by cells
MOTIONS = ("displacement_x", "displacement_y", "velocity_x", "velocity_y", "acceleration_x", "acceleration_y")
MEANS = ("stress_xx", "stress_yy", "stress_xy")
CIRCLE = 3  # cells in the radius of a mean
MOST = 1.0  # demand at which particles may begin: what waits is elastic


def differences(run, zones, found, share, size=None, histories=None):
    """(mapping of the differences, [number of cells of each place], [notes]) for the Places found, which wait until their demand reaches
    `share`; `size` of the cells [m], which follows from zones and materials where it is None. `histories`: of the continuum, beside tunnels
    of particles, where the places become regions; those of the run where it is None."""
    continuum, notes = run.scene["continuum"], []
    alone, all_histories = histories is None, continuum.get("histories", []) if histories is None else histories
    materials = [continuum.get("material", run.scene.get("material")), *(area["material"] for area in continuum.get("materials", []))]
    numbers = run.fields()["grid"]["material"].astype(int)
    models, rings, counts = [], [], []
    left = list(all_histories)
    for place in found:
        model, count = _particles(zones, place, size, numbers, materials)
        loads = continuum.get("body_loads", [])
        if loads:
            model["body_loads"] = loads
        if not any("time" in load for load in loads):
            model["begin"] = begin(share)
        moved = [(history, _as_of_particles(history, zones, place, model["cells"]["size"], notes)) for history in left if _lies_in(history, zones, place)]
        if going := [other for _, other in moved if other]:
            model["histories"] = going
        left = [history for history in left if all(history is not other for other, _ in moved)]
        models.append(model)
        counts.append(count)
        around = next(loop for loop in loops(zones, place.core) if loop.outer)
        rings.append({"overlap": {"around": {"polygon": {"corners": _corners(around)}}, "width": float(f"{place.width:.6g}")}, "solve": "split"})
    told = {"time": {"dt": None}} if "dt" in run.scene["time"] else {}
    if left != all_histories:
        told["continuum"] = {"histories": left}
    if len(models) == 1 and alone:
        return told | {"particles": models[0], "interface": rings[0]}, counts, notes
    names = [f"place_{number}" for number in range(1, len(models) + 1)]
    return told | {"regions": [{"name": name, "particles": model} for name, model in zip(names, models)],
                   "interfaces": [ring | {"inner": name} for name, ring in zip(names, rings)]}, counts, notes


def begin(share):
    """When particles begin that are needed where the demand reached `share`: before anything breaks."""
    return {"demand": min(share, MOST)}


def _particles(zones, place, size, numbers, materials):
    """(the model, how many cells it will have)."""
    here, count = np.unique(numbers[place.filled], return_counts=True)
    most = here[count.argmax()]

    def shorter(chosen):
        return float(np.median(zones.shortest[chosen]))

    require_fine(size, shorter(place.filled), zones.centres[place.core].mean(axis=0))
    whole = size or size_of(shorter(place.filled & (numbers == most)), materials[most])
    groups, finer, sizes = [], [], np.full(len(numbers), whole)
    for number in here[here != most]:
        for piece in zones.pieces(place.filled & (numbers == number)):
            area = _area(zones, piece)
            groups.append({"name": f"ground_{len(groups) + 1}", "where": area, "material": _of_cells(materials[number])})
            own = size or size_of(shorter(piece), materials[number])
            if own < ALIKE * whole:
                sizes[piece] = own
                finer.append({"where": area, "size": own})
    corners = zones.points[np.unique(zones.cells[place.filled])]
    (x_min, y_min), (x_max, y_max) = corners.min(axis=0) - 2 * whole, corners.max(axis=0) + 2 * whole
    packing = {"x_min": _told(x_min), "x_max": _told(x_max), "y_min": _told(y_min), "y_max": _told(y_max), "size": whole}
    model = {"cells": packing | ({"finer": finer} if finer else {}), "within": _area(zones, place.filled), "material": _of_cells(materials[most])}
    return model | ({"groups": groups} if groups else {}), float((zones.areas / sizes**2)[place.filled].sum() / CELL_AREA)


def require_fine(size, side, place):
    """Unusable where cells of a size that is given, if one is, would be larger than the zones that they replace."""
    if size and size > (1 + 1e-6) * side:
        raise Unusable(f"--size {size:g} is above {side:.3g} m, the shorter side of the zones around ({place[0]:.4g}, {place[1]:.4g}) m "
                       "that become particles; give less.")


def size_of(side, material):
    """Of cells that are smaller than zones with this side, and soften stably as far as that many in it allow [m]."""
    largest, least = (side / count for count in CELLS_IN_ZONE)
    return float(f"{max(min(largest, softening_size(material)), least):.3g}")


def softening_size(material):
    """The largest size of cells that soften stably [m]; infinite where they do not break."""
    if "fracture" not in material:
        return np.inf
    fracture, stiffness = material["fracture"], material["young_modulus"] / (1 + material["poisson_ratio"])
    return 0.995 * SOFTENING * stiffness * fracture["fracture_energy"] / fracture["tensile_strength"] ** 2


def _area(zones, chosen):
    outer, *holes = loops(zones, chosen)
    return {"polygon": {"corners": _corners(outer)} | ({"holes": [{"corners": _corners(hole)} for hole in holes]} if holes else {})}


def _corners(loop):
    return [{"x": _told(x), "y": _told(y)} for x, y in loop.points]


def _told(coordinate):
    return round(float(coordinate), ROUND)


def _of_cells(material):
    return {key: material[key] for key in KEPT if key in material}


def _lies_in(history, zones, place):
    """Whether the continuum has no zone any more where the history is: all zones that hold it are of the core."""
    at = history.get("at")
    if at is None or "lining" in history:
        return False
    holding = zones.holding(np.array([at["x"], at["y"]]))
    return bool(holding.any() and place.core[holding].all())


def _as_of_particles(history, zones, place, size, notes):
    """The history of the particles there; none, and a note, where they do not have it."""
    other = history.get("relative_to")
    if history["quantity"] in MOTIONS and (other is None or _lies_in({"at": other}, zones, place)):
        return history
    if history["quantity"] in MEANS:
        return history | {"radius": float(f"{CIRCLE * size:.4g}")}
    notes.append(f"the history `{history['name']}` of {history['quantity']} is left out: it lies among the particles, which have none at a place")
    return None


def require_breakable(run, numbers, near):
    """Unusable where the material of zones near their strength does not say how cells of it break."""
    continuum = run.scene["continuum"]
    for number in np.unique(numbers[near]):
        path = f"continuum.materials[{number - 1}].material" if number else "continuum.material" if "material" in continuum else "material"
        material = continuum["materials"][number - 1]["material"] if number else continuum.get("material", run.scene.get("material"))
        if "fracture" not in material:
            raise Unusable(f"{run.folder}: {path} says when its zones fail, but not how cells of it break; give it `fracture` too, with "
                           "tensile_strength, fracture_energy and compressive_strength, and run the scene again.")
