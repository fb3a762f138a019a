"""One rank: answers the requests that its guard (serve.py) hands on. All ranks answer together; that of rank 0 counts."""
import ctypes
import os
import signal
import sys
from multiprocessing.connection import Connection
from pathlib import Path

PR_SET_PDEATHSIG = 1
ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)  # a rank whose guard was killed would wait for ever

sys.path.insert(1, str(Path(__file__).resolve().parents[1] / "python"))
from mpi4py import MPI  # noqa: E402

from divided import Continuum  # noqa: E402
from wire import Gone, converse, decoded, wire  # noqa: E402


class Requests:
    """The guard, as Link in wire.py is to a participant."""

    def __init__(self, pipe, first):
        self.pipe, self.first = pipe, first

    def receive(self):
        try:
            frame = decoded(self.pipe.recv_bytes())
        except Gone as error:
            self.refuse(wire.Error.REQUEST, str(error))
            raise
        if frame.WhichOneof("content") == "hello":
            raise Gone("begins a new run")
        return frame

    def send(self, frame):
        if self.first:
            self.pipe.send_bytes(frame.SerializeToString())

    def refuse(self, kind, message, path=""):
        self.send(wire.Frame(error=wire.Error(kind=kind, message=message, path=path)))
        if kind == wire.Error.INTERNAL:  # the other ranks may wait for this one
            os._exit(1)


def main():
    signal.signal(signal.SIGTERM, signal.SIG_IGN)  # which mpirun sends to the guard, too
    ranks, pipe = MPI.COMM_WORLD, Connection(int(sys.argv[1]))
    pipe.send((ranks.rank, ranks.size))
    meeting = ranks.bcast(pipe.recv() if ranks.rank == 0 else None)  # of the guards
    if ranks.rank > 0:
        pipe.send(meeting)
    requests = Requests(pipe, ranks.rank == 0)
    while True:
        try:
            converse(requests, Continuum(ranks))
        except Gone:
            pass
        except EOFError:
            return


if __name__ == "__main__":
    main()
