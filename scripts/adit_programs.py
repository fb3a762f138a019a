"""Where the programs and the cases are, in the source tree or where Adit is installed, and the results: in the current folder."""
import contextlib
import os
import subprocess
import sys
from pathlib import Path

from adit import Unusable

ROOT = Path(__file__).resolve().parents[1]  # the source tree, or PREFIX/share/adit
INSTALLED = not (ROOT / "scripts" / "build").exists()
RUNS = Path.cwd() / "runs"


def command(script):
    """What the user types for a script of this folder."""
    return f"adit {script}" if INSTALLED else f"scripts/{script}"


def program(name):
    """The executable; ADIT_BUILD names a build folder other than that of the release."""
    if INSTALLED:
        path = ROOT.parents[1] / "bin" / name
    else:
        path = Path(os.environ.get("ADIT_BUILD", ROOT / "build" / "release")) / name / name
    if not path.exists():
        what = "install Adit again" if INSTALLED else f"build it with scripts/build release {name}"
        print(f"{path} does not exist: {what}.", file=sys.stderr)
        sys.exit(2)
    return path


def bring_up_to_date(*names):
    """Builds the programs in a source tree, unless ADIT_BUILD names a folder that somebody has built."""
    if INSTALLED or "ADIT_BUILD" in os.environ:
        return
    built = subprocess.run([ROOT / "scripts" / "build", "release", *names])
    if built.returncode:
        sys.exit(built.returncode)


@contextlib.contextmanager
def refusals_told(script, *refusals):
    """Ends with exit code 2 and one sentence where a run is not usable, a file cannot be written, or one of `refusals` is raised."""
    try:
        yield
    except OSError as error:
        reason = f"{error.filename}: {error.strerror}" if error.filename else str(error)
    except (Unusable, *refusals) as error:
        reason = str(error)
    else:
        return
    print(f"{command(script)}: {reason}", file=sys.stderr)
    sys.exit(2)


@contextlib.contextmanager
def listening(*command, silenced_by=("--log-level", "off")):
    """The address of a server while it listens; it logs nothing by the options that silence it."""
    with subprocess.Popen([*map(str, command), *silenced_by], stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process.stdout.readline().split()[-1]
        finally:
            process.terminate()
