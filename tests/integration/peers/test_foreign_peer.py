"""Another code can take part: all it needs is wire.proto. Here it is Python, between the coupler and a real server."""

import pathlib
import socket
import struct
import subprocess
import sys
import tempfile
import threading
import unittest

from programs import CASE, SOURCE, ProgramTest, Server, coupler

GENERATED = tempfile.TemporaryDirectory(prefix="adit_proto_")
subprocess.run(["protoc", f"-I{SOURCE}", f"--python_out={GENERATED.name}",
                *(f"protocol/messages/{path.name}" for path in (SOURCE / "protocol/messages").glob("*.proto"))], check=True, cwd=SOURCE)
sys.path.insert(0, GENERATED.name)
from protocol.messages import wire_pb2  # noqa: E402

MAGIC = b"ADIT"
VERSION = 2
SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[]")


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


class Listener:
    """Serves one client in a thread."""

    def __init__(self, serve):
        self.socket = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self.socket.getsockname()[1]
        self.thread = threading.Thread(target=self.run, args=(serve,), daemon=True)
        self.thread.start()

    def run(self, serve):
        client, _ = self.socket.accept()
        with client:
            try:
                serve(client)
            except (EOFError, OSError):
                pass
        self.socket.close()


def between(server, tamper):
    """Passes every frame on through Python's own classes, after `tamper` looked at the answers."""

    def pass_on(source, sink, change):
        try:
            while True:
                frame = source.receive()
                change(frame)
                sink.send(frame)
        except (EOFError, OSError):
            try:
                sink.socket.shutdown(socket.SHUT_WR)
            except OSError:
                pass

    def serve(client):
        host, port = server.address.split(":")
        with socket.create_connection((host, int(port))) as upstream:
            ends = Link(client), Link(upstream)
            for end in ends:
                end.greet()
            requests = threading.Thread(target=pass_on, args=(*ends, lambda frame: None), daemon=True)
            requests.start()
            pass_on(ends[1], ends[0], tamper)

    return serve


class ForeignPeer(ProgramTest):
    def run_with(self, tamper, *more):
        with Server("dem_server") as dem:
            listener = Listener(between(dem, tamper))
            return coupler("run", CASE / "coupled.yaml", "--out", self.folder / "foreign", "--dem", listener.address, *SHORT,
                           *more)

    def test_a_python_participant_gives_the_same_results_to_the_bit(self):
        result = self.run_with(lambda frame: None)
        self.assertEqual(result.returncode, 0, result.stderr)
        own = self.run_scene(CASE / "coupled.yaml", *SHORT, out="own")
        for name in ("histories.csv", "cracks.csv"):
            self.assertEqual((self.folder / "foreign" / name).read_bytes(), (own / name).read_bytes())

    def assert_refused(self, tamper, text):
        result = self.run_with(tamper)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("dem_server", result.stderr)
        self.assertIn(text, result.stderr)

    def test_an_operator_that_does_not_fit_is_refused(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "operator":
                frame.operator.columns[0] = 10**6

        self.assert_refused(tamper, "a point that it does not have")

    def test_missing_velocities_are_refused(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "predicted" and frame.predicted.step == 5:
                del frame.predicted.velocities[-1]

        self.assert_refused(tamper, "velocities")

    def test_another_answer_than_asked_for_is_refused(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "model":
                frame.bye.cpu_seconds = 1

        self.assert_refused(tamper, "model was expected")

    def test_a_peer_that_does_not_say_its_wave_speed_takes_part_unless_the_solve_needs_it(self):
        def tamper(frame):
            if frame.WhichOneof("content") == "model":
                frame.model.ClearField("p_wave_speed")

        self.assertEqual(self.run_with(tamper).returncode, 0)
        split = ("--set", "interface.solve=split")
        result = self.run_with(tamper, *split)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("interface.decay_rate", result.stderr)
        self.assertIn("dem_server", result.stderr)
        self.assertEqual(self.run_with(tamper, *split, "--set", "interface.decay_rate=1000").returncode, 0)

    def greeting(self, reply):
        def serve(client):
            client.sendall(reply)
            client.recv(1000)
            client.recv(1000)

        listener = Listener(serve)
        result = coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--dem", listener.address)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn(listener.address, result.stderr)
        return result.stderr

    def test_a_peer_of_an_older_or_newer_protocol_version_is_refused_with_both_versions(self):
        for version in (0, VERSION - 1, 7):
            hello = wire_pb2.Frame()
            hello.hello.protocol_version = version
            hello.hello.program = "dem_server"
            hello.hello.release = "9.9"
            payload = hello.SerializeToString()
            preamble = MAGIC + struct.pack("<I", version)
            message = self.greeting(preamble + struct.pack("<I", len(payload)) + payload)
            self.assertIn(f"version {version}", message)
            self.assertIn(f"version {VERSION}", message)

    def test_a_peer_that_speaks_something_else_is_named(self):
        self.assertIn("protocol", self.greeting(b"HTTP/1.1 400 Bad Request\r\n\r\n"))


if __name__ == "__main__":
    unittest.main()
