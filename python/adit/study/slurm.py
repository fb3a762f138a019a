"""A study as an array of jobs of Slurm: each computes a part of the runs into one folder, and a last one makes the table of them."""
import re
from pathlib import Path
from shlex import join, quote

from adit import programs
from adit.results.files import Unusable

TEMPLATE = Path(__file__).parent / "job.sh.in"


def part(climbs, text):
    """The climbs of part K of N."""
    found = re.fullmatch(r"(\d+)/(\d+)", text)
    if not found or not int(found[1]) < int(found[2]):
        raise Unusable(f"--part {text} is no part; write K/N with K from 0 to N-1, as in --part 0/4.")
    return climbs[int(found[1])::int(found[2])]


def write(study, out, parts, pictures):
    """Writes OUT/job.sh; yields what the user is told."""
    if parts < 1:
        raise Unusable(f"--slurm {parts}: an array has at least one part.")
    job = out / "job.sh"
    command = [*programs.own_command(), "study", str(study.path.resolve()), "--out", str(out), *([] if pictures else ["--no-pictures"])]
    words = {"title": f"Adit computes the study {study.path.name} in {parts} parts.", "name": quote(study.name), "last": str(parts - 1),
             "parts": str(parts), "job": quote(str(job)), "log": quote(str(out)), "study": join(command)}
    job.write_text(re.sub("@([a-z]+)@", lambda word: words[word[1]], TEMPLATE.read_text()))
    yield f"submit             sbatch {quote(str(job))}"
