"""The matrix of features of lined tunnels: shapes, linings and their joints, ground in layers and with faults, stages, shaking.

The tunnel is 2 m wide around the origin, in ground 8 m wide and high; a second one may stand east of it. Its lining is of particles, or,
as `IN_GRID` says, of beams or zones. A scene takes half a second
to compute.
"""
import math
import re

import changes
import ground
import schema

FACTORS = {
    "plane": ["plane_strain", "plane_stress"],
    "shape": ["circle", "horseshoe", "box"],
    "particles": ["lattice", "cells", "waiting"],
    "lining": ["solid", "breakable", "concrete", "reinforced", "segments", "bolts", "gasket", "keys", "neighbours"],
    "to_ground": ["touches", "bonded"],
    "tunnels": ["one", "two"],
    "ground": ["one", "layers", "stated", "plastic", "gouge", "fault"],
    "damping": ["none", "local"],
    "stage": ["always", "stage", "released"],
    "rest": ["none", "stressed", "kinetic", "local", "adaptive"],
    "sides": ["rollers", "quiet", "springs", "free_field"],
    "base": ["held", "rigid", "compliant"],
    "load": ["none", "edge", "body"],
    "substeps": ["1", "4", "0"],
    "rows": ["interval", "each_step"],
    "output": ["histories", "all"],
}

# Linings of beams and zones, whose grid follows the opening.
IN_GRID = {
    **FACTORS, "as": ["beam", "zones"], "particles": ["none"], "to_ground": ["touches"], "damping": ["none"], "substeps": ["1"],
    "lining": ["solid", "slips", "layers", "segments", "rings", "reinforced"], "ground": ["one", "layers", "plastic"],
}

STATICS = {"kinetic", "local", "adaptive"}
JOINTED = {"segments", "bolts", "gasket", "keys", "neighbours"}

# What the programs refuse, and a word of the refusal.
REFUSED = (
    [({"shape": shape, **lining}, "segments") for shape in ("horseshoe", "box") for lining in ({"lining": "segments"}, {"as": "beam", "lining": "rings"})]
    + [({"plane": "plane_stress", "ground": "plastic"}, "plane strain")]
    + [({"particles": "lattice", "lining": "reinforced"}, "lattice of discs")]
    + [({"particles": "waiting", "load": "body"}, "loads that change"), ({"particles": "waiting", "lining": "reinforced"}, "bars")]
    + [({"as": "zones", "lining": lining, "stage": stage}, "tied to what lies outside") for lining in ("slips", "layers") for stage in ("stage", "released")]
    + [({"as": "zones", "lining": lining}, "segments") for lining in ("segments", "rings")]
)


# What cannot be said, because one value speaks of what the other leaves out.
def meaningless(row):
    has = row.get
    yield has("shape", "circle") != "circle" and has("lining") in JOINTED - {"segments"}
    yield has("stage") in ("stage", "released") and has("rest", "kinetic") not in STATICS


def passes_thresholds(row):
    """Whether something yields, breaks or touches, so that rounding decides in which step: a lining that is not bonded touches the ground."""
    return True


def is_idle(row):
    """Whether nothing moves in its scene, which has no size to compare with."""
    return row["base"] == "held" and row["load"] == "none" and row["rest"] == "none"


ROCK = {"young_modulus": 1e9, "poisson_ratio": 0.2, "density": 2000.0}
STRENGTH = {"tensile_strength": 0.5e6, "fracture_energy": 50.0, "compressive_strength": 5e6}  # of ground that could break
CONCRETE = {"young_modulus": 20e9, "poisson_ratio": 0.2, "density": 2500.0}
CLASS = "C15"
LOW, HIGH, WEST = -4.0, 4.0, -4.0
APART = 6.5  # of the two tunnels


def scene(row):
    """The scene of a row."""
    whole = {"plane": row["plane"], "material": _rock(row), "time": {"duration": 0.03, "substeps": int(row["substeps"])},
             "continuum": _continuum(row), "tunnels": _tunnels(row), "output": ground.output(row)}
    if row["rest"] in STATICS:
        whole["statics"] = {"unbalanced_ratio": 1e-6, "max_steps": 40000, "damping": row["rest"]}
    if row["rest"] == "stressed":
        whole["initial_stress"] = {"xx": -20e3, "yy": -80e3, "yy_per_metre": 20e3, "xx_per_metre": 5e3}
    return whole


def _rock(row):
    return {**ROCK, "fracture": STRENGTH} if row["particles"] == "waiting" else dict(ROCK)


