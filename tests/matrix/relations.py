"""Relations between runs of one scene: what must be the same, or follow a known law, when the scene is said or run in another way.

Each relation is a function (world, row, scene, folder, base) -> None that raises Broken; a world is the module of the row's features.
OF_GROUND, OF_GRAINS and OF_TUNNELS say to which rows it applies. Runs that must not differ at
all are compared to the last bit; where only the order of sums differs, to a stated multiple of rounding.
"""
import copy
import math
import random
import shutil

import changes
import grains
import ground
import runs
import schema
import tunnels

# Of the largest value of a unit. Rounding grows over some hundred steps; rest is reached to the unbalanced ratio that a scene states,
# and soft parts move by a hundred times as much; where something yields or breaks, rounding decides in which step.
ROUNDING, OF_REST, OF_THRESHOLDS, OF_REST_BEYOND_THRESHOLDS = 1e-9, 1e-5, 1e-4, 1e-2
# Where a scene multiplies rounding by more than that, so much is allowed as it makes of stresses and lengths whose last digits differ, a few
# times. One event that comes a step earlier has one of two outcomes, so that several such scenes are asked.
# Where cracks amplify rounding the difference of two runs is a matter of chance: a dozen of them is looked at where few do not suffice.
NUDGES, NUDGED_BY, OF_NUDGES = range(12), 1e-11, 3
# Of accelerations at the edge of an overlap, of whose 2 m waves of 9 m see the other grid.
OF_OTHER_POINTS = 0.05
NOTHING = 1e-15  # J: the energies of a scene in which something happens are above 1e-3 J


# What a model may still do that came to rest, as far as its unbalanced ratio says.
AT_REST = {"m": 1e-6, "m/s": 1e-4, "m/s^2": 0.1, "Pa": 1e3, "N": 1e3, "N*m": 1e3, "J": 0.1, "1": 1e-6, "1/s": 1e-4, "rad": 1e-6}


class Broken(Exception):
    """A relation that does not hold: where, and by how much."""


def _scales(columns):
    """The largest value of each unit."""
    scales = {}
    for name, values in columns.items():
        unit = schema.column_unit(name)
        scales[unit] = max(scales.get(unit, 0.0), *(abs(value) for value in values if value == value), 0.0)
    return scales


def deviation(base, other, change, rows=None, rests=True, typical=False):
    """The largest difference of all columns of `other`, as `change` says, from those of `base`: its share of the largest value of its unit,
    and where it is. The first `rows` of base count. Of a model that `rests`, no unit is smaller than what it may still do (AT_REST).
    `typical`: of the column whose differences have the largest root mean square, which is returned."""
    scales = _scales(base.columns)
    if rests:
        scales = {unit: max(size, AT_REST.get(unit, 0.0)) for unit, size in scales.items()}
    worst, where = 0.0, ""
    for name, values in base.columns.items():
        changed = change.column(name)
        if changed not in other.columns:
            raise Broken(f"column {changed} is missing")
        factor, found = change.factor(name), other.columns[changed][:rows]
        values = values[:rows]
        if len(found) != len(values):
            raise Broken(f"{len(found)} rows, expected {len(values)}")
        scale = scales[schema.column_unit(name)]
        apart = [math.inf if (a == a) != (b == b) else abs(a - factor * b) / scale if a != factor * b and a == a else 0.0 for a, b in zip(values, found)]
        size = math.sqrt(sum(value**2 for value in apart) / len(apart)) if typical else max(apart)
        if size > worst:
            i = apart.index(max(apart))
            worst, where = size, (f"{name} at {base.columns['time_s'][i]:g} s is {values[i]!r}, and {factor * found[i]!r} so changed; the largest of its unit is {scale:g}")
    return worst, where


def exactly(base, other, change=changes.Same(), rows=None):
    """All histories, to the last bit."""
    worst, where = deviation(base, other, change, rows, rests=False)
    if worst > 0:
        raise Broken(where)


