"""Runs scenes and reads what they put out."""
import atexit
import csv
import importlib.util
import json
import math
import os
import pathlib
import re
import shutil
import subprocess
import threading

import grains as discs
import schema

BUILD = pathlib.Path(os.environ.get("ADIT_BUILD", schema.SOURCE / "build" / "release"))
COUPLER = BUILD / "coupler" / "coupler"
PATIENCE_S = 120 * int(os.environ.get("ADIT_PATIENCE", 1))


class Ended(Exception):
    """A run that did not end as it should: its exit code and its words."""

    def __init__(self, code, words):
        super().__init__(f"exit {code}: {words}")
        self.code, self.words = code, words


def coupler(*arguments):
    """Its standard output and error; Ended where it says no."""
    done = subprocess.run([COUPLER, *map(str, arguments)], capture_output=True, text=True, timeout=PATIENCE_S)
    words = "\n".join(line for line in done.stderr.replace("\r", "\n").splitlines() if line and not re.match(r"step \d+ of|statics", line))
    if done.returncode:
        raise Ended(done.returncode, words or done.stdout[-400:])
    return done.stdout + words


def write_scene(scene, folder, change):
    """The scene as a file in a folder, with the files that it names; `change` moves what these hold."""
    folder.mkdir(parents=True, exist_ok=True)
    text = json.dumps(scene, indent=1)
    for name in set(re.findall(r'"path": "([^"]+)"', text)):
        (folder / name).write_text({"mesh": mesh, "placed": placed, "grains": grains, "field": field}.get(name.split("_")[0].split(".")[0], record)(name, change))
    path = folder / "scene.yaml"
    path.write_text(text)
    return path


def record(name, change):
    """A pulse of a record, from rest to rest; `negative.csv` goes the other way."""
    sign = -1.0 if name.startswith("negative") else 1.0
    rows = ["time_s,acceleration_m/s^2"]
    for i in range(121):
        t = i / 1000
        value = sign * 3.0 * math.sin(2 * math.pi * 60 * t) * math.sin(math.pi * i / 30)**2 if i < 30 else 0.0
        rows.append("{!r},{!r}".format(change.number("MotionFile", "t", "s", t), change.number("MotionFile", "a", "m/s^2", value)))
    return "\n".join(rows) + "\n"


def mesh(_, change):
    """The ground as a mesh of Gmsh: 16 x 8 zones."""
    columns, rows = 17, 9
    points = [change.place(-4 + 0.5 * i, 0.5 * j) for j in range(rows) for i in range(columns)]
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Nodes", f"1 {len(points)} 1 {len(points)}", f"2 1 0 {len(points)}"]
    lines += [str(k + 1) for k in range(len(points))] + [f"{x!r} {y!r} 0" for x, y in points]
    quads = [(j * columns + i, j * columns + i + 1, (j + 1) * columns + i + 1, (j + 1) * columns + i) for j in range(rows - 1) for i in range(columns - 1)]
    lines += ["$EndNodes", "$Elements", f"1 {len(quads)} 1 {len(quads)}", f"2 1 3 {len(quads)}"]
    lines += [" ".join(str(n + 1) for n in (k, *quad)) for k, quad in enumerate(quads)]
    return "\n".join([*lines, "$EndElements"]) + "\n"


def placed(name, change):
    """The discs of a hexagonal packing as a table: placed_<x>_<columns>_<low>_<high>.csv."""
    x, columns, low, high = map(float, name.removesuffix(".csv").split("_")[1:])
    radius = 4 / (16 * math.sqrt(3))
    rows = ["x_m,y_m,radius_m"]
    for row in range(round((high - low) / (radius * math.sqrt(3)))):
        for column in range(int(columns) - row % 2):
            at = change.place(x + radius * (2 * column + 1 + row % 2), low + radius * math.sqrt(3) * (row + 0.5))
            rows.append("{!r},{!r},{!r}".format(*at, change.number("PlacedParticles", "radius", "m", radius)))
    return "\n".join(rows) + "\n"


