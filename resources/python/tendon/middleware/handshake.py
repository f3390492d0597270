"""The handshake. Each end of a link proves that it knows this user's cookie, without sending the
cookie. Under TLS, certificates prove the identities, and the proofs are zeroes:

    opener     HELLO      Greeting
    acceptor   CHALLENGE  Challenge: its greeting and its proof
    opener     PROOF      Proof
    acceptor   WELCOME

The header of each frame has the protocol version of its sender. Both versions must be equal.
"""

from __future__ import annotations

import hashlib
import hmac
import os
import secrets
import stat
import struct
import tempfile
from pathlib import Path
from typing import Any, NamedTuple

from .. import messages
from ..errors import Denied, Error, Incompatible, Invalid, Unreachable
from ..messages import MessageType
from ..payload.schema import Field, Number, String, Structure
from .certificate import Shown
from .frame import PROTOCOL_VERSION, Header

OPENER, ACCEPTOR = 0, 1
MAX_COOKIE = 256  # bytes of its file


def runtime_folder() -> Path:
    """The folder of this user's cookie."""
    chosen = os.environ.get("XDG_RUNTIME_DIR")
    if not chosen:
        return Path(tempfile.gettempdir()) / f"tendon-{os.getuid()}"
    return Path(chosen) / "tendon"


def loopback_cookie() -> int:
    """The secret of this user on this machine. The first program of Tendon writes it to a file of
    mode 0600. Raises Denied if the file does not exist yet, or if other users may read it."""
    file = runtime_folder() / "cookie"
    try:
        descriptor = os.open(file, os.O_RDONLY | os.O_CLOEXEC | os.O_NOFOLLOW)
    except FileNotFoundError:
        raise Denied(f"there is no {file}: no program of Tendon runs as this user; "
                     "start one with: gcm serve") from None
    except OSError as failure:
        raise Denied(f"{file}: {failure.strerror}") from None
    with open(descriptor, "rb") as opened:
        status = os.fstat(descriptor)
        if (status.st_uid != os.geteuid() or status.st_mode & 0o077
                or not stat.S_ISREG(status.st_mode)):
            raise Denied(f"{file} must belong to your user, and only your user may read it "
                         "(mode 0600): remove this file, then start the program again")
        text = opened.read(MAX_COOKIE)
    try:
        cookie = int(text, 16)
    except ValueError:
        cookie = 0
    if not 0 < cookie < 1 << 64:
        raise Invalid(f"{file} is damaged: remove this file, then start the program again")
    return cookie


class Reply(NamedTuple):
    """The next message to send."""

    type: MessageType
    body: bytes


class Opener:
    """The opener's side. `address` is the address of the acceptor; `peer` is the acceptor's
    greeting, after the acceptor was authenticated. Under TLS, `shown` is the acceptor's
    certificate, the cookie is 0, and only the process `wanted` is accepted."""

    def __init__(self, name: str, address: str, cookie: int, shown: Shown | None = None,
                 wanted: str = "") -> None:
        self._shown = shown
        self._wanted = wanted
        self._mine = {"instance": secrets.randbits(64), "name": name,
                      "nonce": secrets.token_bytes(16)}
        self._address = address
        self._cookie = cookie
        self.peer: dict[str, Any] = {}
        self.is_welcome = False

    def greet(self) -> Reply:
        """The first message of the handshake."""
        return Reply(MessageType.HELLO, messages.encode("Greeting", self._mine))

    def take(self, header: Header, body: bytes) -> Reply | None:
        """Returns the reply to the peer's next frame; None if the handshake is complete, which
        sets `is_welcome`. If the peer refuses this program, raises the reason."""
        if header.type == MessageType.REFUSAL:
            raise messages.read_refusal(body, self._address)
        if header.version != PROTOCOL_VERSION:  # this program cannot read the body
            raise self._versions_differ(header.version)
        if self.peer:
            if header.type != MessageType.WELCOME:
                raise Invalid(f"{self._address} answered the proof with an unexpected message")
            self.is_welcome = True
            return None
        if header.type != MessageType.CHALLENGE:
            raise Invalid(f"{self._address} answered the Hello with an unexpected message")
        return self._on_challenge(messages.decode("Challenge", body))

    def _on_challenge(self, challenge: dict[str, Any]) -> Reply:
        greeting = challenge["greeting"]
        its_proof = self._proof(ACCEPTOR, greeting)
        if self._shown is not None:
            self._check_shown(self._shown, greeting["name"])
        elif not hmac.compare_digest(challenge["proof"], its_proof):
            raise Denied(f"{greeting['name']} does not know '{self._mine['name']}': both must run "
                         "as the same user of this machine")
        self.peer = greeting
        proof = {"proof": self._proof(OPENER, greeting), "session": 0}
        return Reply(MessageType.PROOF, messages.encode("Proof", proof))

    def _check_shown(self, shown: Shown, name: str) -> None:
        """Checks the name in the peer's certificate before anything confidential is sent. TLS
        itself checks that it is the certificate of a process."""
        if shown.name != name:
            raise Denied(f"{self._address} calls itself '{name}', but shows the certificate of "
                         f"'{shown.name}': do not trust that program")
        if shown.role != "operator":
            raise Denied(f"{self._address} has the certificate of a viewer, but only operators may "
                         f"give orders: issue '{name}' a certificate with --role operator")
        if self._wanted not in ("", name):
            raise Unreachable(f"the process at {self._address} is '{name}', but "
                              f"'{self._wanted}' was expected")

    def _proof(self, role: int, acceptor: dict[str, Any]) -> bytes:
        if self._cookie == 0:
            return bytes(hashlib.sha256().digest_size)
        part = _SIGNED_PART.encode({"role": role, "opener": self._mine, "acceptor": acceptor,
                                   "address": self._address, "session": 0})
        return hmac.new(struct.pack("<Q", self._cookie), part, hashlib.sha256).digest()

    def _versions_differ(self, its: int) -> Error:
        behind = "this program" if its > PROTOCOL_VERSION else self._address
        return Incompatible(f"{self._address} speaks protocol version {its}, but this program "
                            f"speaks version {PROTOCOL_VERSION}: update {behind}")


# The content of a proof. Each part is preceded by its size, so that no bytes can move from one part to the next.
_GREETING = messages.SCHEMAS["tendon.Greeting"]
_SIGNED_PART = Structure("tendon.SignedPart", (
    Field("role", Number("uint8")), Field("opener", _GREETING), Field("acceptor", _GREETING),
    Field("address", String()),
    Field("session", Number("uint64"))))
