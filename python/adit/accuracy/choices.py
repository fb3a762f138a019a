"""Names the answers that depend on a choice between models, which finer zones and particles do not remove.

Each choice is changed by one level in the coarsest model, which costs next to nothing; finer ones depend on it about as much.
"""
from dataclasses import dataclass, field

SHARE = 0.5  # of the accuracy asked for: smaller changes are not told


def softens(part):
    """Whether a material in a part of a scene loses strength with strain."""
    each = part.items() if isinstance(part, dict) else enumerate(part) if isinstance(part, list) else ()
    return any(key == "softening" or softens(value) for key, value in each)


@dataclass
class Choices:
    """`runs`: computes models; `refining`, `choices`: the dimensions of the scene; `coarsest`: its first model; `localizes`: whether its
    ground softens. After `compute()`, `found` = [(question, choice, level, relative change)]."""
    runs: object
    refining: list
    choices: list
    coarsest: object
    within: float
    localizes: bool = False
    found: list = field(default_factory=list)

    def compute(self, budget):
        """Changes each choice that costs no more than is left of a budget [s]."""
        for choice in self.choices:
            level = next((level for level in (1, -1) if choice.settings(level) is not None), None)
            if level is None or 2 * self.coarsest.seconds > budget:
                continue
            changed = self.runs.compute([*self.refining, choice], self.coarsest.levels | {choice.name: level})
            if changed is None:
                continue
            budget -= changed.seconds
            for question, value in changed.values.items():
                before = self.coarsest.values[question]
                scatter = changed.spread(question) + self.coarsest.spread(question)
                change = (value - before) / abs(before) if before else 0.0
                if abs(change) > SHARE * self.within and abs(value - before) > scatter:
                    self.found.append((question, choice, level, change))

    def sentences(self):
        if self.localizes:
            yield "ground that softens fails in one row of zones: where it fails, results depend on the length of zones, and no refinement removes that"
        for question, choice, level, change in self.found:
            yield f"{question} depends on the {choice.name}: {choice.words(level)} changes it by {100 * change:+.2g} % in the coarsest model, and no refinement removes that"
