"""What was computed and how: the models, their loads and motions, the time steps."""
from adit.plots.spectra_pictures import GRAVITY
from adit.report import conditions
from adit.report.markup import paragraphs, section
from adit.report.quantities import digits, quantity, sentence

SAME = 0.01  # share by which a number may differ from the stated one that it is told as


def chapter(results):
    description = results.scene.get("description")
    say = _tunnel if results.is_simplified else _ground
    return section("computed", "What was computed and how", paragraphs([description and sentence(description), *say(results)]),
                   conditions.listed(results))


def _tunnel(results):
    s, scene = results.summary, results.scene.get("simplified", {})
    what = {"beam": "a beam with joints on soil springs", "chain": "a chain of rigid rings on soil springs",
            "column": "columns of ground"}.get(s.get("model"), s.get("model"))
    begin, end = (quantity(s.get(key), "m") for key in ("begin_m", "end_m"))
    yield f"The simplified model is {what}, from {begin} to {end} of chainage."
    excitation = scene.get("excitation", {})
    path = "through the ground, from the rock below" if excitation.get("through_ground") else "directly"
    speed = s.get("apparent_velocity_m_per_s")
    along = f" and passes along the axis with {quantity(speed, 'm/s')}" if speed else ""
    yield f"The motion reaches the tunnel {path}{along}."
    yield motion(excitation.get("motion", {}), s.get("peak_input_acceleration_m_per_s2"))
    yield _steps(s, "implicit")


def _ground(results):
    s = results.summary
    plane = {"plane_strain": "plane strain", "plane_stress": "plane stress"}.get(s.get("plane"), "two dimensions")
    parts = [f"a continuum of {s['zones']:,} zones and {s['grid_points']:,} grid points"] if s.get("zones") else []
    parts += [f"{s['particles']:,} particles with {s['bonds']:,} bonds"] if s.get("particles") else []
    if parts:
        yield f"The model is in {plane}: {' and '.join(parts)}."
    if s.get("coupling_points"):
        yield (f"The bridging-domain method joins them in the overlap, at {s['coupling_points']:,} coupling points: there both "
               f"share mass and forces and move alike (solve: {s.get('solve')}).")
    if s.get("statics_steps") is not None:
        yield "First the model came to rest under its loads, stage by stage where it has stages."
    for name, model in results.models:
        base, sides = model.get("base"), [side for side, on in model.get("free_field", {}).items() if on]
        yield f"The base of the {name} is {base['kind']}." if base and "kind" in base else None
        yield motion(base.get("acceleration") or {}, results.acted(f"{results.path_of(name)}.base.acceleration.peak")) if base else None
        yield f"The {name} ends in free fields: {' and '.join(sides)}." if sides else None
    yield _steps(s, "explicit")


def motion(given, acted=None):
    """A sentence for a motion of the scene; `acted`: its largest acceleration in the run, where that is known."""
    about = {"file": lambda m: f"the record {m.get('path')}", "synthetic": lambda m: f"synthetic ({_listed(m)})",
             "ricker": lambda m: f"a Ricker wavelet of {quantity(m.get('frequency'), 'Hz')}",
             "sine": lambda m: f"a sine of {quantity(m.get('frequency'), 'Hz')}", "table": lambda m: "a table of the scene"}
    kind = next((kind for kind in about if kind in given), None)
    if kind is None:
        return None
    return f"The motion is {about[kind](given[kind])}{_peak(given['peak'], acted) if 'peak' in given else ''}."


def _peak(stated, acted):
    if acted is None or abs(acted - stated) <= SAME * stated:
        return f", with a peak of {_acceleration(stated)}"
    return f". Its peak is stated as {_acceleration(stated)}; the part that the run takes has {_acceleration(acted)}"


def _acceleration(value):
    return f"{quantity(value, 'm/s²')} ({digits(value / GRAVITY)} g)"


def _listed(mapping):
    units = {"corner_period": " s"}
    return ", ".join(f"{key.replace('_', ' ')} {value}{units.get(key, '')}" for key, value in mapping.items()
                     if not isinstance(value, (dict, list)))


def _steps(s, kind):
    if s.get("steps") is None:
        return None
    substeps = s.get("substeps") or 1
    shorter = f", in each of which the particles took {substeps} steps" if substeps > 1 else ""
    stable = f"; the largest stable step is {quantity(s['critical_dt_s'], 's')}" if s.get("critical_dt_s") else ""
    return f"Time was integrated in {s['steps']:,} {kind} steps of {quantity(s.get('dt_s'), 's')}{shorter}{stable}."
