"""Daikai station: how far its box racks beside the free field, by Wang's relation and as computed; what its columns bear until they fail."""
import numpy as np

POISSON = 0.2  # of concrete


class Frame:
    """Beams of Timoshenko between places in the plane, joined rigidly."""

    def __init__(self):
        self.places, self.entries = [], []

    def place(self, x, y):
        found = [i for i, at in enumerate(self.places) if np.hypot(at[0] - x, at[1] - y) < 1e-6]
        if not found:
            self.places.append((x, y))
        return found[0] if found else len(self.places) - 1

    def add(self, start, end, axial, bending, shear):
        i, j = self.place(*start), self.place(*end)
        (x, y), length = np.subtract(end, start), np.hypot(*np.subtract(end, start))
        phi = 12 * bending / (shear * length**2)
        a, b, k = axial / length, bending / length, 3 * bending / length / (1 + phi)
        x, y = x / length, y / length
        for stiffness, form in ((a, [-x, -y, 0, x, y, 0]), (b, [0, 0, -1, 0, 0, 1]),
                                (k, [-2 * y / length, 2 * x / length, 1, 2 * y / length, -2 * x / length, 1])):
            self.entries.append((stiffness, [3 * i, 3 * i + 1, 3 * i + 2, 3 * j, 3 * j + 1, 3 * j + 2], form))

    def sway(self, held, pushed):
        """The force that moves the places `pushed` by 1 m in x together, with those of `held` held in x and y."""
        size = 3 * len(self.places)
        matrix = np.zeros((size, size))
        for stiffness, rows, form in self.entries:
            matrix[np.ix_(rows, rows)] += stiffness * np.outer(form, form)
        known = {3 * i + axis: 0.0 for i in held for axis in (0, 1)} | {3 * i: 1.0 for i in pushed}
        free = [i for i in range(size) if i not in known]
        given = list(known)
        moved = np.zeros(size)
        moved[given] = list(known.values())
        moved[free] = np.linalg.solve(matrix[np.ix_(free, free)], -matrix[np.ix_(free, given)] @ moved[given])
        return sum((matrix @ moved)[3 * i] for i in pushed)


def racking_stiffness(scene):
    """Force per metre of racking and metre of the plane [N/m^2] of the scene's elastic box with its members, on its floor."""
    model, frame = scene["continuum"], Frame()
    ends = [(member[end]["x"], member[end]["y"]) for member in model["members"] for end in ("from", "to")]

    def section(part, width, plane):
        young, thickness = part["young_modulus"], part["thickness"]
        wide = young / (1 - POISSON**2) if plane else young
        return wide * thickness * width, wide * thickness**3 / 12 * width, 5 / 6 * young / (2 * (1 + POISSON)) * thickness * width

    for lining in model["linings"]:
        first, last = (np.array([point["x"], point["y"]]) for point in lining["along"]["line"]["points"])
        on = [end for end in ends if abs(np.linalg.norm(end - first) + np.linalg.norm(end - last) - np.linalg.norm(last - first)) < 1e-6]
        stops = sorted([tuple(first), tuple(last), *on], key=lambda stop: np.linalg.norm(stop - first))
        for start, end in zip(stops, stops[1:]):
            if np.hypot(*np.subtract(end, start)) > 1e-6:
                frame.add(start, end, *section(lining, 1, True))
    for member, start, end in zip(model["members"], ends[::2], ends[1::2]):
        spacing = member.get("spacing", 1)
        width = member.get("width", spacing)
        frame.add(start, end, *section(member, width / spacing, width == spacing))
    heights = np.array([y for _, y in frame.places])
    corner = np.array([abs(x) for x, _ in frame.places]) > 1
    return frame.sway(np.flatnonzero(corner & (heights == heights.min())), np.flatnonzero(corner & (heights == heights.max())))


def wang(shear_modulus, width, height, stiffness):
    """Racking of a box that does not slip over that of the free field: 2 F/(1 + F), F = G W/(S H), as Anderson et al. (2008, NCHRP
    Report 611) put the analyses of Wang (1993)."""
    flexibility = shear_modulus * width / (stiffness * height)
    return 2 * flexibility / (1 + flexibility)


def racking_ratio(run):
    """Racking of the box over that of the free field: the slope of one over the other."""
    box, field = (run.histories[f"{name}_ux_m"] - run.histories[f"{name}_ux_m"][0] for name in ("racking", "free_field"))
    return (box @ field) / (field @ field)


def site_modulus(scene, top, bottom):
    """The shear modulus [Pa] with which the layers between two heights are sheared by one stress together."""
    sheared = 0
    for area in scene["continuum"]["materials"]:
        low, high = max(area["where"].get("y_min", bottom), bottom), min(area["where"].get("y_max", top), top)
        material = area["material"]
        sheared += max(high - low, 0) * 2 * (1 + material["poisson_ratio"]) / material["young_modulus"]
    return (top - bottom) / sheared


def wang_of(scene, width=16.3, top=-5.2, bottom=-11.545):
    """What Wang's relation gives for the elastic station."""
    return wang(site_modulus(scene, top, bottom), width, top - bottom, racking_stiffness(scene))


def column_rows(run):
    """Yields (what, value, unit) of the column until it fails."""
    h, time = run.histories, run.histories["time_s"]
    failed = run.number("member_column_failed_time_s")
    before = time < (np.inf if failed is None else failed)
    drift = h["racking_ux_m"] - h["racking_ux_m"][0]
    shear = abs(h["foot_shear_N"])
    yield "thrust at rest", h["top_thrust_N"][0] / 1e3, "kN"
    yield "least and largest thrust", (h["top_thrust_N"][before].min() / 1e3, h["top_thrust_N"][before].max() / 1e3), "kN"
    yield "largest shear force", shear[before].max() / 1e3, "kN"
    yield "its largest share in the strength", 100 * (abs(h["top_shear_N"]) / h["top_shear_strength_N"].clip(1))[before].max(), "%"
    yield "largest moment", abs(h["foot_moment_Nm"][before]).max() / 1e3, "kN m"
    yield "largest utilisation by thrust and moment", 100 * h["top_utilisation"][before].max(), "%"
    yield "largest racking of the box until then", 1e3 * abs(drift[before]).max(), "mm"
    yield "of the free field", 1e3 * abs(h["free_field_ux_m"] - h["free_field_ux_m"][0])[before].max(), "mm"
    for key, way in (("shear_failed", "fails in shear"), ("axial_failed", "is lost under its thrust"), ("crushed", "is crushed")):
        if (when := run.number(f"member_column_{key}_time_s")) is not None:
            yield way, when, "s"
