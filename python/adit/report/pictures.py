"""Drawings as pictures of the page: narrow enough for a phone, their titles, legends and notes as text."""
import base64
import io

from PIL import Image

from adit.plots import style
from adit.plots.drawing import LEFT, Sheet
from adit.report import curves, legends
from adit.report.markup import image, tag
from adit.report.quantities import digits
from adit.results.rounding import settled

WIDTH = 5.6  # inches: letters of 9 points are readable where the picture fills a phone, and not large where it fills a screen
PANEL = 2.3  # inches: height of panels that stand side by side in a file
BESIDE = 1.5  # inches less, of the height of such panels whose axes have equal scales
DOTS = 200  # per inch, of pictures of the model
LARGEST = 90_000  # bytes of one picture; pictures that need more are drawn with fewer dots
QUALITY = 72  # of WebP
RIGHT, RIGHT_WITH_BAR, BELOW, ABOVE = 0.15, 1.14, 0.48, 0.1  # inches around the axes of a sheet
X_LABEL, Y_LABEL = 0.27, 0.47  # inches from these axes to their labels


def figure(drawing, *below, names_run=False):
    """<figure> with the picture, its title, its legends and the table of its curves; None without a drawing. `names_run`: where
    a page shows several runs."""
    if drawing is None:
        return None
    title = drawing.title[:1].upper() + drawing.title[1:]
    title = f"{drawing.of}: {title}" if names_run else title
    drawn, keys = painted(drawing)
    table = curves.as_table(drawn, title)
    curves.thin(drawn)
    source, width, height = _encoded(drawn, drawing.layout.dense)
    style.plt.close(drawn)
    alt = f"{title}. The legend and the numbers stand below."
    scales = [f"Colours: {f'{each.what} '.lstrip()}{_range(each)} {each.unit}" for each in drawing.colours]
    notes = [tag("p", note, class_="note") for note in (*(text for text, _ in drawing.notes if text), *scales)]
    caption = tag("figcaption", tag("strong", title), legends.written(keys), notes)
    return tag("figure", image(source, alt, width, height, min(100, 100 * width / (96 * WIDTH))), caption, table, below)


def _range(colours):
    low, high = (digits(settled(end, max(abs(colours.low), abs(colours.high)))) for end in (colours.low, colours.high))
    return f"from {low} to {high}"


def painted(drawing):
    """(the drawing as a figure of matplotlib of the page's size, its legends)."""
    return (_sheet if isinstance(drawing.layout, Sheet) else _panels)(drawing)


def _sheet(drawing):
    layout = drawing.layout
    size = layout.size(min(WIDTH, layout.width))
    drawn = style.plt.figure(figsize=(LEFT + size[0] + (RIGHT_WITH_BAR if layout.has_bar else RIGHT), BELOW + size[1] + ABOVE))
    axes, *bar = layout.axes(drawn, BELOW, size)
    axes.xaxis.set_label_coords(0.5, -X_LABEL / size[1])  # at every instant behind a slider
    axes.yaxis.set_label_coords(-Y_LABEL / size[0], 0.5)
    return drawn, drawing.paint(axes, *bar) or []


def _panels(drawing):
    """Panels of one row stand below each other. Margins are as labels need."""
    layout = drawing.layout
    is_row = layout.rows == 1 and layout.columns > 1
    rows, columns = (layout.columns, 1) if is_row else (layout.rows, layout.columns)
    drawn, panels = style.plt.subplots(rows, columns, sharex=layout.sharex and not is_row, sharey=layout.sharey, squeeze=False,
                                       figsize=(WIDTH, layout.size[1]), height_ratios=layout.heights, layout="constrained")
    keys = drawing.paint(*panels.flat) or []
    if is_row:
        for axes in panels.flat:
            axes.set_ylabel(axes.get_ylabel() or panels[0, 0].get_ylabel())
        drawn.set_figheight(rows * (WIDTH - BESIDE if all(axes.get_aspect() == 1 for axes in panels.flat) else PANEL))
    return drawn, keys


def _encoded(drawn, dense):
    """(data URI, width, height in CSS pixels); lines as SVG, many shapes and what would be too large as WebP."""
    width, height = (round(96 * inches) for inches in drawn.get_size_inches())
    if not dense:
        data = _lines(drawn)
        if len(data) <= LARGEST:
            return _uri("image/svg+xml", data), width, height
    return _uri("image/webp", _dots(drawn)), width, height


def _lines(drawn):
    file = io.BytesIO()
    with style.plt.rc_context({"svg.hashsalt": "adit"}):  # the same names inside for the same picture
        drawn.savefig(file, format="svg", metadata={"Date": None})
    return file.getvalue()


def _dots(drawn):
    dots = style.dots(drawn, DOTS)
    while True:
        file = io.BytesIO()
        dots.save(file, "webp", quality=QUALITY, method=2)
        if file.tell() <= LARGEST:
            return file.getvalue()
        dots = dots.resize([int(0.8 * side) for side in dots.size], Image.LANCZOS)


def _uri(kind, data):
    return f"data:{kind};base64,{base64.b64encode(data).decode()}"
