"""Drawing on all cores."""
import multiprocessing
import os
from concurrent.futures import ProcessPoolExecutor

_function = None  # what the processes of on_all_cores compute; they are copies of this one and need not be sent it


def on_all_cores(function, count):
    """Yields function(0), …, function(count - 1) in this order, computed by as many processes as there are cores."""
    global _function
    workers = min(count, len(os.sched_getaffinity(0)))
    if workers < 2:
        yield from map(function, range(count))
        return
    _function = function
    with ProcessPoolExecutor(workers, mp_context=multiprocessing.get_context("fork")) as pool:
        yield from pool.map(_nth, range(count))


def _nth(number):
    return _function(number)
