"""A client that breaks the rules of the conversation holds neither a server nor its memory, and learns what was wrong."""

import pathlib
import socket
import struct
import threading
import time
import unittest

from link import Link, wire_pb2
from programs import Server, counts_resources

MIB = 1 << 20
SCENE = {"material": {"young_modulus": 3e10, "poisson_ratio": 0.2, "density": 2500}, "time": {"duration": 1e-3}}


class Client(Link):
    """Says hello to a server."""

    def __init__(self, server, version=2):
        host, port = server.address.split(":")
        super().__init__(socket.create_connection((host, int(port)), timeout=30))
        try:
            self.greet()
            self.send(self.frame(hello={"protocol_version": version, "program": "coupler", "max_frame_bytes": 1 << 30}))
            self.busy = "busy" in self.receive().error.message  # otherwise its hello
        except (EOFError, OSError):
            self.socket.close()
            raise

    @staticmethod
    def frame(**content):
        return wire_pb2.Frame(**content)

    def answer(self):
        """The next frame that is no heartbeat."""
        while (frame := self.receive()).WhichOneof("content") == "heartbeat":
            pass
        return frame

    def until_closed(self):
        """What the server says before it closes the connection, and the time until then."""
        start, message = time.monotonic(), ""
        try:
            while True:
                message = self.answer().error.message
        except (EOFError, ConnectionError):
            self.socket.close()
            return message, time.monotonic() - start

    def beat(self):
        """Sends heartbeats until the server closes the connection."""
        try:
            while True:
                self.send(self.frame(heartbeat={}))
                time.sleep(0.5)
        except OSError:
            pass


def memory_of(server):
    """Bytes that the process holds now, and the most that it ever held."""
    lines = pathlib.Path(f"/proc/{server.process.pid}/status").read_text().splitlines()
    fields = dict(line.split(":", 1) for line in lines)
    return tuple(1024 * int(fields[name].split()[0]) for name in ("VmRSS", "VmHWM"))


def field(number, content):
    """A field of bytes as protobuf writes it."""
    length = bytearray()
    rest = len(content)
    while rest > 127:
        length.append(rest & 127 | 128)
        rest >>= 7
    return bytes([number << 3 | 2, *length, rest]) + content


class HostileClients(unittest.TestCase):
    def setUp(self):
        self.server = Server("dem_server")
        self.addCleanup(self.server.__exit__)

    def client(self, version=2):
        """A client that the server listens to; it may take a moment to part from the one before."""
        deadline = time.monotonic() + 10
        while True:
            client = Client(self.server, version)
            self.addCleanup(client.socket.close)
            if not client.busy:
                return client
            client.socket.close()
            self.assertLess(time.monotonic(), deadline, "the server stays busy")
            time.sleep(0.02)

    def assert_serves(self, within=10):
        """The next client has its model within some seconds."""
        scene = {**SCENE, "particles": {"packing": {"x_min": 0, "x_max": 2, "y_min": 0, "y_max": 1, "radius": 0.1}}}
        start = time.monotonic()
        while True:
            try:
                client = self.client()
                client.send(client.frame(setup={"run_id": "next", "scene": scene}))
                if client.answer().WhichOneof("content") == "model":
                    return
                client.socket.close()
            except (EOFError, ConnectionError):  # it parts from the client before
                pass
            self.assertLess(time.monotonic() - start, within)
            time.sleep(0.02)

    def test_a_server_leaves_the_packing_of_a_client_that_has_gone(self):
        client = self.client()
        packing = {"x_min": 0, "x_max": 500, "y_min": 0, "y_max": 500, "radius_min": 0.5, "radius_max": 1, "stress": 1e6}
        scene = {**SCENE, "particles": {"random_packing": packing}}
        client.send(client.frame(setup={"run_id": "packs for minutes", "scene": scene}))
        time.sleep(2)
        client.socket.close()
        self.assert_serves(within=3)

    def test_a_client_that_only_beats_is_sent_away(self):
        client = self.client()
        threading.Thread(target=client.beat, daemon=True).start()
        message, seconds = client.until_closed()
        self.assertIn("no answer within 10 s", message)
        self.assertLess(seconds, 14)
        self.assert_serves()

    def test_a_client_that_sends_a_byte_now_and_then_is_sent_away(self):
        client = self.client()
        client.socket.sendall(struct.pack("<I", 1000))
        start = time.monotonic()
        with self.assertRaises(ConnectionError):
            while time.monotonic() - start < 20:
                client.socket.sendall(b"\x12")
                time.sleep(0.5)
        self.assertLess(time.monotonic() - start, 15)
        self.assert_serves()

    @counts_resources
    def test_many_empty_messages_take_no_memory(self):
        client = self.client()
        region = wire_pb2.Setup(scene={"regions": [{}]}).scene.SerializeToString()
        payload = field(2, field(2, 20 * MIB // len(region) * region))
        client.socket.sendall(struct.pack("<I", len(payload)) + payload)
        message, _ = client.until_closed()
        self.assertIn("bytes of memory", message)
        self.assert_serves()
        held, most = memory_of(self.server)
        self.assertLess(most, 200 * MIB)
        self.assertLess(held, 100 * MIB)

    @counts_resources
    def test_memory_is_given_back_after_a_client_has_gone(self):
        client = self.client()
        histories = [{"name": f"history {i}"} for i in range(400000)]
        client.send(client.frame(setup={"run_id": "large", "scene": {**SCENE, "particles": {"histories": histories}}}))
        self.assertEqual(client.answer().WhichOneof("content"), "error")
        client.socket.close()
        self.assert_serves()
        held, most = memory_of(self.server)
        self.assertGreater(most, 80 * MIB)
        self.assertLess(held, 60 * MIB)

    def test_what_is_no_frame_is_answered(self):
        client = self.client()
        client.socket.sendall(struct.pack("<I", 3) + b"abc")
        message, _ = client.until_closed()
        self.assertIn("sent 3 bytes that are not a frame of this protocol", message)
        client = self.client()
        client.socket.sendall(struct.pack("<I", 1 << 30))
        message, _ = client.until_closed()
        self.assertIn(f"announced a frame of {1 << 30} bytes", message)
        self.assert_serves()

    def test_a_hello_of_another_version_is_refused(self):
        client = self.client(version=99)
        _, seconds = client.until_closed()
        self.assertLess(seconds, 5)
        self.assert_serves()


if __name__ == "__main__":
    unittest.main()
