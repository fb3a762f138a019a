#!/usr/bin/python3
"""Lays the runs beside Wang and Penzien: plot.py [RUNS_DIR], runs/lined_tunnel where absent.

Writes RUNS_DIR/around.png (thrust and moment around the ring at rest) and RUNS_DIR/over_time.png (under the wave), and
prints what the closed forms say, and what was found.
"""
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))
from adit_plots import style  # noqa: E402
from adit_plots.run_folder import Run  # noqa: E402

# of common/tunnel.yaml
G, NU, R, THICKNESS = 50e6, 0.49, 3.0, 0.25
E_LINING = 30e9 / (1 - 0.2 ** 2)
EA, EI = E_LINING * THICKNESS, E_LINING * THICKNESS ** 3 / 12
STRAIN = 1e-3  # of the ground far away, at rest


def wang_thrust():
    """Without slip, by unit strain (Wang 1993)."""
    c, f, n = 2 * G * R / (EA * (1 - 2 * NU)), G * R ** 3 / (3 * EI), 1 - 2 * NU
    k = 1 + (f * (n - n * c) - n ** 2 / 2 + 2) / (f * (3 - 2 * NU + n * c) + c * (2.5 - 8 * NU + 6 * NU ** 2) + 6 - 8 * NU)
    return k * G * R


def wang_moment():
    """With full slip, by unit strain (Wang 1993)."""
    return 4 * (1 - NU) / (2 * G * R ** 3 / (3 * EI) + 5 - 6 * NU) * G * R ** 2


def penzien_moment():
    """Without slip, by unit strain (Penzien 2000)."""
    return 3 * EI / (2 * R) * 4 * (1 - NU) / (24 * EI * (3 - 4 * NU) / ((2 * R) ** 3 * G) + 1)


def around(run, folder):
    _, pieces = next(run.snapshots())
    lining = pieces["linings"]
    angle = np.degrees(np.arctan2(lining.points[:, 1], lining.points[:, 0])) % 360
    order = np.argsort(angle)
    fine = np.linspace(0, 360, 361)
    figure, panels = style.plt.subplots(1, 2, figsize=(9.5, 3.6), layout="constrained")
    for axes, name, what, forms in (
            (panels[0], "thrust_N", "thrust [kN/m]", {"Wang, no slip": wang_thrust()}),
            (panels[1], "moment_Nm", "moment [kN m/m]", {"Penzien, no slip": -penzien_moment(), "Wang, full slip": -wang_moment()})):
        values = lining.field(name)
        axes.plot(angle[order], values[order] / 1e3, "o", ms=3.5, color=style.BLUE, label="computed")
        for (form, amplitude), look in zip(forms.items(), ("-", "--")):
            axes.plot(fine, STRAIN * amplitude / 1e3 * np.cos(2 * np.radians(fine - 135)), look, color=style.RED, label=form)
            print(f"ovaling: largest {what}: {np.abs(values).max() / 1e3:.1f}, {form}: {abs(STRAIN * amplitude) / 1e3:.1f}")
        axes.set(xlabel="angle from x [deg]", ylabel=what, xlim=(0, 360), xticks=range(0, 361, 45))
        axes.legend()
    panels[0].set_title(f"{run.name}: around the ring", loc="left")
    style.save(figure, folder / "around.png")


def over_time(run, folder):
    h = run.histories
    strain = (h["free_above_ux_m"] - h["free_below_ux_m"]) / 3
    figure, panels = style.plt.subplots(1, 2, figsize=(9.5, 3.6), layout="constrained")
    for axes, name, what, form, amplitude in (
            (panels[0], "pulled_thrust_N", "thrust at 45° [kN/m]", "Wang, no slip", -wang_thrust()),
            (panels[1], "pulled_moment_Nm", "moment at 45° [kN m/m]", "Penzien, no slip", penzien_moment())):
        axes.plot(h["time_s"], h[name] / 1e3, color=style.BLUE, label="computed")
        axes.plot(h["time_s"], amplitude * strain / 1e3, "--", color=style.RED, label=f"{form}, times the free field's strain")
        axes.set(xlabel="time [s]", ylabel=what)
        axes.legend()
        print(f"shear wave: largest {what}: {np.abs(h[name]).max() / 1e3:.1f}, "
              f"{form}: {np.abs(amplitude * strain).max() / 1e3:.1f} (strain {np.abs(strain).max():.2e})")
    panels[0].set_title(f"{run.name}: over time", loc="left")
    style.save(figure, folder / "over_time.png")


runs = Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "runs" / "lined_tunnel"
around(Run(runs / "ovaling"), runs)
over_time(Run(runs / "shear_wave"), runs)
