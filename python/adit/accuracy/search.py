"""Refines of a scene only what its error comes from, until the results are as accurate as is asked.

The errors of the dimensions add up, each from values that differ in this dimension alone, and the scatter of what has no order. The
coarsest model comes first, because it costs next to nothing: each halving costs about eight times as much as the one before. Every
dimension is halved twice: two changes are the least that tell an order, and one alone can be small by chance. As long as a result is
not accurate enough, the dimension with the largest error of the worst result is halved. A result that scatters by more than is asked
is left alone.

Where statics bring the model to rest, the coarsest model is also computed nearer to it: no answer is told more accurately than that.
"""
from dataclasses import dataclass, field

from adit.accuracy.estimate import Error, error_of
from adit.accuracy.runs import Computed

ENOUGH = 2  # changes
GROWS = 8  # what halved lengths add to the cost, over what the last ones added: in the plane and in time


@dataclass
class Search:
    """`compute(levels)` returns a Computed, or None where the scene cannot be made so; `within`: the error asked for, relative to each
    value; `budget` [s]. After `run()`: `runs` in their order, `best`, the finest, and `errors` = {question: {dimension: Error}}."""
    compute: object
    dimensions: list
    within: float
    budget: float
    runs: list = field(default_factory=list)
    best: Computed = None
    pairs: dict = field(default_factory=dict)  # of each dimension: [(coarser, finer)] that differ in it alone, as it is halved
    stuck: set = field(default_factory=set)  # dimensions that cannot be halved as long as the others are as they are
    rest: str = ""  # dimension of how near to rest the model comes, where there is one
    unrest: dict = field(default_factory=dict)  # {question: relative error of the coarsest model by that}
    next_seconds: float = 0.0  # what the last halving was expected to cost

    def run(self, coarsest):
        """Whether the accuracy was reached, from the run of the coarsest model."""
        self.runs, self.best = [coarsest], coarsest
        self.pairs = {dimension: [] for dimension in self.dimensions}
        nearer = self.rest and self._computed(coarsest.levels | {self.rest: 1})
        if nearer:
            self.unrest = {question: error_of([nearer.values[question] - value]).size / abs(value) for question, value in coarsest.values.items() if value}
        while (dimension := self.next()) is not None:
            if not self._refine(dimension):
                return False
        return self.reached()

    def next(self):
        """The dimension to halve: the one of which least is known, or the worst; None where nothing is left to refine. A dimension that
        could not be halved waits until another one is: zones must not be finer than the particles that they follow."""
        unknown = [dimension for dimension, pairs in self.pairs.items() if len(pairs) < ENOUGH]
        wanted = [min(unknown, key=lambda name: len(self.pairs[name]))] if unknown else [self.worst()] if self.worst() else []
        free = [dimension for dimension in self.dimensions if dimension not in self.stuck]
        return next((name for name in [*wanted, *free] if wanted and name in free), None)

    @property
    def errors(self):
        def changes(question, pairs):
            return [finer.values[question] - coarser.values[question] for coarser, finer in pairs]

        return {question: {name: error_of(changes(question, pairs)) for name, pairs in self.pairs.items() if pairs}
                | ({self.rest: Error(self.unrest[question] * abs(value))} if question in self.unrest else {})
                for question, value in self.best.values.items()}

    def value(self, question):
        """The middle of the interval: that of the finest model, and what the changes before it add."""
        return self.best.values[question] + sum(error.shift for error in self.errors[question].values())

    def interval(self, question):
        """Half of the interval of a result, by all dimensions and its scatter."""
        return sum(error.size for error in self.errors[question].values()) + self.best.spread(question)

    def lacking(self, question):
        """Whether a result is not as accurate as is asked."""
        return self.interval(question) > self.within * abs(self.value(question))

    def scatters(self, question):
        """Whether a result scatters by more than is asked."""
        return self.best.spread(question) > self.within * abs(self.best.values[question])

    def reached(self):
        return all(len(pairs) >= ENOUGH for pairs in self.pairs.values()) and not any(map(self.lacking, self.best.values))

    def worst(self):
        """The dimension with the largest error of the result that is the farthest from the accuracy asked for; None where all others
        than those that scatter are as accurate."""
        def error(question):
            value = abs(self.value(question))
            return self.interval(question) / value if value else float(self.interval(question) > 0)

        open_ones = [question for question in self.best.values if self.lacking(question) and not self.scatters(question)]
        if not open_ones:
            return None
        errors = self.errors[max(open_ones, key=error)]
        return max((name for name in self.pairs if name in errors), key=lambda name: errors[name].size, default=self.dimensions[0])

    def seconds_of(self, dimension):
        """What halving a dimension would cost [s]."""
        pairs = self.pairs[dimension]
        added = pairs[-1][1].seconds - pairs[-1][0].seconds if pairs else self.best.seconds
        return self.best.seconds + GROWS * max(added, 0)

    def _refine(self, dimension):
        """Halves it, where that can be; returns whether the budget allows it."""
        pairs = self.pairs[dimension]
        self.next_seconds = self.seconds_of(dimension)
        if sum(run.seconds for run in self.runs) + self.next_seconds > self.budget:
            return False
        finer = self._computed(self.best.levels | {dimension: self.best.levels[dimension] + 1})
        if finer is None:
            self.stuck.add(dimension)
        else:
            self.stuck.clear()
            pairs.append((self.best, finer))
            self.best = finer
        return True

    def _computed(self, levels):
        run = self.compute(levels)
        if run is not None:
            self.runs.append(run)
        return run


def coarsest(compute, dimensions, lowest):
    """The Computed of the coarsest model that can be computed, from the level `lowest` of all dimensions up to the scene as stated; None
    where not even this can be."""
    return next((found for level in range(lowest, 1) if (found := compute(dict.fromkeys(dimensions, level)))), None)
