"""A coupled run between two machines: steps per second over delay, jitter, loss and bandwidth of the network between them, and the
gain by computing during the exchange and by larger steps of the continuum (time.substeps).

The particles compute on the far machine, in the study of substeps the continuum does; all else on the near one. Each run must
give the histories of the run on loopback, bit for bit.
"""

import contextlib
import pathlib
import re
import statistics
import subprocess
import tempfile

from adit import Run
from network.machines import FAR, NEAR, Link, Machines
from adit.programs import listening

ROUNDS = 3
BEAM, LARGE = "cases/cantilever/variants/coupled_52x6.yaml", "cases/cantilever/variants/coupled_100k.yaml"
POINTS = {BEAM: 63, LARGE: 550}  # coupling points
STEPS = {BEAM: 400, LARGE: 100}
DT = {BEAM: 1.25e-5, LARGE: 7.3e-7}  # [s]
LINKS = {
    "no delay": Link(),
    "0.1 ms": Link(delay=0.05),
    "1 ms": Link(delay=0.5),
    "10 ms": Link(delay=5),
    "1 ms with jitter": Link(delay=0.25, jitter=0.5),
    "1 ms, loss 1 %": Link(delay=0.5, loss=0.01),
    "1 ms, 10 Mbit/s": Link(delay=0.5, rate=10),
}
LATE = "late_particles"  # dem_server that hides nothing behind the exchange
SUBSTEPS = (1, 2)  # more would make the steps of the particles smaller, as the zones of the beam are small
PROGRAMS = ("coupler", "fdm_server", "dem_server", "network_link", LATE)


def run(root):
    with tempfile.TemporaryDirectory() as folder:
        study = Study(root, pathlib.Path(folder))
        return [*study.traffic(), *study.links(), *study.substeps()]


def record(name, value, unit, size=0):
    return {"name": name, "size": size, "threads": 3, "value": value, "unit": unit}


def speed(summary):
    """Steps of the particles per second, without set-up."""
    return summary["steps"] * summary["substeps"] / (summary["coupler_wait_s"] + summary["coupler_solve_s"])


def parts(summaries, trip):
    """Times of a step on loopback [s]: the whole step; and the step without the round trip and the computing hidden behind it."""
    step = statistics.median(1 / speed(summary) for summary in summaries)
    hidden = statistics.median(max(summary[f"{name}_hidden_s"] for name in ("continuum", "particles")) / summary["steps"]
                               for summary in summaries)
    return step, step - trip - hidden


class Study:
    def __init__(self, root, folder):
        self.root, self.folder, self.programs = root, folder, root / "build/release"
        self.reference = {}  # histories on loopback, of each scene with its options
        self.parts = {}  # of the runs on loopback
        subprocess.run([root / "scripts/adit", "certificates", folder / "tls", f"near,{NEAR}", f"far,{FAR}"], check=True, capture_output=True)

    def machines(self, link):
        return Machines(self.programs / "tests/bench/network_link", link)

    @contextlib.contextmanager
    def server(self, machines, program, loopback=False, tls=False):
        """Its address, and the options by which the coupler is trusted."""
        place, host = (machines.on_near, "127.0.0.1") if loopback else (machines.on_far, FAR)
        trust = ("--tls", self.folder / "tls/far") if tls else () if loopback else ("--insecure",)
        folder = "tests/bench" if program == LATE else program
        with listening(*place(self.programs / folder / program, "--listen", f"{host}:0", *trust)) as address:
            yield address, ("--tls", self.folder / "tls/near") if tls else ()

    def coupler(self, machines, *arguments):
        done = subprocess.run(machines.on_near(self.programs / "coupler/coupler", *arguments), capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(done.stderr)
        return done.stdout

    def compute(self, machines, scene, options, *settings, steps=None):
        """The summary of a run. Its histories must be those of the first such run."""
        steps = steps or STEPS[scene]
        sets = [word for setting in (f"time.duration={steps * DT[scene]}", "output.field_times=[]", *settings) for word in ("--set", setting)]
        with tempfile.TemporaryDirectory(dir=self.folder) as out:
            self.coupler(machines, "run", self.root / scene, "--out", out, *sets, *options)
            summary, histories = Run(out).summary, (pathlib.Path(out) / "histories.csv").read_bytes()
        if self.reference.setdefault((scene, settings, steps), histories) != histories:
            raise RuntimeError(f"{scene}: the histories over the network are not those on loopback")
        return summary

    def traffic(self):
        """Bytes of a step to one server and back: of a run and of a longer one, the difference."""
        for scene, points in POINTS.items():
            said = []
            for share in (1, 2):
                with self.machines(Link()) as machines, self.server(machines, "dem_server") as (address, trust):
                    summary = self.compute(machines, scene, ("--dem", address, *trust), steps=share * STEPS[scene])
                said.append((summary["steps"], machines.carried))
            (few, short), (many, long) = said
            for way in ("there", "back"):
                yield record(f"bytes of a step, {way}", (long[way][0] - short[way][0]) / (many - few), "1", points)

    def links(self):
        yield from self.over("loopback", Link(), loopback=True)
        for name, link in LINKS.items():
            yield from self.over(name, link)
        yield from self.over("1 ms, TLS", LINKS["1 ms"], tls=True)

    def over(self, name, link, **how):
        with (self.machines(link) as machines, self.server(machines, "dem_server", **how) as (address, trust),
              self.server(machines, LATE, **how) as (late, _)):
            trips = {scene: self.round_trip(machines, address, trust, points) for scene, points in POINTS.items()}
            found = [[self.compute(machines, scene, ("--dem", server, *trust))
                      for scene, server in ((BEAM, address), (LARGE, address), (LARGE, late))] for _ in range(ROUNDS)]
        runs = dict(zip(("beam", "10^5 particles", "10^5 particles, nothing hidden"), zip(*found)))
        for (what, summaries), scene in zip(runs.items(), (BEAM, LARGE, LARGE)):
            if what not in self.parts:  # on loopback, which comes first
                self.parts[what] = parts(summaries, trips[scene])
            step, answering = self.parts[what]
            yield record(f"{name}: {what}", statistics.median(map(speed, summaries)), "steps/s", POINTS[scene])
            yield record(f"{name}: {what}, model", 1 / max(step, trips[scene] + answering), "steps/s", POINTS[scene])
        yield from (record(f"{name}: round trip", 1e6 * trip, "us", POINTS[scene]) for scene, trip in trips.items())
        hidden = statistics.median(speed(with_it) / speed(without) for _, with_it, without in found)
        yield record(f"{name}: gain by hiding", hidden, "1", POINTS[LARGE])

    def round_trip(self, machines, address, trust, points):
        """Round trip of messages for so many coupling points, without computing [s]."""
        told = self.coupler(machines, "doctor", address, "--points", points, *trust)
        number, unit = re.search(r"round trip +([\d.,]+) (\S+) median", told).groups()
        return float(number.replace(",", "")) * {"µs": 1e-6, "ms": 1e-3}[unit]

    def substeps(self):
        """While the continuum is far away."""
        for name in ("no delay", "1 ms", "10 ms"):
            with self.machines(LINKS[name]) as machines, self.server(machines, "fdm_server") as (address, trust):
                for substeps in SUBSTEPS:
                    speeds = [speed(self.compute(machines, BEAM, ("--fdm", address, *trust), f"time.substeps={substeps}"))
                              for _ in range(ROUNDS)]
                    yield record(f"{name}, continuum far: substeps {substeps}", statistics.median(speeds), "steps/s", POINTS[BEAM])
