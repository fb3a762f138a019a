"""Computes scenes, draws them and reports.

%(prog)s CASE_DIR | SCENE.yaml [options]
For a case it runs every scene directly in its folder, or its `study` if there is one. Results: runs/CASE/SCENE/ in the current
folder. All other options are those of `coupler run`, or of `simplified run` for a scene of a whole tunnel: coupler run --help.
In a source tree the programs are built first, unless ADIT_BUILD names a build folder.
"""
import contextlib
import os
import re
import signal
import subprocess
import sys
from pathlib import Path

from adit import programs
from adit.results.files import Unusable
from adit.runs import variants

ADDRESS = re.compile(r"\S+:\S+")  # of a server that already listens; any other word is its command


def main(words):
    parser = programs.parser("run", __doc__, allow_abbrev=False)
    parser.add_argument("input", metavar="CASE_DIR | SCENE.yaml")
    parser.add_argument("--out", metavar="DIR", type=Path, help="another folder of the results")
    parser.add_argument("--no-report", action="store_true", help="write no report.html")
    parser.add_argument("--no-pictures", action="store_true", help="draw nothing: neither pictures nor reports")
    parser.add_argument("--vary", action="append", metavar="KEY=VALUE,VALUE...",
                        help="compute a scene with each of the values and compare the runs, in runs/CASE/SCENE_variants/; several "
                        "--vary make every combination, keys of one --vary change together: --vary 'time.dt_factor=0.2,0.5' "
                        "--vary 'continuum.block.zones_x,continuum.block.zones_y=8:4,16:8'")
    parser.add_argument("--within", metavar="SHARE", help="refine a scene until the figures named by --figure, or its `questions`, are as accurate, as in --within 5%%")
    parser.add_argument("--figure", action="append", metavar="KEY", help="a figure of summary.json whose accuracy is asked for; several --figure name several")
    parser.add_argument("--budget", metavar="TIME", help="for --within: begin no run that would end later than this [default: that of the scene, or 20min]")
    for name in ("--fdm", "--dem"):
        parser.add_argument(name, metavar="COMMAND | ADDRESS",
                            help="start this server and stop it, as in --dem 'mpirun -np 2 adit_lammps', or join the one that listens there")
    options, others = parser.parse_known_args(words)
    sys.exit(run(options, others))


def run(options, others):
    """Computes all scenes of the input; returns the exit code."""
    given = found(options.input)
    if os.access(given / "study", os.X_OK):
        programs.bring_up_to_date("coupler", "fdm_server", "dem_server")
        return run_study(given / "study", options, others)
    scenes = scenes_of(given)
    programs.bring_up_to_date("coupler", "fdm_server", "dem_server")  # at once: each may wait for few large sources
    solvers = [program_of(scene, others) for scene in scenes]
    programs.bring_up_to_date(*sorted({name for solver in solvers for name in NEEDED[solver]}))
    if len(scenes) > 1 and options.vary:
        raise Unusable(f"--vary needs one scene, and {given} holds {len(scenes)}.")
    if len(scenes) == 1 and not options.vary or options.within:
        code = as_accurate(scenes, options, others + servers_of(options))
        if code is not None:
            return code
    if options.figure or options.budget:
        raise Unusable("--figure and --budget belong to an accuracy, and none is asked for; add --within, such as --within 5%.")
    if options.vary:
        return variants.compute_all(programs.program(solvers[0]), scenes[0], options, others + servers_of(options))
    with contextlib.ExitStack() as servers:
        others = others + servers_of(options, servers)
        folders = []
        for scene, solver in zip(scenes, solvers):
            out = options.out / scene.stem if options.out and len(scenes) > 1 else options.out
            print(f"run: {os.path.relpath(scene)}", flush=True)
            code, folder = compute([programs.program(solver), "run", scene, *(["--out", out] if out else []), *others])
            if code == 0 or folder:  # what was computed until it failed is reported
                draw(folder, options, with_pictures=code == 0)
            if code:
                print(f"{programs.command('run')}: {os.path.relpath(scene)} failed (exit code {code}, reason above)", file=sys.stderr)
                return code
            folders.append(folder)
    compare(folders, options)
    print(f"\nResults: {' '.join(f'{folder}/' for folder in folders)}")
    return 0


