"""Refines of a scene only what its error comes from, until the results are as accurate as is asked.

The errors of the dimensions add up, each from values that differ in this dimension alone. The scene as stated is computed first, then
with each dimension coarser, twice, which costs little; where that cannot be, finer. Two changes are the least that tell an order: one
alone can be small by chance. As long as a result is not accurate enough, the dimension with the largest error of the worst result is
halved.
"""
from dataclasses import dataclass, field

from adit.accuracy.estimate import error_of

ENOUGH = 2  # changes
GROWS = 8  # what halved lengths add to the cost, over what the last ones added: in the plane and in time


@dataclass
class Computed:
    """One run: its levels, {question: value}, and what it cost [s]."""
    levels: dict
    values: dict
    seconds: float


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
    next_seconds: float = 0.0  # what the step that was left out would cost; 0: it cannot be computed

    def run(self, stated):
        """Whether the accuracy was reached, from the run of the scene as stated."""
        self.runs, self.best = [stated], stated
        for dimension in self.dimensions:
            coarse = self._computed(self.best.levels | {dimension: -1})
            coarsest = coarse and self._computed(self.best.levels | {dimension: -2})
            found = [coarsest, coarse, self.best]
            self.pairs[dimension] = [pair for pair in zip(found, found[1:]) if None not in pair]
        while (dimension := self.next()) is not None:
            if not self._refine(dimension):
                return False
        return True

    def next(self):
        """The dimension to halve: one of which too little is known, or the worst; None where the accuracy is reached."""
        unknown = [dimension for dimension, pairs in self.pairs.items() if len(pairs) < ENOUGH]
        return unknown[0] if unknown else None if self.reached() else self.worst()

    @property
    def errors(self):
        def changes(question, pairs):
            return [finer.values[question] - coarser.values[question] for coarser, finer in pairs]

        return {question: {name: error_of(changes(question, pairs)) for name, pairs in self.pairs.items() if pairs}
                for question in self.best.values}

    def interval(self, question):
        """The error of a result, by all dimensions."""
        return sum(error.size for error in self.errors[question].values())

    def reached(self):
        return all(self.interval(question) <= self.within * abs(value) for question, value in self.best.values.items())

    def worst(self):
        """The dimension with the largest error of the result that is the farthest from the accuracy asked for."""
        def lacking(question):
            value = abs(self.best.values[question])
            return self.interval(question) / value if value else float(self.interval(question) > 0)

        errors = self.errors[max(self.best.values, key=lacking)]
        return max(errors, key=lambda name: errors[name].size)

    def _refine(self, dimension):
        """Whether it could be halved within the budget."""
        pairs = self.pairs[dimension]
        added = pairs[-1][1].seconds - pairs[-1][0].seconds if pairs else self.best.seconds
        self.next_seconds = self.best.seconds + GROWS * max(added, 0)
        if sum(run.seconds for run in self.runs) + self.next_seconds > self.budget:
            return False
        finer = self._computed(self.best.levels | {dimension: self.best.levels[dimension] + 1})
        if finer is None:
            self.next_seconds = 0.0
            return False
        pairs.append((self.best, finer))
        self.best = finer
        return True

    def _computed(self, levels):
        run = self.compute(levels)
        if run is not None:
            self.runs.append(run)
        return run
