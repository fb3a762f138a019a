"""Ways to write a scene that must not matter, or whose effect is known: each changes a scene and says how its outputs change.

A change has `scene(scene)`, the scene so changed, and `factor(column)`, by which a column of its histories is multiplied to be the
one of the original, and `column(name)`, the name under which the changed run writes it.
"""
import schema

PI = 3.141592653589793
MIRRORED = {"left": "right", "right": "left"}


class Same:
    """The scene as it stands; the base of all changes."""

    def scene(self, scene):
        return schema.walk(scene, self)

    def number(self, name, key, unit, value):
        return value

    def message(self, name, value):
        return value

    def place(self, x, y):
        """Where a point of a table or a mesh goes."""
        point = self.message("Point", {"x": x, "y": y})
        return tuple(self.number("Point", axis, "m", point[axis]) for axis in ("x", "y"))

    def column(self, name):
        return name

    def factor(self, column):
        return 1.0


def _swapped(value, one, other):
    """The message with two of its keys exchanged, as far as they are there."""
    return {{one: other, other: one}.get(key, key): content for key, content in value.items()}


class Mirrored(Same):
    """Left and right exchanged: x becomes -x."""

    ODD = {"Force": ["x"], "Acceleration": ["x"], "Velocity": ["x"], "Displacement": ["x"], "Point": ["x"], "Stress": ["xy"],
           "WeakPlane": ["dip_angle"], "ParticleMotion": ["spin"], "WallVelocity": ["x"]}

    def message(self, name, value):
        for key in self.ODD.get(name, []):
            if key in value:
                value[key] = -value[key]
        if "x_min" in value or "x_max" in value:
            value = _swapped(value, "x_min", "x_max")
            for key in {"x_min", "x_max"} & value.keys():
                value[key] = -value[key]
        if name == "FreeField":
            value = _swapped(value, "left", "right")
        if name == "QuietParticles":
            value["side"] = MIRRORED.get(value["side"], value["side"])
        if name == "GridBlock" and "ring" not in value:
            value["along"] = self.turned(value["along"])
        if name == "Quadrilateral":
            value["corners"] = [value["corners"][i] for i in (1, 0, 3, 2)]
            value["arcs"] = [{**arc, "side": MIRRORED.get(arc["side"], arc["side"])} for arc in value.get("arcs", [])]
        if name == "LinePath":  # the ground stays on its right
            value["points"] = value["points"][::-1]
        if name == "RoundPath" and "from" in value:
            value = {**value, "from": PI - value["to"], "to": PI - value["from"]}
        if name == "LiningJoint" and "angle" in value:
            value["angle"] = PI - value["angle"]
        if name == "Lining":
            value = _swapped(value, "first_end_fixed", "last_end_fixed")
        if name == "Member":  # its right stays its right
            value = _swapped(_swapped(value, "from", "to"), "first_end_hinged", "last_end_hinged")
        if name == "ParticleJoint":  # the same face stays the far one, on the left
            value = _swapped(value, "from", "to")
        if name == "Base" and value.get("direction", "x") == "x":
            value = self.reversed_base(value)
        return value

    @staticmethod
    def turned(division):
        return division if division.get("from_both_ends") else {**division, "ratio": 1 / division.get("ratio", 1)}

    @staticmethod
    def reversed_base(base):
        """A base moves the other way. A motion has no sign of its own but by its `amplitude` or its table."""
        for kind in ("velocity", "stress"):
            if kind in base:
                base[kind]["amplitude"] = -base[kind]["amplitude"]
        if "acceleration" in base:
            source = base["acceleration"]
            source["file"] = {**source["file"], "path": source["file"]["path"].replace("record", "negative")}
        return base

    def factor(self, column):
        what = schema.quantity(column)
        odd = what[:2] in ("ux", "vx", "ax", "fx") or what.startswith(("sxy", "gxy", "shear", "offset", "rotation", "bar_slip"))
        return -1.0 if odd else 1.0


