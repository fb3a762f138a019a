"""docs/trade.md, its pictures, and docs/trade: the results that they are made of.

Results are taken from the folder of `adit trade NAME` where it has computed some, else from docs/trade. So the page can be written again
without computing, and a test can prove that the page in the tree is the one that the template and the results make.
"""
import shutil

from adit import programs
from adit.plots import style
from adit.results.files import Unusable
from adit.trade.ladders import SCENES, TUNNELS
from adit.trade.own.picture import differences_over_cost
from adit.trade.page.places import filled, ladders_of
from adit.trade.page.results import read
from adit.trade.tunnels.picture import findings_over_cost

TEMPLATE = programs.ROOT / "python" / "adit" / "trade" / "page" / "trade.md"
PAGE = programs.ROOT / "docs" / "trade.md"
PICTURES = programs.ROOT / "docs" / "pictures"
PICTURED = ("bar", "longxi", "qingcaosha", "hzm")
STORED = programs.ROOT / "docs" / "trade"


def check_place():
    if programs.INSTALLED:
        raise Unusable("--page writes docs/trade.md of the source tree, and this Adit is installed; use scripts/adit of the tree.")


def missing(computed):
    """Ladders of the page without results, in the folder `computed` or stored."""
    return [name for name in ladders_of(TEMPLATE) if not any((folder / f"{name}.csv").exists() for folder in (computed, STORED))]


def stored():
    """{name: rows}"""
    return {name: read(name, STORED) for name in ladders_of(TEMPLATE)}


def text(results):
    return filled(TEMPLATE, results)


def write(computed):
    """Takes the results of the folder `computed`, and writes page and pictures."""
    STORED.mkdir(exist_ok=True)
    for name in ladders_of(TEMPLATE):
        if (computed / f"{name}.csv").exists():
            read(name, computed)
            shutil.copyfile(computed / f"{name}.csv", STORED / f"{name}.csv")
    results = stored()
    PAGE.write_text(text(results), encoding="utf-8")
    for name in PICTURED:
        style.save(_picture(name, results[name]), PICTURES / f"trade_{name}.png")
    print(f"written: {PAGE}")


def _picture(name, rows):
    if name in TUNNELS:
        return findings_over_cost(TUNNELS[name].ladder(quick=False), rows)
    return differences_over_cost(name, rows, SCENES[name][1])
