"""The main figures of runs side by side, for the screen."""

ROWS = (  # what, key of summary.json, divisor, format
    ("peak bond force [kN]", "peak_bond_force_N", 1e3, "{:,.0f}"),
    ("  at [ms]", "peak_bond_force_time_s", 1e-3, "{:.2f}"),
    ("  at x [m]", "peak_bond_force_x_m", 1, "{:.2f}"),
    ("first crack at [ms]", "first_crack_time_s", 1e-3, "{:.2f}"),
    ("  at x [m]", "first_crack_x_m", 1, "{:.2f}"),
    ("  at y [m]", "first_crack_y_m", 1, "{:.2f}"),
    ("cracks", "crack_count", 1, "{:.0f}"),
    ("energy drift", "max_energy_drift", 1, "{:.1e}"),
    ("axial force [MN]", "max_axial_force_N", 1e6, "{:,.1f}"),
    ("lateral moment [MN m]", "max_moment_lateral_N_m", 1e6, "{:,.1f}"),
    ("lateral shear [MN]", "max_shear_lateral_N", 1e6, "{:,.2f}"),
    ("strain [1e-6]", "max_strain", 1e-6, "{:,.0f}"),
    ("element joint opening [mm]", "element_joint_max_opening_m", 1e-3, "{:.2f}"),
    ("  at [m]", "element_joint_max_opening_chainage_m", 1, "{:.0f}"),
    ("segment joint opening [mm]", "segment_joint_max_opening_m", 1e-3, "{:.2f}"),
    ("ring joint opening [mm]", "ring_joint_max_opening_m", 1e-3, "{:.3f}"),
    ("wall time [s]", "wall_s", 1, "{:.2f}"),
    ("real-time factor", "real_time_factor", 1, "{:.0f}"),
)


def lines(runs):
    """A line for each figure that some run has, a column for each run."""
    columns = [[""] + [row[0] for row in ROWS], *map(_column, runs)]
    widths = [max(map(len, cells)) for cells in columns]
    for line in zip(*columns):
        if any(cell != "-" for cell in line[1:]):
            yield "  ".join(["  " + line[0].ljust(widths[0]), *(c.rjust(w + 1) for c, w in zip(line[1:], widths[1:]))])


def _column(run):
    values = ((run.summary.get(key), divisor, text) for _, key, divisor, text in ROWS)
    return [run.name] + ["-" if v is None else text.format(v / divisor) for v, divisor, text in values]
