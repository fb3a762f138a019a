"""The reduced variants of cases, as the reference.json of each states them, and what they must agree with."""

import json
import shlex
import subprocess

from programs import ADIT, BUILD, PATIENCE, PATIENCE_S, SOURCE

CASES = SOURCE / "cases"


def contents(case):
    return json.loads((CASES / case / "reference.json").read_text())


def computed(case, folder):
    """Computes the reduced variant of a case below a folder, and returns the run's folder."""
    expected = next(run for run in contents(case)["runs"] if "reduced" in run)
    script, scene, *options = shlex.split(expected["command"])
    assert script == "scripts/run", script
    program = "simplified" if "simplified:" in (SOURCE / scene).read_text() else "coupler"
    done = subprocess.run([BUILD / program / program, "run", SOURCE / scene, "--out", folder / case, *options], capture_output=True,
                          text=True, timeout=280 * PATIENCE)
    assert done.returncode == 0, done.stderr
    return folder / case


def run_reduced(test, case):
    """Computes the reduced variant of a case, checks that it agrees with the reference, and returns its folder."""
    folder = computed(case, test.folder)
    assert_agrees(test, folder, case)
    return folder


def assert_agrees(test, folder, case):
    compared = compare(folder, case)
    test.assertEqual(compared.returncode, 0, compared.stdout + compared.stderr)


def compare(run, case):
    return subprocess.run([*ADIT, "compare", run, "--reference", CASES / case / "reference.json"], capture_output=True,
                          text=True, timeout=PATIENCE_S)
