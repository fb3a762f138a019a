"""Modulus reduction and damping of the hysteretic law: docs/materials.md."""

from adit.plots import style

COLOURS = (style.BLUE, style.RED, style.GREEN, style.ORANGE)


def by_curve(rows):
    curves = {}
    for row in rows:
        curves.setdefault(row["curve"], []).append({key: float(value) for key, value in row.items() if key != "curve"})
    return curves


def picture(rows):
    figure, (modulus, damping) = style.plt.subplots(1, 2, figsize=(9, 3.4))
    for (name, curve), colour in zip(by_curve(rows).items(), COLOURS):
        strain = [100 * row["strain"] for row in curve]
        for axes, key, factor in ((modulus, "ratio", 1), (damping, "damping", 100)):
            axes.semilogx(strain, [factor * row[key] for row in curve], color=colour, label=name)
            axes.semilogx(strain[::6], [factor * row[f"law_{key}"] for row in curve[::6]], "o", ms=3.5, mfc="none", color=colour)
    modulus.set(xlabel="shear strain [%]", ylabel="G/Gmax", ylim=(0, 1.02))
    damping.set(xlabel="shear strain [%]", ylabel="damping ratio [%]", ylim=(0, None))
    modulus.plot([], [], "o", ms=3.5, mfc="none", color=style.BLACK, label="loops of the law")
    modulus.legend()
    figure.tight_layout()
    return figure


def table(rows):
    for name, curve in by_curve(rows).items():
        modulus = max(abs(row["law_ratio"] / row["ratio"] - 1) for row in curve)
        damped = [row for row in curve if row["damping"] > 5e-3]
        damping = max(abs(row["law_damping"] / row["damping"] - 1) for row in damped)
        yield f"{name}: G/Gmax within {100 * modulus:.2f} %, damping above 0.5 % within {100 * damping:.2f} % of its value"
