"""Pictures over time: the histories and the energies of a run."""
import re

import numpy as np

from adit.plots import style
from adit.plots.drawing import Drawing, Panels, legend
from adit.results.rounding import ROUNDING, STILL

LINES = ("-", "--", "-.", (0, (3, 1, 1, 1, 1, 1)))  # line styles of the models, in turn
KINDS = {"kinetic": style.BLUE, "strain": style.ORANGE, "released": style.PINK, "dissipated": style.RED, "external_work": style.GREEN,
         "multiplier_work": style.SKY}
STORED = ("kinetic", "strain")
STRENGTH = "shear_strength_N"  # ending of the columns of what sections resist

# The quantities in histories.csv: endings of the columns' names, name of the quantity, and its units with their sizes.
QUANTITIES = (
    (("ux_m", "uy_m", "uz_m"), "displacement", (("µm", 1e-6), ("mm", 1e-3), ("m", 1))),
    (("vx_m_per_s", "vy_m_per_s"), "velocity", (("mm/s", 1e-3), ("m/s", 1))),
    (("ax_m_per_s2", "ay_m_per_s2"), "acceleration", (("mm/s²", 1e-3), ("m/s²", 1))),
    (("effective_sxx_Pa", "effective_syy_Pa"), "effective stress", (("Pa", 1), ("kPa", 1e3), ("MPa", 1e6))),
    (("pore_pressure_Pa",), "pore pressure", (("Pa", 1), ("kPa", 1e3), ("MPa", 1e6))),
    (("pressure_ratio",), "pressure ratio", (("-", 1),)),
    (("sxx_Pa", "syy_Pa", "szz_Pa", "sxy_Pa"), "stress", (("Pa", 1), ("kPa", 1e3), ("MPa", 1e6))),
    (("normal_stress_Pa", "shear_stress_Pa"), "stress of faces", (("Pa", 1), ("kPa", 1e3), ("MPa", 1e6))),
    (("bar_stress_Pa",), "stress of bars", (("Pa", 1), ("kPa", 1e3), ("MPa", 1e6))),
    (("demand",), "demand", (("-", 1),)),
    (("exx", "eyy", "gxy"), "strain", (("10⁻⁶", 1e-6), ("10⁻³", 1e-3))),
    (("exx_per_s", "eyy_per_s", "gxy_per_s"), "strain rate", (("10⁻⁶/s", 1e-6), ("10⁻³/s", 1e-3), ("1/s", 1))),
    (("contacts",), "coordination", (("-", 1),)),
    (("porosity",), "porosity", (("-", 1),)),
    (("thrust_N",), "thrust", (("N/m", 1), ("kN/m", 1e3), ("MN/m", 1e6))),
    (("moment_Nm",), "moment", (("N m/m", 1), ("kN m/m", 1e3), ("MN m/m", 1e6))),
    (("shear_N", STRENGTH), "shear force", (("N/m", 1), ("kN/m", 1e3), ("MN/m", 1e6))),
    (("utilisation",), "utilisation", (("-", 1),)),
    (("curvature_per_m",), "curvature", (("10⁻³/m", 1e-3), ("1/m", 1))),
    (("opening_m", "outer_opening_m", "inner_opening_m", "gasket_opening_m", "offset_m", "ring_offset_m"), "opening, offset",
     (("µm", 1e-6), ("mm", 1e-3), ("m", 1))),
    (("bar_slip_m",), "slip of bars", (("µm", 1e-6), ("mm", 1e-3))),
    (("largest_diameter_change_m", "smallest_diameter_change_m"), "change of diameters", (("µm", 1e-6), ("mm", 1e-3), ("m", 1))),
    (("largest_diameter_direction_rad",), "direction", (("°", np.pi / 180),)),
    (("tightness",), "tightness of gaskets", (("-", 1),)),
    (("crack_width_m",), "crack width", (("mm", 1e-3),)),
    (("rotation_rad",), "joint rotation", (("10⁻⁶ rad", 1e-6), ("10⁻³ rad", 1e-3))),
    (("force_N", "bolt_force_N", "dowel_force_N", "fx_N", "fy_N"), "force", (("N", 1), ("kN", 1e3), ("MN", 1e6))),
    (("axial_force_N",), "axial force", (("N", 1), ("kN", 1e3), ("MN", 1e6))),
    (("moment_lateral_N_m", "moment_vertical_N_m"), "moment", (("N m", 1), ("kN m", 1e3), ("MN m", 1e6))),
    (("shear_lateral_N", "shear_vertical_N"), "shear force", (("N", 1), ("kN", 1e3), ("MN", 1e6))))
