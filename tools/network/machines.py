"""Two machines on one: network namespaces `near` and `far` with a link between them (tests/bench/network_link.cpp)."""
import subprocess
from typing import NamedTuple

NEAR, FAR = "10.77.0.1", "10.77.0.2"


class Link(NamedTuple):
    """A network between two machines. Delay and jitter are of each way [ms], the rate [Mbit/s] too; 0: no cap."""
    delay: float = 0
    jitter: float = 0
    loss: float = 0  # share of the packets
    rate: float = 0


class NotAllowed(Exception):
    """This machine or its container lets nobody make network namespaces."""


class Machines:
    """While it lives, the two machines do."""

    def __init__(self, program, link):
        self.process = subprocess.Popen(["unshare", "--user", "--map-root-user", "--net", program, *map(str, link)],
                                        stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        words = self.process.stdout.readline().split()
        if not words:
            raise NotAllowed(self.process.communicate()[1].strip())
        self.near, self.far = words[1], words[3]
        self.carried = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        out = self.process.communicate()[0]
        # Bytes and packets that TCP carried, there and back.
        self.carried = {name: (int(data), int(packets)) for name, data, packets in map(str.split, out.splitlines())}

    def on_near(self, *command):
        """The command as it runs on the machine `near`."""
        return self._enter(self.near, command)

    def on_far(self, *command):
        return self._enter(self.far, command)

    @staticmethod
    def _enter(pid, command):
        return ["nsenter", "--target", pid, "--user", "--net", "--preserve-credentials", *map(str, command)]
