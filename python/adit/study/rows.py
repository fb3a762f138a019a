"""Computes one run of a study, wherever: in this process, on a worker of Dask or in a job of Slurm. All share a folder.

A run is known by the hash of its scene. It is computed in a folder of its own and moved to its place at its end, so that whatever is
killed at whatever instant leaves either a whole run or nothing. Runs that begin from the same state at rest share it: the first one
computes it while the others wait for its lock.
"""
import fcntl
import hashlib
import importlib.util
import json
import os
import shutil
import socket
import threading
from contextlib import contextmanager, suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path

from adit.accuracy.runs import answer
from adit.results.files import Unusable
from adit.results.run import Run
from adit.runs import children

ATTEMPTS = 5  # of a run that is killed, or loses a server: what it computes is not at fault
OF_THE_SCENE = (2, 4)  # exit codes: it cannot be computed, it became unstable; they would come again
KEPT = ("summary.json", "histories.csv", "scene.yaml", "answers.json")
END_WITH_PARENT = ("setpriv", "--pdeathsig", "KILL")  # also where the study is killed


@dataclass
class Task:
    """What a worker must know of a run; only texts, numbers, lists and mappings of them."""
    program: str
    scene: str
    settings: dict
    folder: str  # of the study
    hash: str
    statics: str = ""  # of the state at rest that it shares with others; empty where it does not
    release: str = ""  # of the program; runs of another one are computed again
    questions: list = field(default_factory=list)
    functions: dict = field(default_factory=dict)  # {name: file}
    drawn: dict = field(default_factory=dict)
    keep: list = field(default_factory=list)
    options: list = field(default_factory=list)  # further words for the program
    room: str = "runs"  # of the folder

    @property
    def place(self):
        return Path(self.folder) / self.room / self.hash


def compute(task):
    """Computes the run of a Task, given as a mapping, unless it is there; returns what came of it: {"hash", "answers": {name: value}} or
    {"hash", "failed": reason}. "new" tells whether it was computed now, "cpu" [s] what that cost."""
    task = Task(**task)
    with _alone(task.place):  # samples that only differ in what functions are given have one run
        there = found(task)
        return there | {"new": False} if there else _computed(task)


def _computed(task):
    for _ in range(ATTEMPTS):
        shared = _at_rest(task) if task.statics else {"from": None}
        if "failed" in shared:
            return {"hash": task.hash, "new": True} | shared
        with _workplace(task) as work:
            code, reason = _run(task, work, task.settings, shared["from"])
            if code and code not in OF_THE_SCENE:
                continue
            told = {"release": task.release} | ({"failed": reason} if code else {"answers": {}})
            if code == 0:
                with suppress(Unusable):  # which found() tells
                    _answer(task, Run(work), told)  # while all of the run is there
            cpu = _cpu(work)
            _keep(task, work, told)
            return {"new": True, "cpu": cpu} | found(task)
    return {"hash": task.hash, "new": True, "failed": f"ended {ATTEMPTS} times by no fault of its scene, at last so: {reason}"}


def found(task):
    """The same of a run that is there, else None. Answers to new questions are read from what was kept; where one cannot be, the run is
    there and has failed."""
    try:
        told = json.loads((task.place / "answers.json").read_text())
    except (OSError, ValueError):
        return None
    if told["release"] != task.release:
        return None
    if "failed" in told:
        return {"hash": task.hash, "failed": told["failed"]}
    try:
        if _answer(task, Run(task.place), told):
            _write(task.place / "answers.json", told)
    except Unusable as error:
        return {"hash": task.hash, "failed": str(error)}
    return {"hash": task.hash, "answers": {name: told["answers"][name]["value"] for name in (*task.questions, *task.functions)}}


def _answer(task, run, told):
    """Fills in the answers that are not there, or were found in another way; returns whether there were any. Raises Unusable where a
    function of the user fails."""
    sources = _sources(task)
    missing = [name for name, source in sources.items() if told["answers"].get(name, {}).get("source") != source]
    for name in missing:
        value = _of_function(task, name, run) if name in task.functions else answer(run, name)
        told["answers"][name] = {"value": value, "source": sources[name]}
    return bool(missing)


