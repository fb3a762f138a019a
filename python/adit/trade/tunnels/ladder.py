"""Ladders of models of a tunnel, from the cheapest to the finest, and the rows of their tables."""
from dataclasses import dataclass
from typing import Callable

from adit.trade.table import lines
from adit.trade.tunnels.cost import Meter


@dataclass
class Quantity:
    """A quantity of the table."""
    key: str
    heading: str  # with the unit
    factor: float  # from SI to the unit of the heading
    digits: str  # format


@dataclass
class Rung:
    """A model. `compute` takes a Meter and returns {key: value}; a quantity that the model does not have is left out."""
    family: str
    name: str
    compute: Callable


@dataclass
class Ladder:
    """The last rung is the finest, with which all are compared."""
    name: str
    quantities: list
    rungs: list


def table(ladder, out, told):
    """Rows: model, cost and results of each rung, and its errors relative to the finest rung. Calls `told` for each rung."""
    rows = []
    for rung in ladder.rungs:
        meter = Meter(out / rung.name.replace(" ", "_").replace(",", ""))
        found = rung.compute(meter)
        rows.append({"family": rung.family, "model": rung.name, **meter.counts, "cpu_s": meter.cpu_s, "wall_s": meter.wall_s,
                     "memory_bytes": meter.memory_bytes,
                     **{quantity.key: found.get(quantity.key) for quantity in ladder.quantities}})
        told(rows[-1])
    finest = rows[-1]
    for row in rows:
        row |= {f"{q.key} error": error(row[q.key], finest[q.key]) for q in ladder.quantities}
    return rows


def error(value, finest):
    """Error relative to the finest; None if one of them is None, or the finest is zero."""
    return None if value is None or not finest else value / finest - 1


COSTS = (  # heading, key, factor, format
    ("particles", "particles", 1, ",.0f"), ("zones", "zones", 1, ",.0f"), ("updates [10⁶]", "updates", 1e-6, ",.1f"),
    ("CPU [s]", "cpu_s", 1, ".3g"), ("memory [MB]", "memory_bytes", 1e-6, ".0f"))


def markdown(ladder, rows):
    headings = ["model", *(heading for heading, *_ in COSTS), *(quantity.heading for quantity in ladder.quantities)]
    return lines(headings, ([row["model"], *(f"{factor * row[key]:{text}}" for _, key, factor, text in COSTS),
                             *(cell(quantity, row) for quantity in ladder.quantities)] for row in rows))


def cell(quantity, row):
    """A value and its error."""
    value, off = row[quantity.key], row[f"{quantity.key} error"]
    if value is None:
        return "–"
    return f"{quantity.factor * value:{quantity.digits}}" + ("" if not off else f" ({round(100 * off):+d} %)")
