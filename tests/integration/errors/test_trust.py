"""Servers serve only who knows their secret or has a certificate of their authority, and the coupler's own servers only
the coupler that started them."""

import contextlib
import os
import pathlib
import re
import select
import shutil
import socket
import ssl
import subprocess
import time
import unittest

from programs import ADIT, CASE, COUPLER, Server, coupler
from trusted import SHORT, Relay, TrustTest, expire, valid_in

LONG = ("--set", "time.duration=50 s", "--set", "output.field_times=[]")


def children(process):
    """Process ids of the servers that a coupler has started."""
    try:
        return pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
    except OSError:
        return []


def listening(pid, table, inode):
    """Rows of a table of the kernel's that belong to sockets of a process."""
    try:
        links = [entry.readlink().name for entry in pathlib.Path(f"/proc/{pid}/fd").iterdir()]
        rows = [row.split() for row in pathlib.Path(table).read_text().splitlines()[1:]]
    except OSError:
        return []
    sockets = {match[1] for link in links if (match := re.fullmatch(r"socket:\[(\d+)\]", link))}
    return [row for row in rows if row[inode] in sockets]


def listening_ports(pid):
    return [row for row in listening(pid, "/proc/net/tcp", 9) if row[3] == "0A"]


def listening_paths(pid):
    accepts = 1 << 16
    return [row[7] for row in listening(pid, "/proc/net/unix", 6) if len(row) > 7 and int(row[3], 16) & accepts]


class Secrets(TrustTest):
    def test_who_knows_the_secret_is_served(self):
        """Results are those of servers that the coupler starts itself."""
        secret = self.secret()
        with Server("dem_server", "127.0.0.1:0", "--secret-file", secret) as server:
            result = self.join(server, "--secret-file", secret)
        self.assertEqual(result.returncode, 0, result.stderr)
        own = self.run_scene(CASE / "full_dem.yaml", *SHORT, out="own")
        self.assertEqual((self.folder / "joined/histories.csv").read_bytes(), (own / "histories.csv").read_bytes())

    def test_others_are_refused_and_keep_nobody_away(self):
        secret = self.secret()
        with Server("dem_server", "127.0.0.1:0", "--secret-file", secret) as server:
            self.assert_refused(self.join(server), server.address, "--secret-file")
            self.assert_refused(self.join(server, "--secret-file", self.secret("other")), server.address, "its secret is another one")
            self.assertEqual(self.join(server, "--secret-file", secret).returncode, 0)

    def test_a_server_without_the_secret_is_not_believed(self):
        with Server("dem_server") as server:
            self.assert_refused(self.join(server, "--secret-file", self.secret()), server.address, "has no secret")

    def test_a_secret_that_others_can_read_or_guess_is_refused(self):
        with Server("dem_server") as server:
            self.assert_refused(self.join(server, "--secret-file", self.secret("short", "guess me")), "openssl rand -hex 32")
            readable = self.secret()
            readable.chmod(0o644)
            self.assert_refused(self.join(server, "--secret-file", readable), f"chmod 600 {readable}")


