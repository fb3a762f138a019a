"""Groups of particles, such as a lining, told apart from the ground around them by their tone."""
import numpy as np

from adit.plots import style

TONES = ("#CDBFE8", "#B9DFB2", "#F3BDB9")  # of the groups, in turn; the ground outside all groups has none
NAMED = 4  # groups of one tone


def draw(axes, models, shapes, **look):
    """Draws the particles of groups, of these Shapes; returns the handles of the legend. `models`: the parts of the scene."""
    number = shapes.discs.field("group")
    if number is None:
        return []
    there, handles = shapes.there & (number > 0), []
    for k, tone in enumerate(TONES):
        chosen = there & ((number - 1) % len(TONES) == k)
        if chosen.any():
            shapes.add(axes, chosen, fc=tone, **look)
            names = _names(models, np.unique(number[chosen]).astype(int))
            handles.append(shapes.handle(style.literal(f"particles: {names}"), fc=tone, ec=look["ec"], alpha=look.get("alpha")))
    return handles


def _names(models, numbers):
    """The names of the groups of these numbers in all models."""
    found = [group["name"] for model in models for k, group in enumerate(model.get("groups", []), 1) if k in numbers]
    found = list(dict.fromkeys(found)) or ["lining"]  # that of a ring stands in no list
    return ", ".join(found[:NAMED]) + (", …" if len(found) > NAMED else "")
