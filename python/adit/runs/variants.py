"""Computes a scene with several values of its keys, as many runs at a time as there are cores, and compares them.

Several --vary make every combination; keys of one --vary change together: KEY,KEY=VALUE:VALUE,VALUE:VALUE.
"""
import csv
import hashlib
import os
import re
import time
from itertools import product

from adit import programs
from adit.results.files import Unusable
from adit.runs import children
from adit.runs.coupled_runs import for_all

LONGEST = 60  # characters of the name of a folder; longer ones end in a checksum
FEW = 4  # variants that are also drawn separately: drawing takes longer than many runs
TABLE = "variants.csv"
BRACKETS = {"[": 1, "{": 1, "]": -1, "}": -1}


def parted(text, separator):
    """The parts of a text between separators that stand outside of brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += BRACKETS.get(letter, 0)
        if letter == separator and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts]


def values_of(text):
    """(key, [values]) of KEY=VALUE,VALUE…; of keys that change together (KEY,KEY, [VALUE:VALUE, …])."""
    key, found, listed = text.partition("=")
    values = parted(listed, ",")
    if not found or not all([*parted(key, ","), *values]) or not all(all(tied(key, value).values()) for value in values):
        raise Unusable(f"--vary `{text}` is not KEY=VALUE,VALUE… or KEY,KEY=VALUE:VALUE,VALUE:VALUE…; write for example "
                      "--vary 'time.dt_factor=0.2,0.5'.")
    return key.strip(), values


def tied(key, value):
    """{key: value} of keys that change together, an empty value for each that has none or one too many."""
    keys = parted(key, ",")
    values = parted(value, ":") if len(keys) > 1 else [value]
    return dict(zip(keys, values if len(values) == len(keys) else [""] * len(keys)))


def variants(varied):
    """{name of the folder: {key: value}} of every combination."""
    keys = [single for key, _ in varied for single in parted(key, ",")]
    parts = 1
    while len({_end(key, parts) for key in keys}) < len(set(keys)):
        parts += 1
    combinations = [{single: value for (key, _), values in zip(varied, chosen) for single, value in tied(key, values).items()}
                    for chosen in product(*(values for _, values in varied))]
    readable = [_readable(settings, parts) for settings in combinations]
    found = {}
    for name, settings in zip(readable, combinations):
        if settings in found.values():
            raise Unusable(f"two variants would lie in the folder {name}; state each value once.")
        if len(name) > LONGEST or readable.count(name) > 1:
            name = f"{name[:LONGEST - 9].rstrip('._')}_{hashlib.sha256(repr(settings).encode()).hexdigest()[:8]}"
        found[name] = settings
    return found


def _readable(settings, parts):
    """The ends of the keys with their values, of paths the file, without what a folder's name cannot hold."""
    name = ",".join(f"{_end(key, parts)}={value.rpartition('/')[2] or value}" for key, value in settings.items())
    return re.sub(r"[^\w.,=+-]+", "_", name)


def _end(key, parts):
    """The last parts of a key, which name a variant."""
    return ".".join(key.split(".")[-parts:])


def write_table(path, chosen, codes):
    """Writes the folder of each variant, and the exit code of its run."""
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["variant", *next(iter(chosen.values())), "exit_code"])
        writer.writerows([name, *settings.values(), codes[name]] for name, settings in chosen.items())


def compute(program, scene, others, folder, settings, drawn):
    """Runs one variant, draws and reports it by the commands `drawn`; returns (exit code, error text of the program)."""
    sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    threads = () if program.name == "simplified" else ("--fdm-threads", "1", "--dem-threads", "1")
    code, said = children.run([program, "run", scene, "--out", folder, *threads, *sets, *others])
    for name in drawn if code == 0 else ():
        children.run([*programs.own_command(), name, folder])
    return code, said.strip().split("\n")[-1]


def compute_all(program, scene, options, others):
    """Computes and compares all variants of `options.vary`; returns the exit code."""
    children.end_with_this_process()
    chosen = variants([values_of(text) for text in options.vary])
    out = options.out or programs.RUNS / scene.parent.name / f"{scene.stem}_variants"
    try:
        out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise Unusable(f"--out {out} cannot be a folder: {error.strerror}.") from None
    undrawn = [word for word, asked in (("--no-report", options.no_report), ("--no-pictures", options.no_pictures)) if asked]
    drawn = () if options.no_pictures or len(chosen) > FEW else ("plot",) if options.no_report else ("plot", "report")
    print(f"run: {len(chosen)} variants of {os.path.relpath(scene)}, {min(len(chosen), os.cpu_count())} at a time", flush=True)
    start, codes = time.monotonic(), {}
    for name, (code, said) in for_all(lambda name: compute(program, scene, others, out / name, chosen[name], drawn), chosen):
        codes[name] = code
        told = f"failed (exit code {code}): {said}" if code else "done"
        print(f"  {name}: {told} after {time.monotonic() - start:.1f} s, {len(codes)} of {len(chosen)}", flush=True)
    write_table(out / TABLE, chosen, codes)
    computed = [out / name for name in chosen if codes[name] == 0]
    if computed:
        print(flush=True)
        children.run([*programs.own_command(), "compare", "--out", out, *undrawn, *computed], silent=False)
    print(f"\nvariants           {out / TABLE}")
    if len(chosen) > FEW and not options.no_pictures:
        print(f"{len(chosen)} variants are drawn in comparison only; {programs.command('plot')} and "
              f"{programs.command('report')} draw each")
    print(f"Results: {out}/")
    return max(codes.values())
