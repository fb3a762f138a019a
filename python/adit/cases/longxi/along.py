"""The lining of cases/longxi along the tunnel: broken bonds, forces and accelerations by distance from the fault."""
import numpy as np

from adit.plots import style

STRETCH = 4.0  # of the tunnel, over which bonds are counted [m]
DIAMETER = 12.0  # of the tube [m]
INTACT = 0


class Lining:
    """The walls of a run of along.yaml, along_offset.yaml or their variants."""

    def __init__(self, run):
        self.run, self.name = run, run.name
        (_, self.first), *_, (_, self.last) = run.snapshots()
        groups = run.scene["particles"]["groups"]
        walls = [number for number, group in enumerate(groups, 1) if group["name"] in ("crown", "invert")]
        self._in_walls = np.isin(self.last["particles"].field("group"), walls)
        band = next(group["where"]["band"] for group in groups if group["name"] == "gouge")
        rise, advance = (band["to"][axis] - band["from"][axis] for axis in "yx")
        self._slope = advance / rise

    def distance(self, points):
        """From the fault along the tunnel [m], positive to the right; the fault passes through (0, 0)."""
        return points[:, 0] - self._slope * points[:, 1]

    def bonds(self):
        """(distance [m], broken or not) of each bond within the walls, at the end."""
        bonds = self.last["bonds"]
        cells = bonds.cells[self._in_walls[bonds.cells].all(axis=1)]
        broken = bonds.field("state")[self._in_walls[bonds.cells].all(axis=1)] != INTACT
        return self.distance(bonds.points[cells].mean(axis=1)), broken

    def damage(self):
        """(middles of stretches [m], share of the bonds of each that are broken)."""
        distance, broken = self.bonds()
        edges = np.arange(-48, 48 + STRETCH, STRETCH)
        counts, lost = (np.histogram(d, edges)[0] for d in (distance, distance[broken]))
        return (edges[1:] + edges[:-1]) / 2, lost / counts

    def farthest_crack(self):
        """Distance of the farthest broken bond from the fault [m]; 0 without any."""
        distance, broken = self.bonds()
        return np.abs(distance[broken]).max(initial=0)

    def thrust(self):
        """(|distance| [m], largest change of thrust since time began [N per metre]) of the sections, in their order."""
        start, end = self.first["sections"], self.last["sections"]
        before = start.field("thrust_N")
        change = np.maximum(end.field("largest_thrust_N") - before, before - end.field("smallest_thrust_N"))
        return np.abs(self.distance(end.points)), change

    def acceleration(self):
        """The largest acceleration [m/s^2], the mean from row to row, at each place of the crown that has histories."""
        h = self.run.histories
        places = sorted(name[: -len("_vx_m_per_s")] for name in h if name.startswith("crown") and name.endswith("_vx_m_per_s"))
        change = [np.hypot(*(np.diff(h[f"{place}_v{axis}_m_per_s"]) for axis in "xy")) for place in places]
        return np.max(change / np.diff(h["time_s"]), axis=1)


def mean_within(values, low, high):
    """The mean of the values between two distances, in (distance, value)."""
    distance, value = values
    return value[(low <= distance) & (distance <= high)].mean()


def table(linings):
    """Lines of text: a row of each run."""
    yield (f"{'':28}{'broken':>8}{'farthest':>10}{'within 12 m':>13}{'thrust [MN/m], 9 m':>20}{'24 m away':>11}"
           f"{'crown [m/s²]':>14}")
    for lining in linings:
        distance, broken = lining.bonds()
        near = np.abs(distance) <= DIAMETER
        yield (f"{lining.name:28}{broken.sum():8}{lining.farthest_crack():8.1f} m{100 * broken[near].mean():11.1f} %"
               f"{mean_within(lining.thrust(), 7, 11) / 1e6:20.2f}{mean_within(lining.thrust(), 20, 28) / 1e6:11.2f}"
               f"{lining.acceleration().max():14.1f}")


def picture(linings):
    """Cracks of the walls over the distance from the fault, one curve a run."""
    figure, axes = style.plt.subplots(figsize=(8.0, 3.8), layout="constrained")
    for lining, color in zip(linings, (style.BLUE, style.RED, style.GREEN, style.ORANGE, style.SKY, style.PINK)):
        distance, share = lining.damage()
        axes.step(distance, 100 * share, where="mid", color=color, label=lining.name)
    for diameters in (-4, -2, 2, 4):
        axes.axvline(diameters * DIAMETER, color=style.GREY, lw=0.6, ls=":")
    axes.set(xlabel="distance from the fault along the tunnel [m]; dotted: 2 and 4 diameters",
             ylabel="broken bonds of the lining [%]", xlim=(-50, 50), ylim=(0, None))
    axes.legend(loc="upper right")
    return figure
