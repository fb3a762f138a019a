"""Where the programs, the cases and the results are: in the source tree, or where Adit is installed."""
import contextlib
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]  # the source tree, or PREFIX/share/adit
INSTALLED = not (ROOT / "scripts" / "build").exists()
RUNS = (Path.cwd() if INSTALLED else ROOT) / "runs"


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
def listening(*command, silenced_by=("--log-level", "off")):
    """The address of a server while it listens; it logs nothing by the options that silence it."""
    with subprocess.Popen([*map(str, command), *silenced_by], stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process.stdout.readline().split()[-1]
        finally:
            process.terminate()
