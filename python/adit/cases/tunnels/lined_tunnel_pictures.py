"""Pictures of cases/lined_tunnel: forces around the ring at rest, and over time under the wave, beside closed forms."""
import numpy as np

from adit.plots import style
from adit.cases.tunnels import lined_tunnel


def around(run):
    """Thrust, moment and shear force around the ring at rest."""
    tunnel, strain = lined_tunnel.Tunnel.of(run), lined_tunnel.far_strain(run)
    thrust, moment, shear = lined_tunnel.full_solution(tunnel)
    angle, *found = lined_tunnel.around(run)
    fine = np.linspace(0, 360, 361)
    cosine, sine = np.cos(2 * np.radians(fine - 45)), np.sin(2 * np.radians(fine - 45))
    figure, panels = style.plt.subplots(1, 3, figsize=(11, 3.8), layout="constrained")
    for axes, values, what, forms in zip(panels, found, ("thrust [kN]", "moment [kN m]", "shear force [kN]"), (
            (("Wang, no slip", -lined_tunnel.wang_thrust(tunnel) * cosine, "-"), ("full solution", -thrust * cosine, ":")),
            (("Penzien, no slip", lined_tunnel.penzien_moment(tunnel) * cosine, "-"),
             ("Wang, full slip", lined_tunnel.wang_moment(tunnel) * cosine, "--"), ("full solution", moment * cosine, ":")),
            (("full solution", shear * sine, ":"),))):
        axes.plot(angle, values / 1e3, "o", ms=3.5, mfc="none", color=style.BLUE, label="computed")
        for (form, curve, look), color in zip(forms[::-1], (style.BLACK, style.RED, style.GREEN)):
            axes.plot(fine, strain * curve / 1e3, look, color=color, label=form)
        axes.set(xlabel="angle from x, counter-clockwise [°]", xlim=(0, 360), xticks=range(0, 361, 45))
        axes.set_title(what, loc="left")
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.2), ncol=2)
    figure.suptitle(f"{run.name}: per metre, around the ring, at a shear strain of {100 * strain:.2g} % far away", x=0.01, ha="left")
    return figure


def over_time(run):
    """Thrust and moment at 45° under the wave."""
    tunnel, strain, h = lined_tunnel.Tunnel.of(run), lined_tunnel.free_strain(run), run.histories
    figure, panels = style.plt.subplots(1, 2, figsize=(9.5, 3.8), layout="constrained")
    for axes, column, what, form, amplitude in (
            (panels[0], "pulled_thrust_N", "thrust at 45° [kN]", "Wang, no slip", -lined_tunnel.wang_thrust(tunnel)),
            (panels[1], "pulled_moment_Nm", "moment at 45° [kN m]", "Penzien, no slip", lined_tunnel.penzien_moment(tunnel))):
        axes.plot(h["time_s"], h[column] / 1e3, color=style.BLUE, label="computed")
        axes.plot(h["time_s"], amplitude * strain / 1e3, "--", color=style.RED, label=f"{form} × the free field's strain")
        axes.set(xlabel="t [s]", xlim=(0, h["time_s"][-1]))
        axes.set_title(what, loc="left")
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=2)
    figure.suptitle(f"{run.name}: per metre", x=0.01, ha="left")
    return figure
