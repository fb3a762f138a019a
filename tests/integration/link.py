"""One end of a conversation in Python that keeps no rule but the frames' own."""

import contextlib
import socket
import struct
import sys

from programs import SOURCE

sys.path.insert(0, str(SOURCE / "adapters/python"))
from wire import wire as wire_pb2  # noqa: E402

MAGIC = b"ADIT"
VERSION = 2


class Link:
    """One end of a conversation, as wire.proto and the README describe it."""

    def __init__(self, connection):
        self.socket = connection
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def read(self, count):
        data = b""
        while len(data) < count:
            piece = self.socket.recv(count - len(data))
            if not piece:
                raise EOFError
            data += piece
        return data

    def greet(self):
        self.socket.sendall(MAGIC + struct.pack("<I", VERSION))
        assert self.read(8) == MAGIC + struct.pack("<I", VERSION)

    def receive(self):
        return wire_pb2.Frame.FromString(self.read(struct.unpack("<I", self.read(4))[0]))

    def send(self, frame):
        payload = frame.SerializeToString()
        self.socket.sendall(struct.pack("<I", len(payload)) + payload)

    def end(self):
        """Says that no more is sent."""
        with contextlib.suppress(OSError):
            self.socket.shutdown(socket.SHUT_WR)

    def close(self, reset=False):
        """Ends both ways at once, from any thread; by a reset, what was sent and not read yet is lost, too."""
        with contextlib.suppress(OSError):
            if reset:
                self.socket.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            self.socket.shutdown(socket.SHUT_RD if reset else socket.SHUT_RDWR)  # wakes who reads from it
            self.socket.close()
