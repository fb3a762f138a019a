"""The pages that users follow, taken apart: scene files, commands, and the output that the page states for them.

A page marks what it shows by the language of the fenced block:
    yaml     a scene file; its first line names it: `# bar.yaml`
    sh       commands that a reader types, in the folder of these files
    text     what the commands above print, a line for each line of the output that matters; `…` stands for anything
    console  commands that are not run here, such as those for another machine
"""

import dataclasses
import os
import re

FENCE = re.compile(r"^(```+)(\w*)\n(.*?)^\1\n", re.MULTILINE | re.DOTALL)
HEADING = re.compile(r"^## (.*)$", re.MULTILINE)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
ANOTHER_COMPILER = 0.02  # of a number, where the programs are built for a sanitizer: its compiler rounds otherwise


@dataclasses.dataclass
class Step:
    commands: str
    stated: str = ""


def blocks(text):
    """(language, content) of every fenced block."""
    return [(match[2], match[3]) for match in FENCE.finditer(text)]


def files(text):
    """Scene files by name."""
    found = {}
    for language, content in blocks(text):
        if language != "yaml":
            continue
        name = re.match(r"# (\S+\.yaml)\n", content)
        if not name:
            raise ValueError(f"a scene without its name in the first line:\n{content}")
        if name[1] in found:
            raise ValueError(f"two scenes are named {name[1]}")
        found[name[1]] = content
    return found


def chapters(text):
    """Steps by the heading of their chapter, in order."""
    starts = [(match.end(), match[1]) for match in HEADING.finditer(text)]
    ends = [match.start() for match in HEADING.finditer(text)][1:] + [len(text)]
    found = {}
    for (start, title), end in zip(starts, ends):
        steps = []
        for language, content in blocks(text[start:end]):
            if language == "sh":
                steps.append(Step(content))
            elif language == "text":
                steps[-1].stated += content
        if steps:
            found[title] = steps
    return found


def agrees(stated, printed):
    """Whether a printed line says what the page states: the same words, numbers that are the stated ones to their last digit."""
    pieces = [piece.strip() for piece in stated.split("…")]
    pattern = ".*".join(re.escape(" ".join(NUMBER.sub("#", piece).split())) for piece in pieces)
    if "…" not in stated:
        pattern += r"$"
    printed = " ".join(printed.split())
    if not re.match(pattern, NUMBER.sub("#", printed)):
        return False
    if "…" in stated:  # numbers before the first gap
        stated = pieces[0]
    return all(abs(float(found) - float(said)) <= tolerance(said) for said, found in zip(NUMBER.findall(stated), NUMBER.findall(printed)))


def tolerance(said):
    """Half a unit of the last digit of a stated number."""
    mantissa, _, exponent = said.partition("e")
    half = 0.5000001 * 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
    return max(half, ANOTHER_COMPILER * abs(float(said))) if os.environ.get("ADIT_SANITIZE") else half
