"""Pictures of the site: motions, response spectra, transfer function, profiles over depth."""
import matplotlib.pyplot as plt
import numpy as np

from adit_plots import style
from adit_studies.site_response import DAMPING, PERIODS, response_spectrum

COLORS = {"outcrop": style.GREY, "linear": style.BLUE, "hysteretic": style.RED}


def all_pictures(outcrop, linear, hysteretic, findings):
    runs = (outcrop, linear, hysteretic)
    yield "motions", motions(runs)
    yield "response_spectra", spectra(runs)
    yield "transfer_function", transfer_function(findings)
    yield "profiles", profiles((linear, hysteretic))


def surface(run):
    return run.acceleration(run.depth.min())


def motions(runs):
    figure, panels = plt.subplots(3, 1, sharex=True, sharey=True, figsize=(8.0, 5.4), layout="constrained")
    for axes, run in zip(panels, runs):
        a = surface(run)
        axes.plot(run.time, a, color=COLORS[run.name], lw=0.7)
        axes.set(ylabel="a [m/s²]", xlim=(run.time[0], run.time[-1]))
        place = "the rock’s outcrop" if run.name == "outcrop" else f"the surface, {run.name} ground"
        axes.set_title(f"{place}: largest {np.abs(a).max():.2f} m/s²", loc="left")
        axes.grid(lw=0.3, color="#DDDDDD")
    panels[-1].set_xlabel("t [s]")
    return figure


def spectra(runs):
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for run in runs:
        axes.semilogx(PERIODS, response_spectrum(surface(run), run.step), color=COLORS[run.name],
                      label=run.name if run.name == "outcrop" else f"surface, {run.name}")
    axes.set(xlabel="period [s]", ylabel="pseudo-acceleration [m/s²]", xlim=(PERIODS[0], PERIODS[-1]), ylim=(0, None))
    axes.set_xticks([0.05, 0.1, 0.2, 0.5, 1, 2, 4], ["0.05", "0.1", "0.2", "0.5", "1", "2", "4"])
    axes.minorticks_off()
    axes.set_title(f"Response spectra, {100 * DAMPING:.0f} % of damping", loc="left")
    axes.legend()
    axes.grid(lw=0.3, color="#DDDDDD")
    return figure


def transfer_function(findings):
    figure, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
    axes.plot(findings.frequency, findings.theory, color=style.BLACK, lw=2.4, alpha=0.35, label="wave theory")
    axes.plot(findings.frequency, findings.measured, color=style.BLUE, lw=1, label="computed, linear ground")
    axes.set(xlabel="frequency [Hz]", ylabel="surface over outcrop", xlim=(findings.frequency[0], findings.frequency[-1]),
             ylim=(0, None))
    axes.set_title("Transfer function", loc="left")
    axes.legend()
    axes.grid(lw=0.3, color="#DDDDDD")
    return figure


def profiles(runs):
    figure, (left, right) = plt.subplots(1, 2, sharey=True, figsize=(7.2, 4.6), layout="constrained")
    for run in runs:
        left.plot(np.abs(run.acceleration()).max(axis=1), run.depth, ".-", ms=4, color=COLORS[run.name], label=run.name)
        depth, strain = run.strain_profile()
        right.plot(100 * strain, depth, ".-", ms=4, color=COLORS[run.name])
    depths, names = soil(runs[0].scene)
    for axes in (left, right):
        axes.grid(lw=0.3, color="#DDDDDD")
        for depth in depths[1:-1]:
            axes.axhline(depth, color=style.GREY, lw=0.6, ls=":")
    for name, top, bottom in zip(names, depths, depths[1:]):
        right.text(0.98, (top + bottom) / 2, name, transform=right.get_yaxis_transform(), ha="right", va="center",
                   color=style.GREY)
    left.set(xlabel="peak acceleration [m/s²]", ylabel="depth [m]", xlim=(0, None), ylim=(depths[-1], 0))
    right.set(xlabel="largest shear strain [%]", xlim=(0, None))
    left.legend(loc="lower right")
    left.set_title("Largest over time", loc="left")
    return figure


def soil(scene):
    """Depths of the layers' boundaries, and the layers' names."""
    blocks = scene["continuum"]["blocks"]
    return [0.0, *(-block["rectangle"]["y_min"] for block in blocks)], [block["name"] for block in blocks]
