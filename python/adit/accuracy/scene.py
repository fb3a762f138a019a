"""The scene that is asked about, as the reader of scenes reads it."""
import subprocess
import sys

import yaml

from adit import programs
from adit.results.run import SceneLoader


def read(scene, others):
    """As mappings and lists in SI units, with all bases and the `--set` among the options of the program; ends where it is refused."""
    command = [programs.program("coupler"), "check", scene, "--print", *sets_of(others)]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    if done.returncode:
        sys.exit(done.returncode)  # the reader has told why
    return yaml.load(done.stdout, SceneLoader)


def sets_of(others):
    """The words among options that set keys of the scene."""
    words = list(map(str, others))
    return [part for word, following in zip(words, [*words[1:], ""])
            for part in ((word, following) if word == "--set" else (word,) if word.startswith("--set=") else ())]


def parts_of(scene):
    """[(path, part)] of all continua and particles."""
    found = [(kind, scene[kind]) for kind in ("continuum", "particles") if kind in scene]
    for number, region in enumerate(scene.get("regions", [])):
        found += [(f"regions[{number}].{kind}", region[kind]) for kind in ("continuum", "particles") if kind in region]
    return found


def collected(part, path, names):
    """{path of a key: number} of all keys with these names, but for those that say where something is."""
    found = {}
    for key, value in part.items():
        here = f"{path}.{key}"
        if key in names and isinstance(value, (int, float)):
            found[here] = value
        for place, each in ((here, value),) if isinstance(value, dict) else ((f"{here}[{n}]", v) for n, v in enumerate(value if isinstance(value, list) else [])):
            if isinstance(each, dict) and key != "where":
                found |= collected(each, place, names)
    return found
