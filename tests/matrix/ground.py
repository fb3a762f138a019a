"""The matrix of features of shaken ground: what its scenes may say, what they may not say together, and the scene of a row.

The ground is 8 m wide and 4 m high (8 m as a ring), with an opening of 2 m around (0, 2) m; particles take the place of its right end,
of both ends, or of its middle. A scene takes a tenth of a second to compute.
"""
import math

from changes import Mirrored  # noqa: F401, of this world
FACTORS = {
    "plane": ["plane_strain", "plane_stress"],
    "grid": ["block", "blocks", "mesh", "ring", "skewed"],
    "zone": ["assumed_strain", "mixed_discretization"],
    "law": ["elastic", "layers", "mohr_coulomb", "weak_plane", "elements", "reversals", "limited", "scattered", "sand", "clay"],
    "damping": ["none", "rayleigh", "maxwell", "local"],
    "sides": ["free", "rollers", "quiet", "springs", "free_field"],
    "base": ["held", "rigid", "compliant"],
    "motion": ["none", "record", "ricker", "sine", "gabor", "synthetic", "velocity", "stress"],
    "direction": ["x", "y"],
    "load": ["none", "edge", "point", "body"],
    "rest": ["none", "stressed", "kinetic", "local", "adaptive", "unscaled"],
    "hole": ["none", "never", "stage", "side", "two_stages", "released", "filled"],
    "support": ["none", "lining", "jointed", "segments", "arcs", "bolt", "propped"],
    "foundation": ["none", "springs"],
    "large": ["no", "yes"],
    "water": ["none", "table", "sealed", "flows"],
    "inside": ["none", "strip", "ring", "both_ends", "grid"],
    "packing": ["hexagonal", "square", "placed", "random", "cells"],
    "bonds": ["contact", "breakable", "friction", "parallel", "smooth_joint", "spring", "wall"],
    "solve": ["consistent", "lumped", "split"],
    "substeps": ["1", "2", "4", "0"],
    "rows": ["interval", "each_step"],
    "output": ["histories", "all"],
}

PLAIN = {name: values[:1] for name, values in FACTORS.items()}
# Ground with interfaces: planes that slip and open, linings that slip.
WITH_INTERFACES = {
    **PLAIN,
    **{name: FACTORS[name] for name in ("plane", "zone", "sides", "direction", "load", "water", "rows", "output")},
    "damping": ["none", "rayleigh", "maxwell"],
    "grid": ["block", "blocks"], "law": ["elastic", "mohr_coulomb", "reversals"], "base": ["held", "rigid", "compliant"],
    "motion": ["none", "record", "ricker", "velocity"], "rest": ["none", "stressed", "kinetic", "adaptive"], "hole": ["none", "never", "stage"],
    "support": ["none", "lining", "slipping", "bonded", "layered", "reinforced"], "bedding": ["none", "slips", "opens"], "inside": ["none", "strip"],
}

STATICS = {"kinetic", "local", "adaptive", "unscaled"}
STAGED = {"stage", "side", "two_stages", "released", "filled"}

# What the programs refuse, and a word of the refusal.
REFUSED = (
    [({"plane": "plane_stress", "law": law}, "plane strain") for law in ("mohr_coulomb", "weak_plane", "elements", "reversals", "limited", "scattered", "sand", "clay")]
    + [({"plane": "plane_stress", "large": "yes"}, "plane strain")]
    + [({"large": "yes", "inside": inside}, "large_strain") for inside in ("strip", "ring", "both_ends", "grid")]
    + [({"solve": "lumped", "rest": rest}, "lumped") for rest in sorted(STATICS)]
    + [({"foundation": "springs", "hole": hole}, "foundations") for hole in sorted(STAGED)]
    + [({"sides": "free_field", "hole": "side"}, "free_field")]
    + [({"large": "yes", "hole": "filled"}, "small strain")]
    + [({"plane": "plane_stress", "water": water}, "plane strain") for water in ("table", "sealed", "flows")]
    + [({"water": "flows", "inside": inside}, "in an overlap") for inside in ("strip", "both_ends", "grid")]  # below its sea
)


