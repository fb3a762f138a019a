"""Measures what speed costs in accuracy: %(prog)s SCENE.yaml | cantilever | bar | longxi | longxi_cells | qingcaosha | hzm | all

SCENE.yaml: coarser and finer models of a scene along each dimension that it has, compared with the finest by its `questions`.
cantilever, bar: variants of a coupled model, compared with the particles alone. longxi, qingcaosha, hzm: models of a tunnel from
the cheapest to the finest, compared with the finest. Computes one after the other and writes runs/trade/NAME.csv (a row a
variant), NAME.md (the same as a page) and NAME.png (errors over cost). adit/trade defines the variants; docs/trade.md
explains the columns and the conclusions.
"""
from pathlib import Path

from adit import programs
from adit.plots import style
from adit.results.files import Unusable
from adit.trade import front, measure, models, picture, table
from adit.trade.own import command as own
from adit.trade.tunnels import hzm, ladder, longxi, longxi_cells, qingcaosha
from adit.trade.tunnels.picture import findings_over_cost

TUNNELS = {"longxi": longxi, "longxi_cells": longxi_cells, "qingcaosha": qingcaosha, "hzm": hzm}


def study(model, out):
    rows = []
    for row in measure.table(model, out / model.name):
        rows.append(row)
        print(f"  {model.name}: {row['variant']}: force {100 * row['force_l2']:.2f} %, {row['cpu_s']:.3g} CPU s",
              flush=True)
    write(model.name, rows, table.markdown(rows), picture.pareto(model.name, rows), out)
    print(*front.advice(rows), sep="\n")


def climb(steps, out):
    def told(row):
        print(f"  {steps.name}: {row['model']}: {row['cpu_s']:.3g} CPU s, {row['wall_s']:.3g} s", flush=True)

    rows = ladder.table(steps, out / steps.name, told)
    write(steps.name, rows, ladder.markdown(steps, rows), findings_over_cost(steps, rows), out)


def write(name, rows, markdown, drawn, out):
    table.write_csv(out / f"{name}.csv", rows)
    lines = list(markdown)
    (out / f"{name}.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    style.save(drawn, out / f"{name}.png")
    print(*lines, f"written: {out / name}.csv, .md, .png", sep="\n")


def main(words):
    parser = programs.parser("trade", __doc__)
    parser.add_argument("case", metavar="SCENE.yaml | NAME", nargs="?", default="all", help="a scene, or %s" % ", ".join([*models.MODELS, *TUNNELS, "all"]))
    parser.add_argument("--budget", metavar="TIME", help="of a scene: begin no model that would end later than this [default: that of the scene's "
                        "accuracy, or 20min]")
    parser.add_argument("--figure", action="append", metavar="KEY", help="of a scene: a figure of summary.json in place of its questions; may be repeated")
    parser.add_argument("--quick", action="store_true",
                        help="for tests: a tiny bar instead of cantilever and bar; few models of a tunnel, over a short time")
    parser.add_argument("--out", type=Path, default=programs.RUNS / "trade", help="folder of the results")
    options = parser.parse_args(words)
    programs.bring_up_to_date("coupler", "fdm_server", "dem_server", "simplified")
    known = [*models.MODELS, *TUNNELS]
    if options.case not in (*known, "all"):
        if not Path(options.case).exists():
            raise Unusable(f"{options.case} is neither a scene nor one of {', '.join([*known, 'all'])}.")
        options.out.mkdir(parents=True, exist_ok=True)
        return own.trade(Path(options.case).resolve(), options)
    if options.budget or options.figure:
        raise Unusable("--budget and --figure belong to a scene; name one.")
    options.out.mkdir(parents=True, exist_ok=True)
    for name in known if options.case == "all" else [options.case]:
        if name in TUNNELS:
            climb(TUNNELS[name].ladder(options.quick), options.out)
        else:
            study(models.TINY if options.quick else models.MODELS[name], options.out)
