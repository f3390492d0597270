"""Addresses of programs of Tendon, such as "127.0.0.1:10705"."""

from __future__ import annotations

import ipaddress
import os
import re
from typing import NamedTuple

from ..errors import Denied, Invalid

DEFAULT_GCM_PORT = 10705

_HOST = re.compile(r"(?!-)[A-Za-z0-9._:%-]+")


class Address(NamedTuple):
    """A host, without brackets, and a port."""

    host: str
    port: int

    def __str__(self) -> str:
        host = f"[{self.host}]" if ":" in self.host else self.host
        return f"{host}:{self.port}"


def parse_address(text: str, is_encrypted: bool = False) -> Address:
    """Reads host:port. The host must be this machine, unless the link is encrypted."""
    host, colon, port = text.rpartition(":")
    if not colon:
        raise Invalid(f"address '{text}': expected host:port, such as 127.0.0.1:10705")
    if host.startswith("[") and host.endswith("]"):
        host = host[1:-1]
    elif ":" in host:
        raise Invalid(f"address '{text}': put an IPv6 host in brackets, such as [::1]:10705")
    if not _HOST.fullmatch(host):
        raise Invalid(f"address '{text}': expected a host before the ':'")
    if not re.fullmatch("[0-9]{1,5}", port) or not 1 <= int(port) <= 65535:
        raise Invalid(f"port '{port}': expected 1..65535")
    host = "127.0.0.1" if host == "localhost" else host
    if not is_encrypted and not _is_loopback(host):
        raise Denied(f"host '{host}' is on another machine and the connection "
                     "is not encrypted: use 127.0.0.1, or encrypt the connection with "
                     "a certificate")
    return Address(host, int(port))


def gcm_address(chosen: str | None) -> str:
    """The address of the GCM: `chosen`, otherwise $TENDON_GCM, otherwise this machine. A host
    without a port gets the default port."""
    address = chosen or os.environ.get("TENDON_GCM") or "127.0.0.1"
    is_host = ":" not in address or address.endswith("]")
    return f"{address}:{DEFAULT_GCM_PORT}" if is_host else address


def _is_loopback(host: str) -> bool:
    try:
        return ipaddress.ip_address(host).is_loopback
    except ValueError:
        return False