def _sources(task):
    """{name of an answer: how it is found}; a function's answer depends on its text, and on what was drawn."""
    of_functions = {name: hashlib.sha256(Path(file).read_bytes() + json.dumps(task.drawn).encode()).hexdigest()[:16]
                    for name, file in task.functions.items()}
    return {name: "figure" for name in task.questions} | of_functions


_loading = threading.Lock()


def _of_function(task, name, run):
    with _loading:
        spec = importlib.util.spec_from_file_location("answers", task.functions[name])
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
    if not hasattr(module, name):
        raise Unusable(f"{task.functions[name]} has no function {name}(run, drawn); write it there.")
    try:
        return float(getattr(module, name)(run, task.drawn))
    except Exception as error:  # a user's function may raise anything
        raise Unusable(f"{task.functions[name]}: {name}: {type(error).__name__}: {error} (in {run.folder})") from None


def _run(task, out, settings, begin):
    sets = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
    threads = () if task.program.endswith("simplified") else ("--fdm-threads", "1", "--dem-threads", "1")
    begins = ["--from", begin] if begin else []
    code, said = children.run([*END_WITH_PARENT, task.program, "run", task.scene, "--out", out, *threads, *begins, *task.options, *sets])
    return code, (said.strip() or "it said nothing").splitlines()[-1].removeprefix("error: ")


def _at_rest(task):
    """{"from": the folder of the state at rest that runs share}; computed if it is not there. {"failed": reason} where it cannot be."""
    place = Path(task.folder) / "rest" / task.statics
    with _alone(place):
        if not place.exists():
            with _workplace(task) as work:
                # Short, and without what the run puts out: a state at rest does not depend on that.
                code, reason = _run(task, work, task.settings | {"time.duration": "1 ms", "output": "{checkpoint: {}}"}, None)
                if code:
                    return {"failed": f"at rest: {reason}"} if code in OF_THE_SCENE else {"from": None}
                place.parent.mkdir(exist_ok=True)
                os.rename(work, place)
    return {"from": str(place)}


@contextmanager
def _alone(place):
    """One worker at a time is here for a folder; the lock of one that is killed is free."""
    locks = place.parents[1] / "locks"
    locks.mkdir(parents=True, exist_ok=True)
    with open(locks / place.name, "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@contextmanager
def _workplace(task):
    """A folder for one attempt, gone afterwards."""
    work = Path(task.folder) / "work" / f"{task.hash}.{socket.gethostname()}.{os.getpid()}.{threading.get_ident()}"
    work.parent.mkdir(parents=True, exist_ok=True)
    try:
        yield work
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _keep(task, work, told):
    """Moves what is kept of a run to its place."""
    work.mkdir(exist_ok=True)
    _write(work / "answers.json", told)
    for path in work.iterdir():
        if path.name not in KEPT and path.name not in task.keep:
            shutil.rmtree(path) if path.is_dir() else path.unlink()
    task.place.parent.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(task.place, ignore_errors=True)  # of another release
    os.rename(work, task.place)


def _cpu(work):
    """CPU time [s] of all processes of the run; 0 where it failed."""
    try:
        summary = json.loads((work / "summary.json").read_text())
    except OSError:
        return 0.0
    return sum(value for key, value in summary.items() if key.endswith("_cpu_s") and isinstance(value, (int, float)))


def _write(path, told):
    written = path.with_name(f"{path.name}.{os.getpid()}.{threading.get_ident()}")
    written.write_text(json.dumps(told))
    written.replace(path)


def task_of(study, row, folder, program, release, shares_rest):
    """The Task of a row, as a mapping."""
    return asdict(Task(str(program), str(study.scene), study.set | row.settings, str(folder), row.hash, row.statics if shares_rest else "",
                       release, study.questions, {name: str(path) for name, path in study.functions.items()},
                       {name: value for name, value in row.drawn.items()}, study.keep))