def closely(allowed, scene, folder, base, other, change):
    """All histories but those of rounding itself, within a share of the largest value of their unit, or of what the scene makes of rounding.

    That is judged by root mean squares: an acceleration for an instant, where a crack opens or local damping turns, is a matter of chance."""
    base, other = (_without_rounding(one) for one in (base, other))
    if deviation(base, other, change, rests=allowed >= OF_REST)[0] <= allowed:
        return
    class Nudged(changes.Same):
        def number(self, name, key, unit, value):
            return value * (1 + NUDGED_BY * random.Random(f"{nudge} {value}").uniform(-1, 1)) if unit in ("Pa", "m") else value
    typical, where = deviation(base, other, change, rests=allowed >= OF_REST, typical=True)
    grown = 0.0
    rows = len(base.columns["time_s"])
    for nudge in NUDGES:
        nudged = _without_rounding(runs.run(Nudged().scene(copy.deepcopy(scene)), folder / "nudged", Nudged()))
        grown = max(grown, deviation(base, nudged, changes.Same(), rows, rests=allowed >= OF_REST, typical=True)[0])
        if typical <= OF_NUDGES * grown:
            JUDGED_BY_NUDGES.append(grown)
            return
    raise Broken(f"{where}; stresses and lengths that differ by {NUDGED_BY:g} make a difference of {grown:.1e} of the largest, not {typical:.1e}")


JUDGED_BY_NUDGES = []  # the growth of rounding in scenes whose relations hold within it only


def _without_rounding(results):
    """The results without the energy's drift, which is rounding, and the directions of diameters that hardly change."""
    fewer = copy.copy(results)
    fewer.columns = {name: values for name, values in results.columns.items() if name != "energy_drift" and not name.endswith("_direction_rad")}
    return fewer


def same(base, other, ended_before=False):
    """All that two runs have written, to the last bit; one that has `ended_before` has the fields of that end, too."""
    exactly(base, other)
    for name, value in base.figures.items():
        if other.figures.get(name) != value:
            raise Broken(f"figure {name} is {other.figures.get(name)!r}, and {value!r} before")
    if base.figures.keys() != other.figures.keys():
        raise Broken(f"figures {sorted(base.figures.keys() ^ other.figures.keys())} are those of one run only")
    ours, theirs = base.files, other.files
    names = ours.keys() if ended_before else ours.keys() | theirs.keys()
    unlike = [name for name in names if ours.get(name) != theirs.get(name)]
    if unlike:
        raise Broken(f"files {sorted(unlike)} differ")


def tolerance(world, row):
    rests, passes = row["rest"] in world.STATICS, world.passes_thresholds(row)
    return OF_REST_BEYOND_THRESHOLDS if rests and passes else OF_REST if rests else OF_THRESHOLDS if passes else ROUNDING


def _changed(change, row, scene, folder, base, allowed):
    closely(allowed, scene, folder, base, runs.run(change.scene(copy.deepcopy(scene)), folder / "changed", change), change)


# Written in another way ----------------------------------------------------------------------------------------------------------

def mirrored(world, row, scene, folder, base):
    _changed(world.Mirrored(), row, scene, folder, base, tolerance(world, row))


def can_be_mirrored(row):
    # A formula has a sign of its own, and a random packing has no mirror image.
    formula = row["motion"] in ("ricker", "sine", "gabor", "synthetic") and row["direction"] == "x"
    return not formula and row["packing"] not in ("random", "cells")


def turned(world, row, scene, folder, base):
    _changed(changes.Turned(), row, scene, folder, base, tolerance(world, row))


def can_be_turned(row):
    # Bases and free fields are below and beside the ground; rows of packings lie along x.
    turns = row["packing"] == "placed" or row["inside"] in ("none", "grid")
    level = row.get("water", "none") == "none"  # the surface of water is level
    return turns and level and row["base"] == "held" and row["sides"] != "free_field" and row["rest"] != "stressed"


def moved(world, row, scene, folder, base):
    # Places are known to 1e-16 of 8 km: to 1e-11 of a zone.
    _changed(changes.Moved(8192.25, -512.5), row, scene, folder, base, max(1e-7, tolerance(world, row)))


def can_be_moved(row):
    idle = row["motion"] == "none" and row["load"] == "none" and row["rest"] == "none"  # which has no size to compare with
    return row["packing"] not in ("random", "cells") and not idle


def scaled(world, row, scene, folder, base):
    _scaled(changes.Scaled(4.0, 4.0, 4.0**3), scene, folder, base)


def scaled_stress(world, row, scene, folder, base):
    _scaled(changes.Scaled(1.0, 0.5, 1.0), scene, folder, base)


def _scaled(change, scene, folder, base):
    exactly(base, runs.run(change.scene(copy.deepcopy(scene)), folder, change), change)


def can_be_scaled(row):
    # A synthetic motion follows a spectrum over periods in seconds; classes of concrete and steel have their strengths; PM4Sand knows the
    # pressure of the atmosphere.
    return row["motion"] != "synthetic" and row["support"] != "reinforced" and row.get("law") != "sand"


