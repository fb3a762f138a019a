"""Cost of features of a scene: instructions and bytes of a point's step, with and without each feature.

A server computes a short run and one of twice as many steps under valgrind's callgrind, which counts while a step is computed; the
difference is that of the steps. Counts do not depend on what else the machine does, so that one run of each is enough.
Bytes are the cache lines that a cache of 256 KiB fetches: the models are larger than that, as large ones are than a real cache.
"""

import pathlib
import shutil
import subprocess
import tempfile

from adit import Run
from adit.programs import listening

STEPS = 10
DT_S = 1e-5
LINE_BYTES = 64
COUNTED = ("adit::protocol::SteppedParticipant::advance*", "adit::protocol::SteppedParticipant::complete*")

AROUND = """
plane: plane_stress
material: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: 2500}
time: {duration: 1 s, dt: %g s}
output: {history_interval: 1 s}
""" % DT_S
SIDES = {
    "particles": """
particles:
  packing: {x_min: 0, x_max: 20, y_min: 0, y_max: 17.4, radius: 0.1}
  bonds: {}
  loads: [{where: {x_max: 0.15}, force: {x: 1 kN}}]
""",
    "continuum": """
continuum:
  block: {x_min: 0, x_max: 20, y_min: 0, y_max: 20, zones_x: 100, zones_y: 100}
  edge_loads: [{where: {x_max: 0}, force: {x: 1 kN}}]
"""}
OTHER = {
    "particles": "continuum={block: {x_min: -10, x_max: 2, y_min: 0, y_max: 17.4, zones_x: 40, zones_y: 60}}",
    "continuum": "particles={packing: {x_min: 18, x_max: 30, y_min: 0, y_max: 20, radius: 0.1}, bonds: {}}"}
OVERLAP = {"particles": "{particles_begin: {x: 0, y: 0}, continuum_ends: {x: 2, y: 0}}",
           "continuum": "{particles_begin: {x: 18, y: 0}, continuum_ends: {x: 20, y: 0}}"}


def observed(side):
    """Outputs without effect on the results, in every step and in none."""
    watched = side + '.histories=[{name: "middle", quantity: velocity_x, at: {x: 10, y: 9}}]'
    every_step = f"output.history_interval={DT_S} s"
    return {"histories and energies, not due": (watched,), "energies": (every_step,), "histories and energies": (watched, every_step),
            "peaks": ("output.peaks={}",)}


GENERAL = "particles.engine=general"
ASKED = {
    "particles": {
        "bare": (),
        "without shear": ("material.poisson_ratio=0.33333333333333",),
        "weight": ("particles.body_loads=[{acceleration: {y: -9.81}}]",),
        "strengths": ("particles.bonds={tensile_strength: 1 GN, shear_strength: 1 GN}",),
        **observed("particles"),
        "coupling": (OTHER["particles"], "interface.overlap=" + OVERLAP["particles"]),
        "general engine": (GENERAL,),
        "general engine, local damping": (GENERAL, "particles.damping={local: 0.1}"),
        "general engine, contacts": (GENERAL, "particles.contacts={}"),
        "general engine, contacts with friction": (GENERAL, "particles.contacts={friction: 0.5}"),
        "general engine, contacts with dashpots": (GENERAL, "particles.contacts={normal_damping: 0.1}")},
    "continuum": {
        "bare": (),
        "weight": ("continuum.body_loads=[{acceleration: {y: -9.81}}]",),
        "local damping": ("continuum.damping={local: {alpha: 0.1}}",),
        "Rayleigh damping": ("continuum.damping={rayleigh: {ratio: 0.02, low_frequency: 10 Hz, high_frequency: 100 Hz}}",),
        "Maxwell damping": ("continuum.damping={maxwell: {ratio: 0.02, low_frequency: 10 Hz, high_frequency: 100 Hz}}",),
        "quiet boundary": ("continuum.quiet=[{where: {x_min: 20}}]",),
        **observed("continuum"),
        "coupling": (OTHER["continuum"], "interface.overlap=" + OVERLAP["continuum"])}}
PROGRAMS = ("coupler", "fdm_server", "dem_server")


def run(root):
    if not shutil.which("valgrind"):
        raise SystemExit("tools/bench requires: valgrind counts the instructions and is not installed: scripts/setup bench")
    return [record for side, asked in ASKED.items() for record in compare(root, side, asked)]


def compare(root, side, asked):
    records, bare = [], None
    for name, settings in asked.items():
        points, instructions, size = per_step(root, side, settings)
        bare = bare or instructions
        of = {"size": points, "threads": 1}
        records += [{"name": f"{side}: {name}", **of, "value": instructions / points, "unit": "instructions per point-step"},
                    {"name": f"{side}: {name}, over bare", **of, "value": instructions / bare, "unit": "1"},
                    {"name": f"{side}: {name}, bytes", **of, "value": size / points, "unit": "bytes per point-step"}]
    return records


def per_step(root, side, settings):
    """Points of the model, instructions and bytes of one step."""
    points, *short = counted(root, side, settings, STEPS)
    _, *long = counted(root, side, settings, 2 * STEPS)
    return points, *((b - a) / STEPS for a, b in zip(short, long))


def counted(root, side, settings, steps):
    """Points, instructions and bytes of a run."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "scene.yaml").write_text(AROUND + SIDES[side])
        with listening(*counting(root, {"continuum": "fdm_server", "particles": "dem_server"}[side], folder)) as address:
            words = [word for setting in (*settings, f"time.duration={steps * DT_S} s") for word in ("--set", setting)]
            option = {"continuum": "--fdm", "particles": "--dem"}[side]
            done = subprocess.run([root / "build/release/coupler/coupler", "run", folder / "scene.yaml", "--out", folder / "run",
                                   option, address, *words], capture_output=True, text=True)
            if done.returncode:
                raise SystemExit(f"tools/bench requires: {done.stderr}")
        counts = dict(zip(*(line.split()[1:] for line in (folder / "counts").read_text().splitlines()
                            if line.startswith(("events:", "summary:")))))
        return points_of(folder / "run", side), int(counts["Ir"]), LINE_BYTES * (int(counts["DLmr"]) + int(counts["DLmw"]))


def counting(root, program, folder):
    """The command of a server that counts its steps, into the file `counts`."""
    return ["valgrind", f"--log-file={folder}/valgrind", "--tool=callgrind", "--cache-sim=yes", "--LL=262144,16,64",
            f"--callgrind-out-file={folder}/counts", *(f"--toggle-collect={name}" for name in COUNTED),
            root / "build/release" / program / program, "--listen", f"unix:{folder}/socket", "--threads", "1"]


def points_of(run, side):
    return Run(run).summary[{"continuum": "grid_points", "particles": "particles"}[side]]
