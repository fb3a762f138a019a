"""Numbers with units and sentences, as an engineer writes them; the unit follows from the name of a figure in summary.json."""
import math

from adit.report.markup import tag
from adit.results.rounding import coordinate

# Endings of the names in summary.json and of columns, the longest first.
ENDINGS = (("_m_per_s2", "m/s²"), ("_m_per_s", "m/s"), ("_N_m", "N m"), ("_Nm", "N m"), ("_bytes", "B"), ("_per_s", "1/s"),
           ("_rad", "rad"), ("_Hz", "Hz"), ("_Pa", "Pa"), ("_N", "N"), ("_J", "J"), ("_s", "s"), ("_m", "m"))
PREFIXES = (("G", 1e9), ("M", 1e6), ("k", 1e3), ("", 1), ("m", 1e-3), ("µ", 1e-6))
LARGE = {"N", "N m", "Pa", "J", "B", "N/m", "Pa/m", "N m/rad"}  # units that take prefixes above 1
SMALL = {"m", "s", "rad"}  # and below 1
SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def unit_of(name):
    return next((unit for ending, unit in ENDINGS if name.endswith(ending)), "")


def quantity(value, unit=""):
    """Four digits with the unit, such as 14.97 MN; a dash for None."""
    if value is None:
        return "–"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int) and not unit:
        return f"{value:,}"
    if not isinstance(value, (int, float)) or not math.isfinite(value):
        return str(value)
    symbol, size = prefix(abs(value), unit)
    return f"{digits(value / size)} {symbol}{unit}".strip()


def figure(summary, key):
    """A table cell with a figure of the summary, marked with its name there."""
    value = number_of(summary, key)
    return tag("td", quantity(value, unit_of(key)), data_key=key, class_=None if isinstance(value, str) else "number")


def number_of(summary, key):
    """A figure of the summary; of a coordinate, 0 where it is rounding beside the other one of its place."""
    value = summary.get(key)
    for axis, other in (("_x_m", "_y_m"), ("_y_m", "_x_m")):
        if key.endswith(axis) and isinstance(value, (int, float)):
            return coordinate(value, summary.get(key.removesuffix(axis) + other) or 0)
    return value


def place(x, y):
    return f"x = {quantity(coordinate(x, y), 'm')}, y = {quantity(coordinate(y, x), 'm')}"


def sentence(text):
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".")


def prefix(size, unit):
    """(prefix, its factor) with which an engineer writes a quantity of this size in this unit."""
    for symbol, factor in PREFIXES:
        usable = factor == 1 or (factor > 1 and unit in LARGE) or (factor < 1 and unit in SMALL)
        if usable and size >= factor:
            return symbol, factor
    return "", 1


def digits(value):
    if value == 0:
        return "0"
    if 1e-3 <= abs(value) < 1e6:
        text = f"{value:,.4g}" if abs(value) < 1e4 else f"{value:,.0f}"
        return text.replace("-", "−")
    mantissa, exponent = f"{value:.3e}".split("e")
    mantissa = mantissa.rstrip("0").rstrip(".").replace("-", "−")
    return f"{mantissa} × 10{str(int(exponent)).translate(SUPERSCRIPTS)}"
