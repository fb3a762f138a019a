"""The curves of a picture: the table of their extremes, and at most as many points as the picture can show."""
import numpy as np

from adit.report.legends import plain
from adit.report.markup import details, table
from adit.report.quantities import digits
from adit.results.rounding import settled

FEWEST = 3  # points of a curve; lines of fewer are marks
BINS = 700  # across a picture: about the dots of a phone


def as_table(figure, title):
    """A collapsed table with a row for each named curve; None if the figure has none."""
    last = next((axes.get_xlabel() for axes in reversed(figure.axes) if axes.get_xlabel()), "")
    rows = [row for axes in figure.axes for row in _rows(axes, last)]
    if not rows:
        return None
    return details("This picture as a table", table(
        f"{title}: extremes of the curves", ("curve", "quantity", "least", "at", "greatest", "at"), rows))


def _rows(axes, last):
    place = axes.get_xlabel() or last
    widest, highest = (_largest([line.get_data()[axis] for line in axes.get_lines()]) for axis in (0, 1))
    for line in axes.get_lines():
        label = line.get_label()
        x, y = (np.asarray(values, float) for values in line.get_data())
        if label.startswith("_") or len(y) < FEWEST or not np.isfinite(y).any():
            continue
        low, high = np.nanargmin(y), np.nanargmax(y)
        ends = [(digits(settled(y[k], highest)), f"{_name(place)} {digits(settled(x[k], widest))} {_unit(place)}") for k in (low, high)]
        yield (plain(label), plain(axes.get_ylabel()), *ends[0], *ends[1])


def _largest(several):
    """The largest magnitude of the values of several curves."""
    finite = [np.abs(values[np.isfinite(values)]) for values in (np.asarray(each, float) for each in several)]
    return max((np.max(values, initial=0) for values in finite), default=0)


def _name(label):
    name = label.partition("[")[0].strip()
    return f"{name} =" if name else ""


def _unit(label):
    return label.partition("[")[2].rstrip("]")


def thin(figure):
    """Keeps of every long curve the first, the lowest and the highest point in each of BINS parts of its width."""
    for axes in figure.axes:
        for line in axes.get_lines():
            x, y = (np.asarray(values, float) for values in line.get_data())
            if len(x) > 3 * BINS and np.all(np.diff(x) >= 0):  # not what is drawn with gaps
                kept = _telling(axes.transScale.transform(np.column_stack([x, np.ones_like(y)]))[:, 0], y)
                line.set_data(x[kept], y[kept])


def _telling(x, y):
    """Indices of the points to keep, in their order. `x` is where they stand across the picture."""
    inside = np.flatnonzero(np.isfinite(x) & np.isfinite(y))  # a logarithmic axis has no place for 0
    x, y = x[inside], y[inside]
    part = ((x - x[0]) / max(x[-1] - x[0], 1e-300) * (BINS - 1)).astype(int)
    kept = []
    for order in (np.arange(len(x)), np.lexsort((y, part)), np.lexsort((-y, part))):
        first = np.flatnonzero(np.diff(part[order], prepend=-1))  # of each part
        kept.append(order[first])
    return inside[np.unique(np.concatenate([*kept, [len(x) - 1]]))]
