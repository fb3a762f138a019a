"""Draws a run's pictures, or the models of a case in one picture.

%(prog)s RUN_DIR
    writes RUN_DIR/pictures/: deformed model, force chains, bonds, linings, displacement, principal stress and yield state at
    every field time; histories, energy, peaks over time and spectra. A run of a whole tunnel gives envelopes along the axis
    and motion over time and distance.
%(prog)s --model SCENE.yaml
    draws the model before it runs (`coupler check`): materials and groups, joints, supports, boundaries, loads, probes,
    overlap. The pictures lie in runs/CASE/SCENE_model/pictures/. The folder of a `coupler check --out` may stand for the scene.
"""
import argparse
import subprocess
import sys
from itertools import chain
from pathlib import Path

from adit import programs
from adit import Run
from adit.plots import (colour_pictures, lining_pictures, model_pictures, spectra_pictures, style, time_pictures,
                        tunnel_pictures)
from adit.plots.setup import sheets
from adit.plots.setup.checked import Checked


def draw_run(folder):
    run = Run(folder)
    pictures = run.folder / "pictures"
    for old in pictures.glob("*.png"):  # an earlier run may have had other field times
        old.unlink()
    if run.is_simplified:
        for draw in (tunnel_pictures.envelopes, tunnel_pictures.time_distance):
            yield pictures / f"{draw.__name__}.png", draw(run)
        return
    pieces = None
    for time, pieces in run.snapshots():
        for draw in (model_pictures.deformed, model_pictures.force_chains, model_pictures.bonds, lining_pictures.lining_forces,
                     colour_pictures.displacement, colour_pictures.principal_stress, colour_pictures.yield_state):
            yield pictures / f"{draw.__name__}_{style.milliseconds(time)}ms.png", draw(run, time, pieces)
    for name, figure in colour_pictures.peaks(run, time, pieces) if pieces else ():  # in the last snapshot
        yield pictures / f"{name}.png", figure
    for name, figure in spectra_pictures.motions(run):
        yield pictures / f"{name}.png", figure
    for draw in (time_pictures.histories, time_pictures.energy):
        yield pictures / f"{draw.__name__}.png", draw(run)


def draw_model(scene):
    scene = Path(scene)
    folder = scene if scene.is_dir() else check(scene)
    for name, figure in sheets.model(Checked(folder)):
        yield folder / "pictures" / f"{name}.png", figure


def check(scene):
    """Writes the undeformed model and returns its folder."""
    programs.bring_up_to_date("coupler", "fdm_server", "dem_server")
    folder = programs.RUNS / scene.resolve().parent.name / f"{scene.stem}_model"
    done = subprocess.run([programs.program("coupler"), "check", scene, "--out", folder])
    if done.returncode:
        sys.exit(done.returncode)
    return folder


def draw(folders, draws=draw_run):
    """Draws runs, or models by `draw_model`, and prints where."""
    pictures = chain(*map(draws, folders))
    drawn = [style.save(figure, path) for path, figure in pictures if figure]
    print(drawn[0] if len(drawn) == 1 else f"{len(drawn)} pictures in {Path(drawn[0]).parent}" if drawn else "nothing to draw",
          flush=True)


def main(words):
    parser = argparse.ArgumentParser(prog=programs.command("plot"), description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", metavar="RUN_DIR", nargs="+", help="folder of a run, or a scene")
    parser.add_argument("--model", action="store_true", help="draw the models of scenes before they run")
    options = parser.parse_args(words)
    with programs.refusals_told("plot"):
        draw(options.folders, draw_model if options.model else draw_run)
