"""Draws a run's pictures, or the models of a case in one picture.

%(prog)s RUN_DIR
    writes RUN_DIR/pictures/: deformed model, force chains, bonds, cracks, linings, displacement, principal stress, yield state and
    pore pressure at the field times, eight of them or --all; histories, energy, peaks over time and spectra. A run of a whole
    tunnel gives envelopes along the axis and motion over time and distance.
%(prog)s --model SCENE.yaml
    draws the model before it runs (`coupler check`): materials and groups, stages, joints, supports, water, boundaries, loads,
    probes, overlap. The pictures are in runs/CASE/SCENE_model/pictures/. The folder of a `coupler check --out` may replace the scene.
"""
import subprocess
import sys
from pathlib import Path

from adit import Run, programs
from adit.plots import (colour_pictures, crack_pictures, instants, lining_pictures, model_pictures, png, spectra_pictures, style, time_pictures,
                        tunnel_pictures)
from adit.plots.cores import on_all_cores
from adit.plots.deformation import scale_of_run
from adit.plots.setup import sheets
from adit.plots.setup.checked import Checked

OF_AN_INSTANT = (model_pictures.force_chains, model_pictures.bonds, crack_pictures.cracks, lining_pictures.lining_forces, lining_pictures.member_forces,
                 lining_pictures.lining_joints, lining_pictures.interfaces,
                 colour_pictures.displacement, colour_pictures.principal_stress, colour_pictures.yield_state,
                 colour_pictures.pore_pressure, colour_pictures.pressure_ratio)
OVER_TIME = (time_pictures.histories, time_pictures.energy, lining_pictures.lining_capacity, lining_pictures.member_capacity,
             lining_pictures.section_capacity)


def draw_run(folder, most=None):
    """Draws a run, at `most` of its instants, all where there is no limit; returns the paths of the pictures."""
    run = Run(folder)
    pictures = run.folder / "pictures"
    for old in pictures.glob("*.png"):  # an earlier run may have had other field times
        old.unlink()
    groups = list(_groups(run, most))

    def drawn(number):
        draw, *arguments = groups[number]
        return [png.write(drawing, pictures / f"{name}.png") for name, drawing in draw(run, *arguments) if drawing]

    paths = []
    for done, more in enumerate(on_all_cores(drawn, len(groups)), start=1):
        paths += more
        programs.tell_progress(f"pictures: {100 * done / len(groups):.0f} %")
    programs.tell_progress()
    return paths


def _groups(run, most):
    """(function, arguments) of pictures that are drawn together: those of an instant read its fields once."""
    if run.is_simplified:
        yield from ((_one, draw) for draw in (tunnel_pictures.envelopes, tunnel_pictures.time_distance))
        return
    numbers = range(len(run.instants))
    if most and len(numbers) > most:
        numbers = instants.spread(numbers, most, run.fields().values())
    scale = scale_of_run(run)
    yield from ((_of_instant, number, scale) for number in numbers)
    yield (spectra_pictures.motions,)
    yield from ((_one, draw) for draw in OVER_TIME)


def _one(run, draw):
    yield draw.__name__, draw(run)


def _of_instant(run, number, scale):
    time, pieces = run.instants[number][0], run.pieces_at(number)
    yield f"deformed_{style.milliseconds(time)}ms", model_pictures.deformed(run, time, pieces, scale)
    for draw in OF_AN_INSTANT:
        yield f"{draw.__name__}_{style.milliseconds(time)}ms", draw(run, time, pieces)
    if number == len(run.instants) - 1:  # the last one has the peaks of the whole run
        yield from colour_pictures.peaks(run, time, pieces)


def draw_model(scene):
    """Draws the model of a scene before it runs; returns the paths of the pictures."""
    scene = Path(scene)
    folder = scene if scene.is_dir() else check(scene)
    return [png.write(drawing, folder / "pictures" / f"{name}.png") for name, drawing in sheets.model(Checked(folder))]


def check(scene):
    """Writes the undeformed model and returns its folder."""
    programs.bring_up_to_date("coupler", "fdm_server", "dem_server")
    folder = programs.RUNS / scene.resolve().parent.name / f"{scene.stem}_model"
    done = subprocess.run([programs.program("coupler"), "check", scene, "--out", folder])
    if done.returncode:
        sys.exit(done.returncode)
    return folder


def tell(drawn):
    """Prints where pictures are."""
    print(drawn[0] if len(drawn) == 1 else f"{len(drawn)} pictures in {Path(drawn[0]).parent}" if drawn else "nothing to draw",
          flush=True)


def main(words):
    parser = programs.parser("plot", __doc__)
    parser.add_argument("folders", metavar="RUN_DIR", nargs="+", help="folder of a run, or a scene")
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--model", action="store_true", help="draw the models of scenes before they run")
    which.add_argument("--all", action="store_true", help=f"draw all instants, not {instants.MOST} of them as `adit run` does")
    options = parser.parse_args(words)
    draw = draw_model if options.model else lambda folder: draw_run(folder, None if options.all else instants.MOST)
    tell([path for folder in options.folders for path in draw(folder)])
