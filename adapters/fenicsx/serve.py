#!/usr/bin/python3
"""An elastic continuum of FEniCSx over the ranks of MPI, as a participant:

    mpirun -np 2 adapters/fenicsx/serve.py --listen 127.0.0.1:4711 &
    coupler run cases/cantilever/coupled.yaml --fdm 127.0.0.1:4711

Each process that mpirun starts is a guard: it starts its rank (rank.py) as a child and watches it. MPI and FEniCSx live in
the children only, since their calls may compute or wait for minutes in which a thread beside them could not say a word. The
guard of rank 0 speaks with the coupler and hands each request to all ranks.
"""
import signal
import sys
import threading
from pathlib import Path

sys.path.insert(1, str(Path(__file__).resolve().parents[1] / "python"))
from ground import COMPUTED  # noqa: E402
from guard import LAST_WORDS_S, Child, Crew, end, follow  # noqa: E402
from reading import keys  # noqa: E402
from wire import Conversation, RequestError, SceneError, Unstable, scene, serve, wire  # noqa: E402

RAISED = {wire.Error.REQUEST: RequestError, wire.Error.UNSTABLE: Unstable}


class Relay:
    """A participant whose every request is answered by the ranks."""

    def __init__(self, crew):
        self.crew = crew
        crew.tell(wire.Frame(hello=wire.Hello()))  # a new run begins

    def __getattr__(self, asked):
        return lambda request, answer: self.ask(asked, request, answer)

    def ask(self, asked, request, answer):
        reply = self.crew.ask(wire.Frame(**{asked: request}))
        error = reply.error
        if reply.WhichOneof("content") != "error":
            answer.CopyFrom(getattr(reply, Conversation.ANSWERS[asked]))
        elif error.kind == wire.Error.SCENE:
            raise SceneError(error.path, error.message)
        else:
            raise RAISED.get(error.kind, RuntimeError)(error.message)


def main():
    # mpirun sends this to all where one is lost; the coupler has still to be told which.
    signal.signal(signal.SIGTERM, lambda *_: threading.Timer(LAST_WORDS_S, end).start())
    child = Child()
    if child.rank > 0:
        follow(child)
    crew = Crew(child)
    serve("fenicsx_continuum", lambda: Relay(crew), list(keys(scene.Scene.DESCRIPTOR, COMPUTED)))


if __name__ == "__main__":
    main()
