"""Finds micro-properties of cemented discs that give wanted laboratory values.

%(prog)s --young-modulus 69e9 --poisson-ratio 0.26 --compressive-strength 200e6 --tensile-strength 40e6

Tests random packings (plane strain) in uniaxial compression and as Brazilian discs (cases/calibration), repeatedly; prints a part
of a scene, and the wanted and the reached values. Discs cannot reach a compressive strength beyond a few times the tensile strength:
both strengths then share the misfit.
"""
import argparse
import sys
from pathlib import Path

import yaml

from adit import programs
from adit.calibrate.fit import Wanted, fit
from adit.calibrate.laboratory import Laboratory, Specimen, bonds_and_contacts, mean_properties
from adit.runs import coupled_runs


def above_zero(text):
    value = float(text)
    if not 0 < value < float("inf"):
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return value


def main(words):
    parser = programs.parser("calibrate", __doc__)
    parser.add_argument("--young-modulus", type=above_zero, required=True, metavar="PA")
    parser.add_argument("--poisson-ratio", type=above_zero, required=True, metavar="NU")
    parser.add_argument("--compressive-strength", type=above_zero, required=True, metavar="PA", help="uniaxial")
    parser.add_argument("--tensile-strength", type=above_zero, required=True, metavar="PA", help="of the Brazilian test")
    parser.add_argument("--radius-min", type=above_zero, default=0.56e-3, metavar="M", help="the specimen is 89 times as wide")
    parser.add_argument("--size-ratio", type=above_zero, default=1.66, help="largest over smallest radius")
    parser.add_argument("--density", type=above_zero, default=2630.0, metavar="KG/M3")
    parser.add_argument("--seeds", type=int, default=3, metavar="N", help="packings of the seeds 1 to N, whose means are fitted")
    parser.add_argument("--out", metavar="DIR", type=Path, default=programs.RUNS / "calibrate", help="folder of the runs")
    options = parser.parse_args(words)
    if options.size_ratio < 1:
        parser.error("--size-ratio is below 1")
    if options.seeds < 1:
        parser.error("--seeds is below 1")
    programs.bring_up_to_date("coupler", "dem_server")
    r = options.radius_min
    specimen = Specimen(width=r / 0.56e-3 * 0.05, height=r / 0.56e-3 * 0.1, radius_min=r,
                        radius_max=options.size_ratio * r, density=options.density)
    wanted = Wanted(options.young_modulus, options.poisson_ratio, options.compressive_strength, options.tensile_strength)
    try:
        laboratory = Laboratory.grown(specimen, options.seeds, options.out)
        micro, rocks = fit(wanted, laboratory, lambda text: print(text, flush=True))
    except coupled_runs.Failed as reason:
        print(f"{parser.prog}: {reason}", file=sys.stderr)
        sys.exit(1)
    print(f"\n{'':36}{'wanted':>10}{'reached':>10}{'misfit':>10}")
    reached = mean_properties(rocks)
    for name, goal in wanted.properties().items():
        value = reached[name]
        scale, unit = (1e6, " [MPa]") if name.endswith("_Pa") else (1, "")
        print(f"{name.removesuffix('_Pa').replace('_', ' ') + unit:36}{goal / scale:10.5g}{value / scale:10.5g}"
              f"{100 * (value / goal - 1):9.1f}%")
    text = yaml.safe_dump({"particles": bonds_and_contacts(micro, specimen)}, sort_keys=False)
    (options.out / "particles.yaml").write_text(text)
    print(f"\n{text}\nResults: {options.out}/particles.yaml")