# What cannot be said, because one value speaks of what the other leaves out.
def meaningless(row):
    has = row.get
    particles = has("inside") in ("strip", "ring", "both_ends")
    alone = has("inside") == "none"
    yield alone and (has("solve", "consistent") != "consistent" or has("substeps", "1") != "1")
    yield has("inside") == "grid" and has("substeps", "1") != "1"
    yield "inside" in row and not particles and (has("packing", "hexagonal") != "hexagonal" or has("bonds", "contact") != "contact")
    yield has("base") == "held" and has("motion", "none") != "none"
    yield has("motion") == "none" and has("base", "held") != "held"
    yield has("motion") == "stress" and has("base", "compliant") != "compliant"
    yield has("motion") == "none" and has("direction", "x") != "x"
    yield has("hole") in STAGED and has("rest", "kinetic") not in STATICS
    yield has("inside") == "ring" and (has("hole", "none") != "none" or has("support", "none") != "none" or has("grid", "block") == "ring")
    yield has("inside") in ("strip", "both_ends", "grid") and has("hole") == "side"
    yield has("grid") == "skewed" and (has("support", "none") != "none" or has("sides", "free") == "free_field")
    yield has("inside") == "both_ends" and has("support") == "bolt"  # which needs a zone between itself and the overlap
    yield has("hole") == "side" and has("grid") in ("ring", "skewed")
    # Smooth joints and springs belong to lattices that they cross; sizes of a random packing are chosen by its seed.
    yield has("bonds") in ("smooth_joint", "spring", "wall") and has("inside", "strip") != "strip"
    yield has("packing") == "random" and has("bonds") in ("smooth_joint", "friction", "wall")
    yield has("packing") == "cells" and has("bonds") == "parallel"  # facets join cells instead
    yield has("bedding", "none") != "none" and (has("grid", "block") not in ("block", "blocks") or has("inside") == "ring")
    # A lining that slips needs ground on one side where it is installed.
    yield has("support") in ("slipping", "reinforced") and has("hole") not in (None, "never", "stage")
    yield has("law") == "sand" and has("hole", "none") != "none"  # which has no cohesion to stand around it
    # Ground that is grouted around an opening reaches the overlap of irregular packings where zones are oblique.
    yield has("grid") in ("ring", "skewed") and has("hole") == "filled" and has("inside") == "both_ends" and has("packing") in ("random", "cells")
    # A wall bears no part of a stated stress.
    yield has("bonds") == "wall" and has("rest") == "stressed"


ROCK = {"young_modulus": 1e9, "poisson_ratio": 0.2, "density": 2000.0}
LAWS = {
    "elastic": {},
    "layers": {},
    "mohr_coulomb": {"mohr_coulomb": {"cohesion": 60e3, "friction_angle": 0.5, "dilation_angle": 0.1,
                                      "softening": [{"plastic_shear_strain": 0.01, "cohesion": 30e3}]}},
    "weak_plane": {"weak_plane": {"dip_angle": 0.9, "cohesion": 50e3, "friction_angle": 0.4}},
    "elements": {"hysteretic": {"hyperbola": {"reference_strain": 5e-4}, "elements": 20}},
    "limited": {"hysteretic": {"hyperbola": {"reference_strain": 5e-4}, "elements": 20}, "mohr_coulomb": {"cohesion": 60e3, "friction_angle": 0.5}},
    "reversals": {"hysteretic": {"hyperbola": {"reference_strain": 5e-4}, "memory": "reversals", "damping": {"darendeli": {}}}},
}
LAWS["sand"] = {"pm4sand": {"relative_density": 0.5, "modulus_coefficient": 600.0, "contraction_rate": 0.5, "reconsolidation_from": 0.017}}
LAWS["clay"] = {"mohr_coulomb": {"cohesion": 40e3, "remoulding": {"sensitivity": 4.0, "strain_95": 0.05}}}
LAWS["scattered"] = {**LAWS["limited"], **LAWS["weak_plane"]}
HOLE = {"x_min": -1.0, "x_max": 1.0, "y_min": 1.0, "y_max": 3.0}
CENTRE = {"x": 0.0, "y": 2.0}


def passes_thresholds(row):
    """Whether something yields, breaks, touches or is braked against the sign of its velocity, so that rounding decides in which step."""
    return (row["law"] not in ("elastic", "layers") or row["bonds"] not in ("contact", "spring") or row["packing"] == "random"
            or row["support"] in ("jointed", "bolt", "slipping", "layered", "reinforced") or row.get("bedding", "none") != "none"
            or row["foundation"] == "springs" or row["damping"] == "local")


