"""The error that is left in a result, from its changes as lengths are halved again and again (Roache 1994, J. Fluids Eng. 116).

Where a result q approaches its limit as h^p, its error on the finest of two lengths is (q_1 - q_2)/(2^p - 1). Two changes tell an
order p = log2((q_1 - q_2)/(q_2 - q_3)), but not whether it lasts: it is taken no higher than 1. If the order before, of three changes,
was above 1 as well, it is taken as it is, no higher than 2, that of the zones. Roache's factor of 1.25 covers what is left. One change
tells no order: his factor is then 3, of the change itself. Changes of different signs have none: the larger one may come again. Those
that hardly shrink count as of the least order that is taken; a change smaller than an eighth of the one before is so by chance and
counts as an eighth.
"""
import math
from dataclasses import dataclass

FACTOR, OF_ONE = 1.25, 3.0
LEAST, OF_TWO, MOST, CHANCE = 0.2, 1.0, 2.0, 3.0  # orders


@dataclass(frozen=True)
class Error:
    """`size` in the unit of the result; `order`: as observed, None where there is none."""
    size: float
    order: float | None = None


def error_of(changes):
    """Of the finest value, after one change at least, the first one first."""
    last = abs(changes[-1])
    if len(changes) == 1:
        return Error(OF_ONE * last)
    if changes[-2] * changes[-1] <= 0:
        return Error(FACTOR * max(last, abs(changes[-2])))
    orders = [math.log2(before / after) if before * after > 0 else 0.0 for before, after in list(zip(changes, changes[1:]))[-2:]]
    lasts = len(orders) == 2 and min(orders) > OF_TWO
    taken = min(max(orders[-1], LEAST), MOST if lasts else OF_TWO)
    last = max(last, abs(changes[-2]) / 2**CHANCE)
    return Error(FACTOR * last / (2**taken - 1), orders[-1] if orders[-1] > LEAST else None)
