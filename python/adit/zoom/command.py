"""Writes the coupled scene with particles where a run of a continuum came near its strength.

%(prog)s RUN_DIR
    particles where the demand reached 0.8 of the strength at any time; the scene is RUN_DIR/zoom.yaml, and coupler computes it.
    The run needs output.peaks, and materials or linings of tunnels that state a strength.
%(prog)s RUN_DIR --demand 0.6 --size 0.1 --out scene.yaml
    from another share on, with cells of another size [m], into another file.
"""
import os
from pathlib import Path

import numpy as np
import yaml

from adit import Run, Unusable, programs
from adit.zoom.linings import Use, breaking, has_stages, in_grid, used
from adit.zoom.outlines import Zones
from adit.zoom.places import conditioned, places
from adit.zoom.scene import differences, require_breakable
from adit.zoom.tunnel_scene import as_particles, without_lost
from adit.zoom.tunnels import reaches

SHARE = 0.8  # of the strength
STRUCTURES = ("linings", "members", "bolts", "interfaces")
AT_EDGES = "the grid is held, loaded or absorbs waves there, or within four zones"
IN_STAGES = "the scene has stages, in which only tunnels become particles"


def main(words):
    parser = programs.parser("zoom", __doc__)
    parser.add_argument("folder", metavar="RUN_DIR", help="folder of a run of a continuum alone")
    parser.add_argument("--demand", type=float, default=SHARE, metavar="SHARE", help="share of the strength from which on particles are needed (default: %(default)s)")
    parser.add_argument("--size", type=float, metavar="M",
                        help="of the cells [m], in tunnels of those of the lining; half of a zone, or a quarter of the lining, if it is left out")
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
    grid, tunnels = run.fields()["grid"], in_grid(run)
    demand, zones = demand_of(run, grid, tunnels), Zones(grid)
    base, changes, lines, notes = (around_tunnels(run, zones, demand, tunnels, share, size) if tunnels
                                   else in_ground(run, zones, demand, share, size))
    yield from lines
    if not changes:
        return
    out.parent.mkdir(parents=True, exist_ok=True)
    text = yaml.safe_dump({"extends": os.path.relpath(run.folder / base, out.parent)} | changes, sort_keys=False, default_flow_style=None, width=120)
    out.write_text(f"# Particles where the demand reached {share:g}, by {programs.command('zoom')}.\n{text}", encoding="utf-8")
    yield from (f"note: {note}" for note in notes)
    yield f"scene              {out}"


def in_ground(run, zones, demand, share, size):
    """(scene that is extended, changes to it, lines and notes that tell of them) with places of particles where they are needed."""
    grid, near = run.fields()["grid"], demand >= share
    if not near.any():
        return None, None, [f"No particles are needed: the largest demand is {worst_of(zones, demand, grid)}."], []
    require_breakable(run, grid["material"].astype(int), near)
    found, staying = places(zones, near, conditioned(run.scene["continuum"], grid))
    if not found:
        x, y = zones.centres[demand.argmax()]
        raise Unusable(f"{run.folder}: the zones that reach {share:g} of their strength, the worst at ({x:.4g}, {y:.4g}) m, all lie where the grid is "
                       "held, loaded or absorbs waves, or within four zones of it; move that edge farther away.")
    require_ground(run, zones, found)
    changes, counts, notes = differences(run, zones, found, share, size)
    if staying.any():
        notes.append(staying_zones(zones, demand, staying, AT_EDGES))
    return "scene.yaml", changes, list(told(zones, demand, grid["peak_demand_time_s"], found, changes, counts)), notes