class Mirrored(changes.Mirrored):
    """Joints and sections are numbered counter-clockwise, from the first joint and from the right springline."""

    NUMBERED = re.compile(r"_(joint|bolt|gasket|key|section)_(\d)_")

    def message(self, name, value):
        value = super().message(name, value)
        for angle in ("first_joint", "first_dowel"):
            if name in ("TunnelLining", "SecondRing") and angle in value:
                value[angle] = changes.PI - value[angle]
        return value

    def column(self, name):
        name = re.sub("_(left|right)_", lambda found: f"_{changes.MIRRORED[found[1]]}_", name)
        return self.NUMBERED.sub(lambda found: f"_{found[1]}_{self.number_of(found[1], int(found[2]))}_", name)

    @staticmethod
    def number_of(kind, number):
        """Of four, the first of which mirrors itself where it is a joint, and the third where it is a section."""
        return ((1 if kind != "section" else 3) - number) % 4 + 1

    def factor(self, column):
        # The far face of a lining's joint changes sides with it, so that its rotation keeps its sign.
        part = self.NUMBERED.search(column)
        if part and schema.quantity(column).startswith("rotation"):
            return 1.0
        return -1.0 if part and part[1] == "key" else super().factor(column)  # which resists the offset


def _east(row):
    return 4.0 + APART * (row["tunnels"] == "two")


# Of the ground around the lining ------------------------------------------------------------------------------------------------

def _tunnels(row):
    first = {"name": "west", "centre": {"x": 0.0, "y": 0.0}, row["shape"]: _SIZES[row["shape"]], **_inside(row), "sections": 4}
    if row["stage"] != "always":
        first["stage"] = 1
    if row["stage"] == "released":
        first["released"] = 0.4
    found = [first]
    if row["tunnels"] == "two":
        plain = {**row, "lining": "solid", "ground": row["ground"] if row["ground"] in ("layers", "plastic") else "one"}
        found.append({"name": "east", "centre": {"x": APART, "y": 0.0}, "circle": {"radius": 1.0}, **_inside(plain), "sections": 4})
    return found


# Of a horseshoe, four equal parts of the contour begin at the springlines, the crown and the invert, which mirror each other.
_SIZES = {"circle": {"radius": 1.0}, "horseshoe": {"width": 2.0, "height": math.pi / 2}, "box": {"width": 2.0, "height": 2.0}}


def _inside(row):
    return {"lining": _lining_in_grid(row)} if "as" in row else {"lining": _lining(row), "particles": _region(row)}


# Numbers in place of classes and defaults, which no change of scale would reach.
_SECTION = {"thickness": 0.4, "cover": 0.04,
            "concrete": {"young_modulus": 20e9, "compressive_strength": 30e6, "tensile_strength": 0.0, "tension_stiffening": False},
            "steel": {"young_modulus": 200e9, "yield_strength": 400e6, "hardening": 0.01, "law": "menegotto_pinto"},
            "stirrups": {"diameter": 0.01, "spacing": 0.2, "spacing_across": 0.3, "confinement": 0.6},
            "inner": {"diameter": 0.016, "spacing": 0.15}, "outer": {"diameter": 0.016, "spacing": 0.15}}


def _lining_in_grid(row):
    solid = {"thickness": 0.4, "material": dict(CONCRETE)}
    slips = {**solid, "interface": {"friction_angle": 0.5, "cohesion": 20e3}}
    segments = {"segments": 4, "first_joint": math.pi / 4, "contact": {"height": 0.2},
                "bolts": {"length": 0.4, "stiffness": 1e8, "strength": 1e5}}
    return {"as": row["as"], **{
        "solid": solid,
        "slips": slips,
        "layers": {"layers": [{"name": "first", "thickness": 0.2, "material": dict(CONCRETE)},
                              {"name": "second", "thickness": 0.3, "material": dict(CONCRETE), "interface": {"friction_angle": 0.2}}]},
        "segments": {**solid, **segments},
        "rings": {**slips, **segments, "second_ring": {"first_joint": 0.0, "width": 1.2, "dowels": 8, "first_dowel": math.pi / 8,
                                                       "dowel_stiffness": 1e8, "dowel_strength": 20e3}},
        "reinforced": {"section": dict(_SECTION)},
    }[row["lining"]]}


def _section_of_cells():
    section = {**_SECTION, "thickness": 0.42}
    section["concrete"] = {key: value for key, value in section["concrete"].items() if key != "tension_stiffening"}
    section["concrete"]["tensile_strength"] = 1e6
    return section


