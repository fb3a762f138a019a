"""Writes a Slurm job that computes a scene on several nodes: %(prog)s SCENE --nodes N [options] [-- options of sbatch]

%(prog)s lining.yaml --nodes 3 --time 24:00:00 -- --partition=long --account=tunnels

The scene is checked first. With three nodes the coupler, the continuum and the particles have one each; with fewer, the node of the
coupler also computes the other models. Options after -- are passed to Slurm for each node. docs/cluster.md explains the job.
"""
import re
import subprocess
import sys
from pathlib import Path
from shlex import join, quote

from adit import programs

TEMPLATE = Path(__file__).resolve().parent / "job.sh.in"
CERTIFICATES = join([*programs.own_command(), "certificates"])
TABLES = {"particles of": "dem_server", "grid of": "fdm_server"}
COUPLER_CORES = 2  # for a coupler that is alone on its node


def models_in(checked):
    """[(name, program)] of the models in the tables that `coupler check` prints."""
    found, program, columns = [], None, 0
    for line in checked.splitlines():
        name, *counts = re.split("  +", line)
        if name in TABLES:
            program, columns = TABLES[name], len(counts)
        elif program and len(counts) == columns:
            found.append((name, program))
        else:
            program = None
    return found


def components(cores, asked):
    """The lines of #SBATCH, with a component of the job for each node."""
    nodes = [" ".join([f"#SBATCH --nodes=1 --ntasks=1 --cpus-per-task={count}", *asked]) for count in cores]
    return "\n#SBATCH hetjob\n".join(nodes)


def serving(models):
    """The lines that start the servers, in the components from 1 on."""
    lines = [f"serve {number} {quote(name)} {quote(str(programs.program(program)))}"
             for number, (name, program) in enumerate(models, start=1)]
    trust = [f'{CERTIFICATES} "$job/tls" coupler', 'servers+=(--tls "$job/tls/coupler")']
    return "\n".join(trust + lines) if models else "# The coupler starts all servers on its own node."


def job(models, options, asked, command):
    """The text of the job."""
    apart = models[:options.nodes - 1]
    own_cores = COUPLER_CORES if len(apart) == len(models) else options.threads
    words = {
        "title": f"Adit computes {options.scene.name} on {options.nodes} node{'s' * (options.nodes > 1)}.",
        "command": command,
        "name": quote(options.scene.stem),
        "time": options.time,
        "components": components([own_cores, *[options.threads] * len(apart)], asked),
        "scene": quote(str(options.scene.resolve())),
        "job": quote(str(options.out)),
        "results": quote(str(options.out / options.scene.stem)),
        "certificates": CERTIFICATES,
        "threads": str(options.threads),
        "serve": serving(apart),
        "coupler": quote(str(programs.program("coupler")))}
    return re.sub("@([a-z]+)@", lambda found: words[found[1]], TEMPLATE.read_text())


def main(words):
    own, asked = words, []
    if "--" in own:
        own, asked = own[:own.index("--")], own[own.index("--") + 1:]
    parser = programs.parser("cluster", __doc__)
    parser.add_argument("scene", type=Path)
    parser.add_argument("--nodes", type=int, required=True, metavar="N")
    parser.add_argument("--threads", type=int, default=8, metavar="T", help="cores for each server")
    parser.add_argument("--time", default="24:00:00", help="time limit of the job in Slurm's format, above ten minutes; a new job then resumes the run")
    parser.add_argument("--out", type=Path, metavar="DIR", help="folder of the job, which all nodes must see")
    options = parser.parse_args(own)
    options.out = (options.out or programs.RUNS / f"{options.scene.stem}_job").resolve()
    programs.bring_up_to_date("coupler", "fdm_server", "dem_server")
    checked = subprocess.run([programs.program("coupler"), "check", options.scene], stdout=subprocess.PIPE, text=True)
    print(checked.stdout, end="")
    if checked.returncode:
        sys.exit(checked.returncode)
    models = models_in(checked.stdout)
    if not 1 <= options.nodes <= len(models) + 1:
        parser.error(f"--nodes {options.nodes}: the scene has {len(models)} model{'s' * (len(models) > 1)}, each of which and the coupler "
                     f"can have a node; give 1 to {len(models) + 1}")
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "job.sh").write_text(job(models, options, asked, join([parser.prog, *words])))
    print(f"submit             sbatch {quote(str(options.out / 'job.sh'))}")
