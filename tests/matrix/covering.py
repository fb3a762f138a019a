"""Covering arrays: few rows in which every combination of values of any two (or three) factors stands at least once.

Greedy, as AETG (Cohen, Dalal, Fredman, Patton 1997): a row begins with a combination that is still missing, and takes, factor by
factor in random order, the value that adds most of the missing ones; the best of several such rows is kept.
"""
import itertools
import random

CANDIDATES = 12  # rows tried for each one kept


def combinations(factors, strength, possible):
    """All combinations of `strength` values that some row may hold: frozensets of (factor, value)."""
    for names in itertools.combinations(factors, strength):
        for values in itertools.product(*(factors[name] for name in names)):
            chosen = dict(zip(names, values))
            if possible(chosen):
                yield frozenset(chosen.items())


def covering_array(factors, strength, seed, possible):
    """Rows {factor: value} that cover all possible combinations of `strength` factors, and the number of these.

    factors: {name: [value, …]}, the first value of each being the plain one
    possible(row): whether the values of a whole or partial row may stand together; it must be so for the plain ones
    Combinations that no whole row can hold are left out.
    """
    chance = random.Random(seed)
    missing = sorted(combinations(factors, strength, possible), key=sorted)
    chance.shuffle(missing)
    missing = dict.fromkeys(missing)
    rows, covered = [], 0
    while missing:
        start = next(iter(missing))
        found = [row for row in (_row(factors, strength, dict(start), missing, chance, possible) for _ in range(CANDIDATES)) if row]
        if not found:
            del missing[start]
            continue
        row = max(found, key=lambda row: _gain(row, strength, missing))
        for names in itertools.combinations(sorted(row), strength):
            covered += missing.pop(frozenset((name, row[name]) for name in names), 0) is None
        rows.append({name: row[name] for name in factors})
    return rows, covered


def whole_row(factors, start, seed, possible):
    """A row that begins with these values; none where 100 tries found none."""
    chance = random.Random(seed)
    return next((row for _ in range(100) if (row := _row(factors, 1, dict(start), {}, chance, possible))), None)


def _gain(row, strength, missing):
    return sum(frozenset((name, row[name]) for name in names) in missing for names in itertools.combinations(sorted(row), strength))


def _row(factors, strength, row, missing, chance, possible):
    """A whole row with the values of a partial one; none where they allow none."""
    names = [name for name in factors if name not in row]
    chance.shuffle(names)
    for name in names:
        values = [value for value in factors[name] if possible({**row, name: value})]
        if not values:
            return None
        row[name] = max(values, key=lambda value: (_added(row, name, value, strength, missing), chance.random()))
    return row


def _added(row, name, value, strength, missing):
    return sum(frozenset([*pairs, (name, value)]) in missing for pairs in itertools.combinations(sorted(row.items()), strength - 1))
