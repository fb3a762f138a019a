"""Careless changes of one line of C++, as a tired programmer makes them, found in the text by rules."""

import dataclasses
import re


@dataclasses.dataclass(frozen=True)
class Change:
    """One line of one file, before and after; `line` counts from 1."""

    path: str
    line: int
    kind: str
    before: str
    after: str

    def __str__(self):
        return f"{self.path}:{self.line}\n  - {self.before.strip()}\n  + {self.after.strip()}"


def _swap(first, second):
    return [(re.escape(first), second), (re.escape(second), first)]


def _other_number(match):
    text = match[0]
    return str(int(text) + 1) if text.isdigit() else f"(0.7 * {text})"


# Text between two brackets that declares nothing.
_WHOLE = r"(?:[^()=;]|[=!<>]=|\((?:[^()]|\([^()]*\))*\))+"

# Kind, pattern, replacement. Code is formatted: operators of two operands stand between blanks, templates' angles do not.
RULES = [
    *(("sign", *swap) for swap in [*_swap(" + ", " - "), *_swap(" += ", " -= ")]),
    ("sign", r"(?<=[(,=] )-(?=[\w(])|(?<=[(\[{])-(?=[\w(])|(?<=return )-(?=[\w(])", ""),
    *(("factor", *swap) for swap in [*_swap(" * ", " / "), *_swap(" *= ", " /= ")]),
    *(("index", *swap) for swap in _swap("[0]", "[1]")),
    ("index", r"(?<=\w)\[(\w+)\]", r"[\1 + 1]"),
    ("index", r" \+ 1\]", "]"),
    ("index", r" - 1\]", "]"),
    *(("index", rf"(?<=[.>\w])\b{a}\b(?!\()|(?<=_){a}\b", b) for a, b in [("x", "y"), ("y", "x"), ("first", "second"),
                                                                        ("second", "first"), ("xx", "yy"), ("yy", "xx")]),
    *(("comparison", rf" {a} ", f" {b} ") for a, b in [("<", "<="), ("<=", "<"), (">", ">="), (">=", ">"), ("==", "!="),
                                                       ("!=", "==")]),
    ("comparison", r"\bmin(?=[(<])", "max"),
    ("comparison", r"\bmax(?=[(<])", "min"),
    *(("condition", *swap) for swap in _swap(" && ", " || ")),
    ("condition", r"\bif \(!", "if ("),
    ("condition", rf"\bif \((?!!)({_WHOLE})\)", r"if (!(\1))"),
    ("condition", r"\btrue\b", "false"),
    ("condition", r"\bfalse\b", "true"),
    ("constant", r"(?<![\w.\"])\d+(?:\.\d+)?(?:e[+-]?\d+)?(?![\w.\"])", _other_number),
]

# Lines that compute nothing, or only for the compiler.
_IDLE = re.compile(r"\s*(#|using |namespace |template|static_assert|friend |class |struct |enum |public:|private:)")


def _blank(match):
    return " " * len(match[0])


def code_of(text):
    """The lines of the text with comments and the inside of strings blanked, so that places stay."""
    text = re.sub(r'R"\w*\(.*?\)\w*"', lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.S)
    text = re.sub(r'"(?:\\.|[^"\\\n])*"|(?<!\w)\'(?:\\.|[^\'\\\n])\'', _blank, text)
    text = re.sub(r"/\*.*?\*/", lambda m: re.sub(r"[^\n]", " ", m[0]), text, flags=re.S)
    return re.sub(r"//[^\n]*", _blank, text).splitlines()


def changes(path, text):
    """All changes of the text that the rules know, in the order of the lines."""
    found = {}
    for number, (line, code) in enumerate(zip(text.splitlines(), code_of(text)), 1):
        if _IDLE.match(code):
            continue
        for kind, pattern, replacement in RULES:
            for match in re.finditer(pattern, code):
                if kind == "sign" and '"' in (line[match.start() - 1], line[match.end():][:1]):
                    continue  # joins texts
                new = replacement(match) if callable(replacement) else match.expand(replacement)
                after = line[:match.start()] + new + line[match.end():]
                if after != line:
                    found.setdefault((number, after), Change(path, number, kind, line, after))
    return sorted(found.values(), key=lambda change: change.line)


def spread(candidates, count, random):
    """So many of the candidates by chance: folder after folder, in each one kind after the other."""
    shelves = {}
    for change in candidates:
        shelves.setdefault(change.path.rpartition("/")[0], {}).setdefault(change.kind, []).append(change)
    for kinds in shelves.values():
        for shelf in kinds.values():
            random.shuffle(shelf)
    chosen, folders = [], list(shelves)
    random.shuffle(folders)
    while folders and len(chosen) < count:
        for folder in list(folders):
            kinds = shelves[folder]
            kind = random.choice(sorted(kinds))
            chosen.append(kinds[kind].pop())
            if not kinds[kind]:
                del kinds[kind]
            if not kinds:
                folders.remove(folder)
    return chosen[:count]
