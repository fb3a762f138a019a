"""Sets of zones of a grid, as flags (n,), and the loops of points around them."""
import numpy as np

STRAIGHT = 1e-9  # sine of the turn at a corner that is none
NEAR = 1e-9  # of a zone's area, by which a place on its side may lie outside


class Zones:
    """The zones of a grid piece: what touches what."""

    def __init__(self, grid):
        self.points, self.cells = grid.points, grid.cells
        corners = self.points[self.cells]
        self.centres = corners.mean(axis=1)
        ends = np.roll(corners, -1, axis=1)
        lengths = np.hypot(*(ends - corners).transpose(2, 0, 1))
        self.shortest, self.longest = lengths.min(axis=1), lengths.max(axis=1)  # side of each [m]
        self.areas = _cross(corners, ends).sum(axis=1) / 2  # [m^2]
        sides = np.sort(np.stack([self.cells, np.roll(self.cells, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
        _, numbers = np.unique(sides, axis=0, return_inverse=True)
        self.sides = numbers.reshape(-1, 4)  # of each zone

    def at(self, points):
        """The zones with any of these points, given by flags."""
        return points[self.cells].any(axis=1)

    def holding(self, place):
        """The zones within or on whose sides a place (2,) lies."""
        corners = self.points[self.cells]
        return (_cross(np.roll(corners, -1, axis=1) - corners, place - corners) >= -NEAR * self.areas[:, None]).all(axis=1)

    def grown(self, chosen, layers=1):
        """With so many layers of zones around."""
        for _ in range(layers):
            chosen = _sharing(self.cells, chosen)
        return chosen

    def pieces(self, chosen, by_side=True):
        """[flags] of the parts that hang together by sides, or by points."""
        links, left, found = self.sides if by_side else self.cells, chosen.copy(), []
        while left.any():
            piece, before = np.arange(len(left)) == left.argmax(), -1
            while (reached := piece.sum()) != before:
                piece, before = _sharing(links, piece) & left, reached
            found.append(piece)
            left &= ~piece
        return found

    def closed(self, chosen, allowed):
        """With the allowed zones without which its outline would meet itself in a point, and with those that it surrounds."""
        while True:
            before = chosen
            for point in self._pinched(chosen):
                chosen = chosen | ((self.cells == point).any(axis=1) & allowed)
            for loop in loops(self, chosen):
                if not loop.outer:
                    chosen = chosen | (allowed & inside(loop.points, self.centres))
            if (chosen == before).all():
                return chosen

    def _pinched(self, chosen):
        """Points at which more than one path of the outline begins."""
        begins = _outline(self, chosen)[:, 0]
        points, count = np.unique(begins, return_counts=True)
        return points[count > 1]


def _cross(a, b):
    return a[..., 0] * b[..., 1] - a[..., 1] * b[..., 0]


def _sharing(links, chosen):
    """The zones that have a link with a chosen one, which are among them."""
    linked = np.zeros(links.max() + 1, bool)
    linked[links[chosen]] = True
    return linked[links].any(axis=1)


def _outline(zones, chosen):
    """The sides of one chosen zone only, as pairs of points, with the zone on their left."""
    cells = zones.cells[chosen]
    sides = np.concatenate([cells[:, [k, (k + 1) % 4]] for k in range(4)])
    _, first, count = np.unique(np.sort(sides, axis=1), axis=0, return_index=True, return_counts=True)
    return sides[first[count == 1]]


class Loop:
    """Corners (n, 2) of a closed outline; `outer`: what it surrounds is chosen, else it is a hole."""

    def __init__(self, points):
        self.points = points
        self.area = _cross(points, np.roll(points, -1, axis=0)).sum() / 2
        self.outer = self.area > 0


def loops(zones, chosen):
    """The Loops around the chosen zones, the largest first. Where two meet in a point each goes its own way."""
    following = {}
    for begin, end in _outline(zones, chosen):
        following.setdefault(begin, []).append(end)
    found = []
    while following:
        begin = next(iter(following))
        path = [begin]
        while True:
            here = path[-1]
            ends = following[here]
            end = ends[0] if len(ends) == 1 or len(path) < 2 else max(ends, key=lambda end: _turn(zones.points, path[-2], here, end))
            ends.remove(end)
            if not ends:
                del following[here]
            if end == begin:
                break
            path.append(end)
        found.append(Loop(_corners(zones.points[path])))
    return sorted(found, key=lambda loop: -abs(loop.area))


def inside(corners, points):
    """Whether each point lies within the polygon."""
    (x, y), (x_next, y_next) = corners.T[:, :, None], np.roll(corners, -1, axis=0).T[:, :, None]
    px, py = points.T
    crosses = (y > py) != (y_next > py)
    with np.errstate(divide="ignore", invalid="ignore"):
        right = x + (py - y) / (y_next - y) * (x_next - x) > px
    return (crosses & right).sum(axis=0) % 2 == 1


def hull(points):
    """Corners of the convex hull, counter-clockwise."""
    ordered = points[np.lexsort(points.T[::-1])]

    def half(sequence):
        chain = []
        for point in sequence:
            while len(chain) > 1 and _cross(chain[-1] - chain[-2], point - chain[-1]) <= 0:
                chain.pop()
            chain.append(point)
        return chain[:-1]

    return np.array(half(ordered) + half(ordered[::-1]))


def distances(points, loop):
    """The distance [m] of each point from an outline."""
    begin, along = loop.points, np.roll(loop.points, -1, axis=0) - loop.points
    offset = points[:, None] - begin
    share = np.clip((offset * along).sum(axis=2) / (along**2).sum(axis=1), 0, 1)
    return np.hypot(*(offset - share[..., None] * along).transpose(2, 0, 1)).min(axis=1)


def _turn(points, before, here, after):
    """The angle to the left [rad]."""
    a, b = points[here] - points[before], points[after] - points[here]
    return np.arctan2(_cross(a, b), a @ b)


def _corners(points):
    a, b = points - np.roll(points, 1, axis=0), np.roll(points, -1, axis=0) - points
    sine = np.abs(_cross(a, b)) / np.hypot(*a.T) / np.hypot(*b.T)
    return points[sine > STRAIGHT]
