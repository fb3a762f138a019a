"""Computes many runs of a scene, as a study states them, and what follows from them: a table, fragility curves, a report.

%(prog)s STUDY.yaml [options]
Results: runs/CASE/STUDY/ in the current folder. A study that was stopped goes on by the same command; runs whose scene did not change
are not computed again. docs/study.md explains the file.
"""
import fcntl
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path

from adit import programs
from adit import Run
from adit.accuracy import scene as scenes
from adit.accuracy.runs import OF_CRACKS
from adit.results.files import Unusable, nearest
from adit.runs import children
from adit.runs.command import program_of
from adit.study import design, detail, motions as ground, outcome, rows, scheduler, search, slurm, table, until
from adit.study.study import load


def main(words):
    parser = programs.parser("study", __doc__)
    parser.add_argument("study", metavar="STUDY.yaml", type=Path)
    parser.add_argument("--out", metavar="DIR", type=Path, help="another folder of the results")
    parser.add_argument("--set", metavar="KEY=VALUE", action="append", default=[], help="replace a value of the scene in all runs; may be repeated")
    parser.add_argument("--records", metavar="DIR", type=Path, help="folder of records that are further motions of the study")
    parser.add_argument("--jobs", metavar="N", type=int, help="runs at once on this machine [default: as many as cores and memory allow]")
    parser.add_argument("--dask", metavar="HOST:PORT", help="compute on the workers of this scheduler of Dask, which see the folder of the results")
    parser.add_argument("--slurm", metavar="N", type=int, help="write a job of Slurm with an array of N parts, and compute nothing")
    parser.add_argument("--part", metavar="K/N", help="compute the K-th of N parts of the runs only, as a job of an array does; K counts from 0")
    parser.add_argument("--until", metavar="TEXT", help="add runs until a median is known as well, as in --until 'median within 10 %%'")
    parser.add_argument("--most", metavar="RUNS", type=int, default=1000, help="for --until: no more runs than these [default: %(default)s]")
    parser.add_argument("--plan", action="store_true", help="check the study and tell which runs it would make; compute nothing")
    parser.add_argument("--no-pictures", action="store_true", help="draw nothing, and write no report")
    options = parser.parse_args(words)
    if options.jobs is not None and options.jobs < 1:
        parser.error(f"--jobs {options.jobs}: at least 1 is needed")
    programs.bring_up_to_date("coupler", "fdm_server", "dem_server", "simplified")
    study = load(options.study, options.set, options.records)
    out = (options.out or programs.RUNS / study.folder.name / study.name).resolve()
    target = until.target(options.until) if options.until else None
    children.end_with_this_process()
    if options.plan:
        with tempfile.TemporaryDirectory() as fields:
            print(*Plan(study, out, Path(fields)).told(), sep="\n")
        return
    with held(study, out, whole=not (options.slurm or options.part)):
        plan = Plan(study, out, out / "fields")
        if options.slurm:
            print(*slurm.write(study, out, options.slurm, not options.no_pictures), sep="\n")
        elif options.part:
            plan.compute(slurm.part(plan.first, options.part), options)
        else:
            sys.exit(whole(plan, options, target))


