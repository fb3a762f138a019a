"""Relations between runs of one scene: what must be the same, or follow a known law, when the scene is said or run in another way.

Each relation is a function (world, row, scene, folder, base) -> None that raises Broken; a world is the module of the row's features.
OF_GROUND and OF_GRAINS say to which rows it applies. Runs that must not differ at
all are compared to the last bit; where only the order of sums differs, to a stated multiple of rounding.
"""
import copy
import shutil

import changes
import grains
import ground
import runs
import schema

# Of the largest value of a unit. Rounding grows over some hundred steps; rest is reached to the unbalanced ratio that a scene states,
# and soft parts move by a hundred times as much; where something yields or breaks, rounding decides in which step.
ROUNDING, OF_REST, OF_THRESHOLDS, OF_REST_BEYOND_THRESHOLDS = 1e-9, 1e-5, 1e-4, 1e-2
# A smooth joint that slipped in statics keeps what it did there: moduli that differ by 1e-13 change accelerations by 0.5 to 6 %.
OF_SLIP_IN_STATICS = 0.2


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


def compare(base, other, change, tolerance, rows=None):
    """All columns of `other`, as `change` says, against those of `base`, of which the first `rows` count."""
    scales = _scales(base.columns)
    if tolerance >= OF_REST:
        scales = {unit: max(size, AT_REST.get(unit, 0.0)) for unit, size in scales.items()}
    for name, values in base.columns.items():
        if name == "energy_drift":  # which is rounding itself
            continue
        changed = change.column(name)
        if changed not in other.columns:
            raise Broken(f"column {changed} is missing")
        factor, found = change.factor(name), other.columns[changed][:rows]
        values = values[:rows]
        if len(found) != len(values):
            raise Broken(f"{len(found)} rows, expected {len(values)}")
        allowed = tolerance * scales[schema.column_unit(name)]
        for i, (a, b) in enumerate(zip(values, found)):
            if abs(a - factor * b) > allowed or (a == a) != (b == b):
                raise Broken(f"{name} at {base.columns['time_s'][i]:g} s is {a!r}, and {factor * b!r} so changed; the largest of its unit is "
                             f"{scales[schema.column_unit(name)]:g}")


def tolerance(world, row):
    rests, yields = row["rest"] in world.STATICS, world.passes_thresholds(row)
    if rests and "smooth" in (row.get("line"), row["bonds"].partition("_")[0]):
        return OF_SLIP_IN_STATICS
    return OF_REST_BEYOND_THRESHOLDS if rests and yields else OF_REST if rests else OF_THRESHOLDS if yields else ROUNDING


def _changed(change, row, scene, folder, base, allowed):
    compare(base, runs.run(change.scene(copy.deepcopy(scene)), folder, change), change, allowed)


# Written in another way ----------------------------------------------------------------------------------------------------------

def mirrored(world, row, scene, folder, base):
    _changed(changes.Mirrored(), row, scene, folder, base, tolerance(world, row))


def can_be_mirrored(row):
    # A formula has a sign of its own, and a random packing has no mirror image.
    formula = row["motion"] in ("ricker", "sine", "gabor", "synthetic") and row["direction"] == "x"
    return not formula and row["packing"] != "random" and not is_lattice_by_its_order(row)


def is_lattice_by_its_order(row):
    """A table in the order of a lattice has the stated stress in each bond, and another order forces that balance."""
    return row["packing"] == "placed" and row["rest"] == "stressed"


def turned(world, row, scene, folder, base):
    _changed(changes.Turned(), row, scene, folder, base, tolerance(world, row))


def can_be_turned(row):
    # Bases and free fields are below and beside the ground; rows of packings lie along x.
    turns = row["packing"] == "placed" or row["inside"] in ("none", "grid")
    return turns and row["base"] == "held" and row["sides"] != "free_field" and row["rest"] != "stressed"


