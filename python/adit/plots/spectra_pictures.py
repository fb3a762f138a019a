"""Pictures of the motions of `output.spectra`: time histories, response spectra, Fourier spectra, amplification."""
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator

from adit.plots import style
from adit.plots.drawing import Drawing, Panels, legend

GRAVITY = 9.80665  # [m/s^2]; response spectra of accelerations are drawn in g
COLORS = (style.BLACK, style.RED, style.BLUE, style.GREEN, style.ORANGE, style.PINK, style.SKY)


def motions(run):
    """Yields (name, drawing) for every motion of the run."""
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
    time, share = table["time_s"], table["arias_share"]

    def paint(*axes):
        for panel, (column, quantity, unit, peak) in zip(axes, (
                ("acceleration_m_per_s2", "acceleration", "m/s²", "pga_m_per_s2"),
                ("velocity_m_per_s", "velocity", "m/s", "pgv_m_per_s"), ("displacement_m", "displacement", "m", "pgd_m"))):
            panel.plot(time, table[column], color=style.BLUE, lw=0.9)
            panel.axhline(0, color=style.GREY, lw=0.4, zorder=0)
            panel.set_ylabel(f"{quantity} [{unit}]")
            top = int(np.argmax(np.abs(table[column])))
            panel.plot(time[top], table[column][top], "o", ms=6, mfc="none", mec=style.RED, mew=1.2,
                       label=f"{run.number(f'{name}_{peak}'):.3g} {unit}" if run.number(f"{name}_{peak}") is not None else None)
        inside = (share >= 0.05) & (share <= 0.95)
        axes[3].plot(time, 100 * share, color=style.BLUE)
        axes[3].fill_between(time, 0, 100, where=inside, color=style.ORANGE, alpha=0.18, lw=0)
        axes[3].text(0.99, 0.08, f"Arias {run.number(f'{name}_arias_m_per_s') or 0:.3g} m/s, 5 to 95 % in "
                     f"{run.number(f'{name}_significant_duration_s') or 0:.3g} s", transform=axes[3].transAxes, ha="right", size=8.5)
        axes[3].set(ylabel="Arias [%]", xlabel="t [s]", xlim=(time[0], time[-1] or 1), ylim=(0, 102))
        axes[0].figure.align_ylabels()
        return [legend(panel, loc="lower right", bbox_to_anchor=(1.0, 0.93), handletextpad=0.2) for panel in axes[:3]]

    return Drawing(run.name, f"motion {name}", Panels(4, 1, (8.0, 6.6), sharex=True, margins={
        "left": 0.11, "right": 0.97, "top": 0.95, "bottom": 0.07, "hspace": 0.24}), paint)


def _base(transfer):
    """Name of the motion to which the ratio of a table of amplification refers."""
    return next(column for column in transfer if column.endswith("_amplitude_m_per_s")).removesuffix("_amplitude_m_per_s")


def _response(run, name, table, reference, name_of_reference):
    """Pseudo acceleration, velocity and displacement over the period, one curve for each damping; dashed, those of the
    motion from which this one came, if it is known."""
    dampings = [column.removeprefix("sd_").removesuffix("pct_m") for column in table if column.startswith("sd_")]
    pga = run.number(f"{name}_pga_m_per_s2")

    def paint(*axes):
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
        if pga:
            axes[0].axhline(pga / GRAVITY, color=style.GREY, lw=0.8, ls="--", label="PGA")
        return [legend(axes[0], loc="lower left")]

    return Drawing(run.name, f"response spectra of {name}", Panels(1, 3, (10.5, 3.9), margins={
        "left": 0.07, "right": 0.985, "top": 0.9, "bottom": 0.14, "wspace": 0.3}), paint)


def plain_decades(axes):
    """Labels 1, 2 and 5 of every decade of the logarithmic axes with plain numbers."""
    for axis in (axes.xaxis, axes.yaxis):
        if axis.get_scale() == "log":
            axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
            axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
            axis.set_minor_locator(NullLocator())
    axes.grid(lw=0.3, color="#DDDDDD")


def _fourier(run, name, table):
    shown = table["frequency_Hz"] > 0  # earlier releases wrote 0 Hz, too
    frequency, amplitude = table["frequency_Hz"][shown], table["amplitude_m_per_s"][shown]
    top, sampling = np.max(amplitude) or 1, run.number("spectra_sampling_interval_s")

    def paint(axes):
        axes.loglog(frequency, amplitude, color=style.BLUE, lw=0.8)
        axes.set(xlabel="frequency [Hz]", ylabel="Fourier amplitude of the acceleration [m/s]", ylim=(1e-5 * top, 2 * top),
                 xlim=(frequency[0], frequency[-1]))
        axes.grid(lw=0.3, color="#DDDDDD")

    title = f"Fourier spectrum of {name}" + (f", sampled every {1e3 * sampling:.3g} ms" if sampling else "")
    return Drawing(run.name, title, Panels(1, 1, (7.0, 4.0), margins={"left": 0.12, "right": 0.97, "top": 0.9, "bottom": 0.13}), paint)


def _transfer(run, name, table):
    frequency, ratio = table["frequency_Hz"], table["ratio"]

    def paint(axes):
        axes.semilogx(frequency, ratio, color=style.BLUE)
        if np.isfinite(ratio).any():  # there is no ratio where the base has no motion
            top = int(np.nanargmax(ratio))
            axes.plot(frequency[top], ratio[top], "o", ms=6, mfc="none", mec=style.RED, mew=1.2,
                      label=f"{ratio[top]:.3g} at {frequency[top]:.3g} Hz")
        axes.axhline(1, color=style.GREY, lw=0.6)
        axes.set(xlabel="frequency [Hz]", ylabel="amplification", ylim=(0, None), xlim=(frequency[0], frequency[-1]))
        plain_decades(axes)
        return [legend(axes, loc="best", handletextpad=0.2)]

    return Drawing(run.name, f"{name} relative to {_base(table)}", Panels(1, 1, (7.0, 4.0), margins={
        "left": 0.1, "right": 0.97, "top": 0.9, "bottom": 0.13}), paint)