class OwnServers(TrustTest):
    def start(self, *options):
        process = subprocess.Popen([COUPLER, "run", CASE / "coupled.yaml", "--out", self.folder / "run", *options],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def test_who_connects_first_does_not_get_the_server(self):
        """Another program of this user watches for the servers' sockets and is always there before the coupler."""
        thefts = runs = 0
        while thefts < 3 and runs < 20:  # one that comes too late proves nothing
            runs += 1
            run = self.start(*SHORT)
            taken = []
            while run.poll() is None:
                for path in {path for child in children(run) for path in listening_paths(child)}:
                    if len(taken) < 300:
                        taken.append(socket.socket(socket.AF_UNIX))
                        with contextlib.suppress(OSError):  # the coupler is there already
                            taken[-1].connect(path)
                            taken[-1].sendall(b"ADIT\x02\0\0\0")
                            thefts += 1
            for thief in taken:
                thief.close()
            self.assertEqual(run.returncode, 0, run.stderr.read())
        self.assertGreater(thefts, 0, "it never came first")

    def test_strangers_meet_neither_a_server_nor_its_secret(self):
        """Once the coupler is connected, no port and no file leads to its servers."""
        run = self.start(*LONG)
        end = time.monotonic() + 30
        while not (self.folder / "run/histories.csv").exists() and time.monotonic() < end:
            time.sleep(0.02)
        servers = children(run)
        self.assertEqual(len(servers), 2)
        for pid in servers:
            environment = pathlib.Path(f"/proc/{pid}/environ").read_bytes()
            secret = re.search(rb"ADIT_SECRET=([0-9a-f]{64})", environment)[1]
            self.assertNotIn(secret, pathlib.Path(f"/proc/{pid}/cmdline").read_bytes())
            self.assertEqual(listening_ports(pid), [])
            path, = map(pathlib.Path, listening_paths(pid))
            self.assertFalse(path.parent.exists(), path)

    def test_strangers_learn_neither_the_secret_nor_the_run(self):
        secret = self.secret()
        with Server("dem_server", "127.0.0.1:0", "--secret-file", secret) as server:
            self.start("--dem", server.address, "--secret-file", secret, *LONG)
            end = time.monotonic() + 30
            while not (self.folder / "run/histories.csv").exists() and time.monotonic() < end:
                time.sleep(0.02)
            with socket.create_connection(("127.0.0.1", int(server.address.rpartition(":")[2]))) as stranger:
                stranger.sendall(b"ADIT\x02\0\0\0")
                stranger.shutdown(socket.SHUT_WR)
                told = b"".join(iter(lambda: stranger.recv(4096), b""))
            self.assertTrue(told.startswith(b"ADIT"))
            self.assertNotIn(secret.read_bytes(), told)
            self.assertNotIn(b"coupled", told)


class Certificates(TrustTest):
    """TLS 1.3 with a certificate at each end. 0.0.0.0 lies beyond loopback; tests reach it by 127.0.0.1."""

    def serve(self, folder, listen="0.0.0.0:0"):
        return Server("dem_server", listen, "--tls", folder)

    def test_results_are_the_same_by_tls(self):
        folder = self.certificates()
        with self.serve(folder / "localhost") as server:
            for host in ("127.0.0.1", "localhost"):
                result = self.join(server, "--tls", folder / "laptop", host=host)
                self.assertEqual(result.returncode, 0, result.stderr)
        own = self.run_scene(CASE / "full_dem.yaml", *SHORT, out="own")
        self.assertEqual((self.folder / "joined/histories.csv").read_bytes(), (own / "histories.csv").read_bytes())

    def test_nothing_can_be_read_on_the_way(self):
        """Between coupler and server goes no word of the scene, and nothing older than TLS 1.3."""
        folder = self.certificates()
        with self.serve(folder / "localhost") as server, Wiretap(server) as tap:
            result = coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "joined", "--dem", tap.address,
                             "--tls", folder / "laptop", *SHORT)
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(len(tap.heard), 10000)
        for word in (b"ADIT", b"dem_server", b"full_dem", b"Adit authority"):
            self.assertNotIn(word, tap.heard)

    def test_an_older_tls_is_refused(self):
        folder = self.certificates()
        with self.serve(folder / "localhost") as server:
            context = ssl.create_default_context(cafile=folder / "laptop/authority.pem")
            context.load_cert_chain(folder / "laptop/certificate.pem", folder / "laptop/key.pem")
            context.maximum_version = ssl.TLSVersion.TLSv1_2
            host, port = "127.0.0.1", int(server.address.rpartition(":")[2])
            with socket.create_connection((host, port)) as connected, self.assertRaises(ssl.SSLError):
                context.wrap_socket(connected, server_hostname=host)

    def test_certificates_of_another_authority(self):
        folder, other = self.certificates(), self.certificates("theirs")
        with self.serve(folder / "localhost") as server:
            self.assert_refused(self.join(server, "--tls", other / "laptop"),
                                "the certificate of dem_server at", "was signed by another authority")
        mixed = self.folder / "mixed"  # trusts the server, but is not trusted
        shutil.copytree(other / "laptop", mixed)
        shutil.copy(folder / "laptop/authority.pem", mixed)
        with self.serve(folder / "localhost") as server:
            self.assert_refused(self.join(server, "--tls", mixed), "does not accept the certificate of this machine")

    def test_a_certificate_that_has_expired(self):
        folder = self.certificates()
        expired = expire(folder, "laptop")
        with self.serve(folder / "localhost") as server:
            self.assert_refused(self.join(server, "--tls", expired), "does not accept the certificate of this machine", "expired")
        with self.serve(expire(folder, "localhost")) as server:
            self.assert_refused(self.join(server, "--tls", folder / "laptop"), "the certificate of dem_server at", "has expired")

    def test_a_certificate_that_begins_later(self):
        folder = self.certificates()
        with self.serve(folder / "localhost") as server:
            self.assert_refused(self.join(server, "--tls", valid_in(folder, "laptop", 2090)),
                                "does not accept the certificate of this machine", "not valid yet", "clocks")
        with self.serve(valid_in(folder, "localhost", 2090)) as server:
            self.assert_refused(self.join(server, "--tls", folder / "laptop"), "is not valid yet")

    def test_nothing_waits_for_a_pipe_or_a_pass_phrase(self):
        folder = self.certificates()
        locked = self.folder / "locked"
        shutil.copytree(folder / "laptop", locked)
        subprocess.run(["openssl", "pkey", "-in", folder / "laptop/key.pem", "-aes256", "-passout", "pass:x",
                        "-out", locked / "key.pem"], check=True)
        with self.serve(folder / "localhost") as server:
            self.assert_refused(self.join(server, "--tls", locked), "key.pem is no key", "without a pass phrase")
            for name in ("authority.pem", "certificate.pem", "key.pem"):
                piped = self.folder / name
                shutil.copytree(folder / "laptop", piped)
                (piped / name).unlink()
                os.mkfifo(piped / name, 0o600)
                self.assert_refused(self.join(server, "--tls", piped), name, "is not a file")
            pipe = self.folder / "pipe"
            os.mkfifo(pipe, 0o600)
            self.assert_refused(self.join(server, "--secret-file", pipe), "is not a file")

    def test_wrong_names_of_machines_leave_nothing(self):
        """One sentence, exit code 2, and no folder, also for the names before the wrong one."""
        folder = self.folder / "none"
        for name in ("", "a b", "../a", "/a", "a,,b", "10.0.0.999", "1:2", "-a", "a" * 65, "authority,b", "a;b", "é"):
            with self.subTest(name):
                result = subprocess.run([*ADIT, "certificates", folder, "right", name], capture_output=True, text=True)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertRegex(result.stderr, r"\A(usage: [^\n]*\n)?[^\n]*adit certificates: [^\n]*\n\Z")
                self.assertFalse(folder.exists())

    def test_a_certificate_of_another_machine(self):
        """A machine of the same authority cannot pretend to be another one."""
        folder = self.certificates()
        with self.serve(folder / "laptop") as server:
            self.assert_refused(self.join(server, "--tls", folder / "localhost"), "is not for 127.0.0.1")

    def test_a_client_without_certificate(self):
        folder = self.certificates()
        with self.serve(folder / "localhost") as server:
            context = ssl.create_default_context(cafile=folder / "laptop/authority.pem")
            with socket.create_connection(("127.0.0.1", int(server.address.rpartition(":")[2]))) as connected, \
                    self.assertRaisesRegex(ssl.SSLError, "certificate required"), \
                    context.wrap_socket(connected, server_hostname="127.0.0.1") as stranger:
                stranger.sendall(b"ADIT\x02\0\0\0")
                self.assertEqual(stranger.recv(8), b"")

    def test_plain_to_tls_and_back(self):
        folder = self.certificates()
        with self.serve(folder / "localhost") as server:
            self.assert_refused(self.join(server), "it speaks TLS only", "--tls")
        with Server("dem_server") as server:
            self.assert_refused(self.join(server, "--tls", folder / "laptop"), "speaks without TLS", "start it with --tls")

    def test_strangers_keep_nobody_away(self):
        folder = self.certificates()
        with self.serve(folder / "localhost") as server:
            port = int(server.address.rpartition(":")[2])
            words = (b"GET / HTTP/1.1\r\n\r\n", b"ADIT\x02\0\0\0", b"\x16\x03\x01\x02\x00\x01", b"", b"\x80" * 40000)
            strangers = [socket.create_connection(("127.0.0.1", port)) for _ in range(20) for _ in words]
            for stranger, word in zip(strangers, 20 * words):
                stranger.sendall(word)
            result = self.join(server, "--tls", folder / "laptop")
            self.assertEqual(result.returncode, 0, result.stderr)
            for stranger in strangers:
                stranger.close()

    def test_folders_that_cannot_be_used(self):
        folder = self.certificates()
        key = folder / "laptop/key.pem"
        with Server("dem_server") as server:
            key.chmod(0o644)
            self.assert_refused(self.join(server, "--tls", folder / "laptop"), f"chmod 600 {key}")
            key.chmod(0o600)
            key.write_bytes((folder / "localhost/key.pem").read_bytes())
            self.assert_refused(self.join(server, "--tls", folder / "laptop"), str(key), "adit certificates")
            self.assert_refused(self.join(server, "--tls", self.folder / "nowhere"), "authority.pem", "adit certificates")

    def test_insecure_says_what_it_is(self):
        with Server("dem_server", "0.0.0.0:0", "--insecure") as server:
            self.assertEqual(self.join(server).returncode, 0)
            server.process.terminate()
            log = server.process.stderr.read()
        self.assertIn("nothing is encrypted", log)
        self.assertIn("anyone who reaches this server can run models here", log)


class Wiretap(Relay):
    """Keeps what passes."""

    def serve(self):
        client, _ = self.listener.accept()
        with client, socket.create_connection(self.target) as server, contextlib.suppress(OSError):
            other = {client: server, server: client}
            while other:
                for end in select.select(list(other), [], [])[0]:
                    piece = end.recv(1 << 16)
                    self.heard += piece
                    if piece:
                        other[end].sendall(piece)
                    else:
                        other.pop(end).shutdown(socket.SHUT_WR)


if __name__ == "__main__":
    unittest.main()
