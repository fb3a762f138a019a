"""Names beside points of a picture, placed so that they do not lie on each other."""
import numpy as np
from matplotlib.transforms import Bbox

from adit.plots import style

SIZE = 7.5  # points
STEPS = 12  # places tried farther and farther away


def add_labels(axes, places, names):
    """Writes each name near its place, with a thin line to it where it had to move. Names without room are left out."""
    axes.apply_aspect()
    frame = axes.get_window_extent()
    dots = axes.transData.transform(np.asarray(places, float).reshape(-1, 2))
    taken = [Bbox.from_bounds(x - 4, y - 4, 8, 8) for x, y in dots]
    for (x, y), name in zip(dots, names):
        text = axes.text(0, 0, name, size=SIZE, zorder=9, ha="left", va="center", transform=None,
                         bbox={"fc": "white", "ec": "none", "alpha": 0.75, "pad": 0.6})
        width, height = text.get_window_extent().size
        for box in _candidates(x, y, width, height):
            if frame.contains(box.x0, box.y0) and frame.contains(box.x1, box.y1) and not box.count_overlaps(taken):
                taken.append(box)
                text.set_transform(axes.transData)
                text.set_position(axes.transData.inverted().transform((box.x0, (box.y0 + box.y1) / 2)))
                _lead(axes, (x, y), box)
                break
        else:
            text.remove()


def _candidates(x, y, width, height):
    for step in range(STEPS):
        reach = 7 + 9 * step
        for angle in np.radians((0, 180, 90, 270, 45, 135, 225, 315, 22, 158, 202, 338)):
            along, up = np.cos(angle), np.sin(angle)
            middle = x + reach * along + np.sign(round(along, 6)) * width / 2, y + reach * up
            yield Bbox.from_bounds(middle[0] - width / 2, middle[1] - height / 2, width, height)


def _lead(axes, dot, box):
    """A line from the dot to the nearest point of a label that is far from it."""
    nearest = np.clip(dot, box.min, box.max)
    if np.hypot(*(nearest - dot)) > 12:
        axes.plot(*axes.transData.inverted().transform([dot, nearest]).T, color=style.BLACK, lw=0.4, zorder=8)
