"""The wave packets that the study of waves through the overlap sends."""
from itertools import product

from adit.cases.wave_packet import Case

SOLVES = ("consistent", "lumped", "split")
LENGTHS = (20, 10, 5, 4, 3, 2, 1, 0.5)  # λ/h


def cases(full):
    """All rows of the table, none twice; with `full` also those that take long."""
    return list(dict.fromkeys([*bar(), *strip(full), *patch()]))


def bar():
    def packets(lengths=LENGTHS, **what):
        return (Case("bar", solve, length, **what) for solve, length in product(SOLVES, lengths))

    for overlap in (1, 2, 5, 10):
        yield from packets(overlap_over_h=overlap)
    yield from packets(LENGTHS[:-1], h_over_a=4)  # half a zone of 4a is the shortest wave of the chain itself
    for dt_factor in (0.8, 0.1):
        yield from packets(dt_factor=dt_factor)
    yield from packets((20, 10, 5, 4), side="continuum")  # a grid carries nothing shorter than about 3h
    for substeps in (1, 2, 4):
        yield from packets((10, 5, 3, 1), dt_factor=0.2, substeps=substeps)


def strip(full):
    def packets(lengths, angles, waves="P", substeps=1):
        return (Case("strip", solve, length, h_over_a=4, angle_deg=angle, wave=wave, substeps=substeps)
                for solve, length, angle, wave in product(SOLVES, lengths, angles, waves))

    yield from packets((5, 3, 1), (0,), waves="PS")
    yield from packets((5,), (0, 15, 30, 45, 60))
    yield from packets((5,), (30,), waves="S")
    yield from packets((5,), (0,), substeps=2)
    yield from packets((10,), (0,))
    if full:
        yield from packets((10,), (0, 15, 30, 45, 60), waves="PS")
        yield from packets((5,), (0, 15, 30, 45, 60), waves="S")


def patch():
    return (Case("patch", solve, length, h_over_a=4) for solve, length in product(SOLVES, (10, 5, 2)))
