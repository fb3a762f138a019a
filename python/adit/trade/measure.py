"""Runs the variants of a model one after the other and compares each with the full particle model."""
import statistics
import subprocess

import numpy as np

from adit import Run, Unusable, programs
from adit.trade.front import ALONE
from adit.trade.models import dt_factor

REFERENCE_DT_FACTOR = 0.2
COSTS = ("cpu_s", "wall_s")


def table(model, out):
    """Yields a row of the table for each variant, as a dictionary."""
    def finished(scene, settings, name):
        return compute(scene, settings, out / name.replace(" ", "_").replace(",", ""))

    reference = finished(model.full(), dt_factor(REFERENCE_DT_FACTOR), "reference")
    for family, scene, variants in [(ALONE, model.full(), model.alone),
                                    *((f, model.coupled(), v) for f, v in model.families.items())]:
        for name, settings in variants.items():
            runs = [finished(scene, settings, name) for _ in range(model.repeats)]
            costs = [cost(run) for run in runs]
            yield {"family": family, "variant": name, **size(runs[0]), **errors(model, runs[0], reference),
                   **{key: statistics.median(c[key] for c in costs) for key in COSTS}}


def compute(scene, settings, folder):
    sets = [word for setting in settings for word in ("--set", setting)]
    ended = subprocess.run([programs.program("coupler"), "run", scene, *sets, "--out", folder],
                           capture_output=True, text=True)
    if ended.returncode:
        raise Unusable(f"{folder.name} failed (exit code {ended.returncode}): {ended.stderr.splitlines()[-1]}")
    return Run(folder)


def size(run):
    s = run.summary
    return {"solve": s.get("solve", "none"), "substeps": s["substeps"], "dt_s": s["dt_s"] / s["substeps"],
            "particles": s["particles"], "zones": s["zones"], "coupling_points": s["coupling_points"],
            "particle_updates": s["particle_updates"], "zone_updates": s["zone_updates"],
            "updates": s["particle_updates"] + s["zone_updates"], "energy_kept": s["energy_kept"]}


def cost(run):
    """CPU time of all processes and wall-clock time [s]."""
    return {"cpu_s": sum(run.number(f"{process}_cpu_s") or 0 for process in ("coupler", "continuum", "particles")),
            "wall_s": run.number("wall_s")}


def errors(model, run, reference):
    histories = {"force": ("max_bond_force_N", model.force_window)}
    whole = (0, np.inf)
    histories |= {place: (f"{place}_u{model.axis}_m", whole) for place in ("near", "far")}
    found = {}
    for name, (column, window) in histories.items():
        found[f"{name}_l2"], found[f"{name}_peak"] = compare(run.histories, reference.histories, column, window)
    return found


def compare(histories, reference, column, window):
    """Errors relative to the reference, at the reference's times inside the window: root mean square, and largest
    absolute value."""
    times = reference["time_s"]
    inside = (window[0] <= times) & (times <= window[1])
    expected = reference[column][inside]
    found = np.interp(times[inside], histories["time_s"], histories[column])
    largest = np.abs(expected).max()
    return np.linalg.norm(found - expected) / np.linalg.norm(expected), np.abs(found).max() / largest - 1
