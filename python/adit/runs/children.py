"""Programs that this process starts, several at a time, and that end when it is stopped."""
import signal
import subprocess
import sys
import threading

_running = set()
_stopped = threading.Event()


def run(command, silent=True):
    """Runs a command; returns (its exit code, its standard error). A command that is not silent writes to our own streams.
    After a stop nothing is begun."""
    if _stopped.is_set():
        return 1, "stopped"
    streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE} if silent else {}
    with subprocess.Popen([*map(str, command)], text=True, **streams) as child:
        _running.add(child)
        try:
            _, said = child.communicate()
        finally:
            _running.discard(child)
    return child.returncode, said or ""


def end_with_this_process():
    """From now on a signal that stops this process stops all that run() has started."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, _stop)


def _stop(number, _):
    _stopped.set()
    for child in list(_running):
        child.terminate()
    sys.exit(128 + number)
