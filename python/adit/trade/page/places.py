"""Fills the places of the template:

    {{table LADDER}}       all models of a tunnel: cost, results, differences from the finest
    {{when LADDER ROWS}}   rows `question | model | quantities`: what the model costs and how far these are from the finest
    {{choices}}            the scenes that come with Adit: CPU time and largest difference of each model
    {{minutes}}            CPU time of all models
"""
import re

from adit.results.files import Unusable
from adit.trade.ladders import NAMES, SCENES, TUNNELS
from adit.trade.own.rows import computed, finest
from adit.trade.table import lines
from adit.trade.tunnels import ladder

PLACE = re.compile(r"\{\{(\w+)[ ]?(\w*)(.*?)\}\}", re.S)


def filled(template, results):
    """The text of the template with `results`, {name: rows}. Raises Unusable where a place names what is not there."""
    def fill(place):
        kind, name, body = place.groups()
        try:
            return _fill(kind, name, body, results)
        except Unusable as fault:
            raise Unusable(f"{template}: `{f'{kind} {name}'.strip()}`: {fault}") from None

    return PLACE.sub(fill, template.read_text(encoding="utf-8"))


def ladders_of(template):
    """Names of the ladders that the template shows."""
    named = {name for _, name, _ in PLACE.findall(template.read_text(encoding="utf-8"))}
    return [name for name in NAMES if name in SCENES or name in named]


def _fill(kind, name, body, results):
    known = {"choices": choices, "minutes": minutes}
    of_tunnel = {"table": table, "when": when}
    if kind in known:
        return known[kind](results)
    if kind not in of_tunnel:
        raise Unusable(f"there is no such place; the places are {', '.join([*of_tunnel, *known])}.")
    if name not in TUNNELS:
        raise Unusable(f"there is no such ladder; the ladders are {', '.join(TUNNELS)}.")
    return of_tunnel[kind](TUNNELS[name].ladder(quick=False), results[name], body)


def table(steps, rows, _):
    return "\n".join(ladder.markdown(steps, rows))


def when(steps, rows, body):
    asked = [[word.strip() for word in line.split("|")] for line in body.strip().splitlines()]
    return "\n".join(lines(["question", "model", "CPU [s]", "difference from the finest"], (_answer(steps, rows, words) for words in asked)))


def _answer(steps, rows, words):
    if len(words) != 3:
        raise Unusable(f"`{' | '.join(words)}` is no row `question | model | quantities`.")
    question, model, keys = words
    row = _named(model, {row["model"]: row for row in rows}, "model")
    quantities = {quantity.key: quantity for quantity in steps.quantities}
    told = [_difference(_named(key.strip(), quantities, "quantity"), row) for key in keys.split(",")]
    return [question, model, _seconds(row), "the finest model" if row is rows[-1] else ", ".join(told)]


def _named(name, known, what):
    if name not in known:
        raise Unusable(f"there is no {what} `{name}`; there are {', '.join(known)}.")
    return known[name]


def _seconds(row):
    return f"{row['cpu_s']:.{0 if row['cpu_s'] >= 10 else 1 if row['cpu_s'] >= 1 else 2}f}"


def _difference(quantity, row):
    error = row[f"{quantity.key} error"]
    if error is None:
        raise Unusable(f"`{row['model']}` has no difference of `{quantity.key}`; name another quantity.")
    return f"{quantity.heading.split(' [')[0]} {round(100 * error):+d} %"


def choices(results):
    longest_first = sorted(SCENES, key=lambda name: -len(results[name]))
    every = [row for name in longest_first for row in computed(results[name])]
    dimensions = list(dict.fromkeys(row["dimension"] for row in every))
    models = dict.fromkeys(row["model"] for row in sorted(every, key=lambda row: (dimensions.index(row["dimension"]), row["level"])))
    headings = [f"{name}: {what}" for name in SCENES for what in ("CPU [s]", "off by [%]")]
    rows = ([model, *(cell for name in SCENES for cell in _choice(name, model, results[name]))] for model in models)
    return "\n".join(lines(["model", *headings], rows))


def _choice(name, model, rows):
    """CPU time, and the largest difference of an answer from the finest."""
    row = next((row for row in computed(rows) if row["model"] == model), None)
    if row is None:
        return "–", "–"
    largest = max(abs(row[f"{question} difference"]) for question in SCENES[name][1])
    return _seconds(row), "finest" if row is finest(rows) else f"{100 * largest:.2g}"


def minutes(results):
    return f"{sum(row['cpu_s'] or 0 for rows in results.values() for row in rows) / 60:.0f}"