UNIT = re.compile(r"_(m_per_s2?|per_m|N_m|Nm|rad|Pa|N|m)$")  # at the end of a column's name
SAID = {"shear": "shear force", "moment_lateral": "lateral moment", "moment_vertical": "vertical moment",  # others as their columns
        "shear_lateral": "lateral shear force", "shear_vertical": "vertical shear force"}
MOST_LINES = 12  # in one panel
ROW = 0.16  # inches of a line of a legend
BESIDE = {"loc": "upper left", "bbox_to_anchor": (1.01, 1.04), "labelspacing": 0.25}  # of a panel: its legend


def histories(run, quantities=None, title="histories"):
    """The histories of the scene, or those of these `quantities`: one panel for each with its largest MOST_LINES."""
    panels = []
    for quantity, (units, lines) in (quantities or quantities_of(run)).items():
        panels.append((quantity, *unit_for(units, [values for _, values in lines]), _largest(lines)))
    if not panels:
        return None
    heights = [max(1.6, ROW * len(lines)) for *_, lines in panels]  # each as high as its legend
    time, label = style.time_axis(run.histories["time_s"])

    def paint(*axes):
        for panel, (quantity, unit, size, lines) in zip(axes, panels):
            for i, (name, values) in enumerate(lines):
                panel.plot(time, values / size, lw=1, color=_COLORS[i % len(_COLORS)], ls=LINES[i // len(_COLORS) % len(LINES)],
                           label=style.literal(said(name)))
            panel.axhline(0, color=style.GREY, lw=0.4, zorder=0)
            panel.set_ylabel(f"{quantity} [{unit}]")
        axes[-1].set(xlabel=label, xlim=(time[0], time[-1] or 1))
        axes[0].figure.align_ylabels()
        return [legend(panel, handlelength=1.6, **BESIDE) for panel in axes]

    return Drawing(run.name, title, _rows(heights, 0.9 + sum(heights) + 0.2 * len(heights), left=0.11, right=0.79, hspace=0.12), paint)


def _rows(heights, height, **margins):
    """Panels over one time, with margins of equal size above and below for any height of the picture."""
    return Panels(len(heights), 1, (8.0, height), heights, sharex=True,
                  margins={"top": 1 - 0.32 / height, "bottom": 0.5 / height, **margins})


def quantities_of(run):
    """{quantity: (its units, [(column, values)])} of the histories of the scene. Curves that are rounding beside others of their
    dimension are 0."""
    found, members = {}, _histories_of_members(run)
    for endings, quantity, units in QUANTITIES:
        for name, values in run.histories.items() if len(run.histories["time_s"]) else ():
            if (ending := _ending(name)) not in endings:
                continue
            if ending.endswith(("_N", "_Nm")) and name.removesuffix(f"_{ending}") in members:
                of, scale = f"{quantity}, members", tuple((unit.removesuffix("/m"), size) for unit, size in units)
            else:
                of, scale = quantity, units
            found.setdefault(of, (scale, []))[1].append((name, values))
    return _without_rounding(found)


def _without_rounding(found):
    """The quantities with 0 for curves that are rounding beside the largest of their dimension."""
    largest = {"m": STILL}  # coordinates are those of a model of unknown size, which is at least 1 m
    for quantity, (_, lines) in found.items():
        for name, values in lines:
            of = _dimension(quantity, name)
            largest[of] = max(largest.get(of, 0), _size(values))
    return {quantity: (units, [(name, values if _size(values) > ROUNDING * largest[_dimension(quantity, name)] else 0 * values)
                               for name, values in lines]) for quantity, (units, lines) in found.items()}


def _dimension(quantity, column):
    """The unit of a column, of a moment that of the force at a lever of 1 m; of a column without a unit its quantity."""
    unit = UNIT.search(column)
    return quantity if unit is None else "N" if unit[1] in ("Nm", "N_m") else unit[1]


def _size(values):
    return np.nanmax(np.abs(values), initial=0)


def _histories_of_members(run):
    """Their names: forces are those of one member, not per metre."""
    return {history["name"] for _, model in run.models for history in model.get("histories", []) if "member" in history}


def _ending(name):
    """The longest ending of a column's name that names a quantity; None for other columns."""
    fitting = [ending for endings, *_ in QUANTITIES for ending in endings if name.endswith("_" + ending)]
    return max(fitting, key=len, default=None)


def said(column):
    """The text of a column in a legend: its place, and its quantity with the direction."""
    if column == "max_bond_force_N":
        return "largest bond force"
    ending = _ending(column)
    what = UNIT.sub("", ending)
    return f"{column.removesuffix('_' + ending)}, {SAID.get(what, what.replace('_', ' '))}"


def _largest(lines):
    """The lines of largest magnitude, forces before strengths, in the order given."""
    order = sorted(range(len(lines)), key=lambda i: (_ending(lines[i][0]) == STRENGTH, -_size(lines[i][1])))
    return [lines[i] for i in sorted(order[:MOST_LINES])]


def unit_for(units, series):
    """The unit in which the largest value is at least 1: (its name, its size)."""
    largest = max(_size(values) for values in series)
    fitting = [unit for unit in units if largest >= unit[1]]
    return fitting[-1] if fitting else units[0]


_COLORS = (style.BLUE, style.RED, style.GREEN, style.ORANGE, style.PINK, style.SKY, style.BLACK)


def energy(run):
    """Three panels: input and losses, stored energy, and the drift of the balance."""
    h = run.histories
    if "energy_drift" not in h or not len(h["time_s"]):
        return None
    models = [name.removesuffix("_kinetic_J") for name in h if name.endswith("_kinetic_J")]
    names = [(model, kind) for model in models for kind in KINDS if np.any(h.get(f"{model}_{kind}_J", 0))]
    time, label = style.time_axis(h["time_s"])
    rows = [[name for name in names if (name[1] in STORED) == stored] for stored in (False, True)]
    heights = [max(1.7, ROW * (len(row) + 1)) for row in rows] + [1.0]
    total = sum(h[f"{model}_{kind}_J"] for model, kind in rows[1]) if rows[1] else None

    def paint(lost, stored, drift):
        _draw_energies(lost, time, h, rows[0], models, None, "put in and lost")
        _draw_energies(stored, time, h, rows[1], models, total, "stored")
        drift.plot(time, h["energy_drift"], color=style.BLACK, lw=1)
        drift.axhline(0, color=style.GREY, lw=0.5)
        drift.set(xlabel=label, ylabel="drift\n[of the peak]", xlim=(time[0], time[-1] or 1))
        drift.ticklabel_format(axis="y", scilimits=(-2, 3))
        drift.figure.align_ylabels()
        return [legend(panel, handlelength=2.6, **BESIDE) for panel in (lost, stored)]

    return Drawing(run.name, "energy", _rows(heights, 0.9 + sum(heights), left=0.12, right=0.7, hspace=0.14), paint)


def _draw_energies(axes, time, histories, row, models, total, what):
    """Curves of one panel, wide ones below, so that those that coincide are all seen; `total` is drawn on top."""
    series = [histories[f"{model}_{kind}_J"] for model, kind in row]
    unit, size = unit_for((("J", 1), ("kJ", 1e3), ("MJ", 1e6)), [*series, [0]])
    for (model, kind), values in zip(row, series):
        wide = {"lw": 3.5, "alpha": 0.4, "zorder": 1} if kind == "external_work" else {}
        axes.plot(time, values / size, ls=LINES[models.index(model) % len(LINES)], color=KINDS[kind], **wide,
                  label=f"{model}, {kind.replace('_', ' ').replace('multiplier', 'multipliers’')}")
    if total is not None:
        axes.plot(time, total / size, ":", color=style.BLACK, label="kinetic + strain, all")
    axes.axhline(0, color=style.GREY, lw=0.4, zorder=0)
    axes.set_ylabel(f"{what} [{unit}]")
