"""Measures what speed costs in accuracy: %(prog)s SCENE.yaml | NAME | --page

SCENE.yaml: coarser and finer models of a scene along each dimension that it has, compared with the finest by its `questions`. NAME is a
scene that comes with Adit (cantilever, bar, ground_patch), of which the same is computed, or a tunnel (longxi, longxi_cells, qingcaosha,
hzm), whose models from the cheapest to the finest are compared with the finest; without a name all of them are computed. Writes
runs/trade/NAME.csv (a row a model), NAME.md (the same as a table) and NAME.png (differences over CPU time). --page computes what is missing,
and writes docs/trade.md.
"""
from pathlib import Path

from adit import programs
from adit.plots import style
from adit.results.files import Unusable
from adit.trade import table
from adit.trade.ladders import NAMES, SCENES, TUNNELS
from adit.trade.own import command as own
from adit.trade.page import page
from adit.trade.tunnels import ladder
from adit.trade.tunnels.picture import findings_over_cost


def climb(steps, out):
    def told(row):
        print(f"  {steps.name}: {row['model']}: {row['cpu_s']:.3g} CPU s, {row['wall_s']:.3g} s", flush=True)

    rows = ladder.table(steps, out / steps.name, told)
    table.write_csv(out / f"{steps.name}.csv", rows)
    lines = list(ladder.markdown(steps, rows))
    (out / f"{steps.name}.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    style.save(findings_over_cost(steps, rows), out / f"{steps.name}.png")
    print(*lines, f"written: {out / steps.name}.csv, .md, .png", sep="\n")


def compute(name, options):
    if name in TUNNELS:
        climb(TUNNELS[name].ladder(options.quick), options.out)
    else:
        scene, questions = SCENES[name]
        own.trade(name, scene, options.figure or questions, options)


def parsed(words):
    parser = programs.parser("trade", __doc__)
    parser.add_argument("case", metavar="SCENE.yaml | NAME", nargs="?", help="a scene, or %s [default: all of these]" % ", ".join(NAMES))
    parser.add_argument("--page", action="store_true", help="compute all of these that have no results, and write docs/trade.md")
    parser.add_argument("--budget", metavar="TIME", help="of a scene: begin no model that would end later than this [default: that of the scene's "
                        "accuracy, or 20min]")
    parser.add_argument("--figure", action="append", metavar="KEY", help="of a scene: a figure of summary.json in place of its questions; may be repeated")
    parser.add_argument("--quick", action="store_true", help="for tests: few models of a tunnel, over a short time")
    parser.add_argument("--out", type=Path, default=programs.RUNS / "trade", help="folder of the results")
    options = parser.parse_args(words)
    if options.case in TUNNELS or not options.case:
        if options.budget or options.figure:
            raise Unusable("--budget and --figure belong to a scene; name one.")
    elif options.quick:
        raise Unusable("--quick belongs to a tunnel; --budget ends the models of a scene.")
    elif options.case not in SCENES and not Path(options.case).exists():
        raise Unusable(f"{options.case} is neither a scene nor one of {', '.join(NAMES)}.")
    if options.page and (options.case or options.quick):
        raise Unusable("--page takes all results; it goes with --out only.")
    return options


def main(words):
    options = parsed(words)
    if options.page:
        page.check_place()
    missing = page.missing(options.out) if options.page else ()
    if missing or not options.page:
        programs.bring_up_to_date("coupler", "fdm_server", "dem_server", "simplified")
    options.out.mkdir(parents=True, exist_ok=True)
    if options.page:
        for name in missing:
            compute(name, options)
        page.write(options.out)
    elif options.case and options.case not in NAMES:
        scene = Path(options.case).resolve()
        own.trade(scene.stem, scene, options.figure, options)
    else:
        for name in [options.case] if options.case else NAMES:
            compute(name, options)
