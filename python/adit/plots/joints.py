"""Joints of particles as the scene states them: of linings, faults, gaskets."""
import math

from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from adit.plots import style

LOOKS = {"open": ("-", "open joint"), "smooth": ((0, (4, 1.5)), "smooth joint"), "bonds": ((0, (1, 1)), "joint with bonds")}


def draw(axes, models):
    """Draws the joints of models, each the part of a scene; returns the handles of the legend."""
    found = {}
    for model in models:
        for joint in model.get("joints", []):
            kind = next((kind for kind in LOOKS if kind in joint), "open")
            found.setdefault(kind, []).append(segment(joint))
        if "ring" in model:
            found.setdefault("bonds" if "joints" in model["ring"] else "open", []).extend(_of_ring(model["ring"]))
    handles = []
    for kind, lines in found.items():
        dashes, what = LOOKS[kind]
        axes.add_collection(LineCollection(lines, color=style.BLACK, lw=1.8, ls=dashes, zorder=4.5))
        handles.append(Line2D([], [], color=style.BLACK, lw=1.8, ls=dashes, label=what))
    return handles


def segment(line):
    """Both ends of a line of the scene."""
    return [(line[end]["x"], line[end]["y"]) for end in ("from", "to")]


def _of_ring(ring):
    for k in range(ring["segments"]):
        angle = ring.get("first_joint", 0) + 2 * math.pi * k / ring["segments"]
        yield [(ring["centre"]["x"] + r * math.cos(angle), ring["centre"]["y"] + r * math.sin(angle))
               for r in (ring["inner_radius"], ring["outer_radius"])]
