"""The joint of an immersed tunnel over time: of the beam, and of the coupled model in plan that `simplified run --zoom` writes.

Both are (times [s], {quantity: values}); forces and moments are those of the whole section.
"""
import numpy as np

COLUMNS = {  # {quantity: its name in a table, with the unit}
    "opening": "opening_m", "opening of the edge": "edge_opening_m", "offset": "offset_m", "rotation": "rotation_rad",
    "axial force": "axial_force_N", "key force": "key_force_N", "moment": "moment_Nm"}


def half_width(run):
    """The distance of the gasket from the axis [m]: half the width of the first section."""
    return float(run.scene["simplified"]["tunnel"]["sections"][0]["width"]) / 2


def of_beam(run, place, half_width):
    joint = run.table(f"zoom/{place}_joint.csv")
    return joint["time_s"], {
        "opening": joint["opening_m"], "offset": joint["offset_m"], "rotation": joint["rotation_rad"],
        "opening of the edge": joint["opening_m"] + half_width * np.abs(joint["rotation_rad"]),
        "axial force": joint["axial_force_N"], "key force": joint["shear_N"], "moment": joint["moment_Nm"]}


def of_model(run, half_width):
    h = run.histories
    springs = {spring["name"]: (spring["from"]["y"], h[f"{spring['name']}_force_N"]) for spring in run.scene["particles"]["springs"]}
    axial = [spring for name, spring in springs.items() if not name.startswith("key")]
    zero = np.zeros_like(h["time_s"])
    rotation = h["joint_rotation_rad"]
    return h["time_s"], {
        "opening": h["joint_opening_m"], "offset": -h["joint_offset_m"], "rotation": rotation,
        "opening of the edge": h["joint_opening_m"] + half_width * np.abs(rotation),
        "axial force": sum((force for _, force in axial), zero),
        "key force": sum((force for name, (_, force) in springs.items() if name.startswith("key")), zero),
        "moment": sum((-y * force for y, force in axial), zero)}


def largest(quantities):
    """{column: largest value over time} of {quantities: values}, by size but for openings: a joint that closes does not leak."""
    return {column: float((values if column.endswith("opening_m") else np.abs(values)).max())
            for quantity, column in COLUMNS.items() for values in (quantities[quantity],)}
