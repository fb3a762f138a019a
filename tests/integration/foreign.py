"""Another code between the coupler and a server, in Python: it carries, changes, delays or loses what they say."""

import socket
import struct
import threading

from link import Link, wire_pb2


class Listener:
    """Serves clients one after another in a thread: one of them, or as many as come."""

    def __init__(self, serve, clients=1):
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self.socket.getsockname()[1]
        self.thread = threading.Thread(target=self.run, args=(serve, clients), daemon=True)
        self.thread.start()

    def run(self, serve, clients):
        while clients > 0:
            clients -= 1
            client, _ = self.socket.accept()
            with client:
                try:
                    serve(client)
                except (EOFError, OSError):
                    pass
        self.socket.close()


class Cut(Exception):
    """The road ends here, for both ends: by closing, or by a reset."""

    def __init__(self, reset=False):
        super().__init__()
        self.reset = reset


def whole(_, data):
    yield data


def rewritten(change):
    """Frames pass through Python's own classes, and `change` may change them."""

    def carry(kind, data):
        if kind != "preamble":
            frame = wire_pb2.Frame.FromString(data[4:])
            change(frame)
            data = framed(frame.SerializeToString())
        yield data

    return carry


def framed(payload):
    return struct.pack("<I", len(payload)) + payload


def road(server, requests=whole, answers=whole):
    """Between a client and a server. `requests` and `answers` get the kind and the bytes of what goes that way, the preamble and
    then frame after frame, and yield the pieces that go on."""

    def serve(client):
        host, port = server.address.split(":")
        with socket.create_connection((host, int(port))) as upstream:
            ends = Link(client), Link(upstream)
            way = threading.Thread(target=carry_all, args=(*ends, requests), daemon=True)
            way.start()
            carry_all(*ends[::-1], answers)
            way.join()

    return serve


def carry_all(source, sink, carry):
    try:
        for kind, data in items(source):
            for piece in carry(kind, data):
                sink.socket.sendall(piece)
    except Cut as cut:
        for end in source, sink:
            end.close(cut.reset)
    except (EOFError, OSError):
        sink.end()


def items(source):
    yield "preamble", source.read(8)
    while True:
        length = source.read(4)
        payload = source.read(struct.unpack("<I", length)[0])
        yield wire_pb2.Frame.FromString(payload).WhichOneof("content"), length + payload


def between(server, tamper):
    """Passes every frame on through Python's own classes, after `tamper` looked at the answers."""
    return road(server, rewritten(lambda frame: None), rewritten(tamper))
