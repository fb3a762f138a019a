"""The programs under test, and how the tests start and stop them."""

import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

BUILD = pathlib.Path(os.environ["ADIT_BUILD"])
SOURCE = pathlib.Path(os.environ["ADIT_SOURCE"])
sys.path[:0] = [str(SOURCE / "python"), str(SOURCE / "tools")]  # the package `adit`, and what measures other codes and networks
ADIT = [str(SOURCE / "scripts" / "adit")]  # the command, whose name follows
COUPLER = BUILD / "coupler" / "coupler"
CASE = SOURCE / "cases" / "cantilever"
PATIENCE = int(os.environ.get("ADIT_PATIENCE", 1))  # how many times as long as those of a plain build programs may take
PATIENCE_S = 60 * PATIENCE

# A sanitizer reserves terabytes, and needs files and threads of its own where it looks for leaks.
counts_resources = unittest.skipIf(os.environ.get("ADIT_SANITIZE"), "a sanitizer takes memory, files and threads of its own")


class Listening:
    """A program that listens, started by its command."""

    def __init__(self, command):
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        match = re.fullmatch(r"listening on (\S+)\n", line)
        if not match:
            raise RuntimeError(f"{command}: {line!r} {self.process.stderr.read()}")
        self.address = match.group(1)

    def end(self):
        self.process.kill()
        self.process.communicate()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()


class Server(Listening):
    """A server of ours, on a port of its choice."""

    def __init__(self, program, listen="127.0.0.1:0", *options):
        super().__init__([BUILD / program / program, "--listen", listen, *options])


def children_of(pid):
    """Process ids of what the threads of a process have started; none where it has ended."""
    try:
        return [int(child) for task in pathlib.Path(f"/proc/{pid}/task").iterdir() for child in (task / "children").read_text().split()]
    except OSError:
        return []


def wait_until(condition, patience=30 * PATIENCE):
    end = time.monotonic() + patience
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError
        time.sleep(0.02)


def coupler(*arguments, timeout=PATIENCE_S):
    return subprocess.run([COUPLER, *map(str, arguments)], capture_output=True, text=True, timeout=timeout)


def columns(run):
    """The values of histories.csv, by the names of their columns."""
    with open(run / "histories.csv", newline="") as file:
        names, *rows = csv.reader(file)
    return dict(zip(names, zip(*[[float(value) for value in row] for row in rows])))


def cracks(run):
    """Step, kind and ends of each broken bond."""
    with open(run / "cracks.csv", newline="") as file:
        return [(row["step"], row["mode"], row["parent_a"], row["parent_b"], row["group"]) for row in csv.DictReader(file)]


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="adit_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def scene(self, text, name="scene.yaml"):
        path = self.folder / name
        path.write_text(text)
        return path

    @classmethod
    def folder_for_all(cls):
        """A folder for what all tests of a class read and none changes."""
        folder = pathlib.Path(tempfile.mkdtemp(prefix="adit_"))
        cls.addClassCleanup(shutil.rmtree, folder)
        return folder

    def run_scene(self, scene, *arguments, out="run", timeout=PATIENCE_S):
        result = coupler("run", scene, "--out", self.folder / out, *arguments, timeout=timeout)
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.folder / out

    @staticmethod
    def summary(run):
        return json.loads((run / "summary.json").read_text())

    def assert_one_line(self, stderr):
        """One line is said, beside those that tell of a long set-up where a machine is slow."""
        self.assertEqual(len([line for line in stderr.splitlines() if not line.endswith(" so far)")]), 1, stderr)

    def assert_whole_rows(self, run, more_than=0):
        text = (run / "histories.csv").read_text()
        self.assertTrue(text.endswith("\n"))
        names, *rows = csv.reader(text.splitlines())
        self.assertGreater(len(rows), more_than)
        self.assertEqual({len(row) for row in rows}, {len(names)})

    def assert_same_histories(self, own, other, tolerance):
        """All rows of two runs within a tolerance of each column's largest value."""
        ours, theirs = columns(own), columns(other)
        self.assertEqual(ours.keys(), theirs.keys())
        worst = 0
        for name in ours.keys() - {"energy_drift"}:  # which is rounding itself
            largest = max(map(abs, ours[name]))
            apart = max(abs(a - b) for a, b in zip(ours[name], theirs[name], strict=True))
            self.assertLessEqual(apart, tolerance * largest, name)
            worst = max(worst, apart / largest if largest else 0)
        print(f"within {worst:.2g} of the largest value")
