"""The conversation with the coupler (docs/protocol.md): bytes, greeting, heartbeats, the order of requests, errors."""
import argparse
import hmac
import importlib
import secrets
import select
import socket
import ssl
import struct
import subprocess
import sys
import tempfile
import threading
import time
import traceback
from pathlib import Path

import trust
from google.protobuf.message import DecodeError

ROOT = Path(__file__).resolve().parents[2]


def compiled_messages():
    """The Python classes of wire.proto and of the scene that it carries."""
    with tempfile.TemporaryDirectory() as folder:
        files = [f"protocol/messages/{path.name}" for path in (ROOT / "protocol/messages").glob("*.proto")]
        subprocess.run(["protoc", f"-I{ROOT}", f"--python_out={folder}", *files], check=True, cwd=ROOT)
        sys.path.insert(0, folder)
        try:
            return tuple(importlib.import_module(f"protocol.messages.{name}_pb2") for name in ("wire", "scene"))
        finally:
            sys.path.remove(folder)


wire, scene = compiled_messages()

PREAMBLE = b"ADIT" + struct.pack("<I", 2)
MAX_HELLO, MAX_FRAME = 64 << 10, 1 << 30  # bytes
HELLO_S, SILENCE_S, HEARTBEAT_S, FAREWELL_S = 5, 8, 1, 2


class SceneError(Exception):
    """The scene cannot be computed: `path` names the field, as in continuum.motions[0]."""

    def __init__(self, path, message):
        super().__init__(message)
        self.path = path


class RequestError(Exception):
    """The coupler contradicts the conversation."""


class Unstable(Exception):
    """A value is not finite."""


class Gone(Exception):
    """The other end is gone, silent, or does not follow the protocol."""


def decoded(payload):
    try:
        return wire.Frame.FromString(payload)
    except DecodeError as error:
        raise Gone(f"sent {len(payload)} bytes that are no frame") from error


class Link:
    """One end of a connection. Sending is safe from several threads."""

    def __init__(self, connected):
        self.socket = connected
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.settimeout(HELLO_S)
        self.using = threading.Lock()
        self.accepts, self.peer_accepts = MAX_HELLO, MAX_HELLO

    def arrived(self, count):
        """Some bytes. With TLS one thread at a time may use the socket, and none may wait while it does."""
        held = isinstance(self.socket, ssl.SSLSocket) and self.socket.pending()
        if not held and not select.select([self.socket], [], [], self.socket.gettimeout())[0]:
            raise TimeoutError("is silent")
        with self.using:
            return self.socket.recv(count)

    def read(self, count):
        data = bytearray()
        while len(data) < count:
            piece = self.arrived(min(count - len(data), 1 << 20))
            if not piece:
                raise Gone("closed the connection")
            data += piece
        return bytes(data)

    def next_payload(self):
        """The bytes of the next frame."""
        length, = struct.unpack("<I", self.read(4))
        if length > self.accepts:
            raise Gone(f"announced a frame of {length} bytes, but at most {self.accepts} are allowed")
        return self.read(length)

    def next_frame(self):
        return decoded(self.next_payload())

    def next_answer(self):
        """The next frame that is not a heartbeat."""
        while (frame := self.next_frame()).WhichOneof("content") == "heartbeat":
            pass
        return frame

    def receive(self):
        """The same, where an error ends the run."""
        frame = self.next_answer()
        if frame.WhichOneof("content") == "error":
            raise Gone(frame.error.message)
        return frame

    def send(self, frame):
        self.send_payload(frame.SerializeToString())

    def send_payload(self, payload):
        if len(payload) > self.peer_accepts:
            raise ValueError(f"a frame of {len(payload)} bytes is longer than the {self.peer_accepts} that the client accepts")
        with self.using:
            self.socket.sendall(struct.pack("<I", len(payload)) + payload)

    def greet(self, program, computes=(), secret=b"", end=b"server"):
        """`end` is b"client" for who connected."""
        self.socket.sendall(PREAMBLE)
        challenge = secrets.token_bytes(32) if secret else b""
        hello = wire.Hello(protocol_version=2, program=program, release="template", max_frame_bytes=MAX_FRAME,
                           challenge=challenge, computes=computes)
        self.send(wire.Frame(hello=hello))
        if self.read(8) != PREAMBLE:
            raise Gone("does not speak version 2 of the Adit protocol")
        hello = self.receive().hello
        self.peer = hello.program
        if bool(secret) != bool(hello.challenge):
            raise Gone("has no secret" if secret else "has a secret, but this end none")
        if secret:
            self.authenticate(secret, end, (challenge, hello.challenge) if end == b"client" else (hello.challenge, challenge))
        self.accepts, self.peer_accepts = MAX_FRAME, min(hello.max_frame_bytes, MAX_FRAME)
        self.socket.settimeout(SILENCE_S)

    def authenticate(self, secret, end, challenges):
        """Each end proves that it knows the secret, the client first."""
        own = wire.Frame(proof=wire.Proof(hmac=trust.prove(secret, end, challenges)))
        if end == b"client":
            self.send(own)
        other = b"server" if end == b"client" else b"client"
        if not hmac.compare_digest(self.receive().proof.hmac, trust.prove(secret, other, challenges)):
            self.refuse(wire.Error.REFUSED, "its secret is another one; use the same file at both ends")
            raise Gone("has another secret")
        if end == b"server":
            self.send(own)

    def beat(self, ended):
        """Says once a second that this end lives, also while it computes."""
        try:
            while not ended.wait(HEARTBEAT_S):
                self.send(wire.Frame(heartbeat=wire.Heartbeat()))
        except OSError:
            pass  # whoever reads from the connection finds its end

    def refuse(self, kind, message, path=""):
        self.send(wire.Frame(error=wire.Error(kind=kind, message=message, path=path)))

    def close(self):
        """Sends no more, and drops what arrives until the other end closes: it has then read the last frame."""
        self.socket.shutdown(socket.SHUT_WR)
        deadline = time.monotonic() + FAREWELL_S
        while (left := deadline - time.monotonic()) > 0:
            self.socket.settimeout(left)
            if not self.socket.recv(4096):
                return


