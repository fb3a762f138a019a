"""Tests a participant: the states, limits and faults of the protocol, and its physics.

    %(prog)s --fdm COMMAND_OR_ADDRESS [--only WORD]
    %(prog)s --dem 'adapters/python/particles.py --listen 127.0.0.1:0'
    %(prog)s --dem 127.0.0.1:4712

A command must print `listening on HOST:PORT`. A line of the table is one check: `ok`, `FAILED` with the fault, or `-`
if the participant refuses the scene of the check, which is allowed. If a check failed, the exit code is 1, and the output of the
command follows the table.
"""
import sys

from adit import programs
from adit.conformance import CHECKS
from adit.conformance.client import Failure, Gone, NotComputed, Participant


def name_of(check):
    return check.__name__.replace("_", " ")


def outcome(check, participant):
    try:
        check(participant)
    except NotComputed as reason:
        return "-", str(reason)
    except (Failure, Gone, OSError) as failure:
        return "FAILED", str(failure) or type(failure).__name__
    return "ok", ""


def main(words):
    options = programs.parser("conformance", __doc__)
    role = options.add_mutually_exclusive_group(required=True)
    role.add_argument("--fdm", help="the continuum under test: its command, or HOST:PORT")
    role.add_argument("--dem", help="the particles under test, likewise")
    options.add_argument("--only", default="", help="only the checks whose names contain this")
    given = options.parse_args(words)
    checks = [check for check in CHECKS if given.only in name_of(check)]
    if not checks:
        options.error(f"--only {given.only!r} is in no check's name; the table shows the names")
    participant = Participant("continuum", given.fdm) if given.fdm else Participant("particles", given.dem)
    failed = 0
    try:
        for check in checks:
            found, why = outcome(check, participant)
            failed += found == "FAILED"
            print(f"{name_of(check):24}{found:8}{check.__doc__}", flush=True)
            if why:
                print(f"{'':32}{why}", flush=True)
    finally:
        participant.stop()
    if failed and participant.said():
        print(f"\nThe participant printed:\n{participant.said()}", end="")
    sys.exit(1 if failed else 0)