def around_tunnels(run, zones, demand, tunnels, share, size):
    """The same, with tunnels whose linings of beams or zones become particles, and without stages places beside them."""
    grid, breaks = run.fields()["grid"], breaking(run, tunnels)
    uses = [(tunnel, used(run, tunnel, breaks[tunnel.number], grid)) for tunnel in tunnels]
    demand = np.where(np.any([tunnel.zones(run, grid) for tunnel in tunnels], axis=0), 0, demand)  # of the ground
    near, kept = demand >= share, conditioned(run.scene["continuum"], grid)
    reached = reaches(run, zones, near, uses, share, kept)
    if not near.any() and not reached:
        return None, None, [f"No particles are needed: {of_all(zones, demand, grid, uses)}."], []
    held = np.any([np.zeros_like(near), *(reach.near for reach in reached)], axis=0)
    require_breakable(run, grid["material"].astype(int), held if has_stages(run) else near)
    changes, notes = without_lost(run.scene_as_written, reached)
    found, left = [], near & ~held
    if not has_stages(run):
        taken = np.any([kept, *(reach.tunnel.contour.away(zones.points) < reach.outer for reach in reached)], axis=0)
        found, left = places(zones, left, taken)
        require_ground(run, zones, found)
    if left.any():
        notes.append(staying_zones(zones, demand, left, IN_STAGES if has_stages(run) else AT_EDGES))
    if not reached and not found:
        return None, None, [f"No particles are written: {of_all(zones, demand, grid, uses)}; {', '.join(notes)}."], []
    lines = [f"tunnel             `{tunnel.name}` stays as it is: its lining reaches {use}" for tunnel, use in uses
             if all(tunnel is not reach.tunnel for reach in reached)]
    if found:
        histories = (run.scene_as_written["continuum"] | changes.get("continuum", {})).get("histories", [])
        others, counts, more = differences(run, zones, found, share, size, histories)
        lines += told(zones, demand, grid["peak_demand_time_s"], found, others, counts)
        changes, notes = merged(changes, others), notes + more
    if reached:
        stated = list(run.scene_as_written["tunnels"])
        for reach in reached:
            stated[reach.tunnel.number], count = as_particles(run, zones, reach, breaks[reach.tunnel.number], share, size)
            lines.append(told_tunnel(reach, zones, demand, stated[reach.tunnel.number]["particles"], count))
        changes = merged(changes, {"tunnels": stated, "time": steps(run.scene_as_written["time"])})
    return "scene_as_written.yaml", changes, lines, notes


def steps(time):
    """Of the particles: their own in one of the continuum, and not that of zones alone, where the scene does not say otherwise."""
    return ({} if "substeps" in time else {"substeps": 0}) | ({"dt": None} if "dt" in time else {})


def merged(one, other):
    """Both mappings, one in the other where they have the same key."""
    return one | {key: one[key] | value if isinstance(value, dict) and key in one else value for key, value in other.items()}


def told_tunnel(reach, zones, demand, particles, count):
    """What the tunnel becomes, and why."""
    because = [f"its lining reaches {reach.use}"]
    if reach.near.any():
        because.append(f"the ground beside it {Use.of(zones, np.where(reach.near, demand, 0))}")
    finer = f", up to {particles['ground_size']:.3g} m away from it" if "ground_size" in particles else ""
    return (f"tunnel             `{reach.tunnel.name}` becomes particles: {', '.join(because)}; "
            f"about {count:.0f} cells of {particles['size']:.3g} m{finer}, in {reach.ground:.4g} m of ground; overlap {reach.overlap:.3g} m")


def of_all(zones, demand, grid, uses):
    """The largest demand of linings and ground."""
    tunnel, use = max(uses, key=lambda each: each[1].demand)
    ground = f"the largest demand of the ground is {worst_of(zones, demand, grid)}" if demand.any() else "the ground states no strength"
    return f"the lining of `{tunnel.name}` reaches {use}{', others less' if len(uses) > 1 else ''}; {ground}"


def worst_of(zones, demand, grid):
    worst = demand.argmax()
    x, y = zones.centres[worst]
    return f"{demand[worst]:.3g} at ({x:.4g}, {y:.4g}) m at t = {grid['peak_demand_time_s'][worst]:.4g} s"


def staying_zones(zones, demand, staying, because):
    """A note on the zones near their strength that do not become particles."""
    x, y = zones.centres[np.where(staying, demand, 0).argmax()]
    if staying.sum() == 1:
        return f"a zone near its strength, at ({x:.4g}, {y:.4g}) m, stays a zone: {because}"
    return f"{staying.sum()} zones near their strength, the worst at ({x:.4g}, {y:.4g}) m, stay zones: {because}"


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
    if in_grid(run) and not run.summary:
        raise Unusable(f"{run.folder} has no summary.json, which tells how much of their strength the linings used; let the run end.")
    if has_stages(run) and not in_grid(run):
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


def demand_of(run, grid, tunnels):
    """The largest demand of each zone over time; zeros where only the linings of tunnels state a strength."""
    if grid.field("peak_shear_strain") is None:
        raise Unusable(f"{run.folder} kept no peaks; add `output: {{peaks: {{}}}}` to the scene and run it again.")
    if grid.field("peak_demand") is None and tunnels:
        return np.zeros(len(grid.cells))
    if grid.field("peak_demand") is None:
        raise Unusable(f"{run.folder}: no material states a strength to compare with; give `mohr_coulomb`, `weak_plane`, `fracture` or a class of `concrete`.")
    return grid["peak_demand"]