def reordered(world, row, scene, folder, base):
    """Lists whose order means nothing are turned around, and so are all keys."""
    def turn(value, key=""):
        if isinstance(value, dict):
            return {k: turn(value[k], k) for k in reversed(value)}
        if isinstance(value, list):
            values = [turn(one) for one in value]
            return values[::-1] if key in ORDERLESS else values
        return value
    closely(tolerance(world, row), scene, folder, base, runs.run(turn(scene), folder / "turned", changes.Same()), changes.Same())


ORDERLESS = {"blocks", "materials", "excavations", "linings", "members", "bolts", "histories", "motions", "body_loads", "edge_loads", "loads", "quiet",
             "interfaces", "regions", "walls", "springs", "between"}


def said_apart(world, row, scene, folder, base):
    """One half of the keys in a file that the other extends, and the duration by --set: to the last bit."""
    first = {key: scene[key] for key in list(scene)[::2]}
    runs.write_scene(first, folder, changes.Same())
    (folder / "scene.yaml").rename(folder / "first.yaml")
    duration = scene["time"]["duration"]
    rest = {**{key: scene[key] for key in scene if key not in first}, "extends": "first.yaml"}
    rest["time"] = {**scene["time"], "duration": 2 * duration}
    path = runs.write_scene(rest, folder, changes.Same())
    runs.coupler("run", path, "--out", folder / "run", "--set", f"time.duration={duration!r}")
    same(base, runs.Results(folder / "run"))


def by_numbers(world, row, scene, folder, base):
    """Concrete of a class is what its mean values say: GB 50010-2010, table 4.1.3 (f_ck, f_tk [MPa]) over 1 - 1.645 delta of annex C.2.1,
    table 4.1.5 (E_c), fib Model Code 2010, eq. 5.1-9. Its strengths in a laboratory are told alike."""
    of_mean = 1e6 / (1 - 1.645 * 0.233)
    c15 = {"young_modulus": 22e9, "poisson_ratio": 0.2}
    if row["particles"] != "lattice":  # discs take the elastic constants only
        c15["fracture"] = {"compressive_strength": 10.0 * of_mean, "tensile_strength": 1.27 * of_mean,
                           "fracture_energy": 73 * (10.0 * of_mean / 1e6)**0.18}
    changed = copy.deepcopy(scene)
    material = changed["tunnels"][0]["lining"]["material"]
    assert material.pop("concrete") == "C15"
    material.update(c15)
    found = runs.run(changed, folder / "changed", changes.Same())
    closely(tolerance(world, row), scene, folder, base, found, changes.Same())
    told, told_changed = ([note for note in one.summary.get("notes", []) if "laboratory" in note] for one in (base, found))
    if told != told_changed:
        raise Broken(f"the strengths told are {told_changed}, and {told} of the class")


def _with_step(row, scene, folder, base):
    """The scene and its run with a stated step, where none follows from the interval of its rows: it divides the duration then."""
    scene = copy.deepcopy(scene)
    if row["rows"] == "each_step":
        substeps = base.summary["substeps"]
        scene["time"].update({"dt": base.summary["dt_s"] / substeps, "substeps": substeps})
        base = runs.run(scene, folder / "stated", changes.Same())
    return scene, base


# Run in another way --------------------------------------------------------------------------------------------------------------

def longer(world, row, scene, folder, base):
    """A run of twice the duration begins as the short one, to the last bit."""
    scene, base = _with_step(row, scene, folder, base)
    scene["time"]["duration"] *= 2
    exactly(base, runs.run(scene, folder, changes.Same()), rows=len(base.columns["time_s"]))


def threads(world, row, scene, folder, base):
    same(base, runs.run(scene, folder, changes.Same(), "--fdm-threads", 3, "--dem-threads", 2))


def elsewhere(world, row, scene, folder, base):
    """By TCP, with servers that have served other runs: to the last bit."""
    tunnels = scene.get("tunnels", [])
    has = {"fdm": "continuum" in scene or tunnels, "dem": "particles" in scene or any("particles" in tunnel for tunnel in tunnels)}
    own = [name for name, wanted in has.items() if wanted]
    options = [option for name in own for option in (f"--{name}", runs.address(name))]
    same(base, runs.run(scene, folder, changes.Same(), *options))


