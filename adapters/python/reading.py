"""What both templates read of a scene: what they do not compute, places, factors over time."""
import math

import numpy as np

from leap_frog import SPIN, Load, Motion
from wire import SceneError

BOX = {"x_min": True, "x_max": True, "y_min": True, "y_max": True}
POINT = {"x": True, "y": True}
FACTOR = {"constant": True, "table": {"time": True, "value": True}, "sine": {"frequency": True, "phase": True, "end": True}}


def refuse_others(message, computed, path=""):
    """Refuses every field that is set and not among the `computed` ones: a field's name, and True, the values that are
    computed, or the fields inside. Without this a scene would give the results of another model."""
    if len(message.UnknownFields()):
        raise SceneError(path, "holds a key or a value of a newer release; leave it out, or use another participant")
    for field, value in message.ListFields():
        known = computed.get(field.name)
        here = f"{path}.{field.name}" if path else field.name
        is_list = field.label == field.LABEL_REPEATED
        if isinstance(known, dict):
            for i, part in enumerate(value if is_list else [value]):
                refuse_others(part, known, f"{here}[{i}]" if is_list else here)
        elif isinstance(known, set) and value not in known:
            raise SceneError(here, "has a value that this participant does not compute; choose another one")
        elif known is None and (is_list or field.message_type or value != field.default_value):
            raise SceneError(here, "is not computed by this participant; leave it out, or use another participant")


def keys(message, computed, path=""):
    """The same as paths of keys, which hello tells the coupler (Hello in wire.proto)."""
    for name, known in computed.items():
        field, here = message.fields_by_name[name], f"{path}.{name}" if path else name
        if isinstance(known, dict):
            yield from keys(field.message_type, known, here)
        elif isinstance(known, set):
            yield from (f"{here}.{field.enum_type.values_by_number[value].name.lower()}" for value in sorted(known))
        else:
            yield here


def select(area, points, tolerance, path):
    """Numbers of the points inside or on a box, which may be open."""
    inside = np.ones(len(points), bool)
    for column, axis in enumerate("xy"):
        if area.HasField(f"{axis}_min"):
            inside &= points[:, column] >= getattr(area, f"{axis}_min") - tolerance
        if area.HasField(f"{axis}_max"):
            inside &= points[:, column] <= getattr(area, f"{axis}_max") + tolerance
    if not inside.any():
        raise SceneError(path, "selects nothing; widen it")
    return np.flatnonzero(inside)


def factor(function):
    """The factor of a load or a motion at a time [s]."""
    kind = function.WhichOneof("shape")
    if kind == "sine":
        sine = function.sine
        return lambda t: math.sin(2 * math.pi * sine.frequency * t + sine.phase) if t <= sine.end else 0.0
    if kind == "table":
        return lambda t: np.interp(t, function.table.time, function.table.value)
    return lambda t: function.constant if kind == "constant" else 1.0


def body_loads(loads, path, points, masses, tolerance):
    found = []
    for i, load in enumerate(loads):
        chosen = select(load.where, points, tolerance, f"{path}[{i}].where")
        forces = np.outer(masses[chosen], (load.acceleration.x, load.acceleration.y))
        found.append(Load(chosen, forces, factor(load.time)))
    return found


def prescribed(motions, path, points, tolerance):
    """A component that the scene leaves out stays free."""
    found = []
    taken = np.zeros((len(points), 3), bool)
    for i, motion in enumerate(motions):
        chosen = select(motion.where, points, tolerance, f"{path}[{i}].where")
        given = {field.name: value for field, value in (*motion.velocity.ListFields(), *motion.ListFields())}
        for column, name in ((0, "x"), (1, "y"), (SPIN, "spin")):
            if name not in given:
                continue
            if taken[chosen, column].any():
                raise SceneError(f"{path}[{i}]", "moves points that an earlier motion moves; separate the boxes")
            taken[chosen, column] = True
            found.append(Motion(chosen, column, given[name], factor(motion.time)))
    return found


def motion_history(history, path, quantities):
    """(which motion, axis) of a history of a displacement or a velocity."""
    name = quantities.Name(history.quantity).lower()
    kind, _, axis = name.rpartition("_")
    if kind not in ("displacement", "velocity") or axis not in "xy":
        raise SceneError(f"{path}.quantity", f"is {name}; this participant tells displacements and velocities only")
    if not history.HasField("at"):
        raise SceneError(f"{path}.at", "is missing; give the place, {x: …, y: …}")
    return kind, "xy".index(axis)
