"""One change: built, compared with the unchanged code, and tested by the tests that depend on it."""

import concurrent.futures
import dataclasses
import enum
import queue

from . import suite


KINDS = {"unit": (False,), "scripts": (True,), "all": (False, True)}  # whether a test is a script


class Verdict(enum.Enum):
    NOTICED = "noticed"
    UNNOTICED = "unnoticed"
    SAME_CODE = "same code"
    NOT_IN_TESTS = "in no unit test; --tests scripts judges it"
    NOT_COMPILED = "not compiled"


@dataclasses.dataclass
class Result:
    change: object
    verdict: Verdict
    by: str = ""  # the program and test that noticed it


class Bench:
    """A build whose tests pass, and what its files are used for."""

    def __init__(self, build, wanted, times, tests="unit"):
        """`wanted`: files that are to be changed. `times`: suite.Times. `tests`: of KINDS."""
        self._build = build
        build.configure()
        executables = build.executables()
        self._used_by_scripts = [each for each in executables if not each.endswith("_tests")]
        programs = self._programs_for(wanted, executables) if tests != "scripts" else []
        if not build.make(*programs, *(self._used_by_scripts if tests != "unit" else [])):
            raise RuntimeError(f"{build.source} cannot be built without a change; build the project first")
        self._objects = build.objects()
        self._programs = [each for each in suite.programs(build)
                          if each.script in KINDS[tests] and (each.script or each.name in programs)]
        self._inputs = {each.name: build.inputs(each.name) for each in self._programs if not each.script}
        self._started = {each: build.started_by(each, executables) for each in self._inputs}
        made = {each for path in wanted for each in self._objects.get(path, [])}
        made.update(each for started in self._started.values() for each in started)
        self._clean = {target: build.fingerprint(target) for target in made}
        for each in self._programs:
            each.seconds = times.of(each, self._clean.get(each.name))

    # Test programs that contain a file, or one of the folder around it: a header alone is in none.
    def _programs_for(self, wanted, executables):
        tests = [each for each in executables if each.startswith("tests/") and each.endswith("_tests")]
        inputs = {test: self._build.inputs(test) for test in tests}
        folders = set()
        for path in wanted:
            folder = path.rpartition("/")[0]
            while folder and not any(each.startswith(folder + "/") for held in inputs.values() for each in held):
                folder = folder.rpartition("/")[0]
            folders.add(folder + "/")
        return [test for test, held in inputs.items() if any(each.startswith(tuple(folders)) for each in held)]

    def _depending(self, path):
        objects = set(self._objects.get(path, []))
        sources = {each for each, made in self._objects.items() if objects & set(made) and each.endswith(".cpp")}
        return [each for each in self._programs if each.script or sources & self._inputs[each.name]]

    # Whether an object of the changed file differs; None: it cannot be compiled.
    def _differs(self, path):
        for made in self._objects.get(path, []):
            if not self._build.make(made):
                return None
            if self._build.fingerprint(made) != self._clean[made]:
                return True
        return False

    def try_change(self, change):
        if not self._objects.get(change.path):
            return Result(change, Verdict.NOT_IN_TESTS)
        undo = self._build.apply(change)
        try:
            differs = self._differs(change.path)
            if differs is None:
                return Result(change, Verdict.NOT_COMPILED)
            if not differs:
                return Result(change, Verdict.SAME_CODE)
            return self._show_to_tests(change)
        finally:
            undo()

    def _show_to_tests(self, change):
        for program in suite.order(self._depending(change.path), change.path):
            if not self._build.make(*(self._used_by_scripts if program.script else [program.name])):
                return Result(change, Verdict.NOT_COMPILED)
            started = self._started.get(program.name, [])
            if started and all(self._build.fingerprint(each) == self._clean[each] for each in started):
                continue
            outcome = suite.run(program)
            if not outcome.passed:
                return Result(change, Verdict.NOTICED, f"{program.name.rpartition('/')[2]}: {outcome.reason}")
        return Result(change, Verdict.UNNOTICED)


def try_all(benches, changes, tell):
    """Shares the changes among the benches; `tell` hears of each result. Results in the order of the changes."""
    free = queue.SimpleQueue()
    for bench in benches:
        free.put(bench)

    def work(change):
        bench = free.get()
        try:
            result = bench.try_change(change)
        finally:
            free.put(bench)
        tell(result)
        return result

    with concurrent.futures.ThreadPoolExecutor(len(benches)) as pool:
        return list(pool.map(work, changes))
