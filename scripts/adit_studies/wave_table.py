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


def print_shares(shares):
    """Reflected / lost in per cent: a line for each set-up and solve, a column for each wavelength."""
    lengths = sorted({case.lambda_over_h for case in shares}, reverse=True)
    lines = {}
    for case, (reflected, _, lost) in shares.items():
        key = (case.model, case.wave, case.h_over_a, case.overlap_over_h, case.dt_factor, case.substeps,
               case.angle_deg, case.side, case.solve)
        lines.setdefault(key, {})[case.lambda_over_h] = f"{percent(reflected)}/{percent(lost)}"
    print("reflected / lost, per cent of the incident energy, over λ/h")
    head = ("model", "wave", "h/a", "Lo/h", "dt", "m", "angle", "side", "solve")
    widths = [max(len(str(key[i])) for key in [head, *lines]) for i in range(len(head))]
    print("  ".join(name.ljust(width) for name, width in zip(head, widths)), *(f"{length:>12g}" for length in lengths))
    for key, cells in lines.items():
        print("  ".join(str(value).ljust(width) for value, width in zip(key, widths)),
              *(cells.get(length, "").rjust(12) for length in lengths))


def percent(share):
    value = 100 * share
    return "0" if abs(value) < 5e-4 else f"{value:.3f}" if value < 0.1 else f"{value:.2f}" if value < 10 else f"{value:.1f}"
