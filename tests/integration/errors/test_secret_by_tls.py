"""A server with a certificate and a secret serves clients that trust its authority and know the secret. They need no
certificate of their own."""

import contextlib
import shutil
import socket
import ssl
import threading
import unittest

from programs import CASE, Server
from trusted import SHORT, Relay, TrustTest, expire


class SecretByTls(TrustTest):
    def setUp(self):
        super().setUp()
        self.made = self.certificates()
        self.guest = self.folder / "guest"  # what a client without certificate has
        self.guest.mkdir()
        shutil.copy(self.made / "authority/authority.pem", self.guest)
        self.shared = self.secret()

    def serve(self, machine=None):
        return Server("dem_server", "0.0.0.0:0", "--tls", machine or self.made / "localhost", "--secret-file", self.shared)

    def test_who_knows_the_secret_is_served_with_or_without_certificate(self):
        own = self.run_scene(CASE / "full_dem.yaml", *SHORT, out="own")
        with self.serve() as server:
            for folder in (self.guest, self.made / "laptop"):
                result = self.join(server, "--tls", folder, "--secret-file", self.shared)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertEqual((self.folder / "joined/histories.csv").read_bytes(), (own / "histories.csv").read_bytes())

    def test_others_are_refused_and_keep_nobody_away(self):
        with self.serve() as server:
            other = self.secret("other")
            self.assert_refused(self.join(server, "--tls", self.guest, "--secret-file", other), "its secret is another one")
            self.assert_refused(self.join(server, "--tls", self.guest), "serves only clients that know its secret")
            self.assert_refused(self.join(server, "--tls", self.made / "laptop"), "serves only clients that know its secret")
            self.assert_refused(self.join(server, "--secret-file", self.shared), "it speaks TLS only")
            self.assertEqual(self.join(server, "--tls", self.guest, "--secret-file", self.shared).returncode, 0)

    def test_certificates_that_have_expired_are_refused_whoever_knows_the_secret(self):
        with self.serve(expire(self.made, "localhost")) as server:
            self.assert_refused(self.join(server, "--tls", self.guest, "--secret-file", self.shared), "has expired")
        with self.serve() as server:
            self.assert_refused(self.join(server, "--tls", expire(self.made, "laptop"), "--secret-file", self.shared), "expired")

    def test_a_server_without_secret_asks_for_a_certificate(self):
        with Server("dem_server", "0.0.0.0:0", "--tls", self.made / "localhost") as server:
            self.assert_refused(self.join(server, "--tls", self.guest, "--secret-file", self.shared), "there is none")

    def test_a_server_needs_its_certificate(self):
        with self.assertRaisesRegex(RuntimeError, "certificate.pem is no certificate"):
            self.serve(self.guest)

    def test_proofs_cannot_be_passed_on_by_a_machine_between(self):
        """A machine of the same authority that does not know the secret takes both ends' TLS and passes on what they say."""
        with self.serve() as server, Between(server, self.made / "localhost") as between:
            self.assert_refused(self.join(between, "--tls", self.guest, "--secret-file", self.shared), "its secret is another one")
        self.assertIn(b"dem_server", between.heard)


class Between(Relay):
    """Ends the TLS of a client, begins another one to a server, and passes on all that is said."""

    def __init__(self, server, folder):
        super().__init__(server)
        self.inward = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        self.inward.load_cert_chain(folder / "certificate.pem", folder / "key.pem")
        self.outward = ssl.create_default_context(cafile=folder / "authority.pem")

    def serve(self):
        connected, _ = self.listener.accept()
        with self.inward.wrap_socket(connected, server_side=True) as client, \
                self.outward.wrap_socket(socket.create_connection(self.target), server_hostname="127.0.0.1") as server:
            answers = threading.Thread(target=self.pass_on, args=(server, client))
            answers.start()
            self.pass_on(client, server)
            answers.join()

    def pass_on(self, sender, receiver):
        with contextlib.suppress(OSError):
            while piece := sender.recv(1 << 16):
                self.heard += piece
                receiver.sendall(piece)
        with contextlib.suppress(OSError):
            receiver.shutdown(socket.SHUT_WR)


if __name__ == "__main__":
    unittest.main()
