"""Names the answers that depend on a choice between models, which finer zones and particles do not remove.

Each choice is changed by one level in the coarsest model, which costs next to nothing; finer ones depend on it about as much.
"""
from dataclasses import dataclass, field

SHARE = 0.5  # of the accuracy asked for: smaller changes are not told
SMALL = 0.1  # part of a budget


def softens(part):
    """Whether a material in a part of a scene loses strength with strain."""
    each = part.items() if isinstance(part, dict) else enumerate(part) if isinstance(part, list) else ()
    return any(key == "softening" or softens(value) for key, value in each)


@dataclass
class Choices:
    """`runs`: computes models; `refining`, `choices`: the dimensions of the scene; `coarsest`: its first model; `localizes`: whether its
    ground softens. After `compute()`, `found` = [(question, choice, level, relative change)], `failed` = [(choice, why)],
    and `left` = [choice] that the budget left out."""
    runs: object
    refining: list
    choices: list
    coarsest: object
    within: float
    localizes: bool = False
    begun: bool = False
    found: list = field(default_factory=list)
    failed: list = field(default_factory=list)
    left: list = field(default_factory=list)

    def begin(self, budget):
        """Begins all of them beside the search, where they are a small part of a budget [s]."""
        self.begun = 2 * self.coarsest.seconds * len(self.choices) < SMALL * budget
        for choice, level in self._changes() if self.begun else ():
            self.runs.ahead([*self.refining, choice], self.coarsest.levels | {choice.name: level})

    def compute(self, budget):
        """Changes each choice that is begun, or costs no more than is left of a budget [s]."""
        for choice, level in self._changes():
            if not self.begun and 2 * self.coarsest.seconds > budget:
                self.left.append(choice)
                continue
            changed = self.runs.compute([*self.refining, choice], self.coarsest.levels | {choice.name: level})
            if changed is None:
                self.failed.append((choice, self.runs.failure))
                continue
            budget -= changed.seconds
            for question, value in changed.values.items():
                before = self.coarsest.values[question]
                scatter = changed.spread(question) + self.coarsest.spread(question)
                change = (value - before) / abs(before) if before else 0.0
                if abs(change) > SHARE * self.within and abs(value - before) > scatter:
                    self.found.append((question, choice, level, change))

    def _changes(self):
        """[(choice, the level that it is changed to)]"""
        levels = ((choice, next((level for level in (1, -1) if choice.settings(level) is not None), None)) for choice in self.choices)
        return [(choice, level) for choice, level in levels if level is not None]

    def named(self):
        """The answers that depend on a choice."""
        return list(dict.fromkeys(question for question, *_ in self.found))

    def beside(self, question):
        """What the choices change, to stand beside an interval."""
        changes = [(choice.name, change) for asked, choice, _, change in self.found if asked == question]
        return "".join(f", but {100 * change:+.2g} % by another {name}" for name, change in changes)

    def sentences(self):
        if self.localizes:
            yield "ground that softens fails in one row of zones: where it fails, results depend on the length of zones, and no refinement removes that"
        for question, choice, level, change in self.found:
            yield f"{question} depends on the {choice.name}: {choice.words(level)} changes it by {100 * change:+.2g} % in the coarsest model, and no refinement removes that"
        for choice, why in self.failed:
            yield f"the {choice.name} could not be changed: {why}"
        if self.left:
            yield f"the budget does not suffice to change the {', the '.join(choice.name for choice in self.left)}"
