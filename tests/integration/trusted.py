"""Secrets, certificates and clients, for the tests of who is served."""

import secrets
import shutil
import socket
import subprocess
import threading

from programs import ADIT, CASE, ProgramTest, coupler

SHORT = ("--set", "time.duration=2 ms", "--set", "output.field_times=[]")


class TrustTest(ProgramTest):
    def secret(self, name="secret", text=None):
        path = self.folder / name
        path.write_text((text or secrets.token_hex(32)) + "\n")
        path.chmod(0o600)
        return path

    def certificates(self, authority="ours", *machines):
        folder = self.folder / authority
        subprocess.run([*ADIT, "certificates", folder, *(machines or ("localhost,127.0.0.1", "laptop"))],
                       check=True, capture_output=True)
        return folder

    def join(self, server, *options, host="127.0.0.1"):
        address = f"{host}:{server.address.rpartition(':')[2]}"
        return coupler("run", CASE / "full_dem.yaml", "--out", self.folder / "joined", "--dem", address, *SHORT, *options)

    def assert_refused(self, result, *words, code=2):
        self.assertEqual(result.returncode, code, result.stderr)
        for word in words:
            self.assertIn(word, result.stderr)


class Relay:
    """Stands between one client and a server; `serve` passes on what it hears."""

    def __init__(self, server):
        self.target = ("127.0.0.1", int(server.address.rpartition(":")[2]))
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.address = "127.0.0.1:%d" % self.listener.getsockname()[1]
        self.heard = b""

    def __enter__(self):
        self.thread = threading.Thread(target=self.serve)
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.thread.join()
        self.listener.close()


def expire(folder, machine):
    """A copy of a machine's folder whose certificate was valid for one day, long ago."""
    return valid_in(folder, machine, 2020)


def valid_in(folder, machine, year):
    """The same for the first day of a year."""
    copy = folder / f"{machine}_{year}"
    shutil.copytree(folder / machine, copy)
    authority, work = folder / "authority", folder / f"{machine}_work"
    work.mkdir()
    (work / "index.txt").touch()
    (work / "ca.cnf").write_text(f"""[ca]
default_ca = own
[own]
database = {work}/index.txt
new_certs_dir = {work}
rand_serial = yes
default_md = sha256
policy = any
copy_extensions = copy
[any]
commonName = supplied
""")
    request = work / "request.pem"
    subprocess.run(["openssl", "x509", "-x509toreq", "-in", copy / "certificate.pem", "-signkey", copy / "key.pem",
                    "-copy_extensions", "copy", "-out", request], check=True, capture_output=True)
    subprocess.run(["openssl", "ca", "-batch", "-notext", "-config", work / "ca.cnf", "-cert", authority / "authority.pem",
                    "-keyfile", authority / "key.pem", "-startdate", f"{year}0101000000Z", "-enddate", f"{year}0102000000Z",
                    "-in", request, "-out", copy / "certificate.pem"], check=True, capture_output=True)
    return copy
