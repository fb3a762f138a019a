"""A recording as its format states it (coupler/recording/format.hpp), read without the coupler's own reader."""

import struct
import zlib

from link import wire_pb2

PARTICIPANT, REQUEST, ANSWER = range(3)


def entries(path):
    """(time in ns, participant, kind, content) of each entry; checksums are those of the contents."""
    data = path.read_bytes()
    assert data[:16] == b"ADITREC\n" + struct.pack("<II", 1, 2)
    at = 16
    while at < len(data):
        length, checksum = struct.unpack_from("<II", data, at)
        checked = data[at + 8:at + 20 + length]
        assert zlib.crc32(checked) == checksum
        yield (*struct.unpack_from("<QHH", checked), checked[12:])
        at += 20 + length


def frames(path, participant, kind):
    """The frames that one participant was sent, or that it sent."""
    for _, speaker, said, content in entries(path):
        if (speaker, said) == (participant, kind):
            assert struct.unpack_from("<I", content)[0] == len(content) - 4
            yield wire_pb2.Frame.FromString(content[4:])
