"""The bytes of docs/protocol.md are those of a run with the real server, and the page leaves out no message."""

import math
import re
import socket
import sys
import unittest

import guide
from programs import SOURCE, Server

sys.path.insert(0, str(SOURCE / "adapters/python"))
from google.protobuf import text_format  # noqa: E402
from peers.test_templates import template  # noqa: E402
from wire import MAX_FRAME, Link, wire  # noqa: E402

PAGE = (SOURCE / "docs/protocol.md").read_text()
VARYING = {"release", "state_format", "compute_seconds", "hidden_seconds", "cpu_seconds", "resident_bytes"}


def transcripts():
    """For each of the page's transcripts the entries (mark, bytes, text)."""
    for language, content in guide.blocks(PAGE):
        if language == "wire":
            yield [entry_of(part) for part in re.split(r"^(?=[<>])", content, flags=re.MULTILINE) if part]


def entry_of(part):
    hexadecimal, text = re.fullmatch(r"((?:\s*[0-9a-f]{2}\b)*)\s*(.*)", part[1:], re.DOTALL).groups()
    return part[0], bytes.fromhex(hexadecimal), " ".join(text.split())


def frame_of(text):
    return text_format.Parse(text, wire.Frame())


def differences(found, stated, path):
    """Fields whose values differ; numbers by more than rounding."""
    for field in stated.DESCRIPTOR.fields:
        ours, theirs = getattr(found, field.name), getattr(stated, field.name)
        here = f"{path}.{field.name}"
        if field.name in VARYING:
            continue
        if field.label != field.LABEL_REPEATED:
            is_there = not field.message_type or stated.HasField(field.name)
            ours, theirs = [ours][:is_there], [theirs][:is_there]
        if len(ours) != len(theirs):
            yield f"{here}: {len(ours)} instead of {len(theirs)} elements"
        for a, b in zip(ours, theirs):
            if field.message_type:
                yield from differences(a, b, here)
            elif a != b and not (isinstance(a, float) and math.isclose(a, b, rel_tol=1e-12, abs_tol=1e-15)):
                yield f"{here}: {a} instead of {b}"


class ProtocolPage(unittest.TestCase):
    def setUp(self):
        self.run_in_bytes, self.too_far = transcripts()

    def test_the_text_beside_the_bytes_is_what_they_mean(self):
        for mark, data, text in self.run_in_bytes + self.too_far:
            if data and text:
                self.assertEqual(int.from_bytes(data[:4], "little"), len(data) - 4)
                self.assertEqual(wire.Frame.FromString(data[4:]), frame_of(text))

    def replay(self, address, entries, only=None):
        host, port = address.split(":")
        with socket.create_connection((host, int(port)), timeout=10) as connection:
            link = Link(connection)
            link.accepts = MAX_FRAME
            for mark, data, text in entries:
                if mark == ">":
                    connection.sendall(data)
                elif data:
                    self.assertEqual(link.read(len(data)), data)
                else:
                    stated = frame_of(text)
                    found = link.next_answer()
                    kind = stated.WhichOneof("content")
                    self.assertEqual(found.WhichOneof("content"), kind)
                    if only is None or kind in only:
                        self.assertEqual(list(differences(getattr(found, kind), getattr(stated, kind), kind)), [])

    def test_the_run_in_bytes(self):
        with Server("fdm_server") as server:
            self.replay(server.address, self.run_in_bytes)

    def test_a_step_too_far(self):
        with Server("fdm_server") as server:
            self.replay(server.address, self.run_in_bytes[:-2] + self.too_far)

    def test_the_template_moves_alike(self):
        with template("continuum") as other:
            self.replay(other.address, self.run_in_bytes, only={"operator", "predicted", "bye"})

    def test_every_message_and_every_kind_of_error_has_its_place(self):
        names = [field.name for field in wire.Frame.DESCRIPTOR.fields] + list(wire.Error.Kind.keys())
        self.assertEqual([name for name in names if f"`{name}`" not in PAGE], [])


if __name__ == "__main__":
    unittest.main()
