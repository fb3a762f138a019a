"""Where the programs and the cases are, in the source tree or where Adit is installed, and the results: in the current folder."""
import argparse
import contextlib
import json
import os
import select
import shlex
import shutil
import subprocess
import sys
from importlib import metadata
from pathlib import Path
from urllib.parse import unquote

from adit.results.files import Unusable

PACKAGE = Path(__file__).resolve().parent
RUNS = Path.cwd() / "runs"
LONGEST_START_S = 60  # until a server that is started by its command listens


def _is_source_tree(folder):
    return (folder / "scripts" / "build").exists()


def _installed_from():
    """The source tree from which pip has installed this package; None where it has not, or the tree is gone."""
    try:
        place = json.loads(metadata.distribution("adit").read_text("direct_url.json") or "{}").get("url", "")
    except (metadata.PackageNotFoundError, ValueError):
        return None
    tree = Path(unquote(place.removeprefix("file://"))).parent
    return tree if place.startswith("file://") and _is_source_tree(tree) else None


def _root():
    """The source tree, or PREFIX/share/adit, which is laid out alike: cases, adapters and the messages of the protocol.
    The package lies in python/ of the source tree or in PREFIX/lib/python3/dist-packages; where pip has put it anywhere
    else, the programs are those of the tree that it was installed from, or those that the shell finds."""
    if _is_source_tree(PACKAGE.parents[1]):
        return PACKAGE.parents[1]
    if (beside := PACKAGE.parents[3] / "share" / "adit").exists():
        return beside
    if tree := _installed_from():
        return tree
    coupler = shutil.which("coupler")
    return Path(coupler).resolve().parents[1] / "share" / "adit" if coupler else beside


ROOT = _root()
INSTALLED = not _is_source_tree(ROOT)
DOOR = "scripts/adit" if _is_source_tree(PACKAGE.parents[1]) else "adit"  # what the user types


def command(name):
    """The words that the user types for a command of Adit."""
    return f"{DOOR} {name}"


def parser(name, description, **options):
    """The parser of a command's words; %(prog)s in its description is what the user types."""
    return argparse.ArgumentParser(prog=command(name), description=description,
                                   formatter_class=argparse.RawDescriptionHelpFormatter, **options)


def own_command():
    """The words that start `adit` from another program, by paths that hold in every folder."""
    return [sys.executable, *(["-B"] if sys.dont_write_bytecode else []), str(PACKAGE)]


def program(name):
    """The executable; ADIT_BUILD names a build folder other than that of the release. Raises Unusable where it is not there."""
    if INSTALLED:
        path = ROOT.parents[1] / "bin" / name
    else:
        path = Path(os.environ.get("ADIT_BUILD", ROOT / "build" / "release")) / name / name
    if not path.exists():
        what = "install Adit again" if INSTALLED else f"build it with scripts/build release {name}"
        raise Unusable(f"{path} does not exist: {what}.")
    return path.resolve()


def bring_up_to_date(*names):
    """Builds the programs in a source tree, unless ADIT_BUILD names a folder that somebody has built. Raises Unusable where one of
    these is not there."""
    if INSTALLED or "ADIT_BUILD" in os.environ:
        for name in names:
            program(name)
        return
    built = subprocess.run([ROOT / "scripts" / "build", "release", *names])
    if built.returncode:
        sys.exit(built.returncode)


def tell_progress(text=""):
    """Shows a progress text on the last line of a terminal; an empty text removes the line."""
    if sys.stderr.isatty():
        print(f"\r{text}\033[K", end="", file=sys.stderr, flush=True)


@contextlib.contextmanager
def listening(*command, silenced_by=("--log-level", "off"), named=None):
    """The address of a server while it listens; it logs nothing by the options that silence it. Raises Unusable, by the name that
    the user gave it, where it does not say within LONGEST_START_S that it listens."""
    with subprocess.Popen([*map(str, command), *silenced_by], stdout=subprocess.PIPE, text=True) as process:
        try:
            ready, _, _ = select.select([process.stdout], [], [], LONGEST_START_S)
            line = process.stdout.readline().rstrip("\n") if ready else ""
            if not line.startswith("listening on "):
                raise Unusable(f"`{named or shlex.join(map(str, command))}` said `{line}` where `listening on HOST:PORT` was expected.")
            yield line.removeprefix("listening on ")
        finally:
            process.terminate()
