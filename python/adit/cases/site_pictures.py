"""Pictures of the site: motions, response spectra, transfer function, profiles over depth, loops of stress and strain."""
import matplotlib.pyplot as plt

from adit.plots import style
from adit.plots.spectra_pictures import GRAVITY
from adit.cases.site_response import LOOPS

COLORS = {"outcrop": style.GREY, "linear": style.BLUE, "hysteretic": style.RED}


def all_pictures(outcrop, linear, hysteretic, findings):
    yield "motions", motions((outcrop, linear, hysteretic))
    yield "response_spectra", spectra((outcrop, linear, hysteretic))
    yield "transfer_function", transfer_function(findings)
    yield "profiles", profiles((linear, hysteretic))
    yield "loops", loops((linear, hysteretic))


def motions(sites):
    figure, panels = plt.subplots(3, 1, sharex=True, sharey=True, figsize=(8.0, 5.4), layout="constrained")
    for axes, site in zip(panels, sites):
        axes.plot(site.time, site.acceleration, color=COLORS[site.name], lw=0.7)
        axes.set(ylabel="a [m/s²]", xlim=(site.time[0], site.time[-1]))
        place = "the rock’s outcrop" if site.name == "outcrop" else f"the surface, {site.name} ground"
        axes.set_title(f"{place}: largest {site.peak:.2f} m/s²", loc="left")
        axes.grid(lw=0.3, color="#DDDDDD")
    panels[-1].set_xlabel("t [s]")
    return figure


def spectra(sites):
    figure, axes = plt.subplots(figsize=(6.4, 4.2), layout="constrained")
    for site in sites:
        axes.semilogx(site.period, site.spectrum / GRAVITY, color=COLORS[site.name],
                      label=site.name if site.name == "outcrop" else f"surface, {site.name}")
    axes.set(xlabel="period [s]", ylabel="pseudo acceleration [g]", ylim=(0, None),
             xlim=(sites[0].period[0], sites[0].period[-1]))
    axes.set_xticks([0.05, 0.1, 0.2, 0.5, 1, 2, 5], ["0.05", "0.1", "0.2", "0.5", "1", "2", "5"])
    axes.minorticks_off()
    axes.set_title("Response spectra, 5 % of damping", loc="left")
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


def profiles(sites):
    figure, (left, right) = plt.subplots(1, 2, sharey=True, figsize=(7.2, 4.6), layout="constrained")
    for site in sites:
        depth, acceleration = site.peak_acceleration
        left.plot(acceleration, depth, color=COLORS[site.name], label=site.name)
        depth, strain = site.peak_strain
        right.plot(100 * strain, depth, color=COLORS[site.name])
    depths, names = soil(sites[0].scene)
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


def loops(sites):
    figure, panels = plt.subplots(1, len(LOOPS), figsize=(8.0, 3.8), layout="constrained")
    for axes, name in zip(panels, LOOPS):
        for site in sites:
            strain, stress = site.loop(name)
            axes.plot(100 * strain, stress / 1e3, color=COLORS[site.name], lw=0.6, label=site.name)
        axes.set(xlabel="shear strain [%]", ylabel="shear stress [kPa]")
        axes.set_title(f"Foot of the {name}", loc="left")
        axes.grid(lw=0.3, color="#DDDDDD")
    panels[0].legend(loc="upper left")
    return figure


def soil(scene):
    """Depths of the layers' boundaries, and the layers' names."""
    blocks = scene["continuum"]["blocks"]
    return [0.0, *(-block["rectangle"]["y_min"] for block in blocks)], [block["name"] for block in blocks]
