"""Computes a scene with several values of its keys, as many runs at a time as there are cores, and compares them.

variants.py PROGRAM SCENE --vary KEY=VALUE,VALUE... [--vary ...] [--out DIR] [--no-report] [options of PROGRAM run]
Several --vary make every combination. scripts/run calls it.
"""
import argparse
import os
import re
import subprocess
import sys
import time
from itertools import product
from pathlib import Path

import adit_programs
from adit_studies.coupled_runs import COMPARE, PLOT, REPORT, for_all

BRACKETS = {"[": 1, "{": 1, "]": -1, "}": -1}


class Unclear(Exception):
    """What is to be varied cannot be read; the message is one sentence for the user."""


def values_of(text):
    """(key, [values]) of KEY=VALUE,VALUE…; commas inside brackets belong to a value."""
    key, found, listed = text.partition("=")
    values, depth = [""], 0
    for letter in listed:
        depth += BRACKETS.get(letter, 0)
        if letter == "," and depth == 0:
            values.append("")
        else:
            values[-1] += letter
    values = [value.strip() for value in values]
    if not found or not key.strip() or not all(values):
        raise Unclear(f"--vary `{text}` is not KEY=VALUE,VALUE…; write for example --vary 'time.dt_factor=0.2,0.5'")
    return key.strip(), values


def variants(varied):
    """{name of the folder: settings KEY=VALUE} of every combination."""
    keys, lists = zip(*varied)
    parts = 1
    while len({_end(key, parts) for key in keys}) < len(set(keys)):
        parts += 1
    settings = {}
    for chosen in product(*lists):
        name = ",".join(f"{_end(key, parts)}={value}" for key, value in zip(keys, chosen))
        name = re.sub(r"[^\w.,=+-]+", "_", name)
        if name in settings:
            raise Unclear(f"two variants would lie in the folder {name}; state each value once")
        settings[name] = [f"{key}={value}" for key, value in zip(keys, chosen)]
    return settings


def _end(key, parts):
    """The last parts of a key, which name a variant."""
    return ".".join(key.split(".")[-parts:])


def compute(options, others, folder, settings):
    """Runs, draws and reports one variant; returns (exit code, what the program said about an error)."""
    sets = [word for setting in settings for word in ("--set", setting)]
    threads = () if Path(options.program).name == "simplified" else ("--fdm-threads", "1", "--dem-threads", "1")
    done = subprocess.run([options.program, "run", options.scene, "--out", folder, *threads, *sets, *others],
                          capture_output=True, text=True)
    if done.returncode == 0:
        for script in (PLOT, *(() if options.no_report else (REPORT,))):
            subprocess.run([script, folder], stdout=subprocess.DEVNULL)
    return done.returncode, done.stderr.strip().split("\n")[-1]


def compute_all(options, others):
    """Computes and compares all variants; returns the exit code."""
    chosen = variants([values_of(text) for text in options.vary])
    out = options.out or adit_programs.RUNS / options.scene.resolve().parent.name / f"{options.scene.stem}_variants"
    print(f"run: {len(chosen)} variants of {options.scene}, {min(len(chosen), os.cpu_count())} at a time", flush=True)
    start, codes = time.monotonic(), {}
    for name, (code, said) in for_all(lambda name: compute(options, others, out / name, chosen[name]), chosen):
        codes[name] = code
        told = f"failed (exit code {code}): {said}" if code else "done"
        print(f"  {name}: {told} after {time.monotonic() - start:.1f} s, {len(codes)} of {len(chosen)}", flush=True)
    computed = [out / name for name in chosen if codes[name] == 0]
    if computed:
        print(flush=True)
        subprocess.run([COMPARE, "--out", out, *(("--no-report",) if options.no_report else ()), *computed])
    print(f"\nResults: {out}/")
    return max(codes.values())


def main():
    parser = argparse.ArgumentParser(prog=adit_programs.command("run"), description=__doc__, add_help=False)
    parser.add_argument("program")
    parser.add_argument("scene", type=Path)
    parser.add_argument("--vary", action="append")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--no-report", action="store_true")
    try:
        sys.exit(compute_all(*parser.parse_known_args()))
    except Unclear as reason:
        print(f"{parser.prog}: {reason}.", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
