"""The certificate that this program shows under TLS, and the owner of a peer's certificate."""

from __future__ import annotations

import os
import ssl
import stat
from pathlib import Path
from typing import Iterator, NamedTuple

from ..errors import Denied, Invalid, NotFound

MAX_CERTIFICATE = 64 << 10  # bytes of its text

_SEQUENCE, _VERSION = 0x30, 0xa0  # tags of DER
_COMMON_NAME, _UNIT = b"\x55\x04\x03", b"\x55\x04\x0b"


class Credentials(NamedTuple):
    """The files of `--certificate` and `--ca`: a certificate, its key beside it as .key, and the
    folder of the CA's ca.crt and crl.pem."""

    certificate: Path
    authority: Path

    @property
    def key(self) -> Path:
        """The key of the certificate."""
        return self.certificate.with_suffix(".key")


class Shown(NamedTuple):
    """The owner of a certificate, and the owner's role."""

    name: str
    role: str


def chosen_credentials(certificate: str | os.PathLike[str] | None,
                       authority: str | os.PathLike[str] | None) -> Credentials | None:
    """The chosen files. The default of the certificate is $TENDON_CERTIFICATE; the defaults of the
    CA are $TENDON_CA and the user's own CA. None if no certificate is chosen. Raises NotFound or
    Denied if the files cannot be used."""
    file = certificate or os.environ.get("TENDON_CERTIFICATE")
    if not file:
        return None
    folder = authority or os.environ.get("TENDON_CA") or _usual_authority()
    chosen = Credentials(Path(file).absolute(), Path(folder).absolute())
    _require(chosen.certificate, "make one with: gcm cert issue")
    _require(chosen.key, "the key must be in the same folder as the certificate")
    _require(chosen.authority / "ca.crt", "give the folder of the CA")
    _require(chosen.authority / "crl.pem", "copy this file from the CA")
    if stat.S_IMODE(chosen.key.stat().st_mode) & 0o077:
        raise Denied(f"{chosen.key} can be read by others: chmod 600 {chosen.key}")
    return chosen


def holder_of(text: str) -> Shown:
    """The owner of a certificate (PEM), whose subject has one CN and one OU. Does not check whether
    the certificate is valid. Raises Invalid."""
    if len(text) > MAX_CERTIFICATE:
        raise Invalid("the certificate is too long to be read")
    try:
        (tag, parts), = _values(ssl.PEM_cert_to_DER_cert(text))
        if tag != _SEQUENCE:
            raise ValueError
        fields = list(_values(next(_values(parts))[1]))
        has_version = fields[0][0] == _VERSION
        # serial number, algorithm, issuer, validity, subject
        found = dict[bytes, list[str]]()
        for _, one in _values(fields[4 + has_version][1]):
            (_, pair), = _values(one)
            (_, kind), (_, value) = _values(pair)
            found.setdefault(kind, []).append(value.decode())
        (name,), (role,) = found[_COMMON_NAME], found[_UNIT]
    except (ValueError, KeyError, IndexError, StopIteration):
        raise Invalid("this is not a certificate of Tendon: such a certificate has one name and "
                      "one role") from None
    return Shown(name, role)


def _values(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Yields the tag and the content of each DER value in turn."""
    while data:
        if len(data) < 2:
            raise ValueError
        size, start = data[1], 2
        if size >= 0x80:  # the long form
            start += size - 0x80
            size = int.from_bytes(data[2:start], "big")
        if len(data) < start + size:
            raise ValueError
        yield data[0], data[start:start + size]
        data = data[start + size:]


def _usual_authority() -> Path:
    state = os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state"
    return Path(state) / "tendon" / "ca"


def _require(file: Path, advice: str) -> None:
    if not file.is_file():
        raise NotFound(f"there is no {file}: {advice}")
