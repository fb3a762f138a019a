"""Finds the factors of a motion by which the ground reaches levels of intensity at one of its places, such as the free surface.

The ground answers nonlinearly. Between two runs the intensity is taken to grow as factor**exponent, which is a secant of logarithms. In
linear ground the first run tells all: the exponent is 1, or 2 of the Arias intensity.
"""
import math
from dataclasses import dataclass

from adit.results.files import Unusable
from adit.study import design, scheduler, table
from adit.study.motions import power_of

WITHIN = 0.02  # of the level
MOST = 6  # runs of a level
DIGITS = 6  # of factors, so that machines whose logarithms differ in the last digit compute the same runs
BOUNDS = 0.5, 2.0  # of an exponent beyond the runs, times that of linear ground
HARDLY_MORE = 1.1  # times the intensity, of a motion at least twice as strong: the ground yields


@dataclass(frozen=True)
class Line:
    """The intensity over the factor: `reached` [SI] at `factor`, and in proportion to factor**exponent."""
    factor: float
    reached: float
    exponent: float

    def factor_at(self, level):
        return float(f"{self.factor * (level / self.reached)**(1 / self.exponent):.{DIGITS}g}")


def line(reached, level, power, exponent):
    """The Line on which a level is expected from {factor: intensity}: through the two runs between which it lies, or beyond all runs
    through the last two, or through a single one with an exponent. `power`: the exponent of linear ground."""
    factors = sorted(reached)
    over = next((number for number, factor in enumerate(factors) if reached[factor] > level), len(factors))
    first = max(min(over, len(factors) - 1) - 1, 0)
    pair = factors[first:first + 2]
    if len(pair) == 2:
        exponent = math.log(reached[pair[1]] / reached[pair[0]]) / math.log(pair[1] / pair[0])
    if not 0 < over < len(factors):
        low, high = (bound * power for bound in BOUNDS)
        exponent = min(max(exponent, low), high)
    start = pair[0] if over == 0 else pair[-1]
    return Line(start, reached[start], exponent)


def yields(reached, level):
    """Whether a level lies beyond what the ground bears."""
    strongest = max(reached)
    return max(reached.values()) < level and any(
        reached[strongest] < HARDLY_MORE * reached[factor] for factor in reached if factor <= strongest / 2)


def climb(study, rows, folder, progress):
    """scheduler.in_turn() of rows whose factors are searched for: of each level, the run that is nearest to it is returned. Rows whose
    factor would be excessive are left out."""
    found, known = [], None
    for number, row in enumerate(rows):
        run, known = yield from _at_level(study, row, known, folder, progress)
        if run:
            found.append(run)
            if scheduler.ended(study, run[1]):
                progress.expect(number + 1 - len(rows))
                break
    return found


def _at_level(study, row, known, folder, progress):
    """((row, result) or None, the Line there). `known`: the Line at the level before; None where no run has told it."""
    power, largest = power_of(study.levels.measure), study.largest_factor
    exponent = known.exponent if known else power
    wanted = line({known.factor: known.reached}, row.level, power, exponent).factor_at(row.level) if known else row.factor
    runs, reached = {}, {}
    while True:
        factor = min(max(wanted, 1 / largest), largest)
        if factor in runs:
            progress.leave_out(row, wanted)
            return None, known
        if runs:
            progress.expect(1)
        at_factor = row.scaled(factor)
        design.identify(study, [at_factor])
        runs[factor] = at_factor, (yield at_factor)
        if "failed" in runs[factor][1]:
            return runs[factor], known
        reached[factor] = _reached(study, at_factor, folder)
        through = line(reached, row.level, power, exponent)
        nearest = min(reached, key=lambda factor: abs(math.log(reached[factor] / row.level)))
        known = Line(nearest, reached[nearest], through.exponent)
        wanted = through.factor_at(row.level)
        if _near(reached[nearest], row.level) or yields(reached, row.level) or len(runs) == MOST:
            return runs[nearest], known


def _reached(study, row, folder):
    measure, period, place = study.levels.intensity
    reached = table.measured(folder / "runs" / row.hash, place, measure, period)
    if not reached:
        raise Unusable(f"{study.path}: motions.{study.levels.how}.at: {place} stays at rest in {scheduler.name_of(row)}; "
                       "name a place that is shaken.")
    return reached


def _near(reached, level):
    return abs(reached / level - 1) <= WITHIN


def runs_of(study, climbs):
    """(the least, the largest) number of runs in climbs of rows that are searched for."""
    levels = sum(map(len, climbs))
    return len(climbs) if study.climbs else levels, MOST * levels


def missed(study, good):
    """The rows of the table, without those that failed, that have not reached their level."""
    if not study.searches:
        return []
    return [row for row in good if not _near(row[table.level_column(study)], row["level"])]
