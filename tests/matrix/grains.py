"""The matrix of features of particles alone: bodies and grains 4 m wide and 3 m high, which break, slide, roll and hang on springs.

A scene takes less than a tenth of a second to compute.
"""
import math

from changes import Mirrored  # noqa: F401, of this world
import ground

FACTORS = {
    "plane": ["plane_strain", "plane_stress"],
    "packing": ["placed", "hexagonal", "square", "random", "cells"],
    "engine": ["automatic", "general"],
    "bonds": ["contact", "breakable", "friction", "parallel", "grains", "scattered", "fast"],
    "line": ["none", "weak", "open", "smooth"],
    "groups": ["none", "soft", "later", "apart"],
    "spring": ["none", "linear", "tension", "curve", "across", "bar"],
    "floor": ["held", "wall", "quiet"],
    "foundation": ["none", "springs"],
    "damping": ["none", "local", "viscous"],
    "load": ["none", "push", "body", "motion", "wall"],
    "rest": ["none", "stressed", "kinetic", "local", "adaptive", "unscaled"],
    "hole": ["none", "never", "stage"],
    "observe": ["discs", "circles", "section", "joint", "oval"],
    "rows": ["interval", "each_step"],
    "output": ["histories", "all"],
}

STATICS = {"kinetic", "local", "adaptive", "unscaled"}

# What the programs refuse, and a word of the refusal.
REFUSED = (
    [({"rest": "stressed", "floor": "wall"}, "initial_stress"), ({"rest": "stressed", "load": "wall"}, "initial_stress")]
    + [({"foundation": "springs", "hole": "stage"}, "foundations"), ({"foundation": "springs", "groups": "later"}, "foundations")]
)


# What cannot be said, because one value speaks of what the other leaves out.
def meaningless(row):
    has = row.get
    yield has("hole") == "stage" and has("rest", "kinetic") not in STATICS
    yield has("groups") == "later" and has("rest", "kinetic") not in STATICS
    yield has("observe") == "joint" and has("line", "weak") == "none"
    # Grains without bonds have no joints and no strength, and a heap of them comes to rest by itself or not at all.
    yield has("bonds") == "grains" and (has("line", "none") != "none" or has("rest", "none") != "none" or has("groups") == "apart" or has("observe") == "section")
    yield has("load") == "wall" and has("packing", "square") != "square"  # which alone reaches the wall
    yield has("packing") == "cells" and has("bonds") == "parallel"  # facets join cells instead
    yield has("packing", "cells") != "cells" and has("bonds") == "fast"  # stronger by the rate of strain


def passes_thresholds(row):
    """Whether something breaks, slides, touches or is braked against the sign of its velocity, so that rounding decides in which step."""
    return row["bonds"] != "contact" or row["packing"] in ("random", "cells") or row["line"] != "none" or row["spring"] in ("tension", "curve", "bar") or (
        row["floor"] == "wall" or row["load"] == "wall" or row["foundation"] == "springs" or row["groups"] == "apart" or row["damping"] == "local")


def is_idle(row):
    """Whether nothing moves in its scene, which has no size to compare with."""
    return row["load"] == "none" and row["rest"] == "none"


ROCK = {"young_modulus": 1e9, "poisson_ratio": 0.2, "density": 2000.0}
FRACTURE = {"tensile_strength": 100e3, "fracture_energy": 20.0, "compressive_strength": 1e6}
BREAK = ("breakable", "scattered", "fast")  # of cells
RADIUS = 0.125
LOW, HIGH = 0.0, 3.0


def scene(row):
    """The scene of a row."""
    whole = {"plane": row["plane"], "material": dict(ROCK), "time": {"duration": 0.03}, "particles": _particles(row),
             "output": ground.output(row)}
    if row["rest"] in STATICS:
        whole["statics"] = {"unbalanced_ratio": 1e-6 if passes_thresholds(row) else 1e-8, "max_steps": 20000,
                            "damping": row["rest"] if row["rest"] != "unscaled" else "local", "scale_masses": row["rest"] != "unscaled"}
    if row["rest"] == "stressed":
        whole["initial_stress"] = {"xx": -20e3, "yy": -80e3, "yy_per_metre": 20e3}
    if row["packing"] == "cells" and row["bonds"] in BREAK:
        whole["particles"]["material"] = {**ROCK, "fracture": _fracture(row)}
    return whole


def _fracture(row):
    return FRACTURE | ({"rate_exponent": 0.02} if row["bonds"] == "fast" else {})


