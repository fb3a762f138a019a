"""The pictures and the table that a comparison leaves in a folder."""
from PIL import Image

from adit.compare import bonds, differences, overlays
from adit.plots import style
from adit.plots.cores import on_all_cores
from adit.plots.instants import MOST, spread
from adit.report import motions

DOTS = 150  # per inch, of pictures joined from those of the runs


def write(title, runs, folder, with_pictures=True):
    """Writes figures.csv and the pictures into the folder, in place of those of an earlier comparison."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.png"):
        old.unlink()
    differences.write(folder / "figures.csv", runs)
    if not with_pictures:
        return
    for name, figure in _drawn(title, runs):
        style.save(figure, folder / f"{name}.png")
    runs = bonds.with_bonds(runs)
    common = bonds.common_instants(runs) if len(runs) > 1 else []
    chosen = spread(common, MOST, [piece for run in runs for piece in run.last_pieces.values()]) if common else []

    def side_by_side(n):
        time, numbers = chosen[n]
        for view in (bonds.force_chains, bonds.bonds):
            figures = [each for each in view(runs, numbers) if each]
            if figures:
                joined(figures, folder / f"{view.__name__}_{style.milliseconds(time)}ms.png")

    list(on_all_cores(side_by_side, len(chosen)))


def _drawn(title, runs):
    for quantity, what in overlays.shared_histories(runs).items():
        yield quantity.replace(" ", "_"), overlays.histories(title, quantity, *what)
    yield from overlays.envelopes(title, runs)
    cracks, found = overlays.cracks(title, runs), overlays.shared_motions(runs)
    if cracks:
        yield "cracks", cracks
    if found:
        yield "motions", motions.picture(found)


def joined(figures, path):
    """Writes figures into one picture: wide ones below each other, tall ones side by side."""
    drawn = [style.dots(figure, DOTS) for figure in figures]
    wide = all(image.width > 1.4 * image.height for image in drawn)
    size = ((max(i.width for i in drawn), sum(i.height for i in drawn)) if wide
            else (sum(i.width for i in drawn), max(i.height for i in drawn)))
    whole, at = Image.new("RGB", size, "white"), 0
    for image in drawn:
        whole.paste(image, (0, at) if wide else (at, 0))
        at += image.height if wide else image.width
    whole.save(path, compress_level=style.COMPRESSION)
