"""How the run ended, its warnings, its main figures."""
import re

from adit.report.markup import bullets, section, table, tag
from adit.report.quantities import figure, quantity, sentence


def _where(key):
    return ("  at x [m]", f"{key}_x_m", 1, "{:z.2f}"), ("  at y [m]", f"{key}_y_m", 1, "{:z.2f}")


def _when_and_where(key):
    return ("  at [ms]", f"{key}_time_s", 1e-3, "{:z.2f}"), *_where(key)


ROWS = (  # of the main figures: what, key of summary.json, divisor, format
    ("peak bond force [kN]", "peak_bond_force_N", 1e3, "{:z,.0f}"),
    *_when_and_where("peak_bond_force"),
    ("first crack at [ms]", "first_crack_time_s", 1e-3, "{:z.2f}"),
    *_where("first_crack"),
    ("cracks", "crack_count", 1, "{:z.0f}"),
    ("first debonding at [ms]", "first_debonding_time_s", 1e-3, "{:z.2f}"),
    *_where("first_debonding"),
    ("debonded bonds", "debonded_count", 1, "{:z.0f}"),
    ("widest crack [mm]", "largest_crack_width_m", 1e-3, "{:z.3f}"),
    *_when_and_where("largest_crack_width"),
    ("crack paths", "crack_path_count", 1, "{:z.0f}"),
    ("longest crack path [m]", "longest_crack_path_m", 1, "{:z.3f}"),
    ("  open at the end by [mm]", "longest_crack_path_opening_m", 1e-3, "{:z.3f}"),
    ("least thrust, per metre [kN]", "sections_smallest_thrust_N", 1e3, "{:z,.0f}"),
    ("greatest thrust, per metre [kN]", "sections_largest_thrust_N", 1e3, "{:z,.0f}"),
    ("least moment, per metre [kN m]", "sections_smallest_moment_Nm", 1e3, "{:z,.0f}"),
    ("greatest moment, per metre [kN m]", "sections_largest_moment_Nm", 1e3, "{:z,.0f}"),
    ("largest utilisation of a section, thrust and moment [%]", "sections_largest_utilisation", 1e-2, "{:z.0f}"),
    ("  thrust there [kN]", "sections_thrust_at_largest_utilisation_N", 1e3, "{:z,.0f}"),
    ("  moment there [kN m]", "sections_moment_at_largest_utilisation_Nm", 1e3, "{:z,.0f}"),
    *_when_and_where("sections_largest_utilisation"),
    ("largest utilisation of a section, shear [%]", "sections_largest_shear_utilisation", 1e-2, "{:z.0f}"),
    ("state of damage by moments", "sections_damage_state", 1, "{:.0f}"),
    ("largest steel stress in bars [MPa]", "bars_largest_stress_Pa", 1e6, "{:z.0f}"),
    ("largest steel strain in bars [10⁻³]", "bars_largest_strain", 1e-3, "{:z.2f}"),
    ("longest diameter, change [mm]", "ovals_largest_diameter_change_m", 1e-3, "{:z.2f}"),
    ("shortest diameter, change [mm]", "ovals_smallest_diameter_change_m", 1e-3, "{:z.2f}"),
    ("energy drift", "max_energy_drift", 1, "{:.1e}"),
    ("axial force [MN]", "max_axial_force_N", 1e6, "{:z,.1f}"),
    ("lateral moment [MN m]", "max_moment_lateral_N_m", 1e6, "{:z,.1f}"),
    ("lateral shear [MN]", "max_shear_lateral_N", 1e6, "{:z,.2f}"),
    ("strain [1e-6]", "max_strain", 1e-6, "{:z,.0f}"),
    ("element joint opening [mm]", "element_joint_max_opening_m", 1e-3, "{:z.2f}"),
    ("  at [m]", "element_joint_max_opening_chainage_m", 1, "{:z.0f}"),
    ("segment joint opening [mm]", "segment_joint_max_opening_m", 1e-3, "{:z.2f}"),
    ("ring joint opening [mm]", "ring_joint_max_opening_m", 1e-3, "{:z.3f}"),
    ("wall time [s]", "wall_s", 1, "{:z.2f}"),
    ("real-time factor", "real_time_factor", 1, "{:z.0f}"),
)
OF_A_LINING = (  # the same of each lining of a continuum, by its name before
    ("least thrust, per metre [kN]", "least_thrust_N", 1e3, "{:z,.0f}"),
    ("  moment there [kN m]", "moment_at_least_thrust_Nm", 1e3, "{:z,.0f}"),
    ("greatest thrust, per metre [kN]", "largest_thrust_N", 1e3, "{:z,.0f}"),
    ("  moment there [kN m]", "moment_at_largest_thrust_Nm", 1e3, "{:z,.0f}"),
    ("largest moment, per metre [kN m]", "largest_moment_Nm", 1e3, "{:z,.0f}"),
    ("  thrust there [kN]", "thrust_at_largest_moment_N", 1e3, "{:z,.0f}"),
    *_when_and_where("largest_moment"),
    ("largest ovaling: change of a diameter [mm]", "largest_ovaling_m", 1e-3, "{:z.2f}"),
    ("largest racking: top against bottom [mm]", "largest_racking_m", 1e-3, "{:z.2f}"),
    ("largest utilisation, thrust and moment [%]", "largest_utilisation", 1e-2, "{:z.0f}"),
    ("  thrust there [kN]", "thrust_at_largest_utilisation_N", 1e3, "{:z,.0f}"),
    ("  moment there [kN m]", "moment_at_largest_utilisation_Nm", 1e3, "{:z,.0f}"),
    *_when_and_where("largest_utilisation"),
    ("largest utilisation, shear [%]", "largest_shear_utilisation", 1e-2, "{:z.0f}"),
    ("largest moment over its capacity [%]", "largest_moment_ratio", 1e-2, "{:z.0f}"),
    ("  state of damage by it", "damage_state", 1, "{:.0f}"),
    ("largest rotation of a plastic hinge [mrad]", "largest_hinge_rotation_rad", 1e-3, "{:z.2f}"),
    ("largest steel strain [10⁻³]", "largest_steel_strain", 1e-3, "{:z.2f}"),
    ("largest crack width [mm]", "largest_crack_width_m", 1e-3, "{:z.2f}"),
    ("failed in shear at [s]", "shear_failed_time_s", 1, "{:.3f}"),
    ("failed under its thrust at [s]", "axial_failed_time_s", 1, "{:.3f}"),
    ("crushed at [s]", "crushed_time_s", 1, "{:.3f}"),
    ("largest opening of a joint [mm]", "largest_joint_opening_m", 1e-3, "{:z.2f}"),
    ("  thrust there [kN]", "thrust_at_largest_joint_opening_N", 1e3, "{:z,.0f}"),
    ("  moment there [kN m]", "moment_at_largest_joint_opening_Nm", 1e3, "{:z,.0f}"),
    *_when_and_where("largest_joint_opening"),
    ("largest rotation of a joint [mrad]", "largest_joint_rotation_rad", 1e-3, "{:z.2f}"),
    ("largest force of a bolt [kN]", "largest_bolt_force_N", 1e3, "{:z,.0f}"),
    ("largest force of a dowel between rings [kN]", "largest_dowel_force_N", 1e3, "{:z,.0f}"),
    ("largest offset of the rings at a dowel [mm]", "largest_ring_offset_m", 1e-3, "{:z.2f}"),
    ("least tightness of a gasket", "least_tightness", 1, "{:z.2f}"),
)
OF_AN_INTERFACE = (  # the same of each interface, between zones or of a lining
    ("largest offset [mm]", "largest_offset_m", 1e-3, "{:z.2f}"),
    ("largest opening [mm]", "largest_opening_m", 1e-3, "{:z.2f}"),
    ("largest pressure [kPa]", "largest_pressure_Pa", 1e3, "{:z,.0f}"),
    ("largest shear stress [kPa]", "largest_shear_stress_Pa", 1e3, "{:z,.0f}"),
)
PLACES = (("_time_s", ": time"), ("_x_m", ": x"), ("_y_m", ": y"), ("_chainage_m", ": chainage"))
GAP = 0.01  # of the energy, above which the user guide calls for smaller steps


