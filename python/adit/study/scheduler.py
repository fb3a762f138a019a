"""Computes the climbs of a study on any executor: threads of this machine, or workers of Dask."""
import os
import re
import subprocess
import time
from concurrent.futures import FIRST_COMPLETED, ThreadPoolExecutor, wait
from contextlib import contextmanager
from dataclasses import dataclass

from adit import programs
from adit.results.files import Unusable
from adit.study import rows

TOLD = 20  # lines of progress of a study


@contextmanager
def here(jobs):
    """Threads of this machine, each of which starts the programs of one run at a time."""
    with ThreadPoolExecutor(jobs) as pool:
        try:
            yield pool
        finally:
            pool.shutdown(cancel_futures=True)


@contextmanager
def on_dask(address):
    """Workers of Dask's scheduler at an address; they must see the study's folder, and have the package adit."""
    try:
        from distributed import Client
    except ImportError:
        raise Unusable("the package distributed is missing; as root: apt-get install python3-distributed (in the source tree: "
                       "scripts/setup studies).") from None
    try:
        client = Client(address, timeout=30)
    except (OSError, ValueError) as error:
        raise Unusable(f"--dask {address}: no scheduler answers there ({error}); start one by `dask-scheduler`, and workers by "
                       "`dask-worker`.") from None
    with client, client.get_executor(pure=False) as pool:
        yield pool


@dataclass(frozen=True)
class Expected:
    """What a run takes: memory [bytes] and time [s] on a core; 0 where that is not known."""
    memory: float = 0.0
    time: float = 0.0

    @property
    def at_once(self):
        """As many runs as there are cores, and as the memory of the machine holds."""
        cores = len(os.sched_getaffinity(0))
        available = os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
        return max(1, min(cores, int(0.9 * available / self.memory) if self.memory else cores))


def expected(program, scene):
    """The Expected of a scene, from the report of `coupler check`."""
    if str(program).endswith("simplified"):
        return Expected()
    checked = subprocess.run([program, "check", scene, "--fdm-threads", "1", "--dem-threads", "1"], capture_output=True, text=True).stdout
    lines = {label: next((line for line in checked.splitlines() if line.startswith(label)), "") for label in ("memory ", "time to expect ")}
    memory = sum(float(number) * {"kB": 1e3, "MB": 1e6, "GB": 1e9}[unit] for number, unit in re.findall(r"([\d.]+) (kB|MB|GB)", lines["memory "]))
    time = re.match(r"time to expect +([\d.]+) (s|min|h)", lines["time to expect "])
    return Expected(memory, float(time[1]) * {"s": 1, "min": 60, "h": 3600}[time[2]] if time else 0.0)


class Progress:
    """Tells how far a study is: each twentieth of its runs, each run that failed, on a terminal every one."""

    def __init__(self, total):
        self.total, self.done, self.new, self.failed, self.cpu = total, 0, 0, 0, 0.0
        self.begun, self.told = time.monotonic(), 0

    def take(self, row, result):
        self.done += 1
        self.new += result["new"]
        self.cpu += result.get("cpu", 0.0)
        if "failed" in result:
            self.failed += 1
            print(f"  {name_of(row)} failed: {result['failed']}", flush=True)
        share = self.done * TOLD // max(self.total, 1)
        line = f"  {self.done} of {self.total} runs" + (f", {self.failed} failed" if self.failed else "") + self._left()
        if self.new and (share > self.told or self.done == self.total):
            self.told = share
            programs.tell_progress()
            print(line, flush=True)
        else:
            programs.tell_progress(line)

    def expect(self, number):
        """More runs come than were expected, or fewer."""
        self.total += number

    @staticmethod
    def leave_out(row, factor):
        print(f"  {name_of(row)} is left out: it would be scaled by {factor:.3g}", flush=True)

    def _left(self):
        took = time.monotonic() - self.begun
        left = took * (self.total - self.done) / self.new if self.new else 0
        return f", about {left:.0f} s left" if 0 < left < 120 else f", about {left / 60:.0f} min left" if left else f", {took:.1f} s" if self.new else ""


def name_of(row):
    """What a user knows a run by."""
    level = f" at {row.level:.4g}" if row.level is not None else ""
    return f"{row.motion or 'sample'}{level} ({row.sample})"


def compute(ways, task_of, pool, progress):
    """Computes climbs; returns [(row, result)] in their order. `ways`: generators, each of which yields the rows of a climb one after the
    other, is sent what came of each, and returns [(row, result)]. `task_of(row)`: the task of a run."""
    results = [[] for _ in ways]
    pending = {}

    def go_on(number, result=None):
        try:
            row = ways[number].send(result)
            pending[pool.submit(rows.compute, task_of(row))] = number, row
        except StopIteration as end:
            results[number] = end.value

    for number in range(len(ways)):
        go_on(number)
    while pending:
        for future in wait(pending, return_when=FIRST_COMPLETED).done:
            number, row = pending.pop(future)
            progress.take(row, future.result())
            go_on(number, future.result())
    programs.tell_progress()
    return [pair for climb in results for pair in climb]


def in_turn(study, climb, progress):
    """The way through a climb whose rows are known: up to its end, or the row at which it ends."""
    found = []
    for row in climb:
        found.append((row, (yield row)))
        if ended(study, found[-1][1]):
            break
    progress.expect(len(found) - len(climb))
    return found


def ended(study, result):
    """Whether a climb goes no further after this result: a run failed, or exceeds all damage states."""
    if not study.climbs:
        return False
    if "failed" in result:
        return True
    answers = [(damage, result["answers"][damage.of]) for damage in study.damage]
    return all(answer is not None and damage.reached(answer) == len(damage.states) for damage, answer in answers)
