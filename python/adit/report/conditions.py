"""What a checking engineer asks first: initial stress, gravity, stages, statics, damping, and how motions were processed."""
from adit.report.markup import table
from adit.report.model import where
from adit.report.quantities import digits, quantity

INSTALLED = (("linings", "lining"), ("members", "member"), ("bolts", "bolt"), ("groups", "group of particles"), ("joints", "joint"), ("springs", "spring"))
NAMED = 3  # parts of one kind in a stage; more are counted


def listed(results):
    """A table of what the scene states, with what was reached."""
    rows = [*_initial_stress(results), *_joined("body load of", _body_loads(results)), *_stages(results), *_statics(results),
            *_joined("damping of", _damping(results)), *_joined("processing of", _motions(results))]
    return table("Conditions, from scene.yaml and summary.json", None, rows)


def _joined(what, rows):
    """One row for all models of which the same is told."""
    found = {}
    for whose, told in rows:
        found.setdefault(told, []).append(whose)
    for told, whose in found.items():
        yield f"{what} {' and '.join(filter(None, (', '.join(whose[:-1]), whose[-1])))}", told


def _initial_stress(results):
    stress = results.scene.get("initial_stress")
    if stress is None:
        if "statics" in results.scene:
            yield "initial stress", "none is stated: the stress before time begins follows from the loads"
    elif "layers" in stress:
        line = [f"({digits(each['x'])}, {digits(each['y'])}) m" for each in stress.get("surface_line", [])]
        top = f"surface through {', '.join(line)}" if line else f"surface at y = {quantity(stress.get('surface', 0.0), 'm')}"
        layers = [f"to y = {quantity(each['bottom'], 'm')} {quantity(each['density'], 'kg/m³')}, K0 = {digits(each['k0'])}"
                  for each in stress["layers"]]
        extra = [f"surcharge {quantity(stress['surcharge'], 'Pa')}"] if "surcharge" in stress else []
        yield "initial stress", "weight of layers: " + "; ".join([top, *extra, *layers])
    else:
        known = [f"{part} = {quantity(float(stress.get(part, 0)), 'Pa')}{_growth(stress.get(f'{part}_per_metre'))}"
                 for part in ("xx", "yy", "xy", "zz") if part in stress or f"{part}_per_metre" in stress]
        yield "initial stress", f"{', '.join(known) or 'zero'}, positive in tension"


def _growth(per_metre):
    return f" at y = 0, growing with y by {quantity(float(per_metre), 'Pa/m')}" if per_metre else ""


def _body_loads(results):
    for name, model in results.models:
        for load in model.get("body_loads", []):
            parts = [f"{axis} = {quantity(float(value), 'm/s²')}" for axis, value in load["acceleration"].items()]
            place = f", {where(load['where'])}" if "where" in load else ""
            yield f"the {name}", f"{', '.join(parts)}{place}{', varying in time' if 'time' in load else ''}"


def _stages(results):
    """A row for each stage: what is dug, with the share of the forces that it releases, what changes, and what is installed."""
    found = {}
    for name, model in results.models:
        for each in model.get("excavations", []):
            share = each.get("released", 1)
            told = f"excavated: {where(each['where'])} of the {name}, {100 * share:.4g} % of the forces released"
            found.setdefault(each.get("stage", 0), []).append(told)
            if each.get("stage", 0) and share < 1:
                found.setdefault(each["stage"] + 1, []).append(f"the rest of stage {each['stage']} released")
        for each in model.get("materials", []):
            if each.get("stage", 0):
                found.setdefault(each["stage"], []).append(f"changed or filled: {where(each['where'])} of the {name}")
        for kind, one in INSTALLED:
            of_kind = {}
            for part in model.get(kind, []):
                of_kind.setdefault(part.get("stage", 0), []).append(part.get("name", ""))
            for stage, names in of_kind.items():
                if stage:
                    found.setdefault(stage, []).append(f"installed: {_counted(names, one)} of the {name}")
    for stage in sorted(found):
        yield f"stage {stage}" if stage else "before all stages", "; ".join(dict.fromkeys(found[stage]))


def _counted(names, one):
    if len(names) <= NAMED and all(names):
        return ", ".join(f"{one} {name}" for name in names)
    plural = one.replace("group", "groups") if one.startswith("group") else f"{one}s"
    return f"{len(names)} {plural if len(names) > 1 else one}"


def _statics(results):
    s, asked = results.summary, results.scene.get("statics")
    if asked is None:
        return
    told = [f"until the mean unbalanced force is {quantity(float(asked.get('unbalanced_ratio', 1e-5)))} of the mean internal force"]
    if s.get("statics_steps") is not None:
        told.append(f"{quantity(s.get('statics_unbalanced_ratio'))} reached in {s['statics_steps']:,} steps")
    if "damping" in asked:
        told.append(f"{asked['damping']} damping")
    if "count_from_stage" in asked:
        told.append(f"displacements and cracks count from stage {asked['count_from_stage']}")
    if asked.get("keep_displacements"):
        told.append("displacements since the first stage are kept")
    yield "statics before time begins", "; ".join(told)


def _damping(results):
    for name, model in results.models:
        yield f"the {name}", _of_kind(model.get("damping") or {})


def _of_kind(damping):
    told = []
    for kind, ends in (("rayleigh", "at {} and {}"), ("maxwell", "from {} to {}")):
        if kind in damping:
            d = damping[kind]
            between = ends.format(*(quantity(float(d[end]), "Hz") for end in ("low_frequency", "high_frequency")))
            told.append(f"{kind.capitalize()}, {100 * d['ratio']:.4g} % {between}")
    local = damping.get("local")
    if local:
        share = local["alpha"] if isinstance(local, dict) else local
        told.append(f"local, {digits(share)} of the unbalanced force")
    if damping.get("viscous"):
        told.append(f"viscous, {quantity(float(damping['viscous']), '1/s')} per mass")
    return ", ".join(told) or "none beside that of the material"


def _motions(results):
    if results.is_simplified:
        found = [("the motion", results.scene.get("simplified", {}).get("excitation", {}).get("motion"))]
    else:
        found = [(f"the motion of the {name}", model.get("base", {}).get("acceleration")) for name, model in results.models]
    for what, motion in found:
        if motion:
            yield what, ", ".join(_processing(motion))


def _processing(motion):
    corners = [f"{side} corner {quantity(float(motion[f'{side}_corner']), 'Hz')}" for side in ("low", "high") if f"{side}_corner" in motion]
    yield f"Butterworth filter with {' and '.join(corners)}" if corners else "no filter"
    if motion.get("taper"):
        yield f"tapers of {quantity(float(motion['taper']), 's')}"
    yield "baseline corrected" if motion.get("baseline", True) else "baseline not corrected"
    for end in ("from", "until"):
        if end in motion:
            yield f"used {end} {quantity(float(motion[end]), 's')}"