def state(results):
    """One sentence: complete, failed or not finished."""
    s = results.summary
    duration = quantity(s.get("duration_s") or results.scene.get("time", {}).get("duration"), "s")
    if s.get("completed"):
        acted = results.acted("time.duration")
        computed = f"{duration} were computed" if acted is None else f"{quantity(acted, 's')} were computed, {duration} are stated"
        return tag("p", f"The run is complete: {computed}.", class_="state")
    until = "" if results.reached is None else f" at {quantity(results.reached, 's')} of {duration}"
    if s.get("error", "").startswith("ended by "):
        how, told = f"The run was stopped{until}.", f" This page shows what was computed until then. {sentence(s['error'])}"
        told += f" {sentence('to go on: ' + s['resume'])}" if "resume" in s else ""
    elif "error" in s:
        how, told = f"The run failed{until}.", f" This page shows what was computed until then. {sentence(s['error'])}"
    else:
        how, told = f"The run was not finished: it was stopped{until} or is still going on.", " This page shows what there is."
    return tag("p", tag("strong", how), told, class_="state failed")


def warnings(results):
    """Call it last: it lists the files that could not be read for the rest of the page."""
    found = list(results.summary.get("warnings", []))
    drift = results.summary.get("max_energy_drift")
    if drift is not None and drift > GAP:
        found.append(f"the energy balance has a gap of {100 * drift:.2g} % of the peak energy; {_remedy_of_gap(results.summary)}")
    found += dict.fromkeys(results.faults)
    notes = results.summary.get("notes", [])
    return section("warnings", "Warnings", bullets(map(sentence, found)) if found else tag("p", "None."),
                   [tag("h3", "Notes"), bullets(map(sentence, notes))] if notes else None)


