"""One coupled step: its time, the parts of it, and the time of a bare round trip on the same machine; by Unix sockets,
TCP and TLS."""

import contextlib
import pathlib
import statistics
import subprocess
import tempfile

from adit import Run
from adit.programs import listening

ROUNDS = 7
SHORT = "cases/cantilever/variants/coupled_52x6.yaml"
LONG = "cases/cantilever/variants/coupled_100k.yaml"
OVERHEAD_BYTES = 40  # bytes of a frame besides its interface values
PROGRAMS = ("coupler", "fdm_server", "dem_server", "ping_pong")


def run(root):
    return small(root) + ways(root) + large(root)


def median_by_key(samples):
    return {key: statistics.median(sample[key] for sample in samples) for key in samples[0]}


def coupled(root, scene, *options):
    """Microseconds in a step for each of its parts, and the size of the model."""
    with tempfile.TemporaryDirectory() as out:
        subprocess.run([root / "build/release/coupler/coupler", "run", root / scene, "--out", out, *options],
                       check=True, capture_output=True)
        s = Run(out).summary
    us = 1e6 / s["steps"]
    return {"step": us * (s["coupler_wait_s"] + s["coupler_solve_s"]), "waiting": us * s["coupler_wait_s"], "coupler": us * s["coupler_solve_s"],
            "continuum": us * (s["continuum_compute_s"] + s["continuum_hidden_s"]),
            "particles": us * (s["particles_compute_s"] + s["particles_hidden_s"]), "hidden": s["hidden_share"],
            "size": s["particles"], "points": s["coupling_points"]}


def round_trip(root, points):
    size = 16 * points + OVERHEAD_BYTES
    lines = subprocess.run([root / "build/release/tests/bench/ping_pong", str(size), str(size), "20000"],
                           check=True, capture_output=True, text=True).stdout.split()
    return {"bytes": size, lines[0]: float(lines[1]), lines[2]: float(lines[3])}


def small(root):
    """The 52 x 6 cantilever: steps and bare round trips in turn, medians of both."""
    points = coupled(root, SHORT)["points"]
    bare, steps = [], []
    for _ in range(ROUNDS):
        bare.append(round_trip(root, points))
        steps.append(coupled(root, SHORT))
    bare, step = median_by_key(bare), median_by_key(steps)
    size = step["size"]

    def record(name, value, unit="us", size=size, threads=3):
        return {"name": name, "size": size, "threads": threads, "value": value, "unit": unit}

    return [
        record("bare round trip, blocking", bare["blocking"], size=bare["bytes"], threads=2),
        record("bare round trip, spinning", bare["spinning"], size=bare["bytes"], threads=2),
        record("coupled step", step["step"]),
        record("coupled step: particles computing", step["particles"]),
        record("coupled step: continuum computing", step["continuum"]),
        record("coupled step: waiting for both", step["waiting"]),
        record("coupled step: multipliers", step["coupler"]),
        record("computing hidden behind the exchange", step["hidden"], "1"),
        record("coupled step over blocking round trip", step["step"] / bare["blocking"], "1"),
        record("coupled step over spinning round trip", step["step"] / bare["spinning"], "1"),
    ]


def ways(root):
    """The 52 x 6 cantilever with servers that listen in three ways, in turn: ratios of pairs of runs."""
    with contextlib.ExitStack() as stack:
        folder = pathlib.Path(stack.enter_context(tempfile.TemporaryDirectory()))
        subprocess.run([root / "scripts/adit", "certificates", folder, "localhost,127.0.0.1"], check=True, capture_output=True)
        tls = ("--tls", folder / "localhost")

        def join(listen, *options):
            names = {"--fdm": "fdm_server", "--dem": "dem_server"}
            addresses = [(option, stack.enter_context(listening(root / "build/release" / name / name, "--listen", listen.format(name), *options)))
                         for option, name in names.items()]
            return [word for pair in addresses for word in pair] + [*options]

        ways = {"Unix sockets": join(f"unix:{folder}/{{}}"), "TCP": join("127.0.0.1:0"), "TCP with TLS": join("127.0.0.1:0", *tls)}
        steps = [{way: coupled(root, SHORT, *options)["step"] for way, options in ways.items()} for _ in range(ROUNDS)]
    ratios = [{way: step[way] / step["TCP"] for way in ways} for step in steps]
    return [{"name": f"coupled step by {way}{over}", "size": 0, "threads": 3, "value": value, "unit": unit}
            for values, over, unit in ((steps, "", "us"), (ratios, ", over TCP", "1"))
            for way, value in median_by_key(values).items()]


def large(root):
    """10^5 particles: the time of a step beyond the computing of the slower side."""
    step = median_by_key([coupled(root, LONG) for _ in range(3)])
    exchange = step["waiting"] + step["coupler"] - max(step["particles"], step["continuum"])
    return [{"name": "coupled step", "size": step["size"], "threads": 3, "value": step["step"], "unit": "us"},
            {"name": "exchange", "size": step["size"], "threads": 3, "value": exchange, "unit": "us"},
            {"name": "exchange as a share of the step", "size": step["size"], "threads": 3,
             "value": exchange / step["step"], "unit": "1"},
            {"name": "computing hidden behind the exchange", "size": step["size"], "threads": 3,
             "value": step["hidden"], "unit": "1"}]
