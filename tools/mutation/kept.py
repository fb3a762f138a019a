"""The kept changes, tests/mutations.txt: each a file, its line and the replacement.

    coupler/bridging/solves/split.cpp
    - return kDecayOnTheWay * wave_speed / width;
    + return 2 * kDecayOnTheWay * wave_speed / width;

A line is known by its text, never by its number. Where it occurs more than once, the line that follows it is given as
well, after `= `. `#` begins a comment.
"""

from .source import Change


class Stale(Exception):
    """A kept change that no longer fits the code."""


def read(path):
    """(file, line, replacement, line that follows or None) of every change."""
    entries, entry = [], {}
    for text in [*path.read_text().splitlines(), ""]:
        mark, content = text[:2], text[2:].strip()
        if text.startswith("#"):
            continue
        if mark in ("- ", "+ ", "= "):
            entry[mark[0]] = content
        elif text.strip():
            entry = {"file": text.strip()}
        elif entry:
            entries.append((entry["file"], entry["-"], entry["+"], entry.get("=")))
            entry = {}
    return entries


def write(path, changes, root):
    """The changes of today's code as kept ones."""
    entries = []
    for change in changes:
        following = [*(root / change.path).read_text().splitlines(), ""][change.line].strip()
        entries.append(f"{change.path}\n- {change.before.strip()}\n+ {change.after.strip()}\n= {following}\n")
    path.write_text("\n".join(entries))


def _places(text, line, following):
    lines = [each.strip() for each in text.splitlines()] + [""]
    return [i for i, each in enumerate(lines[:-1]) if each == line and (following is None or lines[i + 1] == following)]


def find(root, sources, entry):
    """The change in today's code: in its file, or where the line went when the file was moved. Raises Stale."""
    path, line, replacement, following = entry
    candidates = [path] if path in sources else sources
    found = []
    for each in candidates:
        text = (root / each).read_text()
        found += [(each, text.splitlines(), place) for place in _places(text, line, following)]
    if len(found) != 1:
        where = "nowhere" if not found else f"{len(found)} times"
        raise Stale(f"tests/mutations.txt: the line `{line}` of {path} stands {where} now; write it as it is")
    file, lines, place = found[0]
    before = lines[place]
    indent = before[:len(before) - len(before.lstrip())]
    return Change(file, place + 1, "kept", before, indent + replacement)


def find_all(root, sources, entries):
    """`find` of every entry. Raises Stale with a line for each that no longer fits."""
    found, stale = [], []
    for entry in entries:
        try:
            found.append(find(root, sources, entry))
        except Stale as error:
            stale.append(str(error))
    if stale:
        raise Stale("\n".join(stale))
    return found