def _lining(row):
    if row["lining"] == "reinforced":
        return {"section": _section_of_cells(), **({"to_ground": {}} if row["to_ground"] == "bonded" else {})}
    lining = {"thickness": 0.42, "material": dict(CONCRETE)}
    if row["to_ground"] == "bonded":
        lining["to_ground"] = {}
    kind = row["lining"]
    if kind == "breakable" and row["particles"] != "lattice":
        lining["material"]["fracture"] = {"tensile_strength": 0.3e6, "fracture_energy": 20.0, "cohesion": 1e6}
    elif kind == "concrete":
        lining["material"] = {"concrete": CLASS, "density": 2500.0}
    elif kind == "breakable":
        lining["bonds"] = {"tensile_strength": 40e3, "shear_strength": 120e3}
    if kind in JOINTED:
        lining.update({"segments": 4, "first_joint": math.pi / 4})
    lining.update({
        "bolts": {"bolts": {"length": 0.4, "stiffness": 1e8, "pretension": 1e3, "strength": 1e5}},
        "gasket": {"gasket": {"opening": [-1e-2, 0.0, 1e-2], "force": [-50e3, -1e3, 0.0]}},
        "keys": {"keys": {"stiffness": 1e8, "clearance": 1e-5}},
        "neighbours": {"neighbours": {"rotational_stiffness": 5e6}},
    }.get(kind, {}))
    return lining


def _region(row):
    grains = {"radius": 0.08} if row["particles"] == "lattice" else {"size": 0.2, "ground_size": 0.3}
    region = {**grains, "ground": 0.9, "overlap": 0.5, "bonds": {}}
    if row["particles"] == "waiting":
        region["begin"] = {"demand": 0.8}
    if row["ground"] == "stated":
        region["material"] = {**_rock(row), "young_modulus": 1.02e9}
    if row["ground"] == "gouge":
        region["groups"] = [{"name": "gouge", "where": {"y_max": -1.75}, "material": {**ROCK, "young_modulus": 0.97e9}}]
    if row["ground"] == "fault":
        region["joints"] = [{"name": "fault", "from": {"x": 0.0, "y": 1.45}, "to": {"x": 0.0, "y": 2.4},
                             "smooth": {"normal_stiffness": 5e9, "shear_stiffness": 2e9, "friction": 0.5}}]
    if row["damping"] == "local":
        region["damping"] = {"local": 0.1}
    return region


# The continuum --------------------------------------------------------------------------------------------------------------------

def _continuum(row):
    right = _east(row)
    continuum = {"block": {"x_min": WEST, "x_max": right, "y_min": LOW, "y_max": HIGH, "zones_x": round(2 * (right - WEST)), "zones_y": 16}}
    if row["ground"] == "layers":
        continuum["materials"] = [{"where": {"y_max": -0.5}, "material": {**ROCK, "young_modulus": 1.6e9}}]
    if row["ground"] == "plastic":
        continuum["material"] = {**_rock(row), "mohr_coulomb": {"cohesion": 60e3, "friction_angle": 0.5}}
    gravity = [{"acceleration": {"y": -4.0}}] if row["rest"] in STATICS else []
    time = {"sine": {"frequency": 50.0, "end": 0.02}}
    if row["load"] == "body":
        gravity = gravity + [{"acceleration": {"x": 3.0, "y": -2.0}, "time": time}]
    if row["load"] == "edge":
        continuum["edge_loads"] = [{"where": {"x_min": -2.0, "x_max": 1.0, "y_min": HIGH}, "force": {"x": 60e3, "y": -150e3}, "time": time}]
    continuum["body_loads"] = gravity
    continuum["motions"] = [{"where": {"y_max": LOW}, "velocity": {"x": 0.0, "y": 0.0}}] if row["base"] == "held" else []
    edges = [{"x_max": WEST}, {"x_min": right}]
    if row["sides"] == "rollers":
        continuum["motions"] += [{"where": {**edge, "y_min": LOW + 0.1}, "velocity": {"x": 0.0}} for edge in edges]
    elif row["sides"] == "free_field":
        continuum["free_field"] = {"left": True, "right": True}
    else:
        continuum["quiet"] = [{"where": edge, **({"source_distance": 12.0} if row["sides"] == "springs" else {})} for edge in edges]
    if row["base"] != "held":
        continuum["base"] = {"kind": row["base"], "acceleration": {"file": {"path": "record.csv"}, "baseline": False}}
    continuum["histories"] = [{"name": "west", "quantity": quantity, "at": {"x": -2.9, "y": 1.3}} for quantity in
                              ("displacement_x", "displacement_y", "velocity_x", "velocity_y", "acceleration_x", "stress_xx", "stress_yy", "stress_xy")]
    return continuum
