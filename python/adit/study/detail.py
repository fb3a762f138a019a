"""The worst places in detail: runs of a whole tunnel with the largest answers are computed again by the beam, which writes the joint at its
worst place as a coupled scene of particles and zones (simplified/zoom/plan_scene.hpp), and then that scene: the unified section.

Both are computed as all runs are (rows.py), into OUT/detail/: the beam in HASH_PLACE_beam, the unified section in HASH_PLACE_section.
"""
import math
from dataclasses import asdict, replace

import numpy as np

from adit import Run, programs
from adit.cases.tunnels import plan_joint
from adit.report.quantities import quantity, unit_of
from adit.results.files import Unusable
from adit.study import rows, scheduler, table
from adit.study.fragility import measures

FOLDER = "detail"
MODELS = ("beam", "section")
KINDS = ("moment", "shear", "strain")  # in the names of answers
LEADING = {"worst-moment": "moment_Nm", "worst-shear": "key_force_N"}  # what is told of a place; of others the opening of the edge


def check(study, stated):
    """Raises Unusable where the scene, as it is read, has no joints that can be modelled closely."""
    simplified = stated.get("simplified", {})
    if not simplified.get("tunnel", {}).get("joints"):
        raise Unusable(f"{study.path}: detail: {study.scene.name} is no scene of a whole tunnel with joints (simplified.tunnel.joints), "
                       "which unified sections are made of; leave `detail` out.")
    if "zoom" not in simplified:
        raise Unusable(f"{study.path}: detail: {study.scene.name} has no simplified.zoom, the width of the unified sections; "
                       "write for example `zoom: {width: 90 m}` in it.")


def place_of(answer):
    """The place, as `simplified run --zoom` takes it, that an answer is about: where joints open most if its name tells no other."""
    return f"worst-{next((kind for kind in KINDS if kind in answer), 'opening')}"


def worst(detail, listed):
    """Numbers in `listed` (table.rows_of) of the rows with the largest answers by size; of rows that have one run, the first."""
    known = [number for number, row in enumerate(listed) if row[detail.of] is not None and not math.isnan(row[detail.of])]
    first = {}
    for number in sorted(known, key=lambda number: (-abs(listed[number][detail.of]), listed[number]["folder"])):
        first.setdefault(listed[number]["folder"], number)
    return list(first.values())[:detail.runs]


def compute(plan, options, computed, listed):
    """[{column: value}] of the worst rows; `computed`: [(row, result)] of `listed`. Writes OUT/detail.csv."""
    study, place = plan.study, place_of(plan.study.detail.of)
    numbers = worst(study.detail, listed)
    if not numbers:
        return []
    again = [computed[number][0] for number in numbers]
    pairs = [{model: replace(row, hash=f"{row.hash}_{place}_{model}") for model in MODELS} for row in again]
    tasks = {task["hash"]: task for pair in pairs for task in tasks_of(plan, pair, place)}
    progress = scheduler.Progress(len(tasks))
    print(f"in detail: {len(pairs)} with the largest {study.detail.of}, by the beam and its unified section", flush=True)
    came = plan.go([way(pair, progress) for pair in pairs], lambda row: tasks[row.hash], progress, plan.expected.at_once, options)
    found = [row_of(plan, listed[number], pair, result, place) for number, pair, (_, result) in zip(numbers, pairs, came)]
    table.write_csv(found, plan.out / "detail.csv")
    return found


def way(pair, progress):
    """The way of a run, as scheduler.compute() takes it: its beam, and where that can be computed its unified section. Returns what came
    of the last one."""
    result = yield pair["beam"]
    if "failed" in result:
        progress.expect(-1)
        return [(pair["beam"], result)]
    return [(pair["section"], (yield pair["section"]))]


def tasks_of(plan, pair, place):
    """The Tasks of the beam and of the unified section, as mappings. Runs of a chain are computed by the beam, whose joints tell more."""
    study, out = plan.study, str(plan.out)
    settings = study.set | pair["beam"].settings | {"simplified.model": "beam"}
    beam = rows.Task(str(plan.program), str(study.scene), settings, out, pair["beam"].hash, release=plan.release,
                     keep=["zoom", "joints.csv", *study.keep], options=["--zoom", place], room=FOLDER)
    zoomed = beam.place / "zoom" / f"{place}.yaml"
    section = rows.Task(str(programs.program("coupler")), str(zoomed), {}, out, pair["section"].hash, release=plan.release, keep=["fields"],
                        room=FOLDER)
    return asdict(beam), asdict(section)


def row_of(plan, listed, pair, result, place):
    """{column: value} of a run; None stands for what a run that failed does not have."""
    columns = [f"{model}_{column}" for column in plan_joint.COLUMNS.values() for model in MODELS]
    row = {key: listed[key] for key in ("run", "motion", "level", "sample", plan.study.detail.of)} | {
        "place": place, "joint": "", "chainage_m": None, **dict.fromkeys(columns), "failed": result.get("failed", ""),
        **{model: f"{FOLDER}/{each.hash}" for model, each in pair.items()}}
    if not row["failed"]:
        row |= joint(plan.out, row)
        for model, (_, quantities) in zip(MODELS, over_time(plan.out, row)):
            row |= {f"{model}_{column}": value for column, value in plan_joint.largest(quantities).items()}
    return row


def joint(out, row):
    """The name of the joints, and the chainage of that which the unified section has."""
    chainage = Run(out / row["section"]).scene["particles"]["joints"][0]["from"]["x"]
    joints = Run(out / row["beam"]).table("joints.csv")
    return {"joint": str(joints["group"][np.argmin(np.abs(joints["chainage_m"] - chainage))]), "chainage_m": float(chainage)}


def over_time(out, row):
    """The joint by the beam and by the unified section, as plan_joint tells them."""
    beam = Run(out / row["beam"])
    half_width = plan_joint.half_width(beam)
    return plan_joint.of_beam(beam, row["place"], half_width), plan_joint.of_model(Run(out / row["section"]), half_width)


def told(study, found):
    """Yields what the user is told of the rows."""
    for row in found:
        if row["failed"]:
            yield f"in detail          {name_of(study, row)} failed: {row['failed']}"
        else:
            column = LEADING.get(row["place"], "edge_opening_m")
            by_beam, by_section = (row[f"{model}_{column}"] for model in MODELS)
            yield (f"in detail          {name_of(study, row)}, {row['joint']} at {row['chainage_m']:g} m: {said(column)} "
                   f"{quantity(by_beam, unit_of(column))} by the beam, {quantity(by_section, unit_of(column))} by its unified section"
                   + (f" ({share})" if (share := difference(by_beam, by_section)) else ""))


def name_of(study, row):
    """What a user knows a row of detail.csv by."""
    if row["level"] is None:
        return f"run {row['run']}" + (f", {row['motion']}" if row["motion"] else "")
    unit, si = measures.unit_of(study.levels.measure)
    return f"run {row['run']}, {row['motion']} at {row['level'] / si:.3g} {unit}"


def said(column):
    """A column as words, without its unit."""
    return column.rpartition("_")[0].replace("_", " ")


def difference(beam, section):
    """Of the section from the beam, in words; empty where the beam has nothing."""
    return f"{100 * (section / beam - 1):+.1f} %" if beam > 0 else ""
