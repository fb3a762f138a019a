"""The error that is left in a result, from its changes as lengths are halved again and again (Roache 1994, J. Fluids Eng. 116).

Where a result q approaches its limit as h^p, what is left on the finest of two lengths is (q_1 - q_2)/(2^p - 1), on the side of the last
change. Two changes tell an order p = log2((q_1 - q_2)/(q_2 - q_3)), but not whether it lasts: it is taken no higher than 1. Of two
orders, from three changes, the smaller is taken, no higher than 2, that of the zones; an order of nearly none before does not count.
The limit then lies between the finest result and what is left beyond it, with a quarter of this on either side (Roache's factor of
1.25). The middle of this interval is told, because it is nearer to the limit than the finest result.

Changes that hardly shrink count as of the least order that is taken, to both sides. A change smaller than a ninth of the one before
is so by chance, because no order is that high: it counts as a quarter, to both sides. Changes of different signs have no order: the
larger one may come again, to both sides. One change tells no order either: Roache's factor is then 3, of the change itself. So it is
where the sign has turned and changes grow: what came before has not to do with the limit yet.
"""
import math
from dataclasses import dataclass

FACTOR, OF_ONE = 1.25, 3.0
LEAST, OF_TWO, MOST, CHANCE = 0.2, 1.0, 2.0, 3.1  # orders


@dataclass(frozen=True)
class Error:
    """`size`: half of the interval, in the unit of the result; `order`: as observed, None where there is none; `shift`: of the middle of
    the interval from the finest result."""
    size: float
    order: float | None = None
    shift: float = 0.0


def error_of(changes):
    """Of the finest value, after one change at least, the first one first."""
    last = changes[-1]
    before = changes[-2] if len(changes) > 1 else 0.0
    if len(changes) == 1 or before * last < 0 and abs(last) > abs(before):
        return Error(OF_ONE * abs(last))
    if before * last <= 0:
        return Error(FACTOR * max(abs(last), abs(before)))
    orders = [math.log2(coarser / finer) if coarser * finer > 0 else 0.0 for coarser, finer in list(zip(changes, changes[1:]))[-2:]]
    if orders[-1] <= LEAST:
        return Error(FACTOR * abs(last) / (2**LEAST - 1))
    if orders[-1] > CHANCE:
        return Error(FACTOR * abs(before) / 2**MOST)
    seen = [order for order in orders if order > LEAST]
    left = last / (2**min(*seen, MOST if len(seen) > 1 and min(seen) > OF_TWO else OF_TWO) - 1)
    return Error((FACTOR - 0.5) * abs(left), orders[-1], left / 2)