def moved(world, row, scene, folder, base):
    # Places are known to 1e-16 of 8 km: to 1e-11 of a zone.
    _changed(changes.Moved(8192.25, -512.5), row, scene, folder, base, max(1e-7, tolerance(world, row)))


def can_be_moved(row):
    idle = row["motion"] == "none" and row["load"] == "none" and row["rest"] == "none"  # which has no size to compare with
    return row["packing"] != "random" and not idle


def scaled(world, row, scene, folder, base):
    _changed(changes.Scaled(4.0, 4.0, 4.0**3), row, scene, folder, base, 0.0)


def scaled_stress(world, row, scene, folder, base):
    _changed(changes.Scaled(1.0, 0.5, 1.0), row, scene, folder, base, 0.0)


def can_be_scaled(row):
    # A synthetic motion follows a spectrum over periods in seconds.
    return row["motion"] != "synthetic"


def reordered(world, row, scene, folder, base):
    """Lists whose order means nothing are turned around, and so are all keys."""
    def turn(value, key=""):
        if isinstance(value, dict):
            return {k: turn(value[k], k) for k in reversed(value)}
        if isinstance(value, list):
            values = [turn(one) for one in value]
            return values[::-1] if key in ORDERLESS else values
        return value
    compare(base, runs.run(turn(scene), folder, changes.Same()), changes.Same(), tolerance(world, row))


ORDERLESS = {"blocks", "materials", "excavations", "linings", "bolts", "histories", "motions", "body_loads", "edge_loads", "loads", "quiet", "interfaces", "regions", "walls",
             "springs", "between"}


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
    compare(base, runs.Results(folder / "run"), changes.Same(), 0.0)


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
    compare(base, runs.run(scene, folder, changes.Same()), changes.Same(), 0.0, rows=len(base.columns["time_s"]))


def threads(world, row, scene, folder, base):
    compare(base, runs.run(scene, folder, changes.Same(), "--fdm-threads", 3, "--dem-threads", 2), changes.Same(), 0.0)


def observed(world, row, scene, folder, base):
    """More histories, peaks, fields and checkpoints change nothing, to the last bit."""
    scene = copy.deepcopy(scene)
    scene["output"].update({"peaks": {}, "field_times": [0.0, 0.011, 0.02], "checkpoint": {"interval": 1000.0}})
    model, at = ("continuum", {"x": -0.9, "y": 3.7}) if "continuum" in scene else ("particles", {"x": 3.3, "y": 2.6})
    scene[model]["histories"] += [{"name": "more", "quantity": quantity, "at": at} for quantity in ("velocity_x", "velocity_y")]
    compare(base, runs.run(scene, folder, changes.Same()), changes.Same(), 0.0)


def resumed(world, row, scene, folder, base):
    """Computed to a third and then lengthened to its end: the run in one piece, to the last bit."""
    scene, base = _with_step(row, scene, folder, base)
    scene["output"]["checkpoint"] = {"interval": 1000.0}
    duration = scene["time"]["duration"]
    scene["time"]["duration"] = duration / 3
    runs.run(scene, folder, changes.Same())
    runs.coupler("resume", folder / "run", "--until", repr(duration))
    compare(base, runs.Results(folder / "run"), changes.Same(), 0.0)


def replayed(world, row, scene, folder, base):
    path = runs.write_scene(scene, folder, changes.Same())
    runs.coupler("run", path, "--out", folder / "run", "--record", folder / "talk")
    compare(base, runs.Results(folder / "run"), changes.Same(), 0.0)
    runs.coupler("replay", folder / "talk")


def doubled(world, row, scene, folder, base):
    """Twice the loads and motions of an elastic model double all that is linear, to the last bit."""
    class Doubled(changes.Same):
        def factor(self, column):
            return 0.25 if column.endswith("_J") else 0.5 if column != "time_s" else 1.0
        def number(self, name, key, unit, value):
            loud = name in ("Force", "Acceleration", "Stress") or (name, key) in (("GroundMotion", "peak"), ("BaseVelocity", "amplitude"), ("BaseStress", "amplitude"))
            return 2 * value if loud or (name, key) == ("MotionFile", "a") else value
    _changed(Doubled(), row, scene, folder, base, 0.0)


