"""Every figure of the summaries of several runs, with its difference from that of the first run and their ratio."""
import csv
from dataclasses import dataclass

from adit.report.markup import details, table, tag
from adit.report.quantities import digits, number_of, quantity, unit_of
from adit.results.rounding import settled


@dataclass
class Row:
    key: str  # of summary.json
    values: list  # a number for each run, None where it has none

    def differences(self):
        """Differences of the other runs from the first one."""
        first, *others = self.values
        return [None if first is None or value is None else value - first for value in others]

    def ratios(self):
        """Ratios of the other runs to the first one; None if the first has 0."""
        first, *others = self.values
        return [None if not first or value is None else value / first for value in others]


def rows(runs):
    """Figures that at least two runs have and that are not the same in all that have them, in the order of the summaries."""
    for key in dict.fromkeys(key for run in runs for key in run.summary):
        values = [run.number(key) if key in run.figures else None for run in runs]
        found = [value for value in values if value is not None]
        if len(found) > 1 and len(set(found)) > 1:
            yield Row(key, values)


def write(path, runs):
    """A line for each row: the figure, its values, their differences from the first run and their ratios to it."""
    names = [run.name for run in runs]
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["figure", *names, *(f"{name} - {names[0]}" for name in names[1:]),
                         *(f"{name} / {names[0]}" for name in names[1:])])
        for row in rows(runs):
            cells = [row.key, *row.values, *row.differences(), *row.ratios()]
            writer.writerow("" if cell is None else cell for cell in cells)


def chapter(runs):
    """The same rows as a table of the page, closed at first."""
    found = list(rows(runs))
    head = ["figure", runs[0].name]
    for run in runs[1:]:
        head += [run.name, "difference", f"of {runs[0].name}"]
    listed = table(f"What differs in summary.json, with the difference from {runs[0].name} and the ratio to it", head,
                   [(row.key, *_cells(row, runs)) for row in found])
    return details(f"All {len(found)} figures that differ, with differences and ratios", listed) if found else None


def _cells(row, runs):
    row = Row(row.key, [value if value is None else number_of(run.summary, row.key) for run, value in zip(runs, row.values)])
    unit, size = unit_of(row.key), max(abs(value) for value in row.values if value is not None)
    yield _number(quantity(row.values[0], unit))
    for value, difference, ratio in zip(row.values[1:], row.differences(), row.ratios()):
        yield _number(quantity(value, unit))
        difference = difference if difference is None else settled(difference, size)
        yield _number("" if difference is None else f"{'+' if difference > 0 else ''}{quantity(difference, unit)}")
        yield _number("" if ratio is None else digits(ratio))


def _number(text):
    return tag("td", text, class_="number")
