"""The programs under test, and how the tests start and stop them."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

BUILD = pathlib.Path(os.environ["ADIT_BUILD"])
SOURCE = pathlib.Path(os.environ["ADIT_SOURCE"])
COUPLER = BUILD / "coupler" / "coupler"
CASE = SOURCE / "cases" / "cantilever"
PATIENCE_S = 60


class Server:
    """A server started by hand on a port of its choice."""

    def __init__(self, program, listen="127.0.0.1:0", *options):
        self.process = subprocess.Popen(
            [BUILD / program / program, "--listen", listen, *options],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        match = re.fullmatch(r"listening on (\S+)\n", line)
        if not match:
            raise RuntimeError(f"{program}: {line!r} {self.process.stderr.read()}")
        self.address = match.group(1)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.communicate()


def coupler(*arguments, timeout=PATIENCE_S):
    return subprocess.run([COUPLER, *map(str, arguments)], capture_output=True, text=True, timeout=timeout)


class ProgramTest(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="adit_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def scene(self, text, name="scene.yaml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def run_scene(self, scene, *arguments, out="run"):
        result = coupler("run", scene, "--out", self.folder / out, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return self.folder / out

    @staticmethod
    def summary(run):
        return json.loads((run / "summary.json").read_text())
