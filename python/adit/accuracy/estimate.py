"""The error that is left in a result, from its changes as lengths are halved again and again (Roache 1994, J. Fluids Eng. 116).

Where a result q approaches its limit as h^p, (q_1 - q_2)/(2^p - 1) is left on the finest of two lengths, on the side of the last change.
Two changes tell an order p = log2((q_1 - q_2)/(q_2 - q_3)), but not whether it lasts: it is taken no higher than 1. Of two orders that
follow one another, both above 1, the smaller is taken, no higher than 2, that of the zones.

A change can be small by chance. So all of them count: each is taken to shrink by that order, but at least by the first, from its model
to the finest, and the largest of what they leave is the error, to both sides. Its middle lies beyond the finest result by a third of
what the last change leaves: that is what the second order leaves where the first is taken, and half as much more as is expected is
still inside. Changes of different signs have no order, and tell no side: they count as of the first, with half as much more to both
sides. One change tells no order: Roache's factor is then 3.
"""
import math
from dataclasses import dataclass

OF_ONE, OF_TURNED = 3.0, 1.5
LEAST, FIRST, SECOND = 0.2, 1.0, 2.0  # orders


@dataclass(frozen=True)
class Error:
    """`size`: half of the interval, in the unit of the result; `order`: as observed last, None where there is none; `shift`: of the middle
    of the interval from the finest result."""
    size: float
    order: float | None = None
    shift: float = 0.0


def error_of(changes):
    """Of the finest value, after one change at least, the first one first."""
    if len(changes) == 1:
        return Error(OF_ONE * abs(changes[0]))
    orders = [_order(coarser, finer) for coarser, finer in list(zip(changes, changes[1:]))[-2:]]
    taken = _taken(orders)
    shrinks = 2**max(taken, FIRST)
    largest = max(abs(change) / shrinks**halvings for halvings, change in enumerate(reversed(changes)))
    if orders[-1] is None:
        return Error(OF_TURNED * largest)
    left = changes[-1] / (2**taken - 1)
    return Error(max(largest / (shrinks - 1), abs(left)), orders[-1], left / 3)


def _order(coarser, finer):
    """None where the changes have different signs, or one is 0."""
    return math.log2(coarser / finer) if coarser * finer > 0 else None


def _taken(orders):
    if len(orders) > 1 and None not in orders and min(orders) > FIRST:
        return min(*orders, SECOND)
    return FIRST if orders[-1] is None else min(max(orders[-1], LEAST), FIRST)
