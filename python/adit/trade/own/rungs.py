"""The models of a scene: as stated, then along each dimension by itself coarser and finer, then the finest of all.

All are told relative to the finest, whose zones and particles are half as large as stated where the budget allows that. A dimension
whose results approach a limit has an order, from its own three finest models.
"""
import resource
from dataclasses import dataclass, field

from adit.accuracy.dimensions import name_of
from adit.accuracy.estimate import error_of
from adit.accuracy.search import GROWS

LEVELS = (-2, -1, 1)  # beside the stated one
NONE = 1e-6  # relative changes below this tell no order
HIGHEST = 4.0  # no method here has a higher order, and what moves away from its limit has none


@dataclass
class Rung:
    """`cpu_s`: CPU time of all processes."""
    dimension: str
    levels: dict
    computed: object
    cpu_s: float


@dataclass
class Ladder:
    """`compute(levels)` returns a Computed or None; `refining`, `choices`: the dimensions; `budget` [s]. After `climb()`: `rungs` in
    their order, `finest`, and `left_out`, the names of models beyond the budget."""
    compute: object
    refining: list
    choices: list
    budget: float
    rungs: list = field(default_factory=list)
    finest: Rung = None
    left_out: list = field(default_factory=list)

    def climb(self):
        """Whether the scene as stated could be computed."""
        stated = self._rung("stated", {}, 0)
        if stated is None:
            return False
        for dimension in self.refining:
            for level in LEVELS:
                self._rung(dimension.name, {dimension.name: level}, self._expected(dimension.name, level))
        for dimension in self.choices:
            for level in LEVELS:
                self._rung(dimension.name, {dimension.name: level}, 2 * stated.computed.seconds)
        finest = {dimension.name: 1 for dimension in self.refining}
        finest_of_all = len(finest) > 1 and self._rung("all of these", finest, sum(self._expected(name, 1) for name in finest))
        self.finest = finest_of_all or max((rung for rung in self.rungs if rung is stated or rung.dimension in finest),
                                           key=lambda rung: (sum(rung.levels.values()), rung.computed.seconds))
        return True

    def along(self, dimension):
        """The Computed of a dimension from the coarsest to the finest, with the one as stated."""
        own = {0: self.rungs[0].computed} | {rung.levels[dimension]: rung.computed for rung in self.rungs if rung.dimension == dimension}
        return [own[level] for level in sorted(own)]

    def order(self, dimension, question):
        """As observed; None where there is none."""
        values = [model.values[question] for model in self.along(dimension)]
        changes = [after - before for before, after in zip(values, values[1:])]
        order = error_of(changes).order if len(changes) > 1 and min(map(abs, changes)) > NONE * abs(values[-1]) else None
        return order if order and 0 < order < HIGHEST else None

    def difference(self, rung, question):
        """From the finest, relative to it; None where that is 0."""
        finest = self.finest.computed.values[question]
        return (rung.computed.values[question] - finest) / abs(finest) if finest else None

    def _expected(self, dimension, level):
        """What a model is likely to cost [s]."""
        models = self.along(dimension)
        if level < 0:
            return models[-1].seconds
        return models[-1].seconds + GROWS * max(models[-1].seconds - models[-2].seconds, 0) if len(models) > 1 else GROWS * models[-1].seconds

    def _rung(self, dimension, levels, expected):
        settable = all(each.settings(levels.get(each.name, 0)) is not None for each in [*self.refining, *self.choices])
        if not settable:
            return None
        if sum(rung.computed.seconds for rung in self.rungs) + expected > self.budget:
            self.left_out.append(name_of(levels))
            return None
        before = _cpu_of_children()
        computed = self.compute(levels)
        if computed is None:
            return None
        self.rungs.append(Rung(dimension, levels, computed, _cpu_of_children() - before))
        return self.rungs[-1]


def _cpu_of_children():
    """Of all processes that have ended [s]."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime
