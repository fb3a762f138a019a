"""Whether particles in some places see what breaks where there are particles throughout."""
import numpy as np

from adit.plots.setup.areas import inside

REACH = 1.0  # of two cracks of one cluster [m]
FEW = 5  # cracks of a cluster that may be missed


def clusters(places, reach=REACH):
    """[places of each cluster], the largest first: cracks whose middles (n, 2) follow one another within `reach` [m]."""
    left, found = np.ones(len(places), bool), []
    while left.any():
        cluster = np.arange(len(places)) == left.argmax()
        fresh = cluster
        while fresh.any():
            near = np.hypot(*(places[:, None] - places[fresh]).transpose(2, 0, 1)).min(axis=1) <= reach
            fresh = near & left & ~cluster
            cluster = cluster | fresh
        found.append(places[cluster])
        left &= ~cluster
    return sorted(found, key=len, reverse=True)


def cracks(run):
    """The middles (n, 2) of all cracks of a run [m], debonded facets among them."""
    table = run.cracks
    return np.column_stack([table["x_m"], table["y_m"]])


def in_particles(run, places):
    """Whether each place lies where the run has particles alone."""
    scene = run.scene
    rings = scene.get("interfaces") or [scene["interface"]]
    return np.any([inside(ring["overlap"]["around"], places) for ring in rings], axis=0)


def compared(zoomed, throughout):
    """[(number of cracks, middle [m], how many lie in particles of `zoomed`, cracks of `zoomed` within REACH)] of each cluster of
    `throughout` of more than FEW."""
    own = cracks(zoomed)
    rows = []
    for cluster in clusters(cracks(throughout)):
        if len(cluster) > FEW:
            near = (np.hypot(*(own[:, None] - cluster).transpose(2, 0, 1)).min(axis=1) <= REACH).sum() if len(own) else 0
            rows.append((len(cluster), cluster.mean(axis=0), int(in_particles(zoomed, cluster).sum()), int(near)))
    return rows
