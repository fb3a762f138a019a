"""A client that follows docs/protocol.md, section Long messages, gets in parts what another gets in one frame, and may send so itself."""

import socket
import struct
import unittest

from link import Link, wire_pb2
from programs import PATIENCE_S, Server

GOES_ON, MIB = 1 << 31, 1 << 20
SCENE = {"material": {"young_modulus": 3e10, "poisson_ratio": 0.2, "density": 2500}, "time": {"duration": 1e-3},
         "particles": {"packing": {"x_min": 0, "x_max": 100, "y_min": 0, "y_max": 18, "radius": 0.1},
                       "loads": [{"where": {"x_max": 1}, "force": {"x": 1e6}}]}}


def put_together(whole, part):
    """As protobuf merges messages; what has the name of the last piece, or of its last field, goes on with it."""
    if not isinstance(part, wire_pb2.Snapshot):
        return whole.MergeFrom(part)
    for piece in part.pieces:
        if not whole.pieces or whole.pieces[-1].name != piece.name:
            whole.pieces.add().CopyFrom(piece)
            continue
        last = whole.pieces[-1]
        for name in ("point_fields", "cell_fields"):
            fields = getattr(last, name)
            for field in getattr(piece, name):
                if fields and fields[-1].name == field.name:
                    fields[-1].MergeFrom(field)
                else:
                    fields.add().CopyFrom(field)
            piece.ClearField(name)
        last.MergeFrom(piece)


class Client(Link):
    def __init__(self, server, reads_parts):
        host, port = server.address.split(":")
        super().__init__(socket.create_connection((host, int(port)), timeout=PATIENCE_S))
        self.lengths = []  # of the frames that came
        self.greet()
        self.send(wire_pb2.Frame(hello={"protocol_version": 2, "program": "coupler", "max_frame_bytes": 1 << 30,
                                        "reads_parts": reads_parts}))
        assert self.answer().reads_parts

    def send_part(self, **content):
        payload = wire_pb2.Frame(**content).SerializeToString()
        self.socket.sendall(struct.pack("<I", len(payload) | GOES_ON) + payload)

    def answer(self):
        """The next message that is no heartbeat."""
        whole = None
        while True:
            length, = struct.unpack("<I", self.read(4))
            frame = wire_pb2.Frame.FromString(self.read(length % GOES_ON))
            kind = frame.WhichOneof("content")
            if kind == "heartbeat":
                continue
            self.lengths.append(length % GOES_ON)
            if whole is None:
                whole = getattr(frame, kind)
            else:
                put_together(whole, getattr(frame, kind))
            if length < GOES_ON:
                return whole

    def ask(self, **content):
        self.send(wire_pb2.Frame(**content))
        return self.answer()


class Parts(unittest.TestCase):
    def snapshot_of(self, server, parts):
        client = Client(server, parts)
        setup = wire_pb2.Setup(scene=SCENE)
        if parts:
            scene = setup.scene.SerializeToString()
            for begin in range(0, len(scene), 20):
                client.send_part(setup=wire_pb2.Setup(scene_parts=[scene[begin:begin + 20]]))
            setup = wire_pb2.Setup(run_id="in parts")
        model = client.ask(setup=setup)
        weights = wire_pb2.Weights(weights=[0.5] * (len(model.sample_points) // 2), floor=0.01, x_max=1)
        if parts:
            for begin in range(0, len(weights.weights), 50000):
                client.send_part(weights={"weights": weights.weights[begin:begin + 50000]})
            weights.ClearField("weights")
        interface = client.ask(weights=weights)
        client.ask(advance={"step": 0, "dt": model.critical_dt / 2})
        snapshot = client.ask(snapshot_request={})
        client.ask(finish={})
        client.close()
        return interface.mass, snapshot, client.lengths

    def test_messages_in_parts_are_those_of_one_frame(self):
        with Server("dem_server") as server:
            mass, whole, lengths = self.snapshot_of(server, False)
            same_mass, parts, part_lengths = self.snapshot_of(server, True)
        self.assertGreater(max(lengths), 16 * MIB)
        self.assertLess(max(part_lengths), 16 * MIB)
        self.assertEqual(mass, same_mass)
        self.assertEqual(parts.SerializeToString(), whole.SerializeToString())


if __name__ == "__main__":
    unittest.main()
