"""How fast waves travel over the grid: docs/continuum.md."""

from collections import defaultdict

from adit.plots import style

ZONES = {"assumed strain": style.BLUE, "mixed discretization": style.RED}


def largest(rows, **chosen):
    return max(abs(float(r["error"])) for r in rows if all(r[key] == value for key, value in chosen.items()))


def picture(rows):
    figure, (polar, curves) = style.plt.subplots(1, 2, figsize=(9, 3.6))
    for zone, colour in ZONES.items():
        for wave, line in (("P", "--"), ("S", "-")):
            points = sorted((int(r["angle"]), 100 * float(r["error"])) for r in rows if r["angle"] and (
                r["zone"], r["poisson"], r["zones"], r["wave"]) == (zone, "0.25", "12", wave))
            polar.plot(*zip(*points), line, color=colour, label=f"{wave}, {zone}")
        for wave, line in (("P", "--"), ("S", "-"), ("Rayleigh", ":")):
            worst = defaultdict(float)
            for r in rows:
                if (r["zone"], r["poisson"], r["wave"]) == (zone, "0.25", wave):
                    worst[int(r["zones"])] = max(worst[int(r["zones"])], 100 * abs(float(r["error"])))
            curves.loglog(worst.keys(), worst.values(), line, color=colour, zorder=3 if line == ":" else 2,
                          label=f"{wave}, {zone}")
    polar.set(xlabel="angle from the zones' sides [°]", ylabel="error of the speed [%]", title="12 zones a wavelength")
    curves.set(xlabel="zones a wavelength", ylabel="largest error of any direction [%]", title="ν = 0.25")
    curves.set_xticks([6, 8, 12, 16, 24, 40], ["6", "8", "12", "16", "24", "40"], minor=False)
    curves.minorticks_off()
    for axes in (polar, curves):
        axes.legend(fontsize=7)
    figure.tight_layout()
    return figure


def table(rows):
    yield "| zones a wavelength | default zone: S, P, Rayleigh [%] | FLAC zone: S, P, Rayleigh [%] | cost |"
    yield "|---|---|---|---|"
    for zones in sorted({int(r["zones"]) for r in rows}):
        cells = [", ".join(f"{100 * largest(rows, zone=zone, zones=str(zones), wave=wave):.2f}"
                           for wave in ("S", "P", "Rayleigh")) for zone in ZONES]
        yield f"| {zones} | {cells[0]} | {cells[1]} | {(zones / 10) ** 3:.2g} |"
