"""The pictures and the table that a comparison leaves in a folder."""
from PIL import Image

from adit.compare import bonds, differences
from adit.plots import png, style
from adit.plots.cores import on_all_cores
from adit.plots.instants import MOST, spread
from adit.report import pictures
from adit.report.instants import Instant

DOTS = 150  # per inch, of pictures joined from those of the runs


def write(runs, folder):
    """Writes figures.csv into the folder, and removes the pictures of an earlier comparison."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.png"):
        old.unlink()
    differences.write(folder / "figures.csv", runs)


def draw(overlaid, folder):
    """Writes what overlays.drawn returned."""
    for drawings in overlaid.values():
        for name, drawing in drawings.items():
            png.write(drawing, folder / f"{name}.png")


def draw_side_by_side(runs, folder, for_page):
    """Writes force chains and bonds of the runs with particles, each in one picture at every instant that all of them have and
    that is drawn. Returns these Instants for the page where it is wanted, and how many instants they have in common."""
    runs = bonds.with_bonds(runs)
    common = bonds.common_instants(runs) if len(runs) > 1 else []
    chosen = spread(common, MOST, [piece for run in runs for piece in run.last_pieces.values()])
    peak = runs[0].number("peak_bond_force_time_s") if runs else None

    def drawn(n):
        time, numbers = chosen[n]
        views = bonds.side_by_side(runs, numbers)
        for name, drawings in views.items():
            joined(drawings, folder / f"{name}_{style.milliseconds(time)}ms.png")
        shown = [pictures.figure(each, names_run=True) for drawings in views.values() for each in drawings] if for_page else []
        return Instant(time, shown, -time if peak is None else abs(time - peak))

    return list(on_all_cores(drawn, len(chosen))), len(common)


def joined(drawings, path):
    """Writes drawings into one picture: wide ones below each other, tall ones side by side."""
    drawn = [style.dots(png.figure(each), DOTS) for each in drawings]
    wide = all(image.width > 1.4 * image.height for image in drawn)
    size = ((max(i.width for i in drawn), sum(i.height for i in drawn)) if wide
            else (sum(i.width for i in drawn), max(i.height for i in drawn)))
    whole, at = Image.new("RGB", size, "white"), 0
    for image in drawn:
        whole.paste(image, (0, at) if wide else (at, 0))
        at += image.height if wide else image.width
    whole.save(path, compress_level=style.COMPRESSION)
