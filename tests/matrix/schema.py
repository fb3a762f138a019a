"""What the definition of the scene says of each key: the message it stands in, its unit, whether it is a list."""
import functools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

from google.protobuf import descriptor_pb2

SOURCE = pathlib.Path(os.environ.get("ADIT_SOURCE", pathlib.Path(__file__).resolve().parents[2]))
Field = descriptor_pb2.FieldDescriptorProto
# Exponents of length, time and mass. A table's column and a key name their units alike.
UNITS = {"m": (1, 0, 0), "s": (0, 1, 0), "kg": (0, 0, 1), "N": (1, -2, 1), "Pa": (-1, -2, 1), "J": (2, -2, 1), "Hz": (0, -1, 0),
         "rad": (0, 0, 0), "1": (0, 0, 0)}


def dimension(unit):
    """Exponents of length, time and mass of a unit such as `N*m/rad` or `kg/m^3`."""
    total = [0, 0, 0]
    for place, part in enumerate(unit.split("/")):
        for factor in part.split("*"):
            name, _, power = factor.partition("^")
            for i, exponent in enumerate(UNITS[name]):
                total[i] += (-1 if place else 1) * int(power or 1) * exponent
    return tuple(total)


@functools.cache
def messages():
    """Of each message of the scene, by its name: {key: (field, unit or None)}."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["protoc", f"-I{SOURCE}", "--include_imports", f"--python_out={folder}", f"--descriptor_set_out={folder}/scene",
                        "protocol/messages/rule.proto", "protocol/messages/scene.proto"], check=True)
        sys.path.insert(0, folder)
        from protocol.messages import rule_pb2
        files = descriptor_pb2.FileDescriptorSet.FromString(pathlib.Path(folder, "scene").read_bytes()).file
        sys.path.remove(folder)
    known = {}

    def read(scope, found):
        for message in found:
            name = f"{scope}.{message.name}"
            known[name] = {field.name: (field, field.options.Extensions[rule_pb2.rule].unit) for field in message.field}
            read(name, message.nested_type)

    for file in files:
        if file.package == "adit.scene":
            read(".adit.scene", file.message_type)
    return {name.removeprefix(".adit.scene."): fields for name, fields in known.items()}


def walk(value, visit, name="Scene"):
    """A copy of a message of a scene in which `visit(name, message)` has changed each message, the innermost first, and each number.

    visit.message(name, message) -> message;  visit.number(name, key, unit, value) -> value
    """
    result = {}
    for key, content in value.items():
        field, unit = messages()[name][key]
        each = content if isinstance(content, list) else [content]
        if field.type == Field.TYPE_MESSAGE:
            kind = field.type_name.removeprefix(".adit.scene.")
            each = [walk(one, visit, kind) for one in each]
        elif unit:
            each = [visit.number(name, key, unit, one) for one in each]
        result[key] = each if isinstance(content, list) else each[0]
    return visit.message(name, result)


_COLUMN_UNITS = [("_m_per_s2", "m/s^2"), ("_m_per_s", "m/s"), ("_rad_per_s", "rad/s"), ("_per_s", "1/s"), ("_rad", "rad"), ("_Pa", "Pa"),
                 ("_Nm", "N*m"), ("_N", "N"), ("_J", "J"), ("_Hz", "Hz"), ("_kg", "kg"), ("_m", "m"), ("_s", "s")]


def column_unit(name):
    """The unit at the end of a column's name; a pure number where there is none."""
    return next((unit for ending, unit in _COLUMN_UNITS if name.endswith(ending)), "1")


def quantity(column):
    """What a column of histories holds, without the name of its place: `top_ux_m` -> `ux_m`."""
    match = re.search(r"_([uva][xy]_m(?:_per_s2?)?|s(?:xx|yy|xy|zz)_Pa|exx|eyy|gxy|thrust_N|moment_Nm|shear_N|f[xy]_N|opening_m|offset_m|rotation_rad"
                      r"|normal_stress_Pa|shear_stress_Pa|bar_stress_Pa|bar_slip_m|force_N|contacts|porosity|demand|exx_per_s|eyy_per_s|gxy_per_s)$", column)
    return match.group(1) if match else column