def observed(world, row, scene, folder, base):
    """More histories, peaks, fields and checkpoints change nothing, to the last bit."""
    scene = copy.deepcopy(scene)
    scene["output"].update({"peaks": {}, "field_times": [0.0, 0.011, 0.02], "checkpoint": {"interval": 1000.0}})
    model, at = ("continuum", {"x": -0.9, "y": 3.7}) if "continuum" in scene else ("particles", {"x": 3.3, "y": 2.6})
    scene[model]["histories"] += [{"name": "more", "quantity": quantity, "at": at} for quantity in ("velocity_x", "velocity_y")]
    exactly(base, runs.run(scene, folder, changes.Same()))


def resumed(world, row, scene, folder, base):
    """Computed to a third and then lengthened to its end: the run in one piece, to the last bit."""
    scene, base = _with_step(row, scene, folder, base)
    duration = scene["time"]["duration"]
    if "field_times" in scene["output"]:  # after the first end none can be asked for
        scene["output"]["field_times"] = [time for time in scene["output"]["field_times"] if time <= duration / 3]
        base = runs.run(scene, folder / "fewer", changes.Same())
    scene["output"]["checkpoint"] = {"interval": 1000.0}
    scene["time"]["duration"] = duration / 3
    runs.run(scene, folder, changes.Same())
    runs.coupler("resume", folder / "run", "--until", repr(duration))
    same(base, runs.Results(folder / "run"), ended_before=True)


def replayed(world, row, scene, folder, base):
    path = runs.write_scene(scene, folder, changes.Same())
    runs.coupler("run", path, "--out", folder / "run", "--record", folder / "talk")
    same(base, runs.Results(folder / "run"))
    runs.coupler("replay", folder / "talk")


def doubled(world, row, scene, folder, base):
    """Twice the loads and motions of an elastic model double all that is linear, to the last bit."""
    class Doubled(changes.Same):
        def factor(self, column):
            return 0.25 if column.endswith("_J") else 1.0 if column in ("time_s", "energy_drift") else 0.5
        def number(self, name, key, unit, value):
            loud = name in ("Force", "Acceleration", "Stress") or (name, key) in (("GroundMotion", "peak"), ("BaseVelocity", "amplitude"), ("BaseStress", "amplitude"))
            return 2 * value if loud or (name, key) == ("MotionFile", "a") else value
    _scaled(Doubled(), scene, folder, base)


def is_linear(row):
    """Contacts of particles turn with them: what they do is linear in small motions only."""
    return (row.get("inside", "none") in ("none", "grid") and row["law"] in ("elastic", "layers")
            and row["support"] in ("none", "lining", "arcs", "bonded") and row["foundation"] == "none"
            and row["large"] == "no" and row.get("bedding", "none") == "none" and row["water"] == "none")


def superposed(world, row, scene, folder, base):
    """What twice the loads do, and what twice the motions do, is together three times what both do, of an elastic model."""
    class Louder(changes.Same):
        def __init__(self, loads, motions):
            self.loads, self.motions = loads, motions
        def number(self, name, key, unit, value):
            if name in ("Force", "Acceleration", "Stress"):
                return self.loads * value
            moves = (name, key) in (("GroundMotion", "peak"), ("BaseVelocity", "amplitude"), ("BaseStress", "amplitude"), ("MotionFile", "a"))
            return self.motions * value if moves else value
    one, other = (runs.run(change.scene(copy.deepcopy(scene)), folder / name, change)
                  for name, change in (("loads", Louder(2, 1)), ("motions", Louder(1, 2))))
    linear = [name for name in base.columns if not name.endswith("_J") and name not in ("time_s", "energy_drift")]
    expected, both = copy.copy(base), copy.copy(one)
    expected.columns = {name: base.columns[name] for name in ["time_s", *linear]}
    both.columns = {"time_s": base.columns["time_s"], **{name: [(a + b) / 3 for a, b in zip(one.columns[name], other.columns[name])] for name in linear}}
    closely(tolerance(world, row), scene, folder, expected, both, changes.Same())


def on_any_base(world, row, scene, folder, base):
    """At rest the ground bears the same on a base that will move or yield as on one that never does."""
    held = world.scene({**row, "base": "held", **({"motion": "none", "direction": "x"} if "motion" in row else {})})
    first, other = copy.copy(base), runs.run(held, folder / "held", changes.Same())
    for results in (first, other):
        results.columns = {name: values[:1] for name, values in results.columns.items()
                           if name in base.columns and schema.column_unit(name) in ("Pa", "N", "N*m") or name == "time_s"}
    closely(tolerance(world, row), scene, folder, first, other, changes.Same())