def scatter():
    """Fields of stiffness and of strength (runs.py)."""
    return {"scatter": [{"of": of, "path": f"field_{of}.csv"} for of in ("stiffness", "strength")]}


def output(row):
    """What is written in which steps."""
    all_ = {"peaks": {}, "field_times": [0.0, 0.013, 0.03]} if row["output"] == "all" else {}
    return {"history_interval": 1e-3 if row["rows"] == "interval" else 1e-9, **all_}


class Ground:
    """The ground of a row: its sides, and what stands where."""

    def __init__(self, row):
        self.row = row
        self.low, self.high = (-2.0, 6.0) if row["grid"] == "ring" else (0.0, 4.0)
        self.left, self.right = -4.0, 4.0

    def scene(self):
        row = self.row
        scene = {"plane": row["plane"], "material": dict(ROCK), "time": {"duration": 0.03}, "continuum": self.continuum(),
                 "output": output(row)}
        if row["rest"] in STATICS:
            scene["statics"] = {"unbalanced_ratio": 1e-6 if passes_thresholds(row) else 1e-8, "max_steps": 20000, "damping": row["rest"] if row["rest"] != "unscaled" else "local",
                                "scale_masses": row["rest"] != "unscaled"}
        if row["water"] != "none":
            scene["water"] = self.water()
        if row["rest"] == "stressed":
            scene["initial_stress"] = {"xx": -20e3, "yy": -80e3, "yy_per_metre": 20e3, "xx_per_metre": 5e3, "xy": 4e3}
        {"none": lambda _: None, "strip": self.add_strip, "ring": self.add_ring, "both_ends": self.add_both, "grid": self.add_grid}[row["inside"]](scene)
        if row["substeps"] != "1":
            scene["time"]["substeps"] = int(row["substeps"])
        return scene

    def water(self):
        """Light water, since gravity is: a table in the ground, or the sea on it from which water comes and goes; wells beside an opening."""
        modulus = {} if self.row["water"] == "table" else {"bulk_modulus": 0.4e9}
        wells = [{"where": {"x_min": -2.0, "x_max": 2.0}, "level": 2.0, "stage": 1}] * (self.row["hole"] in STAGED - {"side"})
        table = self.high - 1e-3 if self.has_wet_cells() else 3.0
        return {"level": 6.5 if self.row["water"] == "flows" else table, "density": 300.0, **modulus, **({"places": wells} if wells else {})}

    def has_wet_cells(self):
        """Cells have pores; other particles are tight."""
        return self.row["inside"] in ("strip", "ring", "both_ends") and self.row["packing"] == "cells"

    def pores(self):
        compaction = {"compaction": {"blow_count": 8.0}} if self.row["law"] == "mohr_coulomb" else {}
        flow = {"conductivity": 2e-3, "conductivity_y": 1e-3, **compaction} if self.row["water"] == "flows" else {}
        return {"porosity": 0.4, "saturated_density": 2020.0, **flow}

    def gravity(self):
        return [{"acceleration": {"y": -4.0}}] if self.row["rest"] in STATICS else []

    # The continuum ---------------------------------------------------------------------------------------------------------------

    def continuum(self):
        row = self.row
        continuum = {**self.grid(), "zone": row["zone"], "material": {**ROCK, **LAWS[row["law"]]}, "large_strain": row["large"] == "yes",
                     "body_loads": self.gravity(), "motions": self.supports(), "histories": self.histories()}
        if row["water"] != "none":
            continuum["material"]["pores"] = self.pores()
        if row["law"] == "layers":
            continuum["materials"] = [{"where": {"y_min": self.low, "y_max": 1.6}, "material": {**ROCK, "young_modulus": 2e9}},
                                      {"where": {"y_min": 2.9}, "material": {**ROCK, "young_modulus": 0.4e9, "density": 1700.0}}]
        if row["damping"] != "none":
            band = {"ratio": 0.03, "low_frequency": 20.0, "high_frequency": 100.0}
            continuum["damping"] = {row["damping"]: {"alpha": 0.2} if row["damping"] == "local" else band}
        if row["law"] == "scattered":
            continuum.update(scatter())
        continuum.update(self.sides())
        continuum.update(self.base())
        continuum.update(self.loads())
        continuum.update(self.hole())
        continuum["materials"] = continuum.get("materials", []) + self.later_materials()
        continuum.update(self.support())
        continuum.update(self.section())
        continuum.update(self.bedding())
        if row["foundation"] == "springs":
            continuum["foundations"] = [{"where": {"x_max": -2.1}, "x": {"stiffness": 20e6, "dashpot": 1e4, "slip_stress": 30e3, "hardening": 0.1},
                                         "y": {"stiffness": 30e6}}]
        return continuum

    def grid(self):
        kind = self.row["grid"]
        if kind == "block":
            return {"block": {"x_min": self.left, "x_max": self.right, "y_min": self.low, "y_max": self.high, "zones_x": 16, "zones_y": 8}}
        if kind == "blocks":
            def block(name, x0, x1, y0, y1):
                return {"name": name, "rectangle": {"x_min": x0, "x_max": x1, "y_min": y0, "y_max": y1},
                        "along": {"zones": round(2 * (x1 - x0))}, "across": {"zones": round(2 * (y1 - y0))}}
            return {"blocks": [block("lower", -4.0, 1.0, 0.0, 1.0), block("lower", 1.0, 4.0, 0.0, 1.0), block("west", -4.0, -1.0, 1.0, 4.0),
                               block("core", -1.0, 1.0, 1.0, 3.0), block("roof", -1.0, 1.0, 3.0, 4.0), block("east", 1.0, 4.0, 1.0, 4.0)]}
        if kind == "mesh":
            return {"mesh": {"path": "mesh.msh"}}
        if kind == "ring":
            return {"blocks": [
                {"name": "core", "rectangle": {"x_min": -0.5, "x_max": 0.5, "y_min": 1.5, "y_max": 2.5}, "along": {"zones": 4}, "across": {"zones": 4}},
                {"name": "core", "ring": {"centre": dict(CENTRE), "inner_side": 1.0, "outer_radius": 1.0}, "along": {"zones": 16}, "across": {"zones": 2}},
                {"name": "ground", "ring": {"centre": dict(CENTRE), "inner_radius": 1.0, "outer_side": 8.0}, "along": {"zones": 16},
                 "across": {"zones": 6, "ratio": 1.2}}]}
        def part(lower, upper):  # a skewed line from (0.4, 0) to (-0.4, 4) m divides the ground
            return {"quadrilateral": {"corners": [{"x": x, "y": y} for x, y in (lower[0], lower[1], upper[1], upper[0])]},
                    "along": {"zones": 8}, "across": {"zones": 8}}
        return {"blocks": [part(((-4.0, 0.0), (0.4, 0.0)), ((-4.0, 4.0), (-0.4, 4.0))),
                           part(((0.4, 0.0), (4.0, 0.0)), ((-0.4, 4.0), (4.0, 4.0)))]}

    def has_right(self):
        return self.row["inside"] not in ("strip", "both_ends", "grid")

    def has_left(self):
        return self.row["inside"] != "both_ends"

    def supports(self):
        row, motions = self.row, []
        if row["base"] == "held":
            motions.append({"where": {"y_max": self.low}, "velocity": {"x": 0.0, "y": 0.0}})
        if row["sides"] == "rollers":
            above = self.low + 0.1
            if self.has_left():
                motions.append({"where": {"x_max": self.left, "y_min": above}, "velocity": {"x": 0.0}})
            if self.has_right():
                motions.append({"where": {"x_min": self.right, "y_min": above}, "velocity": {"x": 0.0}})
        return motions

    def sides(self):
        edges = [{"x_max": self.left}] * self.has_left() + [{"x_min": self.right}] * self.has_right()
        if self.row["sides"] in ("quiet", "springs") and edges:
            return {"quiet": [{"where": dict(edge), **({"source_distance": 12.0} if self.row["sides"] == "springs" else {})} for edge in edges]}
        if self.row["sides"] == "free_field" and edges:
            return {"free_field": {"left": self.has_left(), "right": self.has_right()}}
        return {}

    def base(self):
        row = self.row
        if row["base"] == "held":
            return {}
        base = {"kind": row["base"], "direction": row["direction"]}
        sine = {"sine": {"frequency": 60.0, "end": 1 / 60}}
        sources = {
            "record": {"file": {"path": "record.csv"}, "baseline": False},
            "ricker": {"ricker": {"frequency": 50.0, "time": 0.015}, "peak": 4.0},
            "sine": {"sine": {"frequency": 50.0, "end": 0.02}, "peak": 4.0},
            "gabor": {"gabor": {"frequency": 60.0, "time": 0.015}, "peak": 4.0},
            "synthetic": {"synthetic": {"seed": 3}, "peak": 400.0, "until": 4.0},  # of whose 4 s the run takes the quiet beginning
        }
        if row["motion"] in sources:
            base["acceleration"] = sources[row["motion"]]
        elif row["motion"] == "velocity":
            base["velocity"] = {"amplitude": 0.02, "time": sine}
        else:
            base["stress"] = {"amplitude": 20e3, "time": sine}
        return {"base": base}

    def loads(self):
        time = {"sine": {"frequency": 50.0, "end": 0.02}}
        kind = self.row["load"]
        top = {"x_min": -2.0, "x_max": 0.0 if self.row["grid"] != "skewed" else -0.4, "y_min": self.high}
        if kind == "edge":
            return {"edge_loads": [{"where": top, "force": {"x": 60e3, "y": -150e3}, "time": time}]}
        if kind == "point":
            return {"point_loads": [{"where": top, "force": {"x": 60e3, "y": -150e3}, "time": time}]}
        if kind == "body":
            return {"body_loads": self.gravity() + [{"where": {"x_min": -2.1, "x_max": 0.1}, "acceleration": {"x": 5.0, "y": -3.0}, "time": time}]}
        return {}

    def hole(self):
        whole = {"group": "core"} if self.row["grid"] in ("blocks", "ring") else dict(HOLE)
        upper = {**whole, "y_min": 2.0}
        return {
            "none": {},
            "never": {"excavations": [{"where": whole}]},
            "stage": {"excavations": [{"where": whole, "stage": 1}]},
            "side": {"excavations": [{"where": {"x_max": -3.0, "y_min": 1.0, "y_max": 3.0}, "stage": 1}]},
            "two_stages": {"excavations": [{"where": upper, "stage": 1}, {"where": whole, "stage": 2}]},
            "released": {"excavations": [{"where": whole, "stage": 1, "released": 0.4}]},
            "filled": {"excavations": [{"where": whole, "stage": 1, "released": 0.4}]},
        }[self.row["hole"]]

    def later_materials(self):
        """Ground beside the hole is grouted before it is excavated, and its lower half is filled."""
        if self.row["hole"] != "filled":
            return []
        lower = {**({"group": "core"} if self.row["grid"] in ("blocks", "ring") else HOLE), "y_max": 2.0}
        plastic = {"mohr_coulomb": {"cohesion": 80e3, "friction_angle": 0.4}} if self.row["plane"] == "plane_strain" else {}
        return [{"where": {"x_min": -1.6, "x_max": -1.0, "y_min": 1.0, "y_max": 3.0}, "stage": 1, "material": {**ROCK, "young_modulus": 1.5e9, **plastic}},
                {"where": lower, "stage": 2, "material": {**ROCK, "young_modulus": 0.6e9, "density": 1500.0}}]

    def support(self):
        kind, stage = self.row["support"], {"stage": 2} if self.row["hole"] in ("released", "two_stages") else {}
        if kind == "none":
            return {}
        if kind == "bolt":
            from_, to = ({"x": -2.0, "y": 2.0}, {"x": -1.0, "y": 2.0}) if self.row["grid"] != "ring" else ({"x": -2.0, "y": 6.0}, {"x": 0.0, "y": 6.0})
            return {"bolts": [{"from": from_, "to": to, "area": 5e-4, "spacing": 1.0, "young_modulus": 200e9, "density": 7800.0,
                               "yield_force": 50e3, **stage}]}
        section = {"thickness": 0.2, "young_modulus": 20e9, "density": 2500.0, **stage}
        joint = {"jointed": {"joints": [{"at": {"x": 0.0, "y": 3.0}, "rotational_stiffness": 5e6, "yield_moment": 3e3}]},
                 "segments": {"joints": [{"at": {"x": 0.0, "y": 3.0}, "contact": {"height": 0.12},
                                          "bolts": [{"stiffness": 50e6, "pretension": 20e3, "yield_force": 40e3, "position": -0.02}],
                                          "gasket": {"force": {"opening": [-1e-3, 0.0, 4e-3], "force": [-20e3, -5e3, 0.0]}, "position": 0.08,
                                                     "width": 0.03, "water_pressure": 100e3}}]}}.get(kind, {})
        if self.row["grid"] == "ring":
            whole = {"circle": {"centre": dict(CENTRE), "radius": 1.0}}
            halves = [{"circle": {**whole["circle"], "from": 0.0, "to": math.pi}}, {"circle": {**whole["circle"], "from": math.pi, "to": 2 * math.pi}}]
        else:
            def line(*points):
                return {"line": {"points": [{"x": float(x), "y": float(y)} for x, y in points]}}
            whole = line((1, 2), (1, 3), (-1, 3), (-1, 1), (1, 1), (1, 2))
            halves = [line((1, 2), (1, 3), (-1, 3), (-1, 2)), line((-1, 2), (-1, 1), (1, 1), (1, 2))]
        if kind == "arcs":
            return {"linings": [{"name": name, "along": half, **section} for name, half in zip(("upper", "lower"), halves)]}
        if kind == "reinforced":  # and slipping, with bars that differ on both sides
            section = {**stage, "section": {
                "thickness": 0.2, "cover": 0.03, "concrete": {"class": "C20/25"}, "steel": {"class": "B500B", "law": "menegotto_pinto", "rupture_strain": 0.05},
                "stirrups": {"diameter": 0.006, "spacing": 0.1, "spacing_across": 0.2, "confinement": 0.5},
                "inner": {"diameter": 0.012, "spacing": 0.2}, "outer": {"diameter": 0.008, "spacing": 0.2}}}
        if kind in ("slipping", "reinforced"):
            section["interface"] = {"friction_angle": 0.4, "cohesion": 2e3}
            if self.row["hole"] == "stage":
                section["stage"] = 1
        second = {"name": "second", "on": "lining", "thickness": 0.1, "young_modulus": 30e9,
                  **({"stage": 1} if self.row["hole"] == "stage" else stage),
                  **({"interface": {"friction_angle": 0.3}} if kind == "layered" else {})}
        layers = [second] if kind in ("bonded", "layered") else []
        lining = {"linings": [{"name": "lining", "along": whole, **section, **joint}, *layers]}
        if kind == "propped":
            prop = {"name": "prop", "from": {"x": 0.0, "y": 1.0}, "to": {"x": 0.0, "y": 3.0}, "spacing": 2.0, "width": 0.5, "elements": 3,
                    "last_end_hinged": True, **section}
            return {**lining, "members": [prop]}
        return lining

    def bedding(self):
        """A plane below the opening, from the left side to a tip in the ground."""
        if self.row.get("bedding", "none") == "none":
            return {}
        law = {"slips": {"friction_angle": 0.3, "dilation_angle": 0.1, "cohesion": 5e3, "residual": {"cohesion": 0.0, "slip": 1e-3}},
               "opens": {"friction_angle": 0.5, "cohesion": 20e3, "tension": 10e3, "normal_stiffness": 4e9, "shear_stiffness": 2e9}}[self.row["bedding"]]
        points = [{"x": self.left, "y": 0.5}, {"x": 1.0, "y": 0.5}]
        return {"interfaces": [{"name": "bedding", "along": {"line": {"points": points}}, "law": law}]}

    def has_section(self):
        return self.row["grid"] in ("block", "blocks", "mesh") and self.row["hole"] != "side"

    def section(self):
        return {"sections": [{"name": "cut", "from": {"x": -3.0, "y": self.low}, "to": {"x": -3.0, "y": self.high}}]} if self.has_section() else {}

    def histories(self):
        quantities = ["displacement_x", "displacement_y", "velocity_x", "velocity_y", "acceleration_x", "acceleration_y", "stress_xx", "stress_yy",
                      "stress_xy", "stress_zz", "strain_xx", "strain_yy", "shear_strain_xy"]
        if self.row["law"] in ("mohr_coulomb", "weak_plane", "limited", "scattered"):
            quantities.append("demand")
        if self.row["water"] != "none":
            quantities += ["pore_pressure", "pressure_ratio", "effective_stress_xx", "effective_stress_yy"]
        found = [{"name": name, "quantity": quantity, "at": {"x": x, "y": y}}
                 for name, x, y in (("low", -1.72, 0.63), ("high", 1.61, 3.34)) for quantity in quantities]
        found += [{"name": "across", "quantity": quantity, "at": {"x": 1.61, "y": 3.34}, "relative_to": {"x": -1.72, "y": 0.63}}
                  for quantity in ("displacement_x", "acceleration_y")]
        if self.has_section():
            found += [{"name": "cut", "quantity": quantity, "section": "cut"} for quantity in ("thrust", "moment", "shear_force")]
        between = [("bedding", {"x": 0.0, "y": 0.5})] * (self.row.get("bedding", "none") != "none")
        between += [("lining", {"x": 0.0, "y": 3.0})] * (self.row["support"] in ("slipping", "reinforced"))
        found += [{"name": name, "quantity": quantity, "interface": name, "at": dict(at)} for name, at in between
                  for quantity in ("opening", "offset", "normal_stress", "shear_stress")]
        names = {"none": [], "bolt": [], "arcs": ["upper", "lower"]}.get(self.row["support"], ["lining"])
        at = {"lower": {"x": 0.0, "y": 1.0}}
        if self.row["support"] == "reinforced":
            found += [{"name": "lining", "quantity": quantity, "lining": "lining", "at": {"x": 0.0, "y": 3.0}} for quantity in ("utilisation", "curvature")]
        if self.row["support"] == "propped":
            found += [{"name": "prop", "quantity": quantity, "member": "prop", "at": {"x": 0.0, "y": 1.0}} for quantity in ("thrust", "moment")]
        if self.row["support"] == "segments":
            found += [{"name": "joint", "quantity": quantity, "lining": "lining", "at": {"x": 0.0, "y": 3.0}}
                      for quantity in ("outer_opening", "inner_opening", "gasket_opening", "tightness", "bolt_force")]
        return found + [{"name": name, "quantity": quantity, "lining": name, "at": dict(at.get(name, {"x": 0.0, "y": 3.0}))}
                        for name in names for quantity in ("thrust", "moment")]

    # The models inside -----------------------------------------------------------------------------------------------------------

    RADIUS = 4 / (16 * math.sqrt(3))  # 16 rows in 4 m

    def particles(self, x, columns, low, high):
        """Particles of a box that begins at x and is `columns` discs wide."""
        row, radius = self.row, self.RADIUS
        box = {"x_min": x, "x_max": x + 2 * radius * columns, "y_min": low, "y_max": high}
        model = {
            "hexagonal": {"packing": {**box, "radius": radius}},
            "square": {"square_packing": {**box, "x_max": x + 0.25 * columns, "radius": 0.125}},
            "placed": {"placed": {"path": f"placed_{x:.4g}_{columns}_{low:g}_{high:g}.csv"}, "bonds": {"reach": 1e-5}},
            # Discs of a corner may be left out: the packing begins before the overlap.
            "random": {"random_packing": {**box, "x_min": x - 0.4, "x_max": box["x_max"] + 0.4, "radius_min": 0.12, "radius_max": 0.18, "stress": 50e3}},
            "cells": {"cells": {**box, "size": 2 * radius}},
        }[row["packing"]]
        model["body_loads"] = self.gravity()
        if row["law"] == "scattered":
            model.update(scatter())
        if row["foundation"] == "springs" and row["inside"] != "ring":
            model["foundations"] = [{"where": {"x_min": 5.0} if x > 0 else {"x_max": -5.0}, "x": {"stiffness": 20e6, "dashpot": 1e5}}]
        if row["rest"] in STATICS and row["inside"] != "ring":  # beyond the overlap they stand on rock that does not move
            beyond = {"x_min": 4.2} if x > 0 else {"x_max": -4.2}
            model["motions"] = [{"where": {"y_max": low + (0.6 if row["packing"] == "random" else 0.3), **beyond}, "velocity": {"x": 0.0, "y": 0.0}}]
        # Some break in time; before, the body bears its weight, which few contacts of a random packing carry.
        strength = 20e3 if row["rest"] not in STATICS else 100e3 if row["packing"] != "random" else 500e3
        bonds = {
            "contact": {}, "smooth_joint": {}, "spring": {}, "wall": {},
            # Such that some break in time, and that the body bears its weight before.
            "breakable": {"bonds": {"tensile_strength": strength, "shear_strength": 3 * strength}},
            "friction": {"bonds": {}, "contacts": {"friction": 0.5, "normal_damping": 0.1}},
            "parallel": {"bonds": {"parallel": {"normal_stiffness": 4e9, "shear_stiffness": 1.5e9, "cohesion": 1e6, "tensile_strength": 0.3e6}},
                         "contacts": {"friction": 0.5}},
        }[row["bonds"]]
        if row["packing"] == "cells" and row["bonds"] == "breakable":
            bonds = {"bonds": {"fracture": {"tensile_strength": 2 * strength, "fracture_energy": 100.0, "cohesion": 6 * strength}}}
        model.update({**bonds, "bonds": {**model.get("bonds", {}), **bonds.get("bonds", {})}})
        if row["water"] != "none" and row["packing"] == "cells":
            model["material"] = {**ROCK, "pores": self.pores()}
        if row["bonds"] == "smooth_joint":
            model["joints"] = [{"name": "plane", "from": {"x": 4.4, "y": low - 0.1}, "to": {"x": 4.4, "y": high + 0.1},
                                "smooth": {"normal_stiffness": 5e9, "shear_stiffness": 2e9, "friction": 0.5}}]
        if row["bonds"] == "spring":
            model["springs"] = [{"name": "tie", "from": {"x": 4.3, "y": 2.06}, "to": {"x": 5.33, "y": 2.06}, "stiffness": 2e8, "tension_only": False}]
        if row["bonds"] == "wall":
            model["walls"] = [{"name": "floor", "from": {"x": 4.4, "y": low}, "to": {"x": 7.0, "y": low}}]
        return model

    def probes(self, name, x, y):
        return [{"name": name, "quantity": quantity, "at": {"x": x, "y": y}} for quantity in
                ("displacement_x", "displacement_y", "velocity_x", "velocity_y", "acceleration_x")] + [
                {"name": name, "quantity": quantity, "at": {"x": x, "y": y}, "radius": 0.6} for quantity in ("stress_xx", "stress_xy")]

    def add_strip(self, scene):
        scene["particles"] = {**self.particles(2.0, 14, self.low, self.high), "histories": self.probes("end", 5.21, 2.07)}
        scene["interface"] = self.interface({"particles_begin": {"x": 2.0, "y": 0.0}, "continuum_ends": {"x": 4.0, "y": 0.0}})

    def add_ring(self, scene):
        half = 14 * self.RADIUS if self.row["packing"] != "square" else 1.75
        scene["particles"] = {**self.particles(-half, 14, self.low, self.high), "histories": self.probes("middle", 0.23, 2.07)}
        scene["interface"] = self.interface({"around": {"circle": {"centre": dict(CENTRE), "radius": 0.7}}, "width": 0.9})

    def add_both(self, scene):
        self.add_strip(scene)
        width = 28 * self.RADIUS if self.row["packing"] != "square" else 3.5
        scene["regions"] = [{"name": "west", "particles": {**self.particles(-2.0 - width, 14, self.low, self.high), "histories": self.probes("west", -5.21, 2.07)}}]
        scene["interfaces"] = [{**self.interface({"particles_begin": {"x": -2.0, "y": 0.0}, "continuum_ends": {"x": -4.0, "y": 0.0}}),
                                "outer": "continuum", "inner": "west"}]

    def add_grid(self, scene):
        wet = {"material": {**ROCK, "pores": self.pores()}} if self.row["water"] != "none" else {}
        scene["regions"] = [{"name": "fine", "continuum": {
            **wet,
            "block": {"x_min": 2.0, "x_max": 5.0, "y_min": self.low, "y_max": self.high, "zones_x": 12, "zones_y": round(4 * (self.high - self.low))},
            "body_loads": self.gravity(), **(scatter() if self.row["law"] == "scattered" else {}),
            "histories": [{"name": "end", "quantity": quantity, "at": {"x": 4.6, "y": 2.1}} for quantity in ("velocity_x", "stress_xx", "stress_xy")]}}]
        scene["interfaces"] = [{**self.interface({"particles_begin": {"x": 2.0, "y": 0.0}, "continuum_ends": {"x": 4.0, "y": 0.0}}),
                                "outer": "continuum", "inner": "fine"}]

    def interface(self, overlap):
        return {"overlap": overlap, "solve": self.row["solve"], **({"decay_rate": 2000.0} if self.row["solve"] == "split" else {})}


def scene(row):
    return Ground(row).scene()
