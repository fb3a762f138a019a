"""Other codes beside ours: both compute the same model, in turn, on one core, and every pair of turns gives a ratio.

A machine that changes its speed changes it for both codes of a pair, so that the ratio holds where the speeds do not. Both
are measured by processor time: other work on the machine costs them cache and bandwidth, but not their time slices.
"""

import dataclasses
import os
import platform
import re
import statistics
import subprocess
from typing import Callable

ROUNDS = 5


@dataclasses.dataclass(frozen=True)
class Pair:
    model: str
    size: int
    unit: str
    ours: str
    our_speed: Callable[[], float]
    peer: str
    peer_speed: Callable[[], float]


@dataclasses.dataclass(frozen=True)
class Compared:
    pair: Pair
    ours: list[float]
    peers: list[float]

    @property
    def ratios(self):
        return [ours / peers for ours, peers in zip(self.ours, self.peers)]


def compare(pair):
    """Both codes after each other, `ROUNDS` times, on the last core that this program may use."""
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {max(allowed)})
    try:
        turns = [(pair.our_speed(), pair.peer_speed()) for _ in range(ROUNDS)]
    finally:
        os.sched_setaffinity(0, allowed)
    return Compared(pair, *map(list, zip(*turns)))


def records(compared):
    of = {"size": compared.pair.size, "threads": 1}
    name = f"{compared.pair.model}: {compared.pair.ours} and {compared.pair.peer}"
    return [{"name": f"{name}, ours", **of, "value": statistics.median(compared.ours), "unit": compared.pair.unit},
            {"name": f"{name}, theirs", **of, "value": statistics.median(compared.peers), "unit": compared.pair.unit},
            {"name": f"{name}, ratio", **of, "value": statistics.median(compared.ratios), "unit": "1"}]


def table(root, all_compared):
    """The comparison as a page, with the machine, its load and the flags of our programs."""
    rows = [row(compared) for compared in all_compared]
    return "\n".join([
        "| model | size | ours | 10⁶/s | other code | 10⁶/s | ratio: median (least to most) |", "|---|---|---|---|---|---|---|", *rows, "",
        f"10⁶/s are {', '.join(sorted({compared.pair.unit for compared in all_compared}))}, in millions; medians of {ROUNDS} turns.",
        f"Machine: {processor()}, {os.cpu_count()} cores; load {', '.join(f'{load:.1f}' for load in os.getloadavg())} after the runs.",
        f"Our programs: {flags(root)}.", ""])


def row(compared):
    pair, ratios = compared.pair, compared.ratios
    ours, peers = (statistics.median(speeds) / 1e6 for speeds in (compared.ours, compared.peers))
    spread = f"{statistics.median(ratios):.3g} ({min(ratios):.3g} to {max(ratios):.3g})"
    return f"| {pair.model} | {pair.size} | {pair.ours} | {ours:.3g} | {pair.peer} | {peers:.3g} | {spread} |"


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        found = re.search(r"^model name\s*:\s*(.*)$", file.read(), re.MULTILINE)
    return found[1] if found else platform.machine()


def flags(root):
    cache = (root / "build/release/CMakeCache.txt").read_text()
    value = {key: found[1] for key in ("CMAKE_CXX_COMPILER", "CMAKE_CXX_FLAGS_RELEASE", "ADIT_ARCH")
             if (found := re.search(rf"^{key}:\w+=(.*)$", cache, re.MULTILINE))}
    version = subprocess.run([value["CMAKE_CXX_COMPILER"], "-dumpfullversion"], capture_output=True, text=True, check=True).stdout.strip()
    return f"{os.path.basename(value['CMAKE_CXX_COMPILER'])} {version} {value['CMAKE_CXX_FLAGS_RELEASE']} -march={value.get('ADIT_ARCH', '')}".strip()
