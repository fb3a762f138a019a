"""Shares as a user writes them."""
import re


def share_of(text):
    """0.05 of `5%` or `0.05`; None where the text is no share between 0 and 1."""
    found = re.fullmatch(r"\s*(\d*\.?\d+|\d+\.)\s*(%?)\s*", text)
    value = float(found[1]) / (100 if found[2] else 1) if found else 0
    return value if 0 < value < 1 else None