class Plan:
    """The runs of a study with results in `out`, and how they are computed; `fields`: the folder of its random fields."""

    def __init__(self, study, out, fields):
        self.study, self.out, self.fields = study, out, fields
        self.stated = scenes.read(study.scene, [f"--set={key}={value}" for key, value in study.set.items()])
        if study.detail:
            detail.check(study, self.stated)
        self.program = programs.program(program_of(study.scene, []))
        self.release = release(self.program)
        self.rounds = [self._round(0)]

    def _round(self, number):
        moving = ground.read(self.study, number) if self.study.motions else []
        return design.of_round(self.study, self.stated, moving, number, self.fields)

    @cached_property
    def expected(self):
        """What a run takes."""
        return scheduler.expected(self.program, self.study.scene)

    @property
    def first(self):
        return self.rounds[0].climbs

    def next_round(self):
        """The climbs of a further round; empty where it would only compute the same runs again."""
        known = {self._told_by(row) for each in self.rounds for climb in each.climbs for row in climb}
        further = self._round(len(self.rounds))
        self.rounds.append(further)
        return [climb for climb in further.climbs if any(self._told_by(row) not in known for row in climb)]

    @staticmethod
    def _told_by(row):
        """What the answers of a row depend on: its scene, and what functions are given."""
        return row.hash, tuple(row.drawn.items())

    def shared(self, climbs):
        """States at rest from which more than one run begins."""
        if "statics" not in self.stated:
            return set()
        begun = Counter(row.statics for climb in climbs for row in climb)
        return {each for each, runs in begun.items() if runs > 1 or self.study.searches}

    def _missing(self, climbs):
        """Runs that are not there."""
        return sum(not (self.out / "runs" / row.hash).exists() for climb in climbs for row in climb)

    def _to_compute(self):
        """(the least, the largest) number of runs of the first round that are not there; which a search makes, it knows only then."""
        missing = self._missing(self.first)
        return search.runs_of(self.study, self.first) if self.study.searches else (missing, missing)

    def told(self):
        """Yields what the user is told of the runs before the first one."""
        every = [row for climb in self.first for row in climb]
        least, most = self._to_compute()
        runs = f"at least {least}, at most {most}" if self.study.searches else f"{len(every)}, {len({row.hash for row in every})} different"
        yield f"runs               {runs}" + (f"; {len(self.first)} climbs" if len(self.first) < len(every) else "")
        if shared := self.shared(self.first):
            yield f"states at rest     {len(shared)}, shared by {sum(row.statics in shared for row in every)} runs"
        if not self.study.searches:
            yield f"computed before    {len(every) - most}"
        yield f"at once            {self.expected.at_once}"
        if self.expected.time and most:
            minutes = " to ".join(f"{self.expected.time * runs / self.expected.at_once / 60:.2g}" for runs in dict.fromkeys((least, most)))
            yield f"time to expect     about {minutes} min, as the scene itself takes {self.expected.time:g} s"
        if self.study.detail:
            yield f"in detail          {self.study.detail.runs} with the largest {self.study.detail.of}"
        for left_out in self.rounds[0].left_out:
            yield f"note: {left_out}"
        yield f"{self.study.path} can be computed"

    def way(self, climb, progress):
        """The way through a climb."""
        return search.climb(self.study, climb, self.out, progress) if self.study.searches else scheduler.in_turn(self.study, climb, progress)

    def compute(self, climbs, options):
        """[(row, result)] of climbs."""
        shared = self.shared(climbs)
        at_once = self.expected.at_once if self._missing(climbs) and not options.dask else 1
        progress = scheduler.Progress(sum(map(len, climbs)))

        def task_of(row):
            return rows.task_of(self.study, row, self.out, self.program, self.release, row.statics in shared)

        return self.go([self.way(climb, progress) for climb in climbs], task_of, progress, at_once, options)

    @staticmethod
    def go(ways, task_of, progress, at_once, options):
        """[(row, result)] of ways (scheduler.py), on this machine or on Dask."""
        begun = time.monotonic()
        jobs = options.jobs or at_once
        with scheduler.on_dask(options.dask) if options.dask else scheduler.here(jobs) as pool:
            computed = scheduler.compute(ways, task_of, pool, progress)
        took = time.monotonic() - begun
        if progress.new:
            where = "on Dask" if options.dask else f"{jobs} at once"
            cpu = f"; their programs took {progress.cpu:.1f} s of CPU" if progress.cpu else ""  # `simplified` does not tell
            print(f"  {progress.new} runs computed in {took:.1f} s, {where}{cpu}", flush=True)
        return computed


def whole(plan, options, target):
    """Computes the study, adds runs as asked, and writes what follows; the exit code."""
    study, out = plan.study, plan.out
    count = f"at least {search.runs_of(study, plan.first)[0]}" if study.searches else sum(map(len, plan.first))
    print(f"study: {os.path.relpath(study.path)}, {count} runs of {os.path.relpath(study.scene)}", flush=True)
    for left_out in plan.rounds[0].left_out:
        print(f"note: {left_out}", flush=True)
    computed = plan.compute(plan.first, options)
    design.require_some(study, computed)
    require_answers(study, computed, out)
    told = []
    if target:
        computed, told = until.add_runs(plan, options, target, computed)
    listed = table.rows_of(study, computed, out)
    files = table.write(listed, out)
    closer = detail.compute(plan, options, computed, listed) if study.detail else []
    told += outcome.conclude(study, listed, closer, out, pictures=not options.no_pictures)
    for line in ("", *told, f"table              {', '.join(str(out / name) for name in files)}"):
        print(line, flush=True)
    for name in ("work", "locks"):  # of processes that were killed, too
        shutil.rmtree(out / name, ignore_errors=True)
    print(f"\nResults: {out}/")
    return 0 if any(not row["failed"] for row in listed) else 1


def require_answers(study, computed, out):
    """Raises Unusable for a question that no run knows."""
    good = [(row, result) for row, result in computed if "answers" in result]
    for question in study.questions:
        if good and all(result["answers"][question] is None for _, result in good) and not question.startswith(OF_CRACKS):
            run = Run(out / "runs" / good[0][0].hash)
            if question not in run.summary:
                known = [*(key for key, value in run.summary.items() if type(value) in (int, float)), *run.histories]
                raise Unusable(f"{study.path}: questions: no run has {question}; {nearest(question, known)}")


def release(program):
    """The name and release of a program, as it tells them."""
    return subprocess.run([program, "--version"], capture_output=True, text=True).stdout.strip()


@contextmanager
def held(study, out, whole):
    """The folder of a study, for one process at a time unless it computes a part; refused if it is that of another study."""
    out.mkdir(parents=True, exist_ok=True)
    of = out / "study.txt"
    own = f"{study.path.resolve()}\n"
    if of.exists() and of.read_text() != own:
        raise Unusable(f"--out {out} holds the study {of.read_text().strip()}; give another folder.")
    if not of.exists() and any(path.name not in ("fields", "study.lock") for path in out.iterdir()):
        raise Unusable(f"--out {out} holds something else than a study; give another folder.")
    with open(out / "study.lock", "w") as lock:
        try:
            fcntl.flock(lock, (fcntl.LOCK_EX if whole else fcntl.LOCK_SH) | fcntl.LOCK_NB)
        except OSError:
            raise Unusable(f"--out {out}: another process computes this study at this moment; wait for its end.") from None
        of.write_text(own)
        yield
