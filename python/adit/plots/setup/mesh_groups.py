"""The physical groups of a Gmsh file (format 4.1, ASCII), which areas of a scene may name."""
from pathlib import Path

import numpy as np

from adit.plots.setup.areas import Group

LINE, QUADRILATERAL = 1, 3  # Gmsh's numbers of the types of elements


def read(path):
    """{name of a physical group, its number where it has none: Group}."""
    sections = _sections(Path(path).read_text().split("\n"))
    names = {}  # (dimension, tag of the group): name
    for line in sections.get("PhysicalNames", ())[1:]:
        dimension, tag, name = line.split(maxsplit=2)
        names[int(dimension), int(tag)] = name.strip('"')
    points = _nodes(sections["Nodes"])
    groups_of = _groups_of_entities(sections["Entities"])
    found = {}  # name: (edges, zones)
    for dimension, entity, corners in _elements(sections["Elements"]):
        for tag in groups_of.get((dimension, entity), ()):
            kinds = found.setdefault(names.get((dimension, tag), str(tag)), ([], []))
            kinds[dimension - 1].append([points[node] for node in corners])
    return {name: Group(np.array(zones).reshape(-1, 4, 2), np.array(edges).reshape(-1, 2, 2)) for name, (edges, zones) in found.items()}


def _sections(lines):
    found, name = {}, None
    for line in lines:
        if line.startswith("$End"):
            name = None
        elif line.startswith("$"):
            name = line.strip()[1:]
            found[name] = []
        elif name:
            found[name].append(line)
    return found


def _groups_of_entities(lines):
    """{(dimension, tag): tags of its groups} of curves and surfaces: tag, box of six numbers, groups, bounding entities."""
    points, curves, surfaces, _ = map(int, lines[0].split())
    rows = [line.split() for line in lines[1 + points:1 + points + curves + surfaces]]
    return {(1 if i < curves else 2, int(row[0])): [abs(int(tag)) for tag in row[8:8 + int(row[7])]] for i, row in enumerate(rows)}


def _nodes(lines):
    """{tag: (x, y)}; each block holds its tags, then their coordinates."""
    points, at = {}, 1
    for _ in range(int(lines[0].split()[0])):
        count = int(lines[at].split()[3])
        tags = lines[at + 1:at + 1 + count]
        places = lines[at + 1 + count:at + 1 + 2 * count]
        points.update((int(tag), tuple(map(float, place.split()[:2]))) for tag, place in zip(tags, places))
        at += 1 + 2 * count
    return points


def _elements(lines):
    """Yields (dimension, entity, corners) of edges and quadrilaterals."""
    at = 1
    for _ in range(int(lines[0].split()[0])):
        dimension, entity, kind, count = map(int, lines[at].split())
        if kind in (LINE, QUADRILATERAL):
            for line in lines[at + 1:at + 1 + count]:
                yield dimension, entity, [int(node) for node in line.split()[1:]]
        at += 1 + count
