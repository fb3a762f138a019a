"""The table: as CSV, and as Markdown for reading."""
import csv

COLUMNS = (  # heading, key, factor, format
    ("family", "family", None, ""), ("variant", "variant", None, ""),
    ("particles", "particles", 1, ",.0f"), ("zones", "zones", 1, ",.0f"),
    ("force L2 [%]", "force_l2", 100, ".2f"), ("peak [%]", "force_peak", 100, "+.2f"),
    ("near L2 [%]", "near_l2", 100, ".2f"), ("peak [%]", "near_peak", 100, "+.2f"),
    ("far L2 [%]", "far_l2", 100, ".2f"), ("peak [%]", "far_peak", 100, "+.2f"),
    ("energy kept", "energy_kept", 1, ".4f"),
    ("particle updates [10⁶]", "particle_updates", 1e-6, ".2f"), ("zone updates [10⁶]", "zone_updates", 1e-6, ".2f"),
    ("CPU [s]", "cpu_s", 1, ".3g"), ("wall [s]", "wall_s", 1, ".3g"))


def write_csv(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0])
        writer.writeheader()
        writer.writerows(rows)


def lines(headings, rows):
    """A table in Markdown, of rows of texts."""
    yield "| " + " | ".join(headings) + " |"
    yield "|" + "---|" * len(headings)
    for row in rows:
        yield "| " + " | ".join(row) + " |"


def markdown(rows):
    return lines([heading for heading, *_ in COLUMNS],
                 ([row[key] if factor is None else f"{factor * row[key]:{text}}" for _, key, factor, text in COLUMNS]
                  for row in rows))
