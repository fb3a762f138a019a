"""Tunnels whose lining, or the ground beside it, came near its strength, and how far the particles around them must reach."""
import itertools
from dataclasses import dataclass

import numpy as np

from adit.plots.setup.areas import boundary
from adit.results import chains
from adit.results.files import Unusable
from adit.zoom.linings import Tunnel, Use
from adit.zoom.places import ACROSS, MARGIN

ONLY_IN_GRID = ("interface", "layers", "contact", "second_ring")  # keys of a lining
ONLY_IN_FIBRES = ("fibres", "tension_stiffening")  # keys of its concrete
STRUCTURES = ("members", "bolts", "interfaces")


@dataclass
class Reach:
    """What becomes cells: a Tunnel, the Use of its lining, how far the `ground` [m] around the lining goes, the `overlap` [m] included,
    and the flags of the zones near their strength that it holds."""
    tunnel: Tunnel
    use: Use
    ground: float
    overlap: float
    near: np.ndarray

    @property
    def outer(self):
        """The offset of its outline from the inner side [m]."""
        return self.tunnel.thickness + self.ground

    def within(self, points):
        """Flags of the points that the continuum loses."""
        return self.tunnel.contour.away(points) < self.outer - self.overlap


def reaches(run, zones, near, uses, share, kept):
    """[Reach] of the tunnels that need particles. `near`: flags of the zones of ground near their strength; `uses`: [(Tunnel, Use of
    its lining)]; `kept`: flags of the points that belong to the continuum alone."""
    found = []
    for tunnel, use in uses:
        side = _zone(run.scene_as_written["continuum"], tunnel)
        least = (MARGIN + ACROSS) * side
        away = tunnel.contour.away(zones.points)[zones.cells] - tunnel.thickness
        farthest, nearest, reach = away.max(axis=1), away.min(axis=1), 0.0
        while (farther := farthest[near & (nearest < reach + least)].max(initial=0)) > reach:
            reach = farther
        if use.demand < share and reach == 0:
            continue
        _require_possible(run, tunnel)
        room = _room(run, zones, tunnel, kept, [other for other, _ in uses if other is not tunnel], side, least)
        ground = float(f"{min(reach + least, room):.4g}")
        found.append(Reach(tunnel, use, ground, ACROSS * side, near & (nearest < ground)))
    _require_apart(run, zones, found)
    return found


def _zone(continuum, tunnel):
    """The longer side [m] of the equal zones in which a tunnel lies."""
    x, y = tunnel.contour.centre
    rectangles = [(block, block["zones_x"], block["zones_y"]) for block in [continuum.get("block")] if block]
    rectangles += [(block["rectangle"], block["along"]["zones"], block["across"]["zones"])
                   for block in continuum.get("blocks", []) if "rectangle" in block]
    return next(max((box["x_max"] - box["x_min"]) / columns, (box["y_max"] - box["y_min"]) / rows) for box, columns, rows in rectangles
                if box["x_min"] <= x <= box["x_max"] and box["y_min"] <= y <= box["y_max"])


def _room(run, zones, tunnel, kept, others, side, least):
    """How far the particles may reach [m]: up to one zone from what they do not have, and from the boundary of the ground."""
    away = tunnel.contour.away
    outline = zones.points[np.unique(boundary(zones))]
    outline = outline[away(outline) > (1 + 1e-6) * tunnel.thickness]  # without its own opening
    fields = run.fields()
    of_beams = dict(chains.chains(run, fields["linings"])) if "linings" in fields else {}
    own = {name for name, _, _ in tunnel.rings}
    obstacles = [("the edge of the ground", outline), ("what holds, loads or absorbs", zones.points[kept])]
    obstacles += [(f"lining `{name}`", fields["linings"].points[nodes]) for name, nodes in of_beams.items() if name not in own]
    obstacles += [(f"tunnel `{other.name}`", zones.points[zones.cells[other.zones(run, fields["grid"])]].reshape(-1, 2)) for other in others]
    obstacles += [(kind, fields[kind].points) for kind in STRUCTURES if kind in fields]
    what, points = min(((what, points) for what, points in obstacles if len(points)), key=lambda each: away(each[1]).min())
    point, room = points[away(points).argmin()], away(points).min() - tunnel.thickness - side
    if room < (1 - 1e-6) * least:
        raise Unusable(f"{run.folder}: tunnel `{tunnel.name}` needs particles in {least:.4g} m of ground around it, four zones, but at "
                       f"({point[0]:.4g}, {point[1]:.4g}) m, within five, is {what}; give smaller zones, or move it farther away.")
    return room


def _require_possible(run, tunnel):
    """Unusable where the tunnel has what a lining of particles does not."""
    lining, path = tunnel.lining, f"{tunnel.path}.lining"
    keys = [key for key in ONLY_IN_GRID if key in lining]
    keys += [f"section.concrete.{key}" for key in ONLY_IN_FIBRES if key in lining.get("section", {}).get("concrete", {})]
    if keys:
        raise Unusable(f"{run.folder}: tunnel `{tunnel.name}` comes near its strength, but it has {path}.{keys[0]}, "
                       "which particles do not; leave it out and run the scene again.")
    if not tunnel.of_beams and "section" not in lining and "fracture" not in lining["material"]:
        raise Unusable(f"{run.folder}: {path}.material says when its zones fail, but not how cells of it break; give it `fracture` too, "
                       "with tensile_strength, fracture_energy and compressive_strength, and run the scene again.")
    if "scatter" in run.scene["continuum"]:
        raise Unusable(f"{run.folder}: tunnel `{tunnel.name}` comes near its strength, but continuum.scatter would scatter its particles "
                       "as the ground; leave it out.")


def _require_apart(run, zones, found):
    """Unusable where no zone lies between the particles of two tunnels."""
    outside = [(reach.tunnel.contour.away(zones.points) - reach.outer).clip(0) for reach in found]
    for (one, from_one), (other, from_other) in itertools.combinations(zip(found, outside), 2):
        if (from_one + from_other).min() < one.overlap / ACROSS:
            raise Unusable(f"{run.folder}: tunnels `{one.tunnel.name}` and `{other.tunnel.name}` both need particles, which would meet between "
                           f"them ({one.ground:.4g} and {other.ground:.4g} m of ground); give smaller zones, or a larger --demand.")
