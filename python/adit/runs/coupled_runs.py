"""Runs scenes with the coupler: those of a case one by one, those of a study as many at a time as there are cores."""
import argparse
import json
import os
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from adit import programs
from adit import Run


class Failed(Exception):
    """A scene could not be computed; the message is one sentence for the user."""


def run(scene, folder):
    """Computes a scene, given as a dictionary, and returns its Run in `folder`, emptied first."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.parent.mkdir(parents=True, exist_ok=True)
    file = folder.parent / f"{folder.name}.yaml"
    file.write_text(json.dumps(scene))  # JSON is YAML
    done = subprocess.run([programs.program("coupler"), "run", file, "--out", folder], capture_output=True, text=True)
    if done.returncode != 0:
        raise Failed(f"{file} failed (exit code {done.returncode}): {done.stderr.strip()}")
    file.unlink()  # the folder has the scene as it was computed
    return Run(folder)


def run_case(case, names, usage):
    """Runs and draws scenes of a case with the options on the command line; returns (folder of the results, [Run])."""
    parser = argparse.ArgumentParser(description=usage, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", metavar="DIR", type=Path, default=programs.RUNS / case.name, help="folder of the results")
    parser.add_argument("--no-report", action="store_true", help="write no report.html")
    options, others = parser.parse_known_args()
    folders = [options.out / name for name in names]
    for name, folder in zip(names, folders):
        scene = case / f"{name}.yaml"
        print(f"run: {os.path.relpath(scene)}", flush=True)
        compute = [programs.program("coupler"), "run", scene, "--out", folder, *others]
        for command in (compute, [*programs.own_command(), "plot", folder]):
            done = subprocess.run(command)
            if done.returncode != 0:
                sys.exit(done.returncode)
    if not options.no_report:
        subprocess.run([*programs.own_command(), "report", *folders])
        subprocess.run([*programs.own_command(), "compare", *folders])
    return options.out, [Run(folder) for folder in folders]


def for_all(function, cases):
    """Yields (case, function(case)) as they are done."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        pending = {pool.submit(function, case): case for case in cases}
        try:
            for future in as_completed(pending):
                yield pending[future], future.result()
        finally:
            pool.shutdown(cancel_futures=True)


def last(run, column):
    return run.histories[column][-1]


def energy(run, side):
    """Kinetic and strain energy [J] of a side of the model at the end."""
    return last(run, f"{side}_kinetic_J") + last(run, f"{side}_strain_J")


def shares(run, source, remainder=0.0):
    """Shares (reflected, transmitted, lost) of the energy that a source on one side sent, without a static remainder."""
    far = {"particles": "continuum", "continuum": "particles"}[source]
    incident = last(run, f"{source}_external_work_J") - remainder
    reflected, transmitted = (energy(run, source) - remainder) / incident, energy(run, far) / incident
    return reflected, transmitted, 1 - reflected - transmitted
