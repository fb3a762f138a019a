"""Another continuum and ours on the same block of elastic zones: FEniCSx, which replaces fdm_server
(adapters/fenicsx). One rank, one thread; measured is the time that the participant computes, as the coupler's summary tells it."""

import pathlib
import subprocess
import sys
import tempfile

from adit import Run
from benchmarks.peers.alternate import Pair
from adit.programs import listening

SIDE = 300
SCENE = f"""
material: {{young_modulus: 25 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}}
time: {{duration: 20 ms, dt: 0.1 ms}}
output: {{history_interval: 1 s}}
continuum:
  block: {{x_min: 0 m, x_max: {SIDE} m, y_min: 0 m, y_max: {SIDE} m, zones_x: {SIDE}, zones_y: {SIDE}}}
  edge_loads: [{{where: {{x_max: 0 m}}, force: {{x: 1 kN}}}}]
"""


def pairs(root):
    if subprocess.run(["/usr/bin/python3", "-c", "import dolfinx"], capture_output=True).returncode:
        print("FEniCSx: dolfinx is not installed, left out: scripts/setup adapters", file=sys.stderr)
        return []
    ours = lambda: listening(root / "build/release/fdm_server/fdm_server", "--listen", "127.0.0.1:0", "--threads", "1")
    theirs = lambda: listening(root / "adapters/fenicsx/serve.py", "--listen", "127.0.0.1:0", silenced_by=())
    return [Pair("elastic block", SIDE**2, "zone-steps/s", "fdm_server", lambda: zone_steps_per_second(root, ours),
                 "FEniCSx", lambda: zone_steps_per_second(root, theirs))]


def zone_steps_per_second(root, server):
    with tempfile.TemporaryDirectory() as folder:
        scene = pathlib.Path(folder) / "scene.yaml"
        scene.write_text(SCENE)
        with server() as address:
            subprocess.run([root / "build/release/coupler/coupler", "run", scene, "--out", f"{folder}/run", "--fdm", address],
                           check=True, capture_output=True)
        summary = Run(f"{folder}/run").summary
    return SIDE**2 * summary["steps"] / (summary["continuum_compute_s"] + summary["continuum_hidden_s"])
