"""The tests of a build: which programs hold them, what these need, and one run of one of them."""

import dataclasses
import json
import os
import re
import signal
import subprocess
import time

_PATIENCE_S = 60  # in addition to ten times the time without a change, because other runs share the machine


@dataclasses.dataclass
class Program:
    """A test program, or a script of integration tests."""

    name: str  # the target, or the test's name
    command: list
    folder: str
    environment: dict
    script: bool
    seconds: float = 0  # without a change


def programs(build, nightly=False):
    """All that ctest knows of a build whose test programs are made."""
    listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=build.binary, check=True, capture_output=True, text=True)
    found = {}
    for test in json.loads(listed.stdout)["tests"]:
        properties = {entry["name"]: entry["value"] for entry in test.get("properties", [])}
        if "command" not in test or ("nightly" in properties.get("LABELS", []) and not nightly):
            continue
        command = test["command"]
        script = not command[0].startswith(str(build.binary))
        name = test["name"] if script else os.path.relpath(command[0], build.binary)
        environment = dict(entry.split("=", 1) for entry in properties.get("ENVIRONMENT", []))
        found.setdefault(name, Program(name, command if script else command[:1], properties["WORKING_DIRECTORY"],
                                       environment, script))
    return list(found.values())


def order(found, path):
    """Those of the file's own program and room first, the quick ones before the slow ones, scripts last."""
    rooms = path.split("/")[:-1]

    def key(program):
        place = program.name.split("/")[:-1]
        shared = sum(room in place for room in rooms)
        return program.script, "unit" not in place, -shared, program.seconds

    return sorted(found, key=key)


@dataclasses.dataclass
class Outcome:
    passed: bool
    reason: str  # the first test that failed
    seconds: float


def run(program):
    """One run up to the first failure; one that takes much longer than it did without a change has failed."""
    environment = {**os.environ, **program.environment, "GTEST_FAIL_FAST": "1", "GTEST_COLOR": "no"}
    limit = _PATIENCE_S + 10 * program.seconds if program.seconds else None
    start = time.monotonic()
    process = subprocess.Popen(program.command, cwd=program.folder, env=environment, text=True, errors="replace",
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
    try:
        output, _ = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return Outcome(False, f"no end after {limit:.0f} s", time.monotonic() - start)
    first = re.search(r"^(?:\[  FAILED  \] (\S+?),?(?: |$)|(?:FAIL|ERROR): (\S+))", output, re.M)
    reason = next((group for group in first.groups() if group), "") if first else f"exit code {process.returncode}"
    return Outcome(process.returncode == 0, reason, time.monotonic() - start)


class Times:
    """Seconds that programs take without a change, in which they must pass; known again while they are as they were."""

    def __init__(self, path):
        self._path, self._now = path, {}
        self._known = json.loads(path.read_text()) if path.exists() else {}

    def of(self, program, fingerprint):
        key = f"{program.name} {fingerprint}"
        if program.name not in self._now and key not in self._known:
            outcome = run(program)
            if not outcome.passed:
                raise RuntimeError(f"{program.name} fails without a change, at {outcome.reason}; mend it first")
            self._known[key] = outcome.seconds
            self._path.write_text(json.dumps(self._known, indent=1))
        return self._now.setdefault(program.name, self._known.get(key))
