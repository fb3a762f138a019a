"""The table of reflected, transmitted and lost shares, as a file and on the screen."""
import csv

COLUMNS = ("solve", "h_over_a", "overlap_over_h", "lambda_over_h", "dt_factor", "angle_deg", "side",
           "reflected", "transmitted", "lost", "wave", "model", "substeps")


def write(path, shares):
    """`shares`: {case: (reflected, transmitted, lost)} of the incident energy."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(COLUMNS)
        for case, values in shares.items():
            said = vars(case) | {k: f"{v:.6e}" for k, v in zip(("reflected", "transmitted", "lost"), values)}
            writer.writerow(said[column] for column in COLUMNS)


def reflected_and_lost(shares):
    """(head, rows) in per cent: a row for each set-up and solve, a column for each wavelength."""
    lengths = sorted({case.lambda_over_h for case in shares}, reverse=True)
    found = {}
    for case, (reflected, _, lost) in shares.items():
        key = (case.model, case.wave, case.h_over_a, case.overlap_over_h, case.dt_factor, case.substeps,
               case.angle_deg, case.side, case.solve)
        found.setdefault(key, {})[case.lambda_over_h] = f"{percent(reflected)}/{percent(lost)}"
    head = ("model", "wave", "h/a", "Lo/h", "dt", "m", "angle", "side", "solve", *(f"{length:g}" for length in lengths))
    return head, [(*map(str, key), *(cells.get(length, "") for length in lengths)) for key, cells in found.items()]


def print_shares(shares):
    head, rows = reflected_and_lost(shares)
    print("reflected / lost, per cent of the incident energy, over λ/h")
    widths = [max(len(row[i]) for row in (head, *rows)) for i in range(len(head))]
    for row in (head, *rows):
        print("  ".join(cell.ljust(width) for cell, width in zip(row, widths)))


def percent(share):
    value = 100 * share
    return "0" if abs(value) < 5e-4 else f"{value:.3f}" if value < 0.1 else f"{value:.2f}" if value < 10 else f"{value:.1f}"