def field(name, change):
    """Factors of stiffness or strength from place to place, field_<of>.csv: from 0.5 to 1.5."""
    phase = {"field_stiffness.csv": 0.0, "field_strength.csv": 2.0}[name]
    rows = ["x_m,y_m,factor"]
    for x in range(-7, 8):
        for y in range(-2, 7):
            factor = 1 + 0.5 * math.sin(1.3 * x + phase) * math.cos(0.9 * y + phase)
            rows.append("{!r},{!r},{!r}".format(*change.place(float(x), float(y)), factor))
    return "\n".join(rows) + "\n"


def grains(_, change):
    """The placed discs of the particles alone."""
    rows = ["x_m,y_m,radius_m"]
    for centre in discs.centres():
        rows.append("{!r},{!r},{!r}".format(*change.place(*centre), change.number("PlacedParticles", "radius", "m", discs.RADIUS)))
    return "\n".join(rows) + "\n"


# What of a summary tells of the machine, of the time that it took, and of how the run was asked for.
_OF_THE_RUN = re.compile(r"(^|_)(cpu|compute|hidden|wait|solve|factor|wall|stepping|checkpoint|restore)_s$|^(steps_per_s|hidden_share|solve_factor_bytes|resumed_at_steps"
                         r"|case|scene|scene_hash|versions|notes)$")


class Results:
    """What a run has written.

    columns: its histories, {column: [values]}
    figures: those of its summary that belong to the model
    files: the bytes of all others, {path: bytes}
    """

    def __init__(self, folder):
        self.folder = folder
        self.summary = json.loads((folder / "summary.json").read_text())
        origin = set(self.summary) & {"command", "folder", "started", "revision", "inputs"}
        self.figures = {key: value for key, value in self.summary.items() if not _OF_THE_RUN.search(key) and key not in origin}
        with open(folder / "histories.csv", newline="") as file:
            names, *rows = csv.reader(file)
        self.columns = {name: [float(row[i]) for row in rows] for i, name in enumerate(names)}

    @property
    def files(self):
        own = {path.relative_to(self.folder): path for path in sorted(self.folder.rglob("*")) if path.is_file()}
        return {str(name): path.read_bytes() for name, path in own.items() if name.suffix in (".csv", ".vtu", ".vtp", ".vtk", ".npz")}


class _Server:
    """A server that stays, so that nothing of a run may pass to the next one."""

    def __init__(self, command):
        self.process = subprocess.Popen([*map(str, command), "--listen", "127.0.0.1:0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        atexit.register(self.process.terminate)
        self.address = self.process.stdout.readline().removeprefix("listening on ").strip()


_LAMMPS, _FENICSX = BUILD / "adapters/lammps/adit_lammps", schema.SOURCE / "adapters/fenicsx/serve.py"
_MPIRUN = ["mpirun", "-np", "1", "--bind-to", "none", *(["--allow-run-as-root"] if os.geteuid() == 0 else [])]
_COMMANDS = {"fdm": [BUILD / "fdm_server/fdm_server"], "dem": [BUILD / "dem_server/dem_server"],
             "lammps": [*_MPIRUN, _LAMMPS], "fenicsx": [*_MPIRUN, _FENICSX]}
_of_thread = threading.local()


def address(name):
    """Where a server listens that this thread has for itself: fdm, dem, lammps or fenicsx."""
    servers = _of_thread.__dict__.setdefault("servers", {})
    if name not in servers or servers[name].process.poll() is not None:
        servers[name] = _Server(_COMMANDS[name])
    return servers[name].address


def has_lammps():
    return _LAMMPS.exists()


def has_fenicsx():
    return bool(shutil.which("mpirun")) and importlib.util.find_spec("dolfinx") is not None


def run(scene, folder, change, *options):
    """Computes a scene in a folder of its own."""
    path = write_scene(scene, folder, change)
    coupler("run", path, "--out", folder / "run", *options)
    return Results(folder / "run")