# Refined, and joined the other way round -----------------------------------------------------------------------------------------

def refined(world, row, scene, folder, base):
    """Zones of half and a quarter of the size: the second difference is smaller than the first, as far as edges and corners let it."""
    coarse, *finer = (_of_zones(scene, folder / str(times), times) for times in (1, 2, 4))
    fine, finest = finer
    for name in [name for name in coarse if schema.column_unit(name) == "m"]:
        first = max(abs(a - b) for a, b in zip(coarse[name], fine[name]))
        second = max(abs(a - b) for a, b in zip(fine[name], finest[name]))
        size = max(map(abs, finest[name]))
        if second > 0.6 * first and second > 2e-3 * size:
            raise Broken(f"{name} changes by {first:g} from whole zones to halves, and by {second:g} from there to quarters; its largest value is {size:g}")


def _of_zones(scene, folder, times):
    """The histories of displacements in points of the coarse grid, with so many zones for each."""
    scene = copy.deepcopy(scene)
    continuum = scene["continuum"]
    for block in [continuum["block"]] if "block" in continuum else continuum["blocks"]:
        for division in (block, block.get("along", {}), block.get("across", {})):
            division.update({key: times * division[key] for key in ("zones_x", "zones_y", "zones") if key in division})
    continuum["histories"] = [{"name": f"point_{k}", "quantity": quantity, "at": at} for k, at in enumerate(({"x": -2.0, "y": 3.5}, {"x": 1.5, "y": 2.0}))
                              for quantity in ("displacement_x", "displacement_y")]
    return runs.run(scene, folder, changes.Same()).columns


def can_be_refined(row):
    return (row["grid"] in ("block", "blocks") and row["law"] == "elastic" and row["hole"] == "none" and row["support"] == "none" and row["foundation"] == "none"
            and row["inside"] == "none" and row["load"] in ("none", "edge") and row["rest"] == "none" and row["large"] == "no" and row["motion"] != "none")


def exchanged(world, row, scene, folder, base):
    """Two grids that overlap, where the inner one is named the outer: the same ground, whose forces are found at the other's points."""
    changed = copy.deepcopy(scene)
    (interface,) = changed["interfaces"]
    interface["outer"], interface["inner"] = interface["inner"], interface["outer"]
    overlap = interface["overlap"]
    interface["overlap"] = {"particles_begin": overlap["continuum_ends"], "continuum_ends": overlap["particles_begin"]}
    closely(OF_OTHER_POINTS, scene, folder, base, runs.run(changed, folder / "exchanged", changes.Same()), changes.Same())


# Computed by others --------------------------------------------------------------------------------------------------------------

def by_lammps(world, row, scene, folder, base):
    closely(tolerance(world, row), scene, folder, base, runs.run(scene, folder / "lammps", changes.Same(), "--dem", runs.address("lammps")), changes.Same())


def by_fenicsx(world, row, scene, folder, base):
    """Of all that it tells: motions of places."""
    scene = copy.deepcopy(scene)
    continuum = scene["continuum"]
    continuum.pop("sections", None)
    continuum["histories"] = [history for history in continuum["histories"]
                              if history["quantity"].startswith(("displacement", "velocity")) and "relative_to" not in history]
    ours = runs.run(scene, folder / "ours", changes.Same())
    theirs = runs.run(scene, folder / "theirs", changes.Same(), "--fdm", runs.address("fenicsx"))
    closely(tolerance(world, row), scene, folder, ours, theirs, changes.Same())


# Split in another way ------------------------------------------------------------------------------------------------------------

def divided(world, row, scene, folder, base):
    """The block written as two, in whatever order."""
    changed = copy.deepcopy(scene)
    block = changed["continuum"].pop("block")
    def part(x0, x1, zones):
        return {"rectangle": {"x_min": x0, "x_max": x1, "y_min": block["y_min"], "y_max": block["y_max"]},
                "along": {"zones": zones}, "across": {"zones": block["zones_y"]}}
    changed["continuum"]["blocks"] = [part(-2.5, block["x_max"], 13), part(block["x_min"], -2.5, 3)]
    closely(tolerance(world, row), scene, folder, base, runs.run(changed, folder / "changed", changes.Same()), changes.Same())


def in_arcs(world, row, scene, folder, base):
    """A lining written as two that meet."""
    changed = copy.deepcopy(scene)
    halves = ground.scene({**row, "support": "arcs"})["continuum"]["linings"]
    changed["continuum"]["linings"] = halves
    for history in changed["continuum"]["histories"]:
        if history.get("lining"):
            history["lining"] = "upper"
    closely(tolerance(world, row), scene, folder, base, runs.run(changed, folder / "changed", changes.Same()), changes.Same())


