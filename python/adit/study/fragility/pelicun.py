"""Fragility tables of pelicun and of SimCenter's Damage and Loss Model Library, as the rows HTU.GS of their file for HAZUS."""
import csv

from adit.results.files import Unusable
from adit.study.fragility.curves import Curve
from adit.study.fragility.measures import MEASURES

LIMIT_STATES = 4  # that the tables of HAZUS have columns for


def header(limit_states):
    return ["ID", "Incomplete", "Demand-Type", "Demand-Unit", "Demand-Offset", "Demand-Directional",
            *(f"LS{number}-{part}" for number in range(1, limit_states + 1)
              for part in ("Family", "Theta_0", "Theta_1", "DamageStateWeights"))]


def write(path, components, measure, *, period=None):
    """`components`: {ID: {state: Curve}}, states from the least to the worst, over a measure (measures.MEASURES) in SI. Theta_0 is the
    median, Theta_1 the dispersion. Unusable if pelicun does not know the measure."""
    known = MEASURES[measure]
    if known.pelicun is None:
        raise Unusable(f"pelicun has no fragility over {measure}: state another `intensity` in the study, such as PGA.")
    demand = f"{known.pelicun}|{period:g}" if measure == "SA" else known.pelicun
    states = max(LIMIT_STATES, *(len(curves) for curves in components.values()))
    with open(path, "w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(header(states))
        for name, curves in components.items():
            filled = [entry for curve in curves.values()
                      for entry in ("lognormal", f"{curve.median * known.pelicun_per_si:.15g}", f"{curve.dispersion:.15g}", "")]
            table.writerow([name, 0, demand, known.pelicun_unit, 0, 0, *filled, *[""] * (4 * states - len(filled))])


def read(path):
    """{ID: (demand type, unit, [Curve of each limit state])}."""
    with open(path, encoding="utf-8", newline="") as file:
        return {row["ID"]: (row["Demand-Type"], row["Demand-Unit"],
                            [Curve(float(row[key.replace("Family", "Theta_0")]), float(row[key.replace("Family", "Theta_1")]))
                             for key in row if key.endswith("-Family") and row[key] == "lognormal"])
                for row in csv.DictReader(file)}
