#!/usr/bin/python3
"""Prints what the runs say, side by side: table.py RUN_DIR..."""
import json
import sys
from pathlib import Path

ROWS = (  # what, key of summary.json, divisor, format
    ("peak bond force [kN]", "peak_bond_force_N", 1e3, "{:,.0f}"),
    ("  at [ms]", "peak_bond_force_time_s", 1e-3, "{:.2f}"),
    ("  at x [m]", "peak_bond_force_x_m", 1, "{:.2f}"),
    ("first crack at [ms]", "first_crack_time_s", 1e-3, "{:.2f}"),
    ("  at x [m]", "first_crack_x_m", 1, "{:.2f}"),
    ("  at y [m]", "first_crack_y_m", 1, "{:.2f}"),
    ("cracks", "crack_count", 1, "{:.0f}"),
    ("energy drift", "max_energy_drift", 1, "{:.1e}"),
    ("wall time [s]", "wall_s", 1, "{:.2f}"),
)


def column(folder):
    try:
        summary = json.loads((folder / "summary.json").read_text())
    except (OSError, ValueError) as error:
        sys.exit(f"{folder / 'summary.json'} cannot be read: {error}")
    values = ((summary.get(key), divisor, text) for _, key, divisor, text in ROWS)
    return [folder.resolve().name] + ["-" if v is None else text.format(v / divisor) for v, divisor, text in values]


columns = [[""] + [row[0] for row in ROWS]] + [column(Path(folder)) for folder in sys.argv[1:]]
widths = [max(map(len, cells)) for cells in columns]
for line in zip(*columns):
    print("  " + line[0].ljust(widths[0]), *(cell.rjust(width + 2) for cell, width in zip(line[1:], widths[1:])))
