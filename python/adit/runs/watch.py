"""Shows the progress of a run that another process computes, until it has ended.

%(prog)s RUN_DIR [--once]
It prints a line each time the histories have grown: the time reached and the duration, the remaining time at this speed, cracks, and
the drift of the energy. The exit code is 0 if the run was completed, 1 if it ended before.
"""
import os
import sys
import time

from adit import programs
from adit.results.files import Unusable
from adit.results.run import Run

EVERY_S = 2.0  # between two looks at the folder


def main(words):
    parser = programs.parser("watch", __doc__)
    parser.add_argument("folder", metavar="RUN_DIR", help="folder of a run")
    parser.add_argument("--once", action="store_true", help="print one line and end")
    options = parser.parse_args(words)
    sys.exit(watch(options.folder, options.once))


def watch(folder, once):
    """Prints how far the run is; the exit code."""
    begun = told = None
    while True:
        run = Run(folder)
        reached = reached_by(run)
        if run.summary:
            print(ended(run, reached))
            return 0 if run.completed else 1
        if reached != told:
            begun = begun or (time.monotonic(), reached)
            print(line(run, reached, left(run, reached, *begun)), flush=True)
            told = reached
        if once:
            return 0
        time.sleep(EVERY_S)


def reached_by(run):
    """The time [s] of the last row of the histories; 0 if there is none yet."""
    try:
        return float(run.histories["time_s"][-1])
    except (Unusable, IndexError):
        return 0.0


def left(run, reached, since, from_there):
    """Seconds of computing that are left at the speed since the watch began; None where it is not known yet."""
    progress, took = reached - from_there, time.monotonic() - since
    return took * (run.duration - reached) / progress if progress > 0 else None


def line(run, reached, seconds_left):
    share = reached / run.duration if run.duration else 0.0
    words = [f"{reached:.4g} of {run.duration:.4g} s ({100 * share:.0f} %)", *state(run)]
    if seconds_left is not None:
        words.append(f"about {seconds_left:.0f} s left" if seconds_left < 120 else f"about {seconds_left / 60:.0f} min left")
    return ", ".join(words)


def state(run):
    """Further figures for the observer: broken bonds, and the drift of the energy."""
    if run.has("cracks.csv"):
        yield f"{len(run.cracks)} bonds broken"
    if run.has("histories.csv") and len(drift := run.histories.get("energy_drift", ())):
        yield f"energy drift {drift[-1]:.1e}"


def ended(run, reached):
    if run.completed:
        return f"completed at {reached:.4g} s; {programs.command('report')} {os.path.relpath(run.folder)}"
    return f"ended at {reached:.4g} of {run.duration:.4g} s: {run.summary.get('error', 'no reason was written')}"
