"""Refines a scene until the results are as accurate as is asked.

All dimensions are halved together: their ratio stays, so that the changes from model to model tell the error of all of them (Roache
1994). The coarsest model comes first, because it costs next to nothing: each halving costs about eight times as much as the one before.
Two models are enough where little changes, and not by chance: the median change of all figures of the runs must be as small as that of
the answers. A result that scatters by more than is asked is left alone.

Where statics bring the model to rest, the coarsest model is also computed nearer to it: no answer is told more accurately than that.
"""
import math
from dataclasses import dataclass, field
from statistics import median

from adit.accuracy.estimate import OF_ONE, Error, error_of
from adit.accuracy.runs import Computed

GROWS = 8  # what halved lengths add to the cost, over what the last ones added: in the plane and in time
FEW = 3  # figures at least tell whether changes are small by chance


def none_ahead(*levels):
    """Nothing is computed before it is asked for."""


@dataclass
class Search:
    """`compute(levels)` returns a Computed, or None where the scene cannot be made so; `within`: the error asked for, relative to each
    value; `budget` [s]; `ahead(levels, …)` may begin models that will be asked for. After `run()`: `models` from the coarsest to the
    finest, `nearer`, the coarsest nearer to rest, and `stuck`, whether the finest cannot be halved."""
    compute: object
    within: float
    budget: float
    rest: str = ""  # dimension of how near to rest the model comes, where there is one
    ahead: object = none_ahead
    models: list = field(default_factory=list)
    nearer: Computed = None
    stuck: bool = False

    def run(self, coarsest):
        """Whether the accuracy was reached, from the run of the coarsest model."""
        self.models = [coarsest]
        nearer = coarsest.levels | {self.rest: 1}
        if self.rest:
            self.ahead(nearer)
        if not self._refine():
            return False
        if self.rest:
            self.nearer = self.compute(nearer)
        while self.unfinished() and self._refine():
            pass
        return self.reached()

    @property
    def best(self):
        return self.models[-1]

    @property
    def runs(self):
        """All models, the finest last."""
        return [self.models[0], *([self.nearer] if self.nearer else []), *self.models[1:]]

    def unfinished(self):
        """Whether halving may still help a result that is not accurate enough."""
        return not self.stuck and any(self.lacking(question) and not self.scatters(question) for question in self.best.values)

    def reached(self):
        return not any(map(self.lacking, self.best.values))

    def refinement(self, question):
        """The Error that halved lengths would remove; infinite where there is but one model."""
        if len(self.models) == 1:
            return Error(float("inf"))
        values = [model.values[question] for model in self.models]
        error = error_of([finer - coarser for coarser, finer in zip(values, values[1:])])
        if len(self.models) > 2:
            return error
        return Error(max(error.size, OF_ONE * median_change(*self.models) * abs(values[-1])))

    def unrest(self, question):
        """The Error of not being at rest, as far as the coarsest model shows it; None where there are no statics."""
        coarsest = self.models[0].values[question]
        if not self.nearer or not coarsest:
            return None
        return Error(error_of([self.nearer.values[question] - coarsest]).size * abs(self.best.values[question] / coarsest))

    def value(self, question):
        """The middle of the interval of a result."""
        return self._middle_and_half(question)[0]

    def interval(self, question):
        """Half of the interval of a result."""
        return self._middle_and_half(question)[1]

    def _middle_and_half(self, question):
        """Of the finest model, and what the changes before it add; by all errors and the scatter. The interval of what cannot be negative
        ends at 0."""
        error, unrest = self.refinement(question), self.unrest(question)
        middle = self.best.values[question] + error.shift
        half = error.size + (unrest.size if unrest else 0.0) + self.best.spread(question)
        if question not in self.best.sizes or half <= middle or math.isinf(half):
            return middle, half
        return (middle + half) / 2, (middle + half) / 2

    def lacking(self, question):
        """Whether a result is not as accurate as is asked."""
        return self.interval(question) > self.within * abs(self.value(question))

    def scatters(self, question):
        """Whether a result scatters by more than is asked."""
        return self.best.spread(question) > self.within * abs(self.best.values[question])

    def next_seconds(self):
        """What a further halving would cost [s]."""
        before = self.models[-2].seconds if len(self.models) > 1 else 0.0
        return self.best.seconds + GROWS * max(self.best.seconds - before, 0.0)

    def _refine(self):
        """Halves all lengths, if the budget allows it and the scene can be made so; returns whether it was done."""
        if sum(run.seconds for run in self.runs) + self.next_seconds() > self.budget:
            return False
        finer = self.compute(finer_than(self.best.levels))
        self.stuck = finer is None
        if finer:
            self.models.append(finer)
        return not self.stuck


def finer_than(levels):
    return {name: level + 1 for name, level in levels.items()}


def median_change(coarser, finer):
    """Relative, of all figures of two models that do change; infinite where they are too few."""
    pairs = [(coarser.figures[key], value) for key, value in finer.figures.items() if key in coarser.figures]
    changes = [abs(after / before - 1) for before, after in pairs if before and after != before]
    return median(changes) if len(changes) >= FEW else float("inf")


def coarsest(compute, dimensions, lowest):
    """The Computed of the coarsest model that can be computed, from the level `lowest` of all dimensions up to the scene as stated; None
    where not even this can be."""
    return next((found for level in range(lowest, 1) if (found := compute(dict.fromkeys(dimensions, level)))), None)
