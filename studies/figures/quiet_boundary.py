"""Share of plane waves that quiet boundaries reflect, over the angle (takes a minute): docs/boundaries.md."""

from adit.plots import style

DATA = "quiet_boundary.csv"  # kept beside the text
WAVES = {"P": style.BLUE, "SV": style.RED}


def picture(rows):
    figure, axes = style.plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for wave, colour in WAVES.items():
        mine = [row for row in rows if row["wave"] == wave]
        angles = [int(row["angle_deg"]) for row in mine]
        axes.plot(angles, [100 * float(row["theory"]) for row in mine], color=colour, label=f"{wave}, theory of the dashpots")
        for zone, marker in (("assumed_strain", "o"), ("mixed_discretization", "x")):
            axes.plot(angles, [100 * float(row[zone]) for row in mine], marker, color=colour, ms=4, mfc="none",
                      label=f"{wave}, {zone.replace('_', ' ')}")
    axes.axhline(1, color=style.GREY, lw=0.7, ls="--")
    axes.set_yscale("symlog", linthresh=1, linscale=0.8)
    axes.set_yticks([0, 0.5, 1, 2, 5, 10, 20, 50, 100], ["0", "0.5", "1", "2", "5", "10", "20", "50", "100"])
    axes.minorticks_off()
    axes.set(xlabel="angle from the boundary’s normal [°]", ylabel="energy sent back [%]", xlim=(-1, 81), ylim=(-0.05, 100))
    axes.set_title("Quiet boundary, ν = 0.25", loc="left")
    axes.legend(fontsize=7.5)
    axes.grid(lw=0.3, color="#DDDDDD")
    return figure


def table(rows):
    yield "| angle | P: theory, grid [%] | SV: theory, grid [%] |"
    yield "|---|---|---|"
    for angle in sorted({int(row["angle_deg"]) for row in rows}):
        here = {row["wave"]: row for row in rows if int(row["angle_deg"]) == angle}
        cells = (f"{100 * float(here[wave]['theory']):.2f}, {100 * float(here[wave]['assumed_strain']):.2f}" for wave in WAVES)
        yield f"| {angle}° | {' | '.join(cells)} |"
