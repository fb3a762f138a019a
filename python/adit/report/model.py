"""The model: its picture, its materials, joints, supports and overlap weights."""
import numpy as np

from adit import Unusable
from adit.plots.setup import sheets
from adit.plots.setup.checked import LAWS, Checked, in_stages
from adit.report import pictures
from adit.report.markup import details, section, table, tag
from adit.report.quantities import figure, quantity
from adit.results.rounding import coordinate

SIZES = (("particles", "particles"), ("bonds", "bonds"), ("zones", "zones"), ("grid points", "grid_points"),
         ("coupling points", "coupling_points"),
         ("overlap: particles begin at x", "overlap_particles_begin_x_m"),
         ("overlap: particles begin at y", "overlap_particles_begin_y_m"),
         ("overlap: continuum ends at x", "overlap_continuum_ends_x_m"),
         ("overlap: continuum ends at y", "overlap_continuum_ends_y_m"))
CONSTANTS = (("young_modulus", "E", "Pa"), ("poisson_ratio", "ν", ""), ("density", "ρ", "kg/m³"))
STRENGTH = (("cohesion", "c", "Pa"), ("friction_angle", "φ", "°"), ("dilation_angle", "ψ", "°"), ("tension", "tension", "Pa"),
            ("dip_angle", "dip", "°"))
BONDS = (("tensile_strength", "tensile strength", "N"), ("shear_strength", "shear strength", "N"))
SMOOTH = (("normal_stiffness", "normal stiffness", "Pa/m"), ("shear_stiffness", "shear stiffness", "Pa/m"),
          ("friction", "friction", ""))
PROPERTIES = (("thickness", "thickness", "m"), ("young_modulus", "E", "Pa"), ("stiffness", "stiffness", "N/m"),
              ("pretension", "pretension", "N"), ("strength", "strength", "N"), ("area", "area", "m²"),
              ("axial_stiffness", "axial stiffness", "N/m"), ("rotation_stiffness", "rotation stiffness", "N m/rad"),
              ("seal_limit", "limit of the seal", "m"), ("spacing", "spacing", "m"), ("width", "width", "m"), ("stage", "stage", ""))
MEMBERS = ("gasket", "cables", "lateral_keys", "vertical_keys")  # of a joint of a whole tunnel
OF_MEMBERS = (("installed_force", "installed force", "N"), ("stiffness", "stiffness", "N/m"), ("clearance", "clearance", "m"))
MANY = 8  # rows that a table may have without being closed at first


def chapter(results):
    s = results.summary
    sizes = table("Sizes, from summary.json", ("what", "value"), [(n, figure(s, key)) for n, key in SIZES if s.get(key)])
    return section("model", "The model", _pictures(results), sizes, _overlap_weights(results), _materials(results),
                   _parts(results))


def _pictures(results):
    if results.is_simplified:
        return None  # the ground stands above the envelopes
    try:
        return [pictures.figure(drawing) for _, drawing in sheets.model(Checked(results.folder))]
    except Unusable:
        return tag("p", "No fields were written, so the model is not drawn here; adit plot --model SCENE draws it.")


def _overlap_weights(results):
    """How the zones of the overlap weigh, from the first fields."""
    for _ in results.instants[:1]:
        pieces = Checked(results.folder).pieces()
        weights = [piece.field("weight") for name, piece in pieces.items() if name.endswith("grid")]
        shared = np.concatenate([w[w < 1 - 1e-9] for w in weights if w is not None] or [np.array([])])
        if len(shared):
            return tag("p", f"Zones and particles share the energy of the overlap: {len(shared):,} zones weigh from "
                            f"{quantity(float(shared.min()))} to {quantity(float(shared.max()))} of their own, and the "
                            "particles among them the rest.")
    return None