def is_linear(row):
    return (row["law"] in ("elastic", "layers") and row["bonds"] in ("contact",) and row["support"] in ("none", "lining", "arcs") and row["foundation"] == "none"
            and row["large"] == "no" and row["packing"] != "random")


# Split in another way ------------------------------------------------------------------------------------------------------------

def divided(world, row, scene, folder, base):
    """The block written as two, in whatever order."""
    scene = copy.deepcopy(scene)
    block = scene["continuum"].pop("block")
    def part(x0, x1, zones):
        return {"rectangle": {"x_min": x0, "x_max": x1, "y_min": block["y_min"], "y_max": block["y_max"]},
                "along": {"zones": zones}, "across": {"zones": block["zones_y"]}}
    scene["continuum"]["blocks"] = [part(-2.5, block["x_max"], 13), part(block["x_min"], -2.5, 3)]
    compare(base, runs.run(scene, folder, changes.Same()), changes.Same(), tolerance(world, row))


def in_arcs(world, row, scene, folder, base):
    """A lining written as two that meet."""
    scene = copy.deepcopy(scene)
    halves = ground.scene({**row, "support": "arcs"})["continuum"]["linings"]
    scene["continuum"]["linings"] = halves
    for history in scene["continuum"]["histories"]:
        if history.get("lining"):
            history["lining"] = "upper"
    compare(base, runs.run(scene, folder, changes.Same()), changes.Same(), tolerance(world, row))


def balanced(world, row, scene, folder, base):
    """Energy closes: what is put in is kept, or booked where it went. A solve that filters takes what is not booked, and never gives."""
    drift = base.columns["energy_drift"]
    allowed = 2e-2 if row.get("substeps", "1") != "1" or row.get("large") == "yes" else 5e-3
    worst = max(drift) if row.get("solve", "consistent") != "consistent" else max(map(abs, drift))
    if not worst <= allowed:
        raise Broken(f"the energy error is {worst} of the peak energy, at most {allowed} is allowed")


def general(world, row, scene, folder, base):
    """The general engine computes what the lattice engine does, but for the order of its sums."""
    scene = copy.deepcopy(scene)
    scene["particles"]["engine"] = "general"
    compare(base, runs.run(scene, folder, changes.Same()), changes.Same(), tolerance(world, row))


def always(_):
    return True


OF_GROUND = {
    balanced: always, mirrored: can_be_mirrored, turned: can_be_turned, moved: can_be_moved, scaled: can_be_scaled, scaled_stress: can_be_scaled,
    reordered: always, said_apart: always, longer: always, threads: always, observed: lambda row: row["inside"] != "ring" and row["hole"] != "side",
    resumed: always, replayed: always, doubled: is_linear, divided: lambda row: row["grid"] == "block", in_arcs: lambda row: row["support"] == "lining",
}
OF_GRAINS = {
    balanced: always, mirrored: lambda row: row["packing"] != "random" and not is_lattice_by_its_order(row), turned: lambda row: row["packing"] == "placed" and row["floor"] != "quiet" and row["rest"] != "stressed",
    moved: lambda row: row["packing"] != "random" and not grains.is_idle(row), scaled: always, scaled_stress: always, reordered: always, said_apart: always,
    longer: always, threads: always, observed: always, resumed: always, replayed: always, general: lambda row: row["engine"] == "automatic",
}


def check(relation, world, row, scene, folder, base):
    """Raises Broken, with the words of a run that ended."""
    shutil.rmtree(folder, ignore_errors=True)
    try:
        relation(world, row, scene, folder, base)
    except runs.Ended as ended:
        raise Broken(str(ended)) from ended
    shutil.rmtree(folder, ignore_errors=True)
