"""Joints of the worst places over time: by the beam, and by its unified section."""
from adit.cases.tunnels import plan_joint
from adit.plots import style
from adit.plots.drawing import Drawing, legend
from adit.study import detail
from adit.study.pictures import axes as axis

HEIGHT = 1.6  # inches of a panel
SHOWN = ("opening of the edge", "offset", "axial force", "moment")


def joints(outcome, out):
    """Yields (name, Drawing) of each run that was computed in detail, with a panel for each quantity."""
    for row in outcome.closer:
        if not row["failed"]:
            title = f"{detail.name_of(outcome.study, row)}: {row['joint']} at {row['chainage_m']:g} m over time"
            yield f"detail_{row['run']}", over_time(title, *detail.over_time(out, row))


def over_time(title, beam, section):
    """The Drawing of a joint; beam and section as plan_joint tells them."""
    scaled, label = style.time_axis(beam[0])
    size = scaled[-1] / beam[0][-1]

    def paint(*panels):
        for panel, name in zip(panels, SHOWN):
            of = axis.of_answer(plan_joint.COLUMNS[name], beam[1][name])
            panel.plot(scaled, beam[1][name] / of.size, color=style.BLUE, lw=1.0, label="beam")
            panel.plot(section[0] * size, section[1][name] / of.size, "--", color=style.RED, lw=1.0, label="unified section")
            panel.set_ylabel(of.label)
            panel.grid(**axis.GRID)
        panels[-1].set(xlabel=label, xlim=(scaled[0], scaled[-1]))
        return [legend(panels[0], **axis.BESIDE)]

    return Drawing("", title, axis.rows(len(SHOWN), HEIGHT), paint)