def _materials(results):
    rows = []
    for name, model in results.models:
        own = model.get("material") or results.scene.get("material")
        rows += [_material(name, own, model.get("bonds"))] if own else []
        rows += [_material(f"{name}, {where(area.get('where'))}{in_stages([area])}", area["material"]) for area in model.get("materials", [])]
        rows += [_material(f"{name}, group {group['name']}", group.get("material") or own, group.get("bonds"))
                 for group in model.get("groups", []) if group.get("material") or own]
    return table("Materials, from scene.yaml", ("where", "elastic constants", "law and strength"), rows)


def _material(name, material, bonds=None):
    laws = [f"{said}: {_values(material[law], STRENGTH)}".rstrip(": ") for law, said in LAWS.items() if law in material]
    strength = _values(bonds or {}, BONDS)
    return name, _values(material, CONSTANTS), "; ".join([*laws, *([f"bonds: {strength}"] if strength else [])]) or "elastic"


def _values(mapping, known):
    return ", ".join(f"{said} = {_said(mapping[key], unit)}" for key, said, unit in known
                     if isinstance(mapping.get(key), (int, float)))


def _said(value, unit):
    return f"{np.degrees(value):.4g}°" if unit == "°" else quantity(float(value), unit)


def where(area):
    """The area of a scene in words."""
    return ", ".join(f"group {value}" if key == "group" else f"{key} = {quantity(coordinate(float(value)), 'm')}" if isinstance(value, (int, float))
                     else key for key, value in (area or {}).items()) or "all"


def _parts(results):
    """Joints, springs, linings, members and bolts by name."""
    rows = []
    for name, model in results.models:
        for kind, one in (("joints", "joint"), ("springs", "spring"), ("linings", "lining"), ("members", "member"), ("bolts", "bolts")):
            rows += [(part.get("name") or f"{one} {i + 1}", f"{one} of the {name}", _properties(part))
                     for i, part in enumerate(model.get(kind, []))]
    tunnel = results.scene.get("simplified", {}).get("tunnel", {})
    rows += [(group.get("name", "joints"), f"joints of the tunnel, {_chainages(group)}", _properties(group))
             for group in tunnel.get("joints", [])]
    listed = table("Joints, springs, linings, members and bolts, from scene.yaml", ("name", "kind", "properties"), rows)
    return details(f"{len(rows)} joints, springs, linings, members and bolts", listed) if len(rows) > MANY else listed


def _chainages(group):
    """Where the joints of a group are."""
    places = [f"{quantity(group[end], 'm')}" for end in ("from", "to") if end in group]
    alone = [quantity(place, "m") for place in group.get("at", [])]
    return ", ".join(filter(None, (" to ".join(places), *alone)))


def _properties(part):
    law = next((law for law in ("open", "smooth", "bonds") if law in part), None)
    inner = part[law] if law and isinstance(part[law], dict) else {}
    inside = _values(inner, SMOOTH if law == "smooth" else BONDS)
    faces = f"slips: {_values(part['interface'], STRENGTH)}".removesuffix(": ") if "interface" in part else ""
    members = [f"{name.replace('_', ' ')}: {_values(part[name], OF_MEMBERS)}" for name in MEMBERS if name in part]
    return "; ".join(filter(None, (f"{law} joint" if law else "", inside, *members, _values(part, PROPERTIES), _reinforced(part.get("section")), faces)))


def _reinforced(section):
    """The thickness of a section, its concrete and steel by class or strength, and its bars."""
    if not section:
        return ""
    made = [f"{what} {section[what].get('class') or quantity(section[what][strength], 'Pa')}"
            for what, strength in (("concrete", "compressive_strength"), ("steel", "yield_strength"))
            if section.get(what, {}).get("class") or strength in section.get(what, {})]
    bars = [f"{face} bars of {quantity(section[face]['diameter'], 'm')} every {quantity(section[face]['spacing'], 'm')}"
            for face in ("inner", "outer") if {"diameter", "spacing"} <= section.get(face, {}).keys()]
    return f"section of {', '.join([quantity(section['thickness'], 'm'), *made, *bars])}"
