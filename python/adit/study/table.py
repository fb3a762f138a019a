"""The table of a study: inputs, intensities and answers of each run, as CSV and HDF5. It holds no clocks: the same study has the same
table, byte for byte, however often it was stopped."""
import csv
import functools

import numpy as np

from adit.plots.oscillators import pseudo_acceleration
from adit.results.files import Unusable, nearest
from adit.results.run import Run
from adit.study.fragility.measures import G
from adit.study.component import sa

UNITS = {"pga": "m_per_s2", "pgv": "m_per_s", "pgd": "m", "arias": "m_per_s", "cav": "m_per_s"}  # others, sa: m/s²


def column_of(measure):
    return f"{measure}_{UNITS.get(measure, 'm_per_s2')}"


def rows_of(study, computed, folder):
    """[{column: value}] of [(row, result)]; None stands for what a run does not have."""
    found = []
    for number, (row, result) in enumerate(computed, 1):
        answers = result.get("answers") or dict.fromkeys(study.answers)
        one = {"run": number, "motion": row.motion, "level": row.level, "factor": row.factor if row.motion else None, "sample": row.sample}
        one |= {column_of(measure): value for measure, value in row.measures.items()}
        one |= row.drawn | row.seeds
        for measure, period, place in in_histories(study):
            one[column_at(measure, period, place)] = None if "failed" in result else measured(folder / "runs" / row.hash, place, measure, period)
        one |= answers
        one |= {f"{damage.of}_state": None if answers[damage.of] is None else damage.reached(answers[damage.of]) for damage in study.damage}
        found.append(one | {"failed": result.get("failed", ""), "folder": f"runs/{row.hash}"})
    return found


def in_histories(study):
    """[(measure, period, place)] of intensities that are measured in histories: over which fragility is told, and where levels
    are reached."""
    known = [study.intensity, *([study.levels.intensity] if study.levels else [])]
    return [each for each in dict.fromkeys(known) if each[2]]


def column_at(measure, period, place):
    """The column of an intensity in the history `place`, or of the motion as it is given to the scene."""
    name = sa(period) if measure == "sa" else measure
    return f"{place}_{column_of(name)}" if place else column_of(name)


def intensity_column(study):
    """The column that fragility is told over."""
    return column_at(*study.intensity)


def level_column(study):
    """The column of the intensity that the levels are of."""
    return column_at(*study.levels.intensity)


@functools.cache  # a run does not change, and `--until` asks again and again
def measured(folder, place, measure, period):
    """The intensity [SI] of a history of horizontal acceleration."""
    run = Run(folder)
    column = f"{place}_ax_m_per_s2"
    if column not in run.histories:
        raise Unusable(f"motions: at: {place} is no history of acceleration_x of the scene; "
                       + nearest(column, [name for name in run.histories if name.endswith("_ax_m_per_s2")]))
    acceleration, times = run.histories[column], run.histories["time_s"]
    if measure == "pga":
        return float(np.abs(acceleration).max())
    if measure == "sa":
        return float(pseudo_acceleration(acceleration, times[1] - times[0], [period])[0])
    steps, middles = np.diff(times), (acceleration[1:] + acceleration[:-1]) / 2
    if measure == "pgv":
        return float(np.abs(np.cumsum(middles * steps)).max())
    squares = (acceleration[1:]**2 + acceleration[1:] * acceleration[:-1] + acceleration[:-1]**2) / 3
    return float(np.pi / (2 * G) * np.sum(squares * steps))


def column(rows, name):
    """An array of numbers; NaN stands for what a run does not have."""
    return np.array([np.nan if row[name] is None else float(row[name]) for row in rows])


def write(rows, folder):
    """Writes study.csv and, where h5py is installed, study.h5 with an array for each column."""
    write_csv(rows, folder / "study.csv")
    try:
        import h5py
    except ImportError:
        return ["study.csv"]
    with h5py.File(folder / "study.h5", "w") as file:
        for name in rows[0]:
            values = [row[name] for row in rows]
            if any(isinstance(value, str) for value in values):
                file.create_dataset(name, data=["" if value is None else str(value) for value in values], dtype=h5py.string_dtype())
            else:
                file.create_dataset(name, data=column(rows, name))
    return ["study.csv", "study.h5"]


def write_csv(rows, path):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(rows[0]), lineterminator="\n", restval="")
        writer.writeheader()
        writer.writerows({key: "" if value is None else repr(value) if isinstance(value, float) else value for key, value in row.items()}
                         for row in rows)
