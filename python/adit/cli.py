"""The command `adit`: one door to computing, drawing, reporting and comparing."""
import importlib
import os
import signal
import sys

from adit import programs
from adit.results.files import Unusable

COMMANDS = {  # name: (module with main(words), what it does)
    "run": ("adit.runs.command", "computes scenes, draws them and reports, as in run cases/cantilever; results in ./runs"),
    "check": (None, "sets a scene up without computing it, and tells what it holds"),
    "resume": (None, "goes on with a run that was stopped or killed"),
    "watch": ("adit.runs.watch", "tells how far a run is that somebody computes"),
    "plot": ("adit.plots.command", "draws the pictures of a run; plot --model SCENE.yaml draws a model before it runs"),
    "report": ("adit.report.command", "writes the report of a run again"),
    "compare": ("adit.compare.command", "compares runs: figures, histories, spectra, cracks, envelopes, force chains"),
    "paraview": ("adit.paraview.command", "writes a state by which ParaView shows a run"),
    "calibrate": ("adit.calibrate.command", "finds micro-properties of bonded discs for a given rock"),
    "trade": ("adit.trade.command", "measures what speed costs in accuracy"),
    "cluster": ("adit.cluster.command", "writes a job of Slurm that computes a scene on several nodes"),
    "certificates": ("adit.cluster.certificates", "makes certificates for servers and couplers on several machines"),
    "conformance": ("adit.conformance.command", "takes a server of your own through the protocol, and checks its physics"),
    "doctor": (None, "examines a server that listens: who it is, whether it serves, how fast it answers"),
}


def usage():
    told = "\n".join(f"  {name:14}{what}" for name, (_, what) in COMMANDS.items())
    return (f"usage: {programs.DOOR} COMMAND [options]; the options of a command: {programs.DOOR} COMMAND --help\n{told}\n"
            "The programs themselves: coupler, fdm_server, dem_server, simplified (each with --help).")


def main():
    name, *words = sys.argv[1:] or [""]
    if name in ("-h", "--help"):
        print(usage())
    elif name not in COMMANDS:
        print(usage(), file=sys.stderr)
        sys.exit(2)
    else:
        run(name, words)


def run(name, words):
    """Runs a command. Ends with exit code 2 and one sentence where what was asked for cannot be done, or a file cannot be used."""
    module = COMMANDS[name][0]
    try:
        importlib.import_module(module).main(words) if module else run_coupler(name, words)
    except OSError as error:
        reason = f"{error.filename}: {error.strerror}" if error.filename else str(error)
    except Unusable as error:
        reason = str(error)
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)
    else:
        return
    print(f"{programs.command(name)}: {reason}", file=sys.stderr)
    sys.exit(2)


def run_coupler(name, words):
    """Becomes the coupler with one of its own commands."""
    programs.bring_up_to_date("coupler", "fdm_server", "dem_server")
    coupler = programs.program("coupler")
    os.execv(coupler, [str(coupler), name, *words])
