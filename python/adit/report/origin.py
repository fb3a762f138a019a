"""How the results were made: timing, versions, hashes, the command that repeats them, the scene, every figure."""
import json

from adit.report.markup import details, section, table, tag
from adit.report.quantities import figure

LONGEST_SCENE = 100_000  # characters
COSTS = (("whole run", "wall_s"), ("model alone", "model_wall_s"), ("steps", "steps"), ("steps per second", "steps_per_s"),
         ("times as fast as the motion", "real_time_factor"), ("waiting for the servers", "coupler_wait_s"),
         ("solving for the multipliers", "coupler_solve_s"), ("processor time of the coupler", "coupler_cpu_s"))
OF_MODELS = (("{}: computing while others wait", "{}_compute_s"), ("{}: computing during the exchange", "{}_hidden_s"),
             ("{}: processor time of its server", "{}_cpu_s"))

ORIGINS = (("programs", "versions"), ("commit of the source", "revision"), ("computed at", "started"),
           ("hash of the scene", "scene_hash"), ("command", "command"), ("in the folder", "folder"))
SCENES = (("scene_as_written.yaml", "The scene as it was written"), ("scene.yaml", "The scene as it was computed, in SI units"))


def timing(results):
    s = results.figures
    models = [key.removesuffix("_cpu_s") for key in s if key.endswith("_cpu_s") and key != "coupler_cpu_s"]
    known = [*COSTS, *((said.format(m), key.format(m)) for m in models for said, key in OF_MODELS)]
    return section("timing", "Timing", table("What the run cost, from summary.json", None, [
        (said, figure(s, key)) for said, key in known if s.get(key) is not None]))


def chapter(results):
    s = results.summary
    told = [(said, s[key]) for said, key in ORIGINS if s.get(key)]
    told += [("hash of a file", f"{hash_}  {name}") for name, hash_ in s.get("inputs", {}).items()]
    rows = [(said, tag("td", text, class_="anywhere")) for said, text in told]
    return section("origin", "Versions, hashes and how to repeat the run", table("Where the results come from", None, rows),
                   _again(results), _scenes(results), details("Every figure of summary.json", every_figure(results)))


def _again(results):
    program = "simplified" if results.is_simplified else "coupler"
    return [tag("p", "The scene of this folder holds all that was extended and set. It computes the same results again, to the "
                     "last bit:"),
            tag("pre", tag("code", f"{program} run {results.folder.resolve().name}/scene.yaml --out again"), tabindex=0)]


def _scenes(results):
    found = []
    for name, what in SCENES:
        path = results.folder / name
        if path.exists():
            text = path.read_text(errors="replace")
            cut = f"\n… {len(text) - LONGEST_SCENE:,} characters more in {name}" if len(text) > LONGEST_SCENE else ""
            found.append(details(what, tag("pre", text[:LONGEST_SCENE] + cut, tabindex=0)))
    return found


def every_figure(results):
    return table("summary.json, as it stands; names end in their units", ("name", "value"), [
        (key, tag("td", value if isinstance(value, str) else json.dumps(value, ensure_ascii=False), data_raw=key))
        for key, value in results.summary.items()])
