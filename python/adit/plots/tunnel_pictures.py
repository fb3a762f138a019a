"""Pictures of a whole tunnel along its axis (program `simplified`): envelopes, motion over time, scenes compared."""
import matplotlib.pyplot as plt
import numpy as np

from adit import Unusable
from adit.plots import style
from adit.plots.drawing import Colours, Drawing, Panels, legend

# The quantities drawn along the axis: name and unit in the table's columns, label and unit in the picture.
QUANTITIES = (
    ("axial_force", "N", "axial force", "N"),
    ("moment_lateral", "N_m", "lateral moment", "N m"),
    ("shear_lateral", "N", "lateral shear", "N"),
    ("lateral_displacement", "m", "lateral displ.", "m"),
    ("lateral_acceleration", "m_per_s2", "lateral acc.", "m/s²"),
)
# Of a single run in ground that liquefies, in which the tunnel floats.
OF_LIQUEFIED_GROUND = (
    QUANTITIES[0],
    ("moment_vertical", "N_m", "vertical moment", "N m"),
    ("uplift", "m", "uplift", "m"),
    ("pressure_ratio", "", "pressure ratio", ""),
)
SHOWN = 4  # panels below the soil at most
APART = {"w_pad": 0.1, "h_pad": 0.06, "wspace": 0.06}  # so that labels touch neither the edge nor other panels
BESIDE = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.0)}  # of a panel: its legend


def table(run, name):
    """A table of the run; None if it does not have this table."""
    return run.table(name) if run.has(name) else None


def envelopes(run):
    """Least and greatest values along the axis, the soil drawn above."""
    return _along_the_axis([run], run.name, "envelopes along the axis")


def comparison(case, runs):
    """The largest magnitudes of all scenes of a case along the axis, the soil of the first above."""
    return _along_the_axis(runs, case, "the scenes compared")


def time_distance(run):
    """Lateral velocity and axial force over chainage and time."""
    values = table(run, "time_distance.csv")
    if values is None:
        return None
    places, times = np.unique(values["chainage_m"]), np.unique(values["time_s"])
    fields = [values[column].reshape(len(times), len(places)) / divisor
              for column, divisor in (("lateral_velocity_m_per_s", 1), ("axial_force_N", 1e6))]
    limits = [np.max(np.abs(field)) or 1 for field in fields]
    colours = [Colours(what, -limit, limit, unit)
               for what, limit, unit in zip(("lateral velocity", "axial force"), limits, ("m/s", "MN"))]

    def paint(*panels):
        for axes, field, scale in zip(panels, fields, colours):
            mesh = axes.pcolormesh(places / 1e3, times, field, cmap="RdBu_r", vmin=scale.low, vmax=scale.high, shading="nearest",
                                   rasterized=True)
            axes.figure.colorbar(mesh, ax=axes, label=scale.label)
            axes.set_xlabel("chainage [km]")
        panels[0].set_ylabel("t [s]")

    layout = Panels(1, 2, (10, 5.2), sharey=True, pads=APART, dense=True)
    return Drawing(run.name, "over time and distance", layout, paint, colours=tuple(colours))


def _along_the_axis(runs, of, title):
    tables = [table(run, "envelopes.csv") for run in runs]
    if any(t is None for t in tables):
        raise Unusable(f"{runs[0].folder} lacks envelopes.csv: run the scene again.")
    floats = len(runs) == 1 and "pressure_ratio_max" in tables[0]
    rows = [q for q in (OF_LIQUEFIED_GROUND if floats else QUANTITIES) if any(_columns(q)[1] in t for t in tables)][:SHOWN]
    joints = [table(run, "joints.csv") for run in runs]
    with_joints = any(j is not None for j in joints)
    units = [_unit(tables, quantity) for quantity in rows]
    count = 1 + len(rows) + with_joints

    def paint(*panels):
        _draw_soil(panels[0], runs[0])
        for i, (run, values) in enumerate(zip(runs, tables)):
            color = style.of_run(i)
            for axes, quantity, unit in zip(panels[1:], rows, units):
                _draw_envelope(axes, values, quantity, unit, color, run.name, both=len(runs) == 1)
            if with_joints and joints[i] is not None:
                _draw_openings(panels[-1], joints[i], color if len(runs) > 1 else None)
        for axes in panels[1:]:
            axes.grid(lw=0.3, color="#DDDDDD")
        panels[-1].set_xlabel("chainage [km]")
        panels[0].figure.align_ylabels(panels)
        groups = panels[-1] if with_joints and len(runs) == 1 and len(panels[-1].get_lines()) > 1 else None
        return [legend(axes, **BESIDE) for axes in (panels[0], panels[1] if rows else None, groups) if axes]

    return Drawing(of, title, Panels(count, 1, (9, 1.9 * count + 0.6), sharex=True, pads=APART), paint)


def _columns(quantity):
    """The columns of its least and its greatest values."""
    column, unit = quantity[:2]
    return [f"{column}_{end}{'_' * bool(unit)}{unit}" for end in ("min", "max")]


def _unit(tables, quantity):
    """Divisor and name of the unit in which the largest value of a quantity is at least 1."""
    base = quantity[3]
    largest = max(np.max(np.abs(values[name])) for values in tables for name in _columns(quantity) if name in values)
    if not base.startswith("N") or largest < 1e3:
        return 1, base
    return (1e6, f"M{base}") if largest >= 1e6 else (1e3, f"k{base}")


def _draw_envelope(axes, values, quantity, shown, color, name, both):
    label, (divisor, symbol) = quantity[2], shown
    if not all(name in values for name in _columns(quantity)):
        return
    chainage = values["chainage_m"] / 1e3
    least, greatest = (values[name] / divisor for name in _columns(quantity))
    if both:
        axes.fill_between(chainage, least, greatest, color=style.SKY, alpha=0.35, lw=0)
        axes.plot(chainage, least, color=style.BLUE, lw=0.8, label="least")
        axes.plot(chainage, greatest, color=style.RED, lw=0.8, label="greatest")
    else:
        axes.plot(chainage, np.maximum(np.abs(least), np.abs(greatest)), color=color, lw=0.9, label=name)
    axes.set_ylabel(f"{label} [{symbol}]" if symbol else label)


def _draw_openings(axes, joints, color):
    """Draws every group of joints in its own colour. Of several runs, it draws only the group that opens most."""
    groups = list(dict.fromkeys(joints["group"]))
    if color:
        groups = [joints["group"][np.argmax(joints["opening_max_m"])]]
    for i, group in enumerate(groups):
        chosen = joints["group"] == group
        axes.plot(joints["chainage_m"][chosen] / 1e3, 1e3 * joints["opening_max_m"][chosen], color=color or style.of_run(i),
                  lw=0.8, marker="." if np.count_nonzero(chosen) < 300 else None, ms=3,
                  label=style.literal(group.replace("_", " ")))
    axes.set_ylabel("joint opening [mm]")


def _draw_soil(axes, run):
    """Layers below the surface, darker where stiffer, and the tunnel's axis."""
    soil = table(run, "soil_profile.csv")
    axes.set_ylabel("depth [m]")
    if soil is None:
        axes.text(0.5, 0.5, "no ground in the scene", ha="center", va="center", transform=axes.transAxes)
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
