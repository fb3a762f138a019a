"""Pictures of the study of waves through the overlap, from {case: (reflected, transmitted, lost)}."""
import math

import numpy as np
from matplotlib.patches import Circle

from adit.plots import style
from adit.cases.wave_packet import Case
from adit.cases.wave_cases import LENGTHS, SOLVES
from adit.cases.wave_patch import radius
from adit.cases.wave_table import percent as text

COLORS = dict(zip(SOLVES, (style.BLUE, style.ORANGE, style.GREEN)))
PULSES = (5, 2)  # λ/h of the cylindrical pulses that are drawn
SMALLEST = 1e-3  # per cent; smaller shares are rounding errors, or the tail of the packet


def over_wavelength(shares):
    """Reflected and lost in the bar over λ/h: three solves, widths of the overlap as line styles."""
    figure, axes = style.plt.subplots(1, 2, figsize=(9, 4), sharey=True, layout="constrained")
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
    figure.suptitle("Reflected and lost in the bar over the wavelength", x=0.01, ha="left")
    axes[0].set_ylabel("% of the incident energy")
    axes[1].legend(fontsize=7.5, loc="lower left")
    return figure


def over_angle(shares):
    """Reflected and lost in the strip over the angle of incidence, λ = 5h."""
    figure, axes = style.plt.subplots(1, 2, figsize=(8, 3.4), layout="constrained")
    for solve in SOLVES:
        angles = [angle for angle in range(0, 90, 15) if strip(solve, angle) in shares]
        for panel, index in zip(axes, (0, 2)):
            panel.plot(angles, [percent(shares[strip(solve, angle)][index]) for angle in angles], "o-", ms=3.5,
                       color=COLORS[solve], label=solve)
    for panel, title in zip(axes, ("reflected", "lost")):
        panel.set(yscale="log", xlabel="angle of incidence [°]", xticks=range(0, 75, 15), ylim=(0.01, 30))
        panel.set_title(f"{title}, P beam of λ = 5h", loc="left")
    figure.suptitle("Reflected and lost in the strip over the angle of incidence", x=0.01, ha="left")
    axes[0].set_ylabel("% of the incident energy")
    axes[0].legend()
    return figure


def strip(solve, angle):
    return Case("strip", solve, 5, h_over_a=4, angle_deg=angle)


def pulses(shares, snapshots):
    """Speed of the motion when the pulse has left the patch; `snapshots(case)`: the pieces of the run's end."""
    figure, axes = style.plt.subplots(len(PULSES), len(SOLVES), figsize=(9, 6.2), layout="constrained")
    for line, length in zip(axes, PULSES):
        cases = [Case("patch", solve, length, h_over_a=4) for solve in SOLVES]
        ends = [snapshots(case) for case in cases]
        largest = max(speed(piece).max() for pieces in ends for piece in bodies(pieces))
        for panel, case, pieces in zip(line, cases, ends):
            reflected, _, lost = map(text, shares[case])
            image = draw_speed(panel, pieces, largest)
            panel.set_title(f"{case.solve}, λ = {length}h: {reflected} % back, {lost} % lost", loc="left", fontsize=8)
            for r in (radius(case), radius(case) + case.overlap):
                panel.add_patch(Circle((0, 0), r, fc="none", ec=style.BLACK, lw=0.6))
    figure.suptitle("Speed of the motion when the pulse has left the patch", x=0.01, ha="left")
    figure.colorbar(image, ax=axes, label="speed over the largest of the row, common logarithm", shrink=0.6)
    return figure


def bodies(pieces):
    return pieces["grid"], pieces["particles"]


def speed(piece):
    return np.hypot(*piece.field("velocity_m_per_s")[:, :2].T)


def draw_speed(panel, pieces, largest):
    for piece, size in zip(bodies(pieces), (1.5, 0.15)):  # grid points stand for more of the area
        level = np.log10(np.maximum(speed(piece) / largest, 1e-3))
        image = panel.scatter(*piece.points.T, c=level, s=size, marker="s", lw=0, cmap="magma_r", vmin=-3, vmax=0,
                              rasterized=True)
    panel.set(aspect="equal", xticks=[], yticks=[])
    return image


def percent(share):
    return 100 * max(share, 0)
