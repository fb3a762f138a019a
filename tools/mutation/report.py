"""The results of a run of changes as text."""

import sys

from .trial import Verdict


def tell(result):
    """One line as soon as a change is tried."""
    by = f" by {result.by}" if result.by else ""
    print(f"{result.change.path}:{result.change.line}: {result.verdict.value}{by}", flush=True)


def room_of(path):
    """The program, and the room in it."""
    parts = path.split("/")
    return "/".join(parts[:2]) if len(parts) > 2 else parts[0]


def print_summary(results, out=sys.stdout):
    """The changes that no test noticed, and a table by room."""
    unnoticed = [result for result in results if result.verdict is Verdict.UNNOTICED]
    if unnoticed:
        print("\nNo test noticed:", file=out)
    for result in unnoticed:
        print(f"{result.change}", file=out)
    rooms = sorted({room_of(result.change.path) for result in results})
    width = max(map(len, [*rooms, "all"]), default=0)
    print(f"\n{'room':{width}}  tried  noticed  same code  not compiled  not in tests", file=out)
    for room in [*rooms, "all"]:
        here = [r.verdict for r in results if room in ("all", room_of(r.change.path))]
        judged = here.count(Verdict.NOTICED) + here.count(Verdict.UNNOTICED)
        print(f"{room:{width}}  {judged:5}  {here.count(Verdict.NOTICED):7}  {here.count(Verdict.SAME_CODE):9}"
              f"  {here.count(Verdict.NOT_COMPILED):12}  {here.count(Verdict.NOT_IN_TESTS):12}", file=out)
