"""coupler doctor tells of a server whether it serves, who it is and how fast it answers; or why it does not serve."""

import http.server
import re
import secrets
import socket
import subprocess
import threading
import time
import unittest

from foreign import Listener
from peers.test_templates import template
from programs import ADIT, CASE, COUPLER, ProgramTest, Server, coupler


class Doctor(ProgramTest):
    def examine(self, address, code, *words, options=()):
        result = coupler("doctor", address, *options)
        self.assertEqual(result.returncode, code, result.stdout + result.stderr)
        for word in words:
            self.assertIn(word, result.stdout + result.stderr)
        self.assertEqual(result.stderr.count("\n"), 0 if code == 0 else 1, result.stderr)
        return result.stdout

    def assert_measured(self, text, points):
        """A step carries a pair of numbers for each coupling point in each direction, and some bytes more."""
        self.assertIn(f"of {points} coupling points", text)
        sent, received = map(int, re.search(r"bytes a step +(\d+) sent, (\d+) received", text).groups())
        for count in (sent, received):
            self.assertGreaterEqual(count, 16 * points)
            self.assertLess(count, 16 * points + 120)
        median = float(re.search(r"round trip +(\S+) µs", text)[1])
        steps = int(re.search(r"at most (\S+) ", text)[1].replace(",", ""))
        self.assertAlmostEqual(steps * median / 1e6, 1, delta=0.02)

    def test_a_server_that_is_free(self):
        for program, sizes in (("fdm_server", (140,)), ("dem_server", (7, 300))):
            with Server(program) as server:
                for points in sizes:  # it serves again afterwards
                    text = self.examine(server.address, 0, f"program            {program} ", "without TLS",
                                        "without a secret", options=("--points", points))
                    self.assert_measured(text, points)

    def test_another_code(self):
        for name in ("continuum", "particles"):
            with template(name) as other:
                self.assert_measured(self.examine(other.address, 0, options=("--points", 5)), 5)

    def secret(self):
        path = self.folder / "secret"
        path.write_text(secrets.token_hex(32))
        path.chmod(0o600)
        return "--secret-file", path

    def test_a_server_that_computes(self):
        for options in ((), self.secret()):
            with Server("dem_server", "127.0.0.1:0", *options) as server:
                out = self.folder / f"run_{len(options)}"
                run = subprocess.Popen([COUPLER, "run", CASE / "full_dem.yaml", "--out", out, "--dem", server.address, *options,
                                        "--set", "time.duration=50 s"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                self.addCleanup(run.wait)
                self.addCleanup(run.kill)
                end = time.monotonic() + 30
                while not (out / "histories.csv").exists() and time.monotonic() < end:
                    time.sleep(0.02)
                self.examine(server.address, 2, "reachable          yes", "serves             no", "busy with run cantilever/full_dem",
                             options=options)
                run.kill()

    def test_nothing_at_the_address(self):
        with socket.create_server(("127.0.0.1", 0)) as free:
            address = "127.0.0.1:%d" % free.getsockname()[1]
        self.examine(address, 2, "reachable          no", f"nothing listens at {address}")
        self.examine("127.0.0.1", 2, "127.0.0.1")
        self.examine("no.such.host.invalid:4711", 2, "reachable          no", "the host in no.such.host.invalid:4711 is not known")

    def test_a_program_that_says_nothing(self):
        with socket.create_server(("127.0.0.1", 0)) as silent:
            self.examine("127.0.0.1:%d" % silent.getsockname()[1], 3, "serves             no", "no answer within 5 s")

    def test_a_web_server(self):
        with http.server.HTTPServer(("127.0.0.1", 0), http.server.SimpleHTTPRequestHandler) as web:
            web.RequestHandlerClass.log_message = lambda *_: None
            thread = threading.Thread(target=web.serve_forever)
            thread.start()
            self.examine("127.0.0.1:%d" % web.server_port, 2, "does not speak the Adit protocol but HTTP", "check host and port")
            web.shutdown()
            thread.join()

    def test_another_server_by_tls(self):
        """Such as a web server: it answers what is not TLS by an alert."""

        def alert(client):
            client.recv(100)
            client.sendall(b"\x15\x03\x03\0\2\2\x46")

        self.examine(Listener(alert).address, 2, "does not speak the Adit protocol but TLS")

    def test_tls(self):
        folder = self.folder / "certificates"
        subprocess.run([*ADIT, "certificates", folder, "localhost", "laptop"], check=True, capture_output=True)
        with Server("dem_server", "127.0.0.1:0", "--tls", folder / "localhost") as server:
            address = "localhost:" + server.address.rpartition(":")[2]
            text = self.examine(address, 0, "TLS 1.3, certificate of localhost, signed by Adit authority", options=("--tls", folder / "laptop"))
            self.assert_measured(text, 140)
            self.examine(address, 2, "serves             no", "it speaks TLS only")
        with Server("dem_server") as server:
            self.examine(server.address, 2, "trusted            no", "without TLS", options=("--tls", folder / "laptop"))
        with Server("dem_server", f"unix:{self.folder}/dem") as server:  # of this machine: as a run, without TLS
            self.examine(server.address, 0, "without TLS", options=("--tls", folder / "laptop"))

    def test_a_secret(self):
        secret = self.secret()
        with Server("fdm_server", "127.0.0.1:0", *secret) as server:
            self.examine(server.address, 0, "by a secret that both ends know", options=secret)
            self.examine(server.address, 2, "serves             no", "--secret-file")


if __name__ == "__main__":
    unittest.main()
