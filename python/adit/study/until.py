"""`--until 'median within 10 %'`: runs are added, a motion at a time, until every median that the runs tell is known as well."""
import re

from adit.accuracy.shares import share_of
from adit.results.files import Unusable
from adit.study import table
from adit.study.fragility import needed
from adit.study.outcome import Outcome

AT_A_TIME = 4  # climbs, or more where a motion has more; the same on every machine, and so the same table


def target(text):
    """The share of `median within 10 %`."""
    found = re.fullmatch(r"\s*median\s+within\s+(\d*\.?\d+\s*%?)\s*", text)
    share = share_of(found[1]) if found else None
    if share is None:
        raise Unusable(f"--until '{text}' is not understood; write for example --until 'median within 10 %'.")
    return share


def add_runs(plan, options, share, computed):
    """(all of [(row, result)], what the user is told). Ends where the medians are known, no further run would be another one, or
    `options.most` runs are made."""
    queue = []
    while True:
        curves = [each for each in Outcome(plan.study, table.rows_of(plan.study, computed, plan.out)).curves if each.fit.curve]
        if curves and all(needed.reached(each.intervals["median"], share) for each in curves):
            return computed, [f"until              every median is known within {100 * share:g} %: {len(computed)} runs"]
        if len(computed) >= options.most:
            return computed, [f"until              the medians are not known within {100 * share:g} % by {len(computed)} runs; --most allows no more"]
        batch = []
        while len(batch) < AT_A_TIME and (queue or (queue := of_one_motion(plan.next_round()))):
            batch += queue.pop(0)
        if not batch:
            return computed, [f"until              further runs would be the same as these {len(computed)}; give more motions, or random quantities"]
        computed = computed + plan.compute(batch, options)


def of_one_motion(climbs):
    """Climbs in groups of one motion each."""
    groups = {}
    for climb in climbs:
        groups.setdefault(climb[0].motion, []).append(climb)
    return list(groups.values())