def _particles(row):
    box = {"x_min": 0.0, "x_max": 4.0, "y_min": LOW, "y_max": HIGH}
    model = {
        "placed": {"placed": {"path": "grains.csv"}, "bonds": {"reach": 1e-5}},
        "hexagonal": {"packing": {**box, "radius": RADIUS}},
        "square": {"square_packing": {**box, "radius": RADIUS}},
        "random": {"random_packing": {**box, "radius_min": 0.1, "radius_max": 0.15, "stress": 50e3}},
        "cells": {"cells": {**box, "size": 2 * RADIUS}},
    }[row["packing"]]
    bonds = {
        "contact": {"bonds": {}}, "grains": {"bonds": {}, "contacts": {"friction": 0.5, "normal_damping": 0.2, "shear_damping": 0.1}},
        "breakable": {"bonds": {"tensile_strength": 100e3, "shear_strength": 300e3}},
        "friction": {"bonds": {}, "contacts": {"friction": 0.5, "normal_damping": 0.1}},
        "parallel": {"bonds": {"parallel": {"normal_stiffness": 4e9, "shear_stiffness": 1.5e9, "cohesion": 2e6, "tensile_strength": 1e6}},
                     "contacts": {"friction": 0.5}},
        "scattered": {"bonds": {"tensile_strength": 100e3, "shear_strength": 300e3}, **ground.scatter()},
        "fast": {},
    }[row["bonds"]]
    if row["packing"] == "cells" and row["bonds"] in BREAK:
        bonds = {"bonds": {}}
    model.update({**bonds, "bonds": {**model.get("bonds", {}), **bonds["bonds"]}, "engine": row["engine"]})
    if row["bonds"] == "grains":
        del model["bonds"]
    model["histories"] = _histories(row)
    for add in (_add_floor, _add_line, _add_groups, _add_spring, _add_load, _add_rest, _add_observed):
        add(row, model)
    return model


def _add_floor(row, model):
    if row["floor"] == "held":
        model["motions"] = [{"where": {"y_max": LOW + 0.3}, "velocity": {"x": 0.0, "y": 0.0}}]
    elif row["floor"] == "wall":
        model["walls"] = [{"name": name, "from": {"x": x0, "y": y0}, "to": {"x": x1, "y": y1}} for name, x0, y0, x1, y1 in
                          (("floor", -1.0, LOW, 5.0, LOW), ("left", 0.0, -1.0, 0.0, 4.0), ("right", 4.0, -1.0, 4.0, 4.0))]
    else:
        model["quiet"] = [{"where": {"y_max": LOW + 0.3}, "side": "lower"}]
    if row["foundation"] == "springs":
        model["foundations"] = [{"where": {"x_max": 1.0}, "x": {"stiffness": 20e6, "dashpot": 1e5, "slip_stress": 30e3, "hardening": 0.1},
                                 "y": {"stiffness": 30e6}}]
    if row["damping"] != "none":
        model["damping"] = {row["damping"]: 0.2 if row["damping"] == "local" else 10.0}


def _add_line(row, model):
    weak = {"tensile_strength": 50e3, "shear_strength": 100e3}
    if row["packing"] == "cells":
        weak = {"fracture": {**FRACTURE, "tensile_strength": 50e3}}
    law = {"weak": {"bonds": weak}, "open": {"open": True},
           "smooth": {"smooth": {"normal_stiffness": 5e9, "shear_stiffness": 2e9, "friction": 0.5}}}.get(row["line"])
    if law:
        model["joints"] = [{"name": "line", "from": {"x": -0.1, "y": 1.43}, "to": {"x": 4.1, "y": 1.43}, **law}]


def _add_groups(row, model):
    if row["groups"] == "none":
        return
    group = {"name": "part", "where": {"x_min": 2.5, "y_max": 2.05}}
    rock = {**ROCK, "fracture": _fracture(row)} if row["packing"] == "cells" and row["bonds"] in BREAK else ROCK
    group.update({"soft": {"material": {**rock, "young_modulus": 0.4e9}}, "apart": {}, "later": {"material": {**rock, "young_modulus": 4e9}, "stage": 1}}[row["groups"]])
    model.setdefault("groups", []).append(group)
    if row["groups"] == "apart":  # which only touches what lies above
        model["groups"].append({"name": "above", "where": {"x_min": 2.5, "y_min": 2.05}})
        model["between"] = [{"first": "part", "second": "above"}]


def _add_spring(row, model):
    law = {"linear": {"stiffness": 2e8, "tension_only": False}, "tension": {"stiffness": 2e8, "pretension": 1e3},
           "curve": {"curve": {"opening": [-1e-3, 0.0, 1e-3], "force": [-50e3, 0.0, 20e3]}},
           "across": {"stiffness": 2e8, "tension_only": False, "clearance": 1e-5, "direction": {"x": 0.0, "y": 1.0}}}.get(row["spring"])
    if row["spring"] == "bar":
        model["bars"] = [{"along": {"line": {"points": [{"x": 0.4, "y": 1.56}, {"x": 3.6, "y": 1.56}]}}, "diameter": 16e-3, "area": 1e-3,
                          "steel": {"yield_strength": 5e6, "hardening": 0.01}, "concrete_strength": 30e6}]
    if law:
        model["springs"] = [{"name": "tie", "from": {"x": 1.06, "y": 1.06}, "to": {"x": 1.06, "y": 1.94}, **law}]


