"""Pieces of HTML. Every text is escaped unless it is Markup already, so that no name of a scene can become a tag."""
from html import escape


class Markup(str):
    """Text that is HTML."""


def safe(content):
    """Content as HTML: texts escaped, iterables joined, an empty text for None."""
    if content is None:
        return Markup()
    if isinstance(content, Markup):
        return content
    if isinstance(content, (str, int, float)):
        return Markup(escape(str(content)))
    return Markup("".join(map(safe, content)))


def tag(name, *content, **attributes):
    """<name attributes>content</name>; `class_` and `data_key` stand for class and data-key, False leaves one out."""
    written = "".join(
        f" {key.rstrip('_').replace('_', '-')}" + ("" if value is True else f'="{escape(str(value))}"')
        for key, value in attributes.items() if value is not None and value is not False)
    return Markup(f"<{name}{written}>{safe(content)}</{name}>")


def image(source, alt, width, height, share):
    """A picture that fills this share [%] of a narrow page."""
    return Markup(f'<img src="{source}" alt="{escape(alt)}" width="{width}" height="{height}" style="--share: {share:.0f}">')


def section(name, title, *content):
    """A chapter of the page; None without content."""
    content = [part for part in content if part]
    if not content:
        return None
    return tag("section", tag("h2", title, id=f"{name}-title"), content, id=name, aria_labelledby=f"{name}-title")


def details(summary, *content, **attributes):
    return tag("details", tag("summary", summary), content, **attributes)


def paragraphs(sentences):
    return [tag("p", sentence) for sentence in sentences if sentence]


def bullets(items, **attributes):
    return tag("ul", [tag("li", item) for item in items], **attributes) if items else None


def table(caption, head, rows):
    """A table whose first column names the rows. Wide tables scroll inside their own box."""
    if not rows:
        return None
    header = tag("thead", tag("tr", [tag("th", cell, scope="col") for cell in head])) if head else None
    body = tag("tbody", [tag("tr", tag("th", row[0], scope="row"), [_cell(cell) for cell in row[1:]]) for row in rows])
    return tag("div", tag("table", tag("caption", caption), header, body),
               class_="table", tabindex=0, role="region", aria_label=f"table: {caption}")


def _cell(content):
    return content if isinstance(content, Markup) and content.startswith("<td") else tag("td", content)
