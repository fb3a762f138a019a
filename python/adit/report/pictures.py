"""Turns a figure of adit.plots into a picture of the page: narrow enough for a phone, its title and legends as text."""
import base64
import contextlib
import io

from matplotlib.gridspec import GridSpec
from PIL import Image

from adit.plots import style
from adit.report import curves, legends
from adit.report.markup import image, tag
from adit.report.quantities import digits

WIDTH = 5.6  # inches: letters of 9 points are readable where the picture fills a phone, and not large where it fills a screen
PANEL = 2.3  # inches: height of panels that stood side by side
DOTS = 200  # per inch, of pictures of the model
LARGEST = 90_000  # bytes of one picture; pictures that need more are drawn with fewer dots
QUALITY = 72  # of WebP


@contextlib.contextmanager
def narrow():
    """Within it, pictures of the model are drawn as narrow as the page needs."""
    wide, style.WIDTH = style.WIDTH, WIDTH
    try:
        yield
    finally:
        style.WIDTH = wide


def figure(drawn, *below, of_model=False, of_run=None):
    """<figure> with the picture, its title, its legends and the table of its curves; nothing for no figure. `of_run`: the
    name of its run, where a page shows several."""
    if drawn is None:
        return None
    title, notes = _take_title(drawn), _take_notes(drawn)
    title = f"{of_run}: {title}" if of_run else title
    keys = legends.taken_from(drawn)
    table = curves.as_table(drawn, title)
    curves.thin(drawn)
    _fit(drawn)
    source, width, height = _encoded(drawn, of_model)
    style.plt.close(drawn)
    alt = f"{title}. The legend and the numbers stand below."
    told = [tag("p", note, class_="note") for note in notes]
    caption = tag("figcaption", tag("strong", title), legends.written(keys), told)
    return tag("figure", image(source, alt, width, height, min(100, 100 * width / (96 * WIDTH))), caption, table, below)


def _take_title(drawn):
    """The title without the name of the run, which the page tells."""
    if drawn._suptitle:
        text = drawn._suptitle.get_text()
        drawn._suptitle.remove()
        drawn._suptitle = None  # the layout would look for it
    else:
        first = next((axes for axes in drawn.axes if axes.get_title(loc="left")), drawn.axes[0])
        text = first.get_title(loc="left")
        first.set_title("", loc="left")
    text = legends.plain(text.replace("\n", " "))
    text = text.partition(": ")[2] or text
    return text[:1].upper() + text[1:]


def _take_notes(drawn):
    """What is written below a picture, and the range of its colours."""
    notes = [text.get_text() for text in drawn.texts]
    for text in list(drawn.texts):
        text.remove()
    for axes in drawn.axes:
        bar = getattr(axes, "_colorbar", None)
        if bar is not None:
            low, high, label = bar.norm.vmin, bar.norm.vmax, bar.ax.get_ylabel().strip()
            what, _, unit = label.rstrip("]").partition("[")
            notes.append(f"Colours: {what}from {digits(low)} to {digits(high)} {unit}")
    return [legends.plain(note) for note in notes]


def _fit(drawn):
    panels = [axes for axes in drawn.axes if hasattr(axes, "get_subplotspec")]
    if panels:
        _stack(drawn, panels)
    else:
        _crop(drawn)


def _stack(drawn, panels):
    """Puts panels below each other and lets matplotlib find the margins that labels need. Axes that share a panel stay together."""
    places = list(dict.fromkeys(axes.get_subplotspec() for axes in panels))
    height = drawn.get_figheight()
    if places[0].get_gridspec().nrows == 1 and len(places) > 1:
        alike = all(axes.get_aspect() == 1 for axes in panels)
        rows = GridSpec(len(places), 1, figure=drawn)
        for axes in panels:
            axes.set_subplotspec(rows[places.index(axes.get_subplotspec())])
            if axes.yaxis.get_label_position() == "left":
                axes.tick_params(labelleft=True)
                axes.set_ylabel(axes.get_ylabel() or panels[0].get_ylabel())
        height = len(places) * (WIDTH - 1.5 if alike else PANEL)
    drawn.set_size_inches(WIDTH, height)
    drawn.set_layout_engine("constrained")


def _crop(drawn):
    """Cuts off the room that title and legends had."""
    left, right, below, above = 0.65, 0.15, 0.48, 0.1  # inches for the labels of the axes
    beside = 0.75  # for those of a scale of colours
    size = drawn.get_size_inches()
    boxes = [axes.get_position() for axes in drawn.axes]
    x0, y0 = min(b.x0 for b in boxes) * size[0] - left, min(b.y0 for b in boxes) * size[1] - below
    width = max(b.x1 for b in boxes) * size[0] + (beside if len(boxes) > 1 else right) - x0
    height = max(b.y1 for b in boxes) * size[1] + above - y0
    drawn.set_size_inches(width, height)
    for axes, b in zip(drawn.axes, boxes):
        axes.set_position(((b.x0 * size[0] - x0) / width, (b.y0 * size[1] - y0) / height,
                           b.width * size[0] / width, b.height * size[1] / height))


def _encoded(drawn, of_model):
    """(data URI, width, height in CSS pixels); lines as SVG, the model and what would be too large as WebP."""
    width, height = (round(96 * inches) for inches in drawn.get_size_inches())
    if not of_model:
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