class Conversation:
    """Hands the requests to the participant, and only in their order."""

    ANSWERS = {"setup": "model", "weights": "interface", "couple": "operator", "advance": "predicted",
               "snapshot_request": "snapshot", "finish": "bye"}
    ALLOWED = {"connected": {"setup"}, "setup": {"weights", "finish"},
               "weights": {"couple", "advance", "snapshot_request", "finish"},
               "running": {"advance", "snapshot_request", "finish"}, "finish": set()}

    def __init__(self, participant):
        self.participant, self.stage = participant, "connected"

    def answer(self, request):
        asked = request.WhichOneof("content")
        if asked not in self.ALLOWED[self.stage]:
            raise RequestError(f"{asked} came where {' or '.join(sorted(self.ALLOWED[self.stage]))} was expected")
        reply = wire.Frame()
        answer = getattr(reply, self.ANSWERS[asked])
        answer.SetInParent()
        started = time.monotonic()
        getattr(self.participant, asked)(getattr(request, asked), answer)
        if asked == "advance":
            answer.compute_seconds = time.monotonic() - started
        if asked != "snapshot_request":
            self.stage = asked if asked in self.ALLOWED else "running"
        return reply


def converse(link, participant):
    """One run, to its end; an error is an answer, too."""
    conversation = Conversation(participant)
    while conversation.stage != "finish":
        request = link.receive()
        try:
            link.send(conversation.answer(request))
        except SceneError as error:
            return link.refuse(wire.Error.SCENE, str(error), error.path)
        except RequestError as error:
            return link.refuse(wire.Error.REQUEST, str(error))
        except Unstable as error:
            return link.refuse(wire.Error.UNSTABLE, str(error))
        except (OSError, Gone):
            raise
        except Exception as error:
            traceback.print_exc()
            return link.refuse(wire.Error.INTERNAL, f"{type(error).__name__}: {error}")


def run_for(connected, options, program, take_part, computes, occupied):
    ended = threading.Event()
    if options.tls:
        connected = options.tls.wrap_socket(connected, server_side=True, do_handshake_on_connect=False)
    with connected:
        try:
            link = Link(connected)
            if options.tls:
                connected.do_handshake()
            if not occupied.acquire(timeout=HEARTBEAT_S):  # long enough for the last client to leave
                connected.sendall(PREAMBLE)
                link.refuse(wire.Error.REFUSED, "busy with another run")
                return link.close()
            try:
                link.greet(program, computes, options.secret_file)
                threading.Thread(target=link.beat, args=(ended,), daemon=True).start()
                take_part(link)
            finally:
                ended.set()
                occupied.release()
            link.close()
        except (OSError, Gone) as error:
            print(f"{program}: run dropped: the client {error}", file=sys.stderr)


def serve(program, make_participant, computes):
    """Listens, and serves one run after another, each with a participant of its own. `computes`: see Hello in wire.proto."""
    listen(program, lambda link: converse(link, make_participant()), computes)


def listen(program, take_part, computes):
    """The same, where `take_part` converses on the link of each run."""
    parser = argparse.ArgumentParser(description=f"{program}, a participant in the runs of the Adit coupler.")
    parser.add_argument("--listen", default="127.0.0.1:0", help="HOST:PORT; port 0 takes any free one")
    # Python's ssl cannot bind a proof to its connection, which the coupler demands where it has both.
    who = parser.add_mutually_exclusive_group()
    who.add_argument("--secret-file", type=trust.read_secret, default=b"", help="file whose first line clients must know")
    who.add_argument("--tls", type=trust.server_context, help="folder of this machine's certificate; clients must have one, too")
    options = parser.parse_args()
    host, _, port = options.listen.rpartition(":")
    listener = socket.create_server((host, int(port)))
    print("listening on %s:%d" % listener.getsockname()[:2], flush=True)
    occupied = threading.Lock()
    while True:
        connected, _ = listener.accept()
        given = (connected, options, program, take_part, computes, occupied)
        threading.Thread(target=run_for, args=given, daemon=True).start()