def as_accurate(scenes, options, others):
    """The exit code; None where neither the command nor the scene asks for an accuracy."""
    from adit.accuracy import command as accuracy, scene

    if len(scenes) > 1 or options.vary:
        raise Unusable("--within needs one scene, and no --vary; name one.")
    read = scene.read(scenes[0], others)
    asked = accuracy.asked_of(read, options)
    if asked is None:
        return None
    code, folder = accuracy.run(scenes[0], read, asked, options, others)
    draw(folder, options, with_pictures=True)
    print(f"\nResults: {folder}/")
    return code


# The command for a scene of each program.
NEEDED = {"coupler": ("coupler", "fdm_server", "dem_server"), "simplified": ("simplified",)}


def found(text):
    """The case or the scene: a path from the current folder, or one of the cases that come with Adit."""
    for path in (Path(text), programs.ROOT / text):
        if path.exists():
            return path.resolve()
    raise Unusable(f"{text} does not exist; name a case or a scene, as in {programs.command('run')} cases/cantilever.")


def scenes_of(given):
    """The scenes of a case, the models to compare with first."""
    if not given.is_dir():
        return [given]
    scenes = sorted(given.glob("*.yaml"), key=lambda scene: (not scene.name.startswith("full_"), scene.name))
    if not scenes:
        raise Unusable(f"{given} holds no scene (*.yaml).")
    return scenes


def program_of(scene, others):
    """The program that computes a scene with the `--set` among the options, by the reader of scenes itself."""
    from adit.accuracy.scene import sets_of

    asked = subprocess.run([programs.program("coupler"), "check", scene, "--which", *sets_of(others)], stdout=subprocess.PIPE, text=True)
    if asked.returncode:
        sys.exit(asked.returncode)  # the reader has told why
    return asked.stdout.strip()


def run_study(study, options, others):
    words = [word for name in ("out", "fdm", "dem") if (value := getattr(options, name)) for word in (f"--{name}", str(value))]
    words += [f"--{name.replace('_', '-')}" for name in ("no_report", "no_pictures") if getattr(options, name)]
    words += [word for value in options.vary or () for word in ("--vary", value)]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(programs.PACKAGE.parent), *os.environ.get("PYTHONPATH", "").split(os.pathsep)])}
    return subprocess.run([sys.executable, study, *words, *others], env=environment).returncode


def servers_of(options, started=None):
    """The options of the program for the servers that are named; those named by their command are started."""
    words = []
    for name in ("fdm", "dem"):
        given = getattr(options, name)
        if given and started is not None and not ADDRESS.fullmatch(given):
            given = started.enter_context(programs.listening("bash", "-c", f"exec {given}", silenced_by=(), named=given))
        words += [f"--{name}", given] if given else []
    return words


def compute(command):
    """Runs a program and shows what it prints; returns (exit code, the folder of its results or None).

    The terminal sends SIGINT and SIGHUP to the program, too, which then saves its state; SIGTERM is handed on."""
    folder = None
    with subprocess.Popen([*map(str, command)], stdout=subprocess.PIPE, text=True, errors="replace") as process:
        with _signals({signal.SIGINT: lambda *_: None, signal.SIGHUP: lambda *_: None,
                       signal.SIGTERM: lambda number, _: process.send_signal(number)}):
            for line in process.stdout:
                print(line, end="", flush=True)
                if line.startswith("results "):
                    folder = Path(line.removeprefix("results").strip())
            code = process.wait()
    return (128 - code if code < 0 else code), folder


@contextlib.contextmanager
def _signals(handlers):
    """Handles signals meanwhile, but for those that are ignored, as nohup does."""
    before = {number: signal.signal(number, handler) for number, handler in handlers.items()
              if signal.getsignal(number) != signal.SIG_IGN}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def draw(folder, options, with_pictures):
    """The pictures and the report of a run. A failure here does not change the results."""
    from adit.plots import command as plots, instants  # matplotlib is imported only where something is drawn
    from adit.report import page

    if with_pictures and not options.no_pictures:
        plots.tell(plots.draw_run(folder, instants.MOST))
    if options.no_pictures or options.no_report:
        return
    try:
        print(f"report             {page.of_run(folder)}", flush=True)
    except (Unusable, OSError) as error:
        print(f"{programs.command('run')}: the report of {folder} could not be written ({error}); the results are there", file=sys.stderr)


def compare(folders, options):
    from adit.compare import command as comparison

    print()
    try:
        comparison.compare(folders, None, with_pictures=not options.no_pictures, with_report=not options.no_report)
    except (Unusable, OSError) as error:
        print(f"{programs.command('run')}: the runs could not be compared: {error}", file=sys.stderr)
