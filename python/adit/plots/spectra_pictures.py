"""Pictures of the motions for which spectra were asked: time histories, response spectra, Fourier spectra, amplification."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from adit.plots import style

GRAVITY = 9.80665  # [m/s^2]; response spectra of accelerations are drawn in g
COLORS = (style.BLACK, style.RED, style.BLUE, style.GREEN, style.ORANGE, style.PINK, style.SKY)


def motions(run):
    """Yields (name, figure) for every motion of the run."""
    for name, tables in run.spectra.items():
        transfer = tables.get("transfer")
        yield f"{name}_motion", _over_time(run, name, tables["motion"])
        if np.any(tables["motion"]["acceleration_m_per_s2"]):  # a motion at rest has no place on logarithmic axes
            yield f"{name}_response", _response(run, name, tables["response"], tables.get("reference"),
                                                _base(transfer) if transfer else "input")
            yield f"{name}_fourier", _fourier(run, name, tables["fourier"])
        if transfer:
            yield f"{name}_transfer", _transfer(run, name, transfer)


def _over_time(run, name, table):
    """Acceleration, velocity, displacement, and the growth of the Arias intensity with its significant duration."""
    figure, axes = plt.subplots(4, 1, sharex=True, figsize=(8.0, 6.6), gridspec_kw={
        "left": 0.11, "right": 0.97, "top": 0.95, "bottom": 0.07, "hspace": 0.24})
    time = table["time_s"]
    for panel, (column, quantity, unit, peak) in zip(axes, (
            ("acceleration_m_per_s2", "acceleration", "m/s²", "pga_m_per_s2"),
            ("velocity_m_per_s", "velocity", "m/s", "pgv_m_per_s"), ("displacement_m", "displacement", "m", "pgd_m"))):
        panel.plot(time, table[column], color=style.BLUE, lw=0.9)
        panel.axhline(0, color=style.GREY, lw=0.4, zorder=0)
        panel.set_ylabel(f"{quantity} [{unit}]")
        top = int(np.argmax(np.abs(table[column])))
        panel.plot(time[top], table[column][top], "o", ms=6, mfc="none", mec=style.RED, mew=1.2,
                   label=f"{run.number(f'{name}_{peak}'):.3g} {unit}" if run.number(f"{name}_{peak}") is not None else None)
        panel.legend(loc="lower right", bbox_to_anchor=(1.0, 0.93), handletextpad=0.2)
    share = table["arias_share"]
    axes[3].plot(time, 100 * share, color=style.BLUE)
    inside = (share >= 0.05) & (share <= 0.95)
    axes[3].fill_between(time, 0, 100, where=inside, color=style.ORANGE, alpha=0.18, lw=0)
    axes[3].text(0.99, 0.08, f"Arias {run.number(f'{name}_arias_m_per_s') or 0:.3g} m/s, 5 to 95 % in "
                 f"{run.number(f'{name}_significant_duration_s') or 0:.3g} s", transform=axes[3].transAxes, ha="right", size=8.5)
    axes[3].set(ylabel="Arias [%]", xlabel="t [s]", xlim=(time[0], time[-1] or 1), ylim=(0, 102))
    axes[0].set_title(f"{run.name}: motion {style.literal(name)}", loc="left")
    figure.align_ylabels()
    return figure


def _base(transfer):
    """Name of the motion to which the ratio of a table of amplification refers."""
    return next(column for column in transfer if column.endswith("_amplitude_m_per_s")).removesuffix("_amplitude_m_per_s")


def _response(run, name, table, reference, name_of_reference):
    """Pseudo acceleration, velocity and displacement over the period, one curve for each damping; dashed, those of the
    motion from which this one came, if it is known."""
    dampings = [column.removeprefix("sd_").removesuffix("pct_m") for column in table if column.startswith("sd_")]
    figure, axes = plt.subplots(1, 3, figsize=(10.5, 3.9), gridspec_kw={
        "left": 0.07, "right": 0.985, "top": 0.9, "bottom": 0.14, "wspace": 0.3})
    for panel, (kind, unit, size, quantity) in zip(axes, (("psa_{}pct_m_per_s2", "g", GRAVITY, "pseudo acceleration"),
                                                          ("sv_{}pct_m_per_s", "m/s", 1, "relative velocity"),
                                                          ("sd_{}pct_m", "m", 1, "relative displacement"))):
        for i, damping in enumerate(dampings):
            panel.loglog(table["period_s"], table[kind.format(damping)] / size, color=COLORS[i % len(COLORS)],
                         label=f"damping {damping} %")
            if reference:
                panel.loglog(reference["period_s"], reference[kind.format(damping)] / size, color=COLORS[i % len(COLORS)],
                             lw=0.9, ls="--", label=f"{style.literal(name_of_reference)}, {damping} %")
        panel.set(xlabel="period [s]", ylabel=f"{quantity} [{unit}]", xlim=(table["period_s"][0], table["period_s"][-1]))
        plain_decades(panel)
    pga = run.number(f"{name}_pga_m_per_s2")
    if pga:
        axes[0].axhline(pga / GRAVITY, color=style.GREY, lw=0.8, ls="--", label="PGA")
    axes[0].legend(loc="lower left")
    axes[0].set_title(f"{run.name}: response spectra of {style.literal(name)}", loc="left")
    return figure


def plain_decades(axes):
    """Labels 1, 2 and 5 of every decade of the logarithmic axes with plain numbers."""
    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() == "log":
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_locator(NullLocator())
    axes.grid(lw=0.3, color="#DDDDDD")


def _fourier(run, name, table):
    figure, axes = plt.subplots(figsize=(7.0, 4.0), gridspec_kw={"left": 0.12, "right": 0.97, "top": 0.9, "bottom": 0.13})
    shown = table["frequency_Hz"] > 0  # earlier releases wrote 0 Hz, too
    frequency, amplitude = table["frequency_Hz"][shown], table["amplitude_m_per_s"][shown]
    axes.loglog(frequency, amplitude, color=style.BLUE, lw=0.8)
    top = np.max(amplitude) or 1
    axes.set(xlabel="frequency [Hz]", ylabel="Fourier amplitude of the acceleration [m/s]", ylim=(1e-5 * top, 2 * top),
             xlim=(frequency[0], frequency[-1]))
    axes.grid(lw=0.3, color="#DDDDDD")
    sampling = run.number("spectra_sampling_interval_s")
    axes.set_title(f"{run.name}: Fourier spectrum of {style.literal(name)}" + (
        f", sampled every {1e3 * sampling:.3g} ms" if sampling else ""), loc="left")
    return figure


def _transfer(run, name, table):
    base = _base(table)
    figure, axes = plt.subplots(figsize=(7.0, 4.0), gridspec_kw={"left": 0.1, "right": 0.97, "top": 0.9, "bottom": 0.13})
    axes.semilogx(table["frequency_Hz"], table["ratio"], color=style.BLUE)
    if np.isfinite(table["ratio"]).any():  # there is no ratio where the base has no motion
        top = int(np.nanargmax(table["ratio"]))
        axes.plot(table["frequency_Hz"][top], table["ratio"][top], "o", ms=6, mfc="none", mec=style.RED, mew=1.2,
                  label=f"{table['ratio'][top]:.3g} at {table['frequency_Hz'][top]:.3g} Hz")
    axes.axhline(1, color=style.GREY, lw=0.6)
    axes.set(xlabel="frequency [Hz]", ylabel="amplification", ylim=(0, None),
             xlim=(table["frequency_Hz"][0], table["frequency_Hz"][-1]))
    plain_decades(axes)
    axes.legend(loc="best", handletextpad=0.2)
    axes.set_title(f"{run.name}: {style.literal(name)} relative to {style.literal(base)}", loc="left")
    return figure
