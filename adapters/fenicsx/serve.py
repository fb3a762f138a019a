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
from guard import LAST_WORDS_S, Child, Crew, Lost, content, end, follow, next_message  # noqa: E402
from reading import keys  # noqa: E402
from wire import Gone, decoded, listen, scene, wire  # noqa: E402


def relay(link, crew):
    """One run, to its end. Requests go to the ranks and answers come back as bytes: while Python decodes a long message, no
    heartbeat can be sent."""
    crew.begin()
    while True:
        request = next_message(link)
        if content(request) == "error":
            raise Gone(decoded(request).error.message)
        try:
            answer = crew.ask(request)
            link.send_payload(answer)
        except (Lost, ValueError) as error:
            return link.refuse(wire.Error.INTERNAL, str(error))
        if content(answer) in ("bye", "error"):
            return


def main():
    # mpirun sends this to all where one is lost; the coupler has still to be told which.
    signal.signal(signal.SIGTERM, lambda *_: threading.Timer(LAST_WORDS_S, end).start())
    child = Child()
    if child.rank > 0:
        follow(child)
    crew = Crew(child)
    listen("fenicsx_continuum", lambda link: relay(link, crew), list(keys(scene.Scene.DESCRIPTOR, COMPUTED)))


if __name__ == "__main__":
    main()
