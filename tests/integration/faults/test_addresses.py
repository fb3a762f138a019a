"""Servers that cannot be reached or do not begin: one sentence that says where, exit code 2, within 10 s; a server that the coupler
starts itself, exit code 3. No results are begun."""

import contextlib
import signal
import socket
import subprocess
import sys
import time
import unittest

from faults.faulty import SHORT, FaultTest
from programs import CASE, COUPLER, PATIENCE_S, coupler

SILENT_NAME_SERVER = """
import socket, subprocess, sys
subprocess.run(["ip", "link", "set", "lo", "up"], check=True)
silent = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
silent.bind(("127.0.0.1", 53))
subprocess.run(["mount", "--bind", sys.argv[1], "/etc/resolv.conf"], check=True)
sys.exit(subprocess.run(sys.argv[2:]).returncode)
"""


class Addresses(FaultTest):
    def assert_refused(self, address, *words, code=2):
        begin = time.monotonic()
        done = coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--dem", address, *SHORT)
        self.assertLess(time.monotonic() - begin, 10)
        self.assertEqual(done.returncode, code, done.stderr)
        self.assert_said(done.stderr, *words)
        self.assertFalse((self.folder / "run/summary.json").exists())

    def test_a_name_that_nobody_has(self):
        self.assert_refused("no-such-host.invalid:4711", "the host in no-such-host.invalid:4711 is not known", "check its name")

    def test_a_machine_that_does_not_answer(self):
        """A full queue of connections, as behind a firewall that drops what comes."""
        with socket.create_server(("127.0.0.1", 0), backlog=0) as full, contextlib.ExitStack() as waiting:
            host, port = full.getsockname()
            for _ in range(3):
                client = waiting.enter_context(socket.socket())
                client.setblocking(False)
                client.connect_ex((host, port))
            self.assert_refused(f"{host}:{port}", f"dem_server does not answer at {host}:{port} within 5 s", "firewall")

    def test_a_program_that_says_nothing(self):
        with socket.create_server(("127.0.0.1", 0)) as mute:
            address = "127.0.0.1:%d" % mute.getsockname()[1]
            self.assert_refused(address, f"dem_server at {address}: no answer within 5 s", code=3)

    def test_a_name_server_that_is_dead(self):
        settings = self.folder / "resolv.conf"
        settings.write_text("nameserver 127.0.0.1\n")
        command = ["unshare", "-rmn", sys.executable, "-c", SILENT_NAME_SERVER, settings]
        if subprocess.run([*command, "true"], capture_output=True).returncode:
            self.skipTest("no name server can be given to a process here")
        begin = time.monotonic()
        done = subprocess.run([*command, COUPLER, "run", CASE / "full_dem.yaml", "--out", self.folder / "run", "--dem", "tunnel.example:4711"],
                              capture_output=True, text=True, timeout=PATIENCE_S)
        self.assertLess(time.monotonic() - begin, 10)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assert_said(done.stderr, "the host in tunnel.example:4711 is not known, because no name server answers within 5 s")

    def test_a_server_that_is_not_installed(self):
        done, _ = self.run_beside(None)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assert_said(done.stderr, "fdm_server: is found neither in ", "install or build it")

    def test_a_server_that_ends_at_once_tells_how(self):
        for script, words in (("exit 7", "ended with exit code 7 before it listened"),
                              ("kill -9 $$", f"was ended by signal {int(signal.SIGKILL)} (Killed) before it listened")):
            for command in ("run", "check"):
                done, seconds = self.run_beside(f"echo first; echo the reason >&2; {script}", command)
                self.assertEqual(done.returncode, 3, done.stderr)
                self.assert_said(done.stderr, f"fdm_server: {words}; the last line of its log: the reason")
                self.assertLess(seconds, 5)


if __name__ == "__main__":
    unittest.main()
