"""Pictures of the laboratory tests on cemented discs."""
import numpy as np
from matplotlib.collections import EllipseCollection, LineCollection
from matplotlib.lines import Line2D

from adit.plots import style
from adit.plots.drawing import Drawing, Panels, Sheet, legend
from adit.plots.model_pictures import DISC_EDGE, DISC_FACE


def curves(rock):
    """Stress over the gauges' strains in compression; stress and number of cracks over the platens' approach, both tests."""
    test = rock.compression
    risen = slice(0, test.peak + 1)

    def paint(left, middle, right):
        left.plot(1e3 * test.axial[risen], test.stress[risen] / 1e6, color=style.BLUE, label="axial")
        left.plot(-1e3 * test.lateral[risen], test.stress[risen] / 1e6, color=style.GREEN, label="lateral")
        left.set(xlabel="strain of the gauges [10⁻³]", ylabel="axial stress [MPa]", title="compression until the peak",
                 ylim=(0, None))
        _with_cracks(middle, test, "axial stress [MPa]", "uniaxial compression")
        _with_cracks(right, rock.brazilian, "2P/πD [MPa]", "Brazilian disc")
        return [legend(left, loc="upper center")]

    return Drawing("", "Stress in both tests", Panels(1, 3, (10.5, 3.4), title_above=True), paint)


def _with_cracks(axes, test, label, title):
    axes.plot(1e3 * test.approach, test.stress / 1e6, color=style.BLUE)
    axes.set(xlabel="approach of the platens [mm]", ylabel=label, title=title, ylim=(0, None),
             xlim=(0, min(2 * 1e3 * test.approach[test.peak], 1e3 * test.approach[-1])))
    count = axes.twinx()
    times = np.sort(test.run.cracks["time_s"])
    count.plot(1e3 * test.approach, np.searchsorted(times, test.run.histories["time_s"]), color=style.RED, lw=0.9)
    count.set_ylabel("cracks", color=style.RED)
    count.set_ylim(0, None)
    count.spines["right"].set_visible(True)


def cracked(test, title):
    """The discs, and the cracks until shortly after the peak as lines at the places where they opened."""
    _, pieces = next(test.run.snapshots())
    particles = pieces["particles"]
    size = 2 * particles.field("radius_m")
    end = test.run.histories["time_s"][min(int(1.15 * test.peak), len(test.stress) - 1)]
    cracks = test.run.cracks
    soon = cracks["time_s"] <= end

    def paint(axes):
        axes.add_collection(EllipseCollection(size, size, np.zeros_like(size), units="xy", offsets=particles.points,
                                              offset_transform=axes.transData, fc=DISC_FACE, ec=DISC_EDGE, lw=0.2))
        handles = []
        for mode, color in (("tensile", style.RED), ("shear", style.BLUE)):
            chosen = soon & (cracks["mode"] == mode)
            along = np.column_stack([np.cos(cracks["orientation_rad"][chosen]), np.sin(cracks["orientation_rad"][chosen])])
            middle = np.column_stack([cracks["x_m"][chosen], cracks["y_m"][chosen]])
            half = cracks["length_m"][chosen, None] / 2 * along
            axes.add_collection(LineCollection(np.stack([middle - half, middle + half], axis=1), color=color, lw=1.6))
            handles.append(Line2D([], [], color=color, lw=1.6, label=f"{chosen.sum()} {mode} cracks"))
        return [legend(None, handles)]

    bounds = style.bounds_of(particles.points - size[:, None] / 2, particles.points + size[:, None] / 2)
    return Drawing("", title, Sheet(bounds, width=5.0), paint)