def _add_load(row, model):
    time = {"sine": {"frequency": 50.0, "end": 0.02}}
    if row["load"] == "push":
        model["loads"] = [{"where": {"y_min": HIGH - 0.5, "x_max": 2.0}, "force": {"x": 30e3, "y": -90e3}, "time": time}]
    elif row["load"] == "body":
        model["body_loads"] = [{"where": {"x_max": 2.05}, "acceleration": {"x": 5.0, "y": -3.0}, "time": time}]
    elif row["load"] == "motion":
        model.setdefault("motions", []).append({"where": {"y_min": HIGH - 0.5}, "velocity": {"x": 0.02, "y": -0.01}, "time": time})
    elif row["load"] == "wall":
        model.setdefault("walls", []).append({"name": "press", "from": {"x": -1.0, "y": HIGH}, "to": {"x": 5.0, "y": HIGH},
                                              "velocity": {"x": 0.01, "y": -0.02, "time": time}})


def _add_rest(row, model):
    if row["rest"] in STATICS:
        model["body_loads"] = model.get("body_loads", []) + [{"acceleration": {"y": -4.0}}]
    hole = {"x_min": 1.5, "x_max": 2.5, "y_min": 1.0, "y_max": 2.05}  # as high as a group beside
    if row["hole"] != "none":
        model["excavations"] = [{"where": hole, **({"stage": 1} if row["hole"] == "stage" else {})}]


def _add_observed(row, model):
    if row["observe"] == "section":
        model["sections"] = [{"name": "cut", "from": {"x": 0.0, "y": 2.31}, "to": {"x": 1.0, "y": 2.31}}]
        model["histories"] += [{"name": "cut", "quantity": quantity, "section": "cut"} for quantity in ("thrust", "moment", "shear_force")]
    if row["observe"] == "joint":
        model["histories"] += [{"name": "line", "quantity": quantity, "joint": "line"} for quantity in ("opening", "offset", "rotation")]
    if row["observe"] == "oval":
        model["ovals"] = [{"name": "round", "annulus": {"centre": {"x": 2.0, "y": 1.5}, "inner_radius": 0.75, "outer_radius": 1.3}}]
        model["histories"] += [{"name": "round", "quantity": quantity, "oval": "round"} for quantity in ("largest_diameter_change", "smallest_diameter_change")]


def _histories(row):
    motion = ("displacement_x", "displacement_y", "velocity_x", "velocity_y", "acceleration_x", "acceleration_y")
    found = [{"name": "low", "quantity": quantity, "at": {"x": 0.61, "y": 0.87}} for quantity in motion]
    found += [{"name": "high", "quantity": quantity, "at": {"x": 3.31, "y": 2.63}} for quantity in motion]
    found += [{"name": "across", "quantity": quantity, "at": {"x": 3.31, "y": 2.63}, "relative_to": {"x": 0.61, "y": 0.87}}
              for quantity in ("displacement_x", "acceleration_y")]
    if row["observe"] == "circles":
        found += [{"name": "ring", "quantity": quantity, "at": {"x": 3.2, "y": 1.5}, "radius": 0.6}
                  for quantity in ("stress_xx", "stress_yy", "stress_xy", "strain_rate_xx", "shear_strain_rate_xy", "coordination", "porosity")]
        if row["packing"] == "cells":
            found.append({"name": "ring", "quantity": "crack_width", "at": {"x": 3.2, "y": 1.5}, "radius": 0.6})
    if row["spring"] == "bar":
        found += [{"name": "bar", "quantity": quantity, "at": {"x": 1.0, "y": 1.56}} for quantity in ("bar_stress", "bar_slip")]
    elif row["spring"] != "none":
        found.append({"name": "tie", "quantity": "spring_force", "spring": "tie"})
    if row["floor"] == "wall":
        found += [{"name": "floor", "quantity": quantity, "wall": "floor"} for quantity in ("force_x", "force_y")]
    return found


def centres():
    """The centres of the placed discs, a hexagonal packing."""
    rows = int((HIGH - LOW) / (RADIUS * math.sqrt(3)))
    return [(RADIUS * (2 * column + 1 + row % 2), LOW + RADIUS * math.sqrt(3) * (row + 0.5)) for row in range(rows) for column in range(16 - row % 2)]
