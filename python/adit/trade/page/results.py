"""Results of a ladder, read again."""
from adit.results.files import Unusable
from adit.trade.ladders import SCENES, TUNNELS
from adit.trade.table import read_csv


def read(name, folder):
    """Rows of NAME.csv. Raises Unusable where they are not those of the models that the ladder has today."""
    path = folder / f"{name}.csv"
    rows = read_csv(path)
    if not (_are_of_tunnel(name, rows) if name in TUNNELS else _are_of_scene(name, rows)):
        raise Unusable(f"{path} holds other models or quantities than {name} has today; compute them with `adit trade {name}`.")
    return rows


def _are_of_tunnel(name, rows):
    ladder = TUNNELS[name].ladder(quick=False)
    return [row["model"] for row in rows] == [rung.name for rung in ladder.rungs] and all(each.key in rows[0] for each in ladder.quantities)


def _are_of_scene(name, rows):
    return all(question in rows[0] for question in SCENES[name][1])