def balanced(world, row, scene, folder, base):
    """Energy closes: what is put in is kept, or booked where it went. A solve that filters takes what is not booked, and never gives.
    Where nothing happens there is only rounding."""
    if max(max(map(abs, values)) for name, values in base.columns.items() if name.endswith("_J")) < NOTHING:
        return
    drift = base.columns["energy_drift"]
    allowed = 2e-2 if row.get("substeps", "1") != "1" or row.get("large") == "yes" else 5e-3
    filters = world is tunnels or row.get("solve", "consistent") != "consistent"
    worst = max(drift) if filters else max(map(abs, drift))
    if not worst <= allowed:
        raise Broken(f"the energy error is {worst} of the peak energy, at most {allowed} is allowed")


def general(world, row, scene, folder, base):
    """The general engine computes what the lattice engine does, but for the order of its sums."""
    changed = copy.deepcopy(scene)
    changed["particles"]["engine"] = "general"
    closely(tolerance(world, row), scene, folder, base, runs.run(changed, folder / "changed", changes.Same()), changes.Same())


def always(_):
    return True


OF_GROUND = {
    balanced: always, mirrored: can_be_mirrored, turned: can_be_turned, moved: can_be_moved, scaled: can_be_scaled, scaled_stress: can_be_scaled,
    reordered: always, said_apart: always, longer: always, threads: always, elsewhere: always,
    observed: lambda row: row["inside"] != "ring" and row["hole"] != "side", resumed: always, replayed: always, doubled: is_linear,
    superposed: lambda row: is_linear(row) and row["motion"] not in ("none", "synthetic"), refined: can_be_refined,
    exchanged: lambda row: row["inside"] == "grid" and row["solve"] == "consistent", divided: lambda row: row["grid"] == "block",
    in_arcs: lambda row: row["support"] == "lining", on_any_base: lambda row: row["rest"] in ground.STATICS and row["base"] != "held",
}


def has_no_scale_of_its_own(row):
    return row["spring"] != "bar" and row["bonds"] != "fast"


OF_GRAINS = {
    balanced: always, mirrored: lambda row: row["packing"] not in ("random", "cells"),
    turned: lambda row: row["packing"] == "placed" and row["floor"] != "quiet" and row["rest"] != "stressed",
    moved: lambda row: row["packing"] not in ("random", "cells") and not grains.is_idle(row),
    # Bond and dowels of bars follow formulas of the strength in MPa; what is fast is so in seconds.
    scaled: has_no_scale_of_its_own, scaled_stress: has_no_scale_of_its_own, reordered: always, said_apart: always,
    longer: always, threads: always, elsewhere: always, observed: always, resumed: always, replayed: always,
    general: lambda row: row["engine"] == "automatic",
}
OF_TUNNELS = {
    balanced: always, mirrored: lambda row: row["particles"] == "lattice", moved: lambda row: row["particles"] == "lattice" and not tunnels.is_idle(row),
    # Bond, dowels and fracture energy of a section follow formulas of the strength in MPa.
    scaled: lambda row: row["lining"] not in ("concrete", "reinforced"), scaled_stress: lambda row: row["lining"] not in ("concrete", "reinforced"),
    by_numbers: lambda row: row["lining"] == "concrete",
    reordered: always, said_apart: always,
    longer: always, threads: always, elsewhere: lambda row: row["tunnels"] == "one", observed: always, resumed: always, replayed: always,
    on_any_base: lambda row: row["rest"] in tunnels.STATICS and row["base"] != "held",
}
OF_GRID_TUNNELS = {
    **{relation: OF_TUNNELS[relation] for relation in (balanced, reordered, said_apart, longer, threads, observed, resumed, replayed, on_any_base)},
    mirrored: always, moved: lambda row: not tunnels.is_idle(row), scaled: always, elsewhere: always,
    scaled_stress: lambda row: row["lining"] != "reinforced",  # whose density is not stated
}


def check(relation, world, row, scene, folder, base):
    """Raises Broken, with the words of a run that ended."""
    shutil.rmtree(folder, ignore_errors=True)
    try:
        relation(world, row, scene, folder, base)
    except runs.Ended as ended:
        raise Broken(str(ended)) from ended
    shutil.rmtree(folder, ignore_errors=True)