def _remedy_of_gap(summary):
    taken, solve = -(summary.get("multiplier_work_J") or 0), summary.get("solve")
    if taken > 0 and solve in ("split", "lumped"):
        return (f"the multipliers took {quantity(taken, 'J')}, because the solve `{solve}` damps what zones cannot carry; a smaller "
                "time.dt_factor helps against the rest only")
    return "more than 1 % calls for a smaller time.dt_factor"


def figures(results):
    """The main figures of the run, those that scripts/run prints."""
    return section("figures", "Main figures", table("Main figures, from summary.json", ("figure", "value"), [
        (name, figure(results.figures, key)) for name, key in main_figures(results) if results.figures.get(key) is not None]))


def main_figures(*runs):
    """(name, key of summary.json) for these runs; rows such as `at x` carry the name of the quantity that they belong to."""
    owner = ""
    for what, key, *_ in _rows(runs):
        name = what.partition(" [")[0]
        part = next((said for ending, said in PLACES if key.endswith(ending)), f": {name.strip()}" if name.startswith(" ") else "")
        if not name.startswith(" "):
            owner = name.removesuffix(" at")
        yield f"{owner}{part}", key


def lines(runs):
    """The main figures for the screen: a line for each that some run has, a column for each run."""
    rows = _rows(runs)
    columns = [[""] + [row[0] for row in rows], *(_column(run, rows) for run in runs)]
    widths = [max(map(len, cells)) for cells in columns]
    for line in zip(*columns):
        if any(cell != "-" for cell in line[1:]):
            yield "  ".join(["  " + line[0].ljust(widths[0]), *(c.rjust(w + 1) for c, w in zip(line[1:], widths[1:]))])


def _rows(runs):
    """ROWS, and those of each lining, member and interface of the runs before what follows the forces of sections."""
    linings, faces = _named(runs, "lining|member", "_largest_moment_Nm"), _named(runs, "interface", "_largest_offset_m")
    after = next(i for i, row in enumerate(ROWS) if row[1] == "ovals_largest_diameter_change_m")
    of_linings = [row for lining in linings for row in _of_a_lining(lining)]
    of_faces = [row for name in faces for row in _of_an_interface(name)]
    return [*ROWS[:after], *of_linings, *of_faces, *ROWS[after:]]


def _named(runs, kinds, last):
    """The beginnings of the keys of all linings, members or interfaces, before the ending that each of them has."""
    return dict.fromkeys(key.removesuffix(last) for run in runs for key in run.summary if re.fullmatch(rf"(.+_)?({kinds})_.+{last}", key))


def _of_an_interface(name):
    """The rows of `interface_<name>`."""
    region, _, called = re.fullmatch("(.*?)(interface)_(.*)", name).groups()
    for what, key, *shown in OF_AN_INTERFACE:
        yield f"{region}interface {called}: {what}", f"{name}_{key}", *shown


def _of_a_lining(name):
    """The rows of `lining_<name>` or `member_<name>`."""
    kind, _, called = re.search("(lining|member)_.*", name).group().partition("_")
    region = name.removesuffix(f"{kind}_{called}")
    for what, key, *shown in OF_A_LINING:
        words = what.replace("per metre", "of one") if kind == "member" else what
        yield words if words.startswith(" ") else f"{region}{kind} {called}: {words}", f"{name}_{key}", *shown


def _column(run, rows):
    values = ((run.number(key) if key in run.figures else None, divisor, text) for _, key, divisor, text in rows)
    return [run.name] + ["-" if v is None else text.format(v / divisor) for v, divisor, text in values]
