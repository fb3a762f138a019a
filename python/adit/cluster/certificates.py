"""Makes certificates for servers and couplers that speak TLS beyond one machine.

Makes an authority in FOLDER/authority, unless it is there, and for each MACHINE the folder FOLDER/MACHINE for --tls.
MACHINE is the name or the address by which others reach it; further ones follow commas: tunnel-b,192.168.0.7
Copy each folder to its machine over a secure connection. Keep FOLDER/authority/key.pem secret: anyone who has it can make more.
"""
import ipaddress
import os
import re
import secrets
import subprocess
from pathlib import Path

from adit import programs
from adit.results.files import Unusable

DAYS, DAYS_OF_AUTHORITY = 825, 3650
LONGEST_NAME = 64  # characters allowed in the subject of a certificate
MACHINE = re.compile(r"[A-Za-z0-9:*][A-Za-z0-9_.:*-]*")


def main(words):
    parser = programs.parser("certificates", __doc__)
    parser.add_argument("folder", metavar="FOLDER", type=Path)
    parser.add_argument("machines", metavar="MACHINE", nargs="+")
    options = parser.parse_args(words)
    os.umask(0o077)
    machines = [names_of(machine) for machine in options.machines]  # all are looked at before anything is made
    make_authority(options.folder / "authority")
    for names in machines:
        make_certificate(options.folder, names)
        print(f"certificates: {options.folder / names[0]} is for --tls on {' '.join(names)}, for {DAYS} days")


def names_of(machine):
    """The names and addresses of a machine, the first of which names its folder."""
    names = machine.split(",")
    if not all(MACHINE.fullmatch(name) for name in names):
        raise Unusable(f"'{machine}' is no machine; give its name or its address, and further ones after commas: tunnel-b,192.168.0.7")
    if names[0] == "authority":
        raise Unusable("a machine cannot be called authority, which is the folder of the authority")
    if len(names[0]) > LONGEST_NAME:
        raise Unusable(f"'{names[0]}' is longer than the {LONGEST_NAME} characters that a certificate takes; begin with a shorter name, "
                      "and give this one after a comma")
    for name in filter(is_address, names):
        try:
            ipaddress.ip_address(name)
        except ValueError:
            raise Unusable(f"'{name}' is no address; an address is written as 192.168.0.7 or fd00::7") from None
    return names


def is_address(name):
    return ":" in name or re.fullmatch("[0-9.]+", name)


def openssl(*words, **more):
    """Runs openssl; returns its standard output. Its progress notes are discarded."""
    try:
        return subprocess.run(["openssl", *map(str, words)], check=True, capture_output=True, text=True, **more).stdout
    except FileNotFoundError:
        raise Unusable("openssl is not installed; install the package openssl") from None
    except subprocess.CalledProcessError as error:
        raise Unusable(f"openssl {words[0]} failed: {error.stderr.strip()}") from None


def make_key(path):
    openssl("genpkey", "-quiet", "-algorithm", "EC", "-pkeyopt", "ec_paramgen_curve:P-256", "-out", path)


def make_authority(folder):
    if (folder / "key.pem").exists():
        return
    folder.mkdir(parents=True, exist_ok=True)
    make_key(folder / "key.pem")
    openssl("req", "-x509", "-new", "-key", folder / "key.pem", "-days", DAYS_OF_AUTHORITY, "-subj", f"/CN=Adit authority {secrets.token_hex(4)}",
            "-addext", "basicConstraints=critical,CA:TRUE", "-addext", "keyUsage=critical,keyCertSign", "-out", folder / "authority.pem")


def make_certificate(folder, names):
    """A key and a certificate of the authority in `folder`, valid for all names of a machine."""
    own, authority = folder / names[0], folder / "authority"
    own.mkdir(parents=True, exist_ok=True)
    make_key(own / "key.pem")
    request = openssl("req", "-new", "-key", own / "key.pem", "-subj", f"/CN={names[0]}")
    extensions = own / "extensions"
    extensions.write_text(f"subjectAltName={','.join(('IP:' if is_address(name) else 'DNS:') + name for name in names)}\n"
                          "basicConstraints=CA:FALSE\nkeyUsage=digitalSignature\n")
    openssl("x509", "-req", "-CA", authority / "authority.pem", "-CAkey", authority / "key.pem", "-days", DAYS,
            "-out", own / "certificate.pem", "-extfile", extensions, input=request)
    extensions.unlink()
    (own / "authority.pem").write_bytes((authority / "authority.pem").read_bytes())
