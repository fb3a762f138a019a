"""Pictures of the study of waves through the overlap, from {case: (reflected, transmitted, lost)}."""
import math

import numpy as np
from matplotlib.patches import Circle

from adit.plots import style
from adit.plots.drawing import Colours, Drawing, Panels, legend
from adit.cases.wave_packet import Case
from adit.cases.wave_cases import LENGTHS, SOLVES
from adit.cases.wave_patch import radius
from adit.cases.wave_table import percent as text

COLORS = dict(zip(SOLVES, (style.BLUE, style.ORANGE, style.GREEN)))
PULSES = (5, 2)  # λ/h of the cylindrical pulses that are drawn
SPEEDS = Colours("speed over the largest of the row, common logarithm", -3, 0, "")
SMALLEST = 1e-3  # per cent; smaller shares are rounding errors, or the tail of the packet


def over_wavelength(shares):
    """Reflected and lost in the bar over λ/h: three solves, widths of the overlap as line styles."""
    def paint(*axes):
        for solve in SOLVES:
            for overlap, look in ((2, ":"), (5, "-"), (10, "--")):
                rows = [(length, shares[case]) for length in LENGTHS
                        if (case := Case("bar", solve, length, overlap_over_h=overlap)) in shares]
                for panel, index in zip(axes, (0, 2)):
                    panel.plot([row[0] for row in rows], [percent(row[1][index]) for row in rows], look, color=COLORS[solve],
                               marker="o" if overlap == 5 else "", ms=3, label=f"{solve}, overlap {overlap}h")
        for panel, title in zip(axes, ("reflected", "lost (the consistent solve loses nothing)")):
            panel.set(xscale="log", yscale="log", xlabel="wavelength over zone size, λ/h", ylim=(SMALLEST, 150))
            panel.set_xticks(LENGTHS, [f"{length:g}" for length in LENGTHS])
            panel.minorticks_off()
            panel.axvline(math.pi, color=style.GREY, lw=0.8)
            panel.text(math.pi * 1.05, 1.4 * SMALLEST, "the grid's cut-off, π", color=style.GREY, fontsize=8)
            panel.set_title(title, loc="left")
        axes[0].set_ylabel("% of the incident energy")
        return [legend(axes[1], fontsize=7.5, loc="lower left")]

    layout = Panels(1, 2, (9, 4), sharey=True, title_above=True)
    return Drawing("", "Reflected and lost in the bar over the wavelength", layout, paint)


def over_angle(shares):
    """Reflected and lost in the strip over the angle of incidence, λ = 5h."""
    def paint(*axes):
        for solve in SOLVES:
            angles = [angle for angle in range(0, 90, 15) if strip(solve, angle) in shares]
            for panel, index in zip(axes, (0, 2)):
                panel.plot(angles, [percent(shares[strip(solve, angle)][index]) for angle in angles], "o-", ms=3.5,
                           color=COLORS[solve], label=solve)
        for panel, title in zip(axes, ("reflected", "lost")):
            panel.set(yscale="log", xlabel="angle of incidence [°]", xticks=range(0, 75, 15), ylim=(0.01, 30))
            panel.set_title(f"{title}, P beam of λ = 5h", loc="left")
        axes[0].set_ylabel("% of the incident energy")
        return [legend(axes[0])]

    layout = Panels(1, 2, (8, 3.4), title_above=True)
    return Drawing("", "Reflected and lost in the strip over the angle of incidence", layout, paint)


def strip(solve, angle):
    return Case("strip", solve, 5, h_over_a=4, angle_deg=angle)


def pulses(shares, snapshots):
    """Speed of the motion when the pulse has left the patch; `snapshots(case)`: the pieces of the run's end."""
    rows = [[(case, snapshots(case)) for case in (Case("patch", solve, length, h_over_a=4) for solve in SOLVES)] for length in PULSES]
    largest = [max(speed(piece).max() for _, pieces in row for piece in bodies(pieces)) for row in rows]

    def paint(*axes):
        for panel, (case, pieces), top in zip(axes, (each for row in rows for each in row), np.repeat(largest, len(SOLVES))):
            reflected, _, lost = map(text, shares[case])
            image = draw_speed(panel, pieces, top)
            panel.set_title(f"{case.solve}, λ = {case.lambda_over_h}h: {reflected} % back, {lost} % lost", loc="left", fontsize=8)
            for r in (radius(case), radius(case) + case.overlap):
                panel.add_patch(Circle((0, 0), r, fc="none", ec=style.BLACK, lw=0.6))
        axes[0].figure.colorbar(image, ax=axes, label=SPEEDS.what, shrink=0.6)

    layout = Panels(len(PULSES), len(SOLVES), (9, 6.2), title_above=True)
    return Drawing("", "Speed of the motion when the pulse has left the patch", layout, paint, colours=(SPEEDS,))


def bodies(pieces):
    return pieces["grid"], pieces["particles"]


def speed(piece):
    return np.hypot(*piece.field("velocity_m_per_s")[:, :2].T)


def draw_speed(panel, pieces, largest):
    for piece, size in zip(bodies(pieces), (1.5, 0.15)):  # grid points stand for more of the area
        level = np.log10(np.maximum(speed(piece) / largest, 1e-3))
        image = panel.scatter(*piece.points.T, c=level, s=size, marker="s", lw=0, cmap="magma_r", vmin=SPEEDS.low,
                              vmax=SPEEDS.high, rasterized=True)
    panel.set(aspect="equal", xticks=[], yticks=[])
    return image


def percent(share):
    return 100 * max(share, 0)
