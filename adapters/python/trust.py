"""Who may speak to a participant: who knows its secret, or has a certificate of its authority (docs/protocol.md, Hello)."""
import hmac
import ssl
import sys
from pathlib import Path

SHORTEST_SECRET = 16


def require_private(file):
    if file.stat().st_mode & 0o077:
        sys.exit(f"other users may read or change {file}: chmod 600 {file}")


def read_secret(path):
    """The first line of a file that only its owner may read."""
    file = Path(path)
    require_private(file)
    secret = file.read_bytes().partition(b"\n")[0]
    if len(secret) < SHORTEST_SECRET:
        sys.exit(f"the first line of {file} is no secret of {SHORTEST_SECRET} bytes or more: openssl rand -hex 32 > {file}")
    return secret


def prove(secret, who, challenges):
    """`who` is b"client" or b"server"; the challenges are those of the coupler and of the participant."""
    return hmac.digest(secret, who + b"".join(challenges), "sha256")


def server_context(folder):
    """TLS 1.3 with a certificate of the authority at both ends. `folder` is one that adit certificates made."""
    folder = Path(folder)
    require_private(folder / "key.pem")
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.minimum_version = ssl.TLSVersion.TLSv1_3
    context.verify_mode = ssl.CERT_REQUIRED
    context.load_verify_locations(folder / "authority.pem")
    context.load_cert_chain(folder / "certificate.pem", folder / "key.pem")
    return context