class Turned(Same):
    """The whole scene turned by a quarter, counter-clockwise: (x, y) becomes (-y, x)."""

    ACROSS = {"ux": "uy", "uy": "ux", "vx": "vy", "vy": "vx", "ax": "ay", "ay": "ax", "fx": "fy", "fy": "fx", "sxx": "syy", "syy": "sxx",
              "exx": "eyy", "eyy": "exx"}
    VECTORS = {"Point", "Force", "Acceleration", "Velocity", "Displacement", "WallVelocity"}

    def message(self, name, value):
        if name in self.VECTORS:
            turned = {}
            if "y" in value:
                turned["x"] = -value["y"]
            if "x" in value:
                turned["y"] = value["x"]
            return turned
        if {"x_min", "x_max", "y_min", "y_max"} & value.keys():
            value = {{"x_min": "y_min", "x_max": "y_max", "y_min": "x_max", "y_max": "x_min"}.get(key, key): content for key, content in value.items()}
            for key in {"x_min", "x_max"} & value.keys():
                value[key] = -value[key]
        if name == "Block":
            value = _swapped(value, "zones_x", "zones_y")
        if name == "GridBlock" and "rectangle" in value:  # a rectangle's `along` is x
            value = {**value, "along": Mirrored.turned(value["across"]), "across": value["along"]}
        if name == "Stress":
            value = _swapped(value, "xx", "yy")
            value["xy"] = -value.get("xy", 0.0)
        if name == "WeakPlane":
            value["dip_angle"] = value["dip_angle"] + PI / 2
        if name == "LiningJoint" and "angle" in value:
            value["angle"] = value["angle"] + PI / 2
        if name == "RoundPath" and "from" in value:
            value = {**value, "from": value["from"] + PI / 2, "to": value["to"] + PI / 2}
        if name == "Foundation":
            value = _swapped(value, "x", "y")
        if name == "History":
            value["quantity"] = self.quantity(value["quantity"])
        return value

    @staticmethod
    def quantity(name):
        ends = {"_x": "_y", "_y": "_x", "_xx": "_yy", "_yy": "_xx"}
        end = next((end for end in ends if name.endswith(end)), None)
        return name[:-len(end)] + ends[end] if end else name

    def column(self, name):
        what = schema.quantity(name)
        key = next((key for key in self.ACROSS if what.startswith(key + "_") or what == key), None)
        return name if key is None else name[:len(name) - len(what)] + self.ACROSS[key] + what[len(key):]

    def factor(self, column):
        what = schema.quantity(column)
        return -1.0 if what[:2] in ("uy", "vy", "ay", "fy") or what.startswith(("sxy", "gxy")) else 1.0


class Moved(Same):
    """The whole scene moved by some way [m]. What is stated at y = 0 moves along."""

    def __init__(self, x, y):
        self.by = {"x": x, "y": y}

    def message(self, name, value):
        if name == "Point":
            return {axis: value[axis] + self.by[axis] for axis in value}
        for key in {"x_min", "x_max", "y_min", "y_max"} & value.keys():
            value[key] += self.by[key[0]]
        if name == "Stress":
            for of in ("xx", "yy", "zz"):
                if f"{of}_per_metre" in value:
                    value[of] = value.get(of, 0.0) - value[f"{of}_per_metre"] * self.by["y"]
            if "layers" in value:
                value["surface"] = value.get("surface", 0.0) + self.by["y"]
        if name == "GroundLayer":
            value["bottom"] += self.by["y"]
        if name in ("Water", "WaterPlace") and "level" in value:
            value["level"] += self.by["y"]
        if name == "ParticleSpring" and "direction" in value:  # which is no place
            value["direction"] = {axis: value["direction"][axis] - self.by[axis] for axis in value["direction"]}
        return value


class Scaled(Same):
    """All lengths, times and masses multiplied by powers of two, so that a similar run is the same to the last bit."""

    def __init__(self, length, time, mass):
        self.by = (length, time, mass)

    # What the model has per metre of thickness, which stays a metre: of a force, N/m is what its unit N means.
    IN_PLANE = {"N", "N*m", "J", "kg", "N/m", "N*m/rad"}

    def times(self, unit, in_plane):
        factor = 1.0
        for base, exponent in zip(self.by, schema.dimension(unit)):
            factor *= base**exponent
        return factor / self.by[0] if in_plane else factor

    def number(self, name, key, unit, value):
        # A bolt or dowel is one of many at a distance, which is scaled, too.
        in_plane = (unit in self.IN_PLANE and name not in ("Bolt", "SecondRing")) or (name == "Lining" and key in ("area", "inertia")) or name == "FoundationSpring"
        return value * self.times(unit, in_plane)

    def message(self, name, value):
        if name == "Water":  # whose weight is that of gravity on earth
            value["density"] *= self.times("m/s^2", False)
        return value

    def factor(self, column):
        unit = schema.column_unit(column)
        return 1 / self.times(unit, unit in self.IN_PLANE and not column.startswith("prop_"))  # forces of one member
