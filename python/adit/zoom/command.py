"""Writes the coupled scene with particles where a run of a continuum came near its strength.

%(prog)s RUN_DIR
    particles where the demand reached 0.8 of the strength at any time; the scene is RUN_DIR/zoom.yaml, and coupler computes it.
    The run needs output.peaks, and materials that state a strength.
%(prog)s RUN_DIR --demand 0.6 --size 0.1 --out scene.yaml
    from another share on, with cells of another size [m], into another file.
"""
import os
from pathlib import Path

import numpy as np
import yaml

from adit import Run, Unusable, programs
from adit.zoom.outlines import Zones
from adit.zoom.places import conditioned, places
from adit.zoom.scene import differences, require_breakable

SHARE = 0.8  # of the strength
STRUCTURES = ("linings", "members", "bolts", "interfaces")


def main(words):
    parser = programs.parser("zoom", __doc__)
    parser.add_argument("folder", metavar="RUN_DIR", help="folder of a run of a continuum alone")
    parser.add_argument("--demand", type=float, default=SHARE, metavar="SHARE", help="share of the strength from which on particles are needed (default: %(default)s)")
    parser.add_argument("--size", type=float, metavar="M", help="of the cells [m]; half of a zone if it is left out")
    parser.add_argument("--out", type=Path, metavar="FILE", help="scene to write; RUN_DIR/zoom.yaml if it is left out")
    options = parser.parse_args(words)
    if not options.demand > 0:
        raise Unusable(f"--demand {options.demand:g} is no share of a strength; give more than 0, such as 0.8.")
    if options.size is not None and not options.size > 0:
        raise Unusable(f"--size {options.size:g} is no size of a cell; give metres above 0.")
    for line in zoom(Run(options.folder), options.demand, options.size, options.out or Path(options.folder) / "zoom.yaml"):
        print(line)


def zoom(run, share, size, out):
    """Writes the scene, if any is needed; yields what is to be told, line by line."""
    require_continuum(run)
    grid = run.fields()["grid"]
    demand = demand_of(run, grid)
    near, zones = demand >= share, Zones(grid)
    if not near.any():
        worst = demand.argmax()
        x, y = zones.centres[worst]
        yield (f"No particles are needed: the largest demand is {demand[worst]:.3g} at ({x:.4g}, {y:.4g}) m at "
               f"t = {grid['peak_demand_time_s'][worst]:.4g} s.")
        return
    require_breakable(run, grid["material"].astype(int), near)
    found, staying = places(zones, near, conditioned(run.scene["continuum"], grid))
    if not found:
        x, y = zones.centres[demand.argmax()]
        raise Unusable(f"{run.folder}: the zones that reach {share:g} of their strength, the worst at ({x:.4g}, {y:.4g}) m, all lie where the grid is "
                       "held, loaded or absorbs waves, or within four zones of it; move that edge farther away.")
    require_ground(run, zones, found)
    changes, counts, notes = differences(run, zones, found, share, size)
    out.parent.mkdir(parents=True, exist_ok=True)
    text = yaml.safe_dump({"extends": os.path.relpath(run.folder / "scene.yaml", out.parent)} | changes, sort_keys=False, default_flow_style=None, width=120)
    out.write_text(f"# Particles where the demand reached {share:g}, by {programs.command('zoom')}.\n{text}", encoding="utf-8")
    yield from told(zones, demand, grid["peak_demand_time_s"], found, changes, counts)
    if staying.any():
        x, y = zones.centres[np.where(staying, demand, 0).argmax()]
        notes.append(f"{staying.sum()} zones near their strength, the worst at ({x:.4g}, {y:.4g}) m, stay zones: they lie where the grid is held, "
                     "loaded or absorbs waves, or within four zones of it")
    yield from (f"note: {note}" for note in notes)
    yield f"scene              {out}"


def told(zones, demand, times, found, changes, counts):
    """What each place is."""
    models = [region["particles"] for region in changes["regions"]] if "regions" in changes else [changes["particles"]]
    for place, model, count in zip(found, models, counts):
        worst = np.where(place.core, demand, 0).argmax()
        x, y = zones.centres[worst]
        finer = ", finer in parts," if "finer" in model["cells"] else ""
        yield (f"particles          about {count:.0f} of {model['cells']['size']:.3g} m{finer} for {place.filled.sum()} zones around ({x:.4g}, {y:.4g}) m, "
               f"where the demand reaches {demand[worst]:.3g} at t = {times[worst]:.4g} s; overlap {place.width:.3g} m")


def require_continuum(run):
    """Unusable for runs that have particles already, or are of a whole tunnel."""
    if run.is_simplified:
        raise Unusable(f"{run.folder} is a run of `simplified`; `simplified run --zoom` writes the detailed models of its worst places.")
    if "continuum" not in run.scene or any(key in run.scene for key in ("particles", "regions")):
        raise Unusable(f"{run.folder} is no run of a continuum alone; zoom says where such a run needs particles.")
    if any(excavation.get("stage", 0) for excavation in run.scene["continuum"].get("excavations", [])):
        raise Unusable(f"{run.folder}: zones are excavated in stages, which particles in their place would not be; begin with the opening "
                       "(stage 0), or give a tunnel `lining.as: particles`.")


def require_ground(run, zones, found):
    """Unusable where structures stand in what would become particles, which do not have them."""
    fields = run.fields()
    for kind in STRUCTURES:
        for point in fields[kind].points if kind in fields else ():
            holding = zones.holding(point)
            if any((place.filled & holding).any() for place in found):
                raise Unusable(f"{run.folder}: {kind} of the continuum stand at ({point[0]:.4g}, {point[1]:.4g}) m in a place that comes near its strength, and "
                               "particles do not have them; give a tunnel `lining.as: zones` without an interface, or `lining.as: particles`.")


def demand_of(run, grid):
    """The largest demand of each zone over time."""
    if grid.field("peak_shear_strain") is None:
        raise Unusable(f"{run.folder} kept no peaks; add `output: {{peaks: {{}}}}` to the scene and run it again.")
    if grid.field("peak_demand") is None:
        raise Unusable(f"{run.folder}: no material states a strength to compare with; give `mohr_coulomb`, `weak_plane`, `fracture` or a class of `concrete`.")
    return grid["peak_demand"]
