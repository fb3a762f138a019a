"""The processes that watch the ranks. A guard sees that its own rank ended or was stopped, and tells the guard of rank 0. They
speak as the coupler and a participant do: a secret, heartbeats, frames, and an end to every silence.
"""
import os
import secrets
import signal
import socket
import subprocess
import sys
import threading
import time
from contextlib import suppress
from multiprocessing import Pipe
from pathlib import Path

from wire import Gone, Link, wire

LAST_WORDS_S = 0.7  # to tell the coupler who was lost; mpirun kills a second after it has told a process to end
GLANCE_S = 0.1
# mpirun chooses 0 where there are as many cores as ranks, but the other models of a run need cores, too.
PATIENT = {"OMPI_MCA_mpi_yield_when_idle": "1"}


class Lost(Exception):
    """A rank was lost."""


def content(payload):
    """What a frame brings, by the name of its field, whose number the first byte tells."""
    field = wire.Frame.DESCRIPTOR.fields_by_number.get(payload[0] >> 3) if payload else None
    return field.name if field else ""


def next_message(link):
    """The bytes of the next frame that is not a heartbeat."""
    while content(payload := link.next_payload()) == "heartbeat":
        pass
    return payload


def end():
    os._exit(1)


class Child:
    """The process of one rank, which says its number and the number of ranks."""

    def __init__(self):
        self.pipe, theirs = Pipe()
        command = [sys.executable, Path(__file__).with_name("rank.py"), str(theirs.fileno())]
        self.process = subprocess.Popen(command, pass_fds=[theirs.fileno()], env={**os.environ, **PATIENT})
        theirs.close()
        try:
            self.rank, self.size = self.pipe.recv()
        except EOFError:
            end()  # it said why

    def wait(self):
        """Waits until the rank is lost, and tells how."""
        pid, status = os.waitpid(self.process.pid, os.WUNTRACED)
        if os.WIFSTOPPED(status):
            self.process.kill()
            how = f"was stopped by {signal.Signals(os.WSTOPSIG(status)).name}"
        elif os.WIFSIGNALED(status):
            how = f"was killed by {signal.Signals(os.WTERMSIG(status)).name}"
        else:
            how = f"ended with exit code {os.WEXITSTATUS(status)}"
        return f"rank {self.rank} of {self.size}, process {pid} on {socket.gethostname()}, {how}"

    def tell(self, message):
        with suppress(OSError):  # who waits for the process finds its end
            self.pipe.send_bytes(message)


def beating(link):
    threading.Thread(target=link.beat, args=(threading.Event(),), daemon=True).start()


def follow(child):
    """The guard of another rank than 0, until a rank is lost."""
    address, secret = child.pipe.recv()
    link = Link(socket.create_connection(address))
    link.greet(f"rank {child.rank} of {child.size}", secret=secret, end=b"client")
    beating(link)
    threading.Thread(target=hand_on, args=(link, child), daemon=True).start()
    with suppress(OSError):
        link.refuse(wire.Error.INTERNAL, child.wait())
    time.sleep(LAST_WORDS_S)
    end()


def hand_on(link, child):
    with suppress(OSError, Gone):
        while True:
            child.tell(next_message(link))
    end()  # rank 0 has told why, or is lost itself


class Crew:
    """All ranks, as the guard of rank 0 sees them."""

    def __init__(self, child):
        self.child, self.lost, self.links = child, "", []
        secret = secrets.token_hex(32).encode()
        with socket.create_server(("", 0), backlog=child.size) as meeting:
            child.pipe.send(((socket.gethostname(), meeting.getsockname()[1]), secret))
            while len(self.links) < child.size - 1:
                link = Link(meeting.accept()[0])
                with suppress(OSError, Gone):  # of a stranger
                    link.greet("rank 0", secret=secret)
                    self.links.append(link)
        for link in self.links:
            beating(link)
            threading.Thread(target=self.listen, args=(link,), daemon=True).start()
        threading.Thread(target=lambda: self.lose(child.wait()), daemon=True).start()

    def listen(self, link):
        try:
            self.lose(link.next_answer().error.message)
        except (OSError, Gone) as error:
            self.lose(f"{link.peer} {error}")

    def lose(self, how):
        if self.lost:
            return
        self.lost = how
        with suppress(OSError):  # of a terminal that is gone
            print(how, file=sys.stderr, flush=True)
        time.sleep(LAST_WORDS_S)
        end()

    def begin(self):
        """A new run."""
        self.tell(wire.Frame(hello=wire.Hello()).SerializeToString())

    def ask(self, request):
        """The answer of rank 0 to a request to all ranks; both are the bytes of frames."""
        self.tell(request)
        with suppress(EOFError, OSError):
            while not self.lost:
                if self.child.pipe.poll(GLANCE_S):
                    return self.child.pipe.recv_bytes()
        while not self.lost:
            time.sleep(GLANCE_S)
        raise Lost(self.lost)

    def tell(self, message):
        for link in self.links:
            with suppress(OSError):  # who listens to it finds its end
                link.send_payload(message)
        self.child.tell(message)
