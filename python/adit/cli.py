"""The command `adit`, which computes, draws, reports and compares."""
import importlib
import os
import signal
import sys

from adit import programs
from adit.results.files import Unusable

COMMANDS = {  # name: (module with main(words), what it does)
    "run": ("adit.runs.command", "computes scenes, draws them and reports, as in run cases/cantilever; results in ./runs"),
    "check": (None, "sets a scene up without computing it, and describes the run"),
    "resume": (None, "resumes a run that was stopped or killed"),
    "watch": ("adit.runs.watch", "shows the progress of a run that another process computes"),
    "plot": ("adit.plots.command", "draws the pictures of a run; plot --model SCENE.yaml draws a model before it runs"),
    "report": ("adit.report.command", "writes the report of a run again"),
    "compare": ("adit.compare.command", "compares runs: figures, histories, spectra, cracks, envelopes, force chains"),
    "table": ("adit.table.command", "writes the forces of a lining or member along its path, at a time of the fields, as CSV"),
    "paraview": ("adit.paraview.command", "writes a state by which ParaView shows a run"),
    "calibrate": ("adit.calibrate.command", "finds micro-properties of bonded discs for a given rock"),
    "study": ("adit.study.command", "computes many runs of a scene: records, random ground; fragility curves and a report"),
    "trade": ("adit.trade.command", "measures what speed costs in accuracy"),
    "zoom": ("adit.zoom.command", "writes the coupled scene with particles where a run of a continuum came near its strength"),
    "cluster": ("adit.cluster.command", "writes a Slurm job that computes a scene on several nodes"),
    "certificates": ("adit.cluster.certificates", "makes certificates for servers and couplers on several machines"),
    "conformance": ("adit.conformance.command", "tests the protocol and the physics of a server of your own"),
    "doctor": (None, "examines a server that listens: its program, whether it serves, its round trip"),
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
    """Runs a command. Ends with exit code 2 and one sentence if it cannot do it, or if a file cannot be used."""
    module = COMMANDS[name][0]
    try:
        importlib.import_module(module).main(words) if module else run_coupler(name, words)
    except BrokenPipeError:  # who read has enough, as `head`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return
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
