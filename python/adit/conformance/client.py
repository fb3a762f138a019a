"""The coupler's end of a conversation, as the checks use it."""
import re
import shlex
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from adit import programs

sys.path.insert(0, str(programs.ROOT / "adapters/python"))
from google.protobuf import text_format  # noqa: E402
from wire import MAX_FRAME, PREAMBLE, Gone, Link, scene, wire  # noqa: E402,F401

START_S = 10


class Failure(Exception):
    """The participant violates docs/protocol.md."""


class NotComputed(Exception):
    """The participant refuses the scene of a check, as it may."""


def require(holds, sentence):
    if not holds:
        raise Failure(sentence)


class Participant:
    """A participant under test, started by a command or listening already; its role is `continuum` or `particles`."""

    def __init__(self, role, given):
        self.role, self.process, self.output = role, None, None
        host, _, port = (given if re.fullmatch(r"\S+:\d+", given) else self.start(given)).rpartition(":")
        self.address = host, int(port)

    def start(self, command):
        """The address at which it listens. Its output goes into a file, so that printing never blocks it."""
        self.output = tempfile.NamedTemporaryFile("ab", prefix="conformance_")
        self.process = subprocess.Popen(shlex.split(command), stdout=self.output, stderr=self.output)
        while not (listening := re.search(r"^listening on (\S+:\d+)\n", self.said(), re.MULTILINE)):
            if self.process.poll() is not None:
                raise SystemExit(f"conformance: `{command}` ended before it printed `listening on HOST:PORT`\n{self.said()}")
            time.sleep(0.05)
        return listening[1]

    def said(self):
        """The output of the command."""
        return Path(self.output.name).read_text(errors="replace") if self.output else ""

    def stop(self):
        if self.process:
            self.process.terminate()
            self.process.wait()

    def connect(self):
        """A connection without any greeting."""
        link = Link(socket.create_connection(self.address, timeout=START_S))
        link.accepts = MAX_FRAME
        return link

    def run(self):
        """A run; the participant has some seconds to notice that the client of the last one has gone."""
        deadline = time.monotonic() + START_S
        while True:
            try:
                return Run(self.connect())
            except (OSError, Gone) as error:
                if time.monotonic() > deadline:
                    raise Failure(f"serves no further run: {error}") from error
                time.sleep(0.05)

    def serves_another_run(self):
        with self.run() as run:
            run.set_up(scene_of(self.role))
            run.expect("bye", finish=wire.Finish())


class Run:
    """A connection that was greeted."""

    def __init__(self, link):
        self.link = link
        try:
            link.greet("conformance")
        except (OSError, Gone):
            link.socket.close()
            raise

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.link.socket.close()

    def ask(self, **content):
        """The kind and the message of the answer to a request."""
        self.link.send(wire.Frame(**content))
        frame = self.link.next_answer()
        kind = frame.WhichOneof("content")
        return kind, getattr(frame, kind)

    def expect(self, expected, **content):
        kind, answer = self.ask(**content)
        if kind == "error" and answer.kind == wire.Error.SCENE and expected != "error":
            raise NotComputed(f"{answer.path} {answer.message}")
        said = f": {answer.message}" if kind == "error" else ""
        require(kind == expected, f"answers {next(iter(content))} by {kind} where {expected} was expected{said}")
        return answer

    def expect_error(self, kind, **content):
        answer = self.expect("error", **content)
        found, wanted = wire.Error.Kind.Name(answer.kind), wire.Error.Kind.Name(kind)
        require(found == wanted, f"answers {next(iter(content))} by an error of kind {found}, expected {wanted}: {answer.message}")
        return answer

    def set_up(self, described):
        self.model = self.expect("model", setup=wire.Setup(run_id="conformance", scene=described))
        return self.model

    def weigh(self, weight=1.0, coupled=True):
        """Equal weights everywhere, and a box around the whole model."""
        model = self.model
        weights = wire.Weights(floor=1e-3, x_min=model.x_min, x_max=model.x_max, y_min=model.y_min, y_max=model.y_max)
        if coupled:
            weights.weights.extend([weight] * (len(model.sample_points) // 2))
        self.interface = self.expect("interface", weights=weights)
        self.points = np.reshape(self.interface.points, (-1, 2))
        return self.interface

    def couple(self, points):
        self.operator = self.expect("operator", couple=wire.Couple(points=np.ravel(points).tolist()))
        return self.operator

    def step(self, n, dt, impulses=(), **wanted):
        advance = wire.Advance(step=n, dt=dt, impulses=np.ravel(impulses).tolist(), **wanted)
        predicted = self.expect("predicted", advance=advance)
        require(predicted.step == n, f"predicts step {predicted.step} where step {n} was asked for")
        require(predicted.HasField("energies") == advance.want_energies, f"step {n}: energies came unasked, or not where asked")
        require(predicted.HasField("relaxation") == advance.relax, f"step {n}: relaxation came in time, or not in statics")
        return predicted

    def relax(self, n, dt, **asked):
        """A step of statics."""
        return self.step(n, dt, relax=True, **asked)


STATED = {"young": 2e7, "poisson": 0.2, "density": 2000.0}
MODELS = {
    "continuum": "continuum { block { x_min: 0 x_max: 4 y_min: 0 y_max: 2 zones_x: 8 zones_y: 5 } %s }",
    "particles": "particles { packing { x_min: 0 x_max: 2 y_min: 0 y_max: 1 radius: 0.1 } bonds {} %s }"}


def scene_of(role, inside="", around=""):
    """A small elastic model in plane stress; `inside` and `around` are further fields of the model and of the scene."""
    text = ("plane: PLANE_STRESS time { duration: 1 } material { young_modulus: %(young)r poisson_ratio: %(poisson)r "
            "density: %(density)r } " % STATED)
    return text_format.Parse(text + around + MODELS[role] % inside, scene.Scene())


def tied(participant, inside="", weight=1.0, around="", chosen=slice(None)):
    """A run with coupling points and their masses: all points in the order in which they were offered, or those chosen."""
    run = participant.run()
    run.set_up(scene_of(participant.role, inside, around))
    run.weigh(weight)
    run.couple(run.points[chosen])
    inverse = np.reshape(run.operator.inverse_masses, (-1, 2))[list(run.operator.columns)]
    with np.errstate(divide="ignore"):
        run.masses = 1 / inverse
    return run
