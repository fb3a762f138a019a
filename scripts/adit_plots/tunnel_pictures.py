"""Pictures of a whole tunnel along its axis (program `simplified`): envelopes, motion over time, scenes compared."""
import matplotlib.pyplot as plt
import numpy as np

from adit_plots import style
from adit_plots.run_folder import Unusable, read_columns

# What is drawn along the axis: quantity, divisor, label.
QUANTITIES = (
    ("axial_force", "N", 1e6, "axial force [MN]"),
    ("moment_lateral", "N_m", 1e6, "lateral moment [MN m]"),
    ("shear_lateral", "N", 1e6, "lateral shear [MN]"),
    ("lateral_displacement", "m", 1, "lateral displ. [m]"),
    ("lateral_acceleration", "m_per_s2", 1, "lateral acc. [m/s²]"),
)
SHOWN = 4  # panels below the soil at most


def is_tunnel(run):
    return run.summary.get("model") in ("beam", "chain", "column")


def table(run, name):
    """A table of the run, None where it has none."""
    path = run.folder / name
    return read_columns(path) if path.exists() else None


def envelopes(run):
    """Least and greatest values along the axis, the soil drawn above."""
    return _along_the_axis([run], f"{run.name}: envelopes along the axis")


def comparison(case, runs):
    """The largest magnitudes of all scenes of a case along the axis, the soil of the first above."""
    return _along_the_axis(runs, f"{case}: the scenes compared")


def time_distance(run):
    """Lateral velocity and axial force over chainage and time."""
    values = table(run, "time_distance.csv")
    if values is None:
        return None
    places, times = np.unique(values["chainage_m"]), np.unique(values["time_s"])
    figure, panels = plt.subplots(1, 2, sharey=True, figsize=(10, 5.2), layout="constrained")
    for axes, (column, divisor, label) in zip(panels, (
            ("lateral_velocity_m_per_s", 1, "lateral velocity [m/s]"), ("axial_force_N", 1e6, "axial force [MN]"))):
        field = values[column].reshape(len(times), len(places)) / divisor
        limit = np.max(np.abs(field)) or 1
        mesh = axes.pcolormesh(places / 1e3, times, field, cmap="RdBu_r", vmin=-limit, vmax=limit, shading="nearest",
                               rasterized=True)
        figure.colorbar(mesh, ax=axes, label=label)
        axes.set_xlabel("chainage [km]")
    panels[0].set_ylabel("t [s]")
    panels[0].set_title(f"{run.name}: over time and distance", loc="left")
    return figure


def _along_the_axis(runs, title):
    tables = [table(run, "envelopes.csv") for run in runs]
    if any(t is None for t in tables):
        raise Unusable(f"{runs[0].folder} lacks envelopes.csv: run the scene again.")
    rows = [q for q in QUANTITIES if any(f"{q[0]}_max_{q[1]}" in t for t in tables)][:SHOWN]
    joints = [table(run, "joints.csv") for run in runs]
    with_joints = any(j is not None for j in joints)
    count = 1 + len(rows) + with_joints
    figure, panels = plt.subplots(count, 1, sharex=True, figsize=(9, 1.9 * count + 0.6), layout="constrained")
    panels[0].set_title(title, loc="left")
    _draw_soil(panels[0], runs[0])
    for i, (run, values) in enumerate(zip(runs, tables)):
        color = _color(i)
        for axes, quantity in zip(panels[1:], rows):
            _draw_envelope(axes, values, quantity, color, run.name, both=len(runs) == 1)
        if with_joints and joints[i] is not None:
            panels[-1].plot(joints[i]["chainage_m"] / 1e3, 1e3 * joints[i]["opening_max_m"], ".-", color=color,
                            lw=0.8, ms=3, label=run.name)
    if with_joints:
        panels[-1].set_ylabel("joint opening [mm]")
    if len(runs) > 1:
        panels[1].legend(loc="upper left", bbox_to_anchor=(1.01, 1.0))
    for axes in panels[1:]:
        axes.grid(lw=0.3, color="#DDDDDD")
    panels[-1].set_xlabel("chainage [km]")
    figure.align_ylabels(panels)
    return figure


def _draw_envelope(axes, values, quantity, color, name, both):
    column, unit, divisor, label = quantity
    if f"{column}_max_{unit}" not in values:
        return
    chainage = values["chainage_m"] / 1e3
    least, greatest = values[f"{column}_min_{unit}"] / divisor, values[f"{column}_max_{unit}"] / divisor
    if both:
        axes.fill_between(chainage, least, greatest, color=style.SKY, alpha=0.35, lw=0)
        axes.plot(chainage, least, color=style.BLUE, lw=0.8)
        axes.plot(chainage, greatest, color=style.RED, lw=0.8)
    else:
        axes.plot(chainage, np.maximum(np.abs(least), np.abs(greatest)), color=color, lw=0.9, label=name)
    axes.set_ylabel(label)


def _draw_soil(axes, run):
    """Layers below the surface, darker where stiffer, and the tunnel's axis."""
    soil = table(run, "soil_profile.csv")
    axes.set_ylabel("depth [m]")
    if soil is None:
        axes.text(0.5, 0.5, "no ground stated", ha="center", va="center", transform=axes.transAxes)
        return
    chainage, top, layer = soil["chainage_m"] / 1e3, np.zeros(len(soil["chainage_m"])), 1
    stiffest = max(np.max(v) for k, v in soil.items() if k.endswith("shear_velocity_m_per_s"))
    while f"layer_{layer}_bottom_m" in soil:
        bottom, velocity = soil[f"layer_{layer}_bottom_m"], soil[f"layer_{layer}_shear_velocity_m_per_s"]
        share = 0.15 + 0.6 * np.mean(velocity) / stiffest
        axes.fill_between(chainage, top, bottom, color=plt.get_cmap("YlOrBr")(share), lw=0,
                          label=f"{np.mean(velocity):.0f} m/s")
        top, layer = bottom, layer + 1
    if run.summary.get("model") != "column":
        axes.plot(chainage, soil["axis_depth_m"], color=style.BLACK, lw=1.6, label="tunnel")
    axes.set_ylim(1.05 * np.max(top), 0)
    axes.legend(loc="upper left", bbox_to_anchor=(1.01, 1.0))


def _color(i):
    colors = (style.BLACK, style.RED, style.BLUE, style.GREEN, style.ORANGE, style.PINK, style.SKY)
    return colors[i % len(colors)]
