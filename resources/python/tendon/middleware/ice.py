"""Frames over ZeroC Ice, by the contract in tendon.ice. Nothing else in this package knows Ice."""

from __future__ import annotations

import struct
import threading
import time
from pathlib import Path
from typing import Any, Callable

try:
    import Ice
except ModuleNotFoundError as missing:
    raise ModuleNotFoundError(
        "this Python has no module Ice, which tendon needs: use a Python with python3-zeroc-ice, "
        "such as /usr/bin/python3 after tools/setup", name="Ice") from missing

from ..errors import Denied, Error, Failed, Invalid, TimedOut, Unreachable
from .address import Address, parse_address
from .certificate import Credentials, Shown, holder_of
from .frame import MAX_PIECE_SIZE, MAX_UNAUTHENTICATED_FRAME_SIZE, Header, read_frame

Ice.loadSlice("", [str(Path(__file__).with_name("tendon.ice").resolve())])
_CONTRACT = Ice.openModule("tendon")  # the module of tendon.ice
_IDENTITY = Ice.Identity("tendon", "")
_ENCAPSULATION = struct.Struct("<iBB")  # size including these fields, version
_NOTHING = _ENCAPSULATION.pack(_ENCAPSULATION.size, 1, 1)
_NO_REPLY_YET = _ENCAPSULATION.pack(_ENCAPSULATION.size + 1, 1, 1) + b"\0"

ENVELOPE = 16 << 10  # bytes that Ice may add to a frame

# All settings of a communicator, as in core/tendon/ice/settings.cpp. The environment cannot change them. Timeouts are
# in ms, except for ACM: in s. Clients send heartbeats.
_SETTINGS = {
    "Ice.Admin.Enabled": "0",
    "Ice.MessageSizeMax": str((MAX_PIECE_SIZE + ENVELOPE) >> 10),
    "Ice.RetryIntervals": "-1",
    "Ice.Override.Timeout": "3000",
    "Ice.Override.ConnectTimeout": "3000",
    "Ice.Override.CloseTimeout": "750",
    "Ice.ACM.Timeout": "1",
    "Ice.ACM.Client.Heartbeat": "3",
    "Ice.ACM.Client.Close": "0",
    "Ice.ThreadPool.Client.Serialize": "1",
    "Ice.ThreadPool.Client.Size": "1",
    "Ice.ThreadPool.Client.SizeMax": "1",
    "Ice.Warn.Connections": "0",
}

OnFrame = Callable[[Header, bytes], None]
OnClosed = Callable[[Error], None]


class Network:
    """One communicator. With credentials, all of its links use TLS. Thread-safe."""

    def __init__(self, credentials: Credentials | None = None) -> None:
        self._credentials = credentials
        settings = Ice.InitializationData()
        settings.properties = Ice.createProperties()
        for name, value in (_SETTINGS | _tls_settings(credentials)).items():
            settings.properties.setProperty(name, value)
        try:
            self._communicator = Ice.initialize(settings)
        except Ice.Exception as why:
            raise _why_not_started(why, credentials) from None
        self._lock = threading.Lock()
        self._is_closed = False
        self._last_number = 0
        self._links: dict[Any, IceLink] = {}  # by connection
        self._adapter = self._communicator.createObjectAdapter("")
        self._adapter.add(_Endpoint(self._links), _IDENTITY)
        self._adapter.activate()

    @property
    def is_encrypted(self) -> bool:
        """True if the links use TLS."""
        return self._credentials is not None

    def address(self, text: str) -> Address:
        """Reads host:port; refuses an address that this network may not use."""
        return parse_address(text, is_encrypted=self.is_encrypted)

    def open(self, address: Address, on_frame: OnFrame, on_closed: OnClosed,
             timeout: float) -> IceLink:
        """Opens a connection to the program at an address, within `timeout` seconds. One thread of
        Ice calls `on_frame` and `on_closed`, which must not block."""
        deadline = time.monotonic() + timeout
        with self._lock:
            if self._is_closed:
                raise Failed("this system is closed; call connect() again")
            self._last_number += 1
            number = self._last_number
        opening = None
        try:
            protocol = "tcp" if self._credentials is None else "ssl"
            proxy = self._communicator.stringToProxy(
                f'tendon:{protocol} -h "{address.host}" -p {address.port}')
            # The connection id makes Ice open a separate connection for each link.
            opening = proxy.ice_connectionId(str(number)).ice_getConnectionAsync()
            connection = opening.result(_left(deadline))
            link = IceLink(connection, on_frame, on_closed)
            self._serve(connection, link)
            # The ping makes the other end serve the connection, too.
            ping = connection.createProxy(_IDENTITY).ice_invokeAsync(
                "ice_ping", Ice.OperationMode.Normal, b"")
            ping.result(_left(deadline))
            return link
        except Ice.Exception as why:
            if opening is not None:
                opening.add_done_callback(_close)  # also if it opens after the timeout
            raise _why_not_opened(why, address, timeout, self._credentials) from None

    def close(self) -> None:
        """Ends all connections; may be called twice."""
        with self._lock:
            self._is_closed = True
        self._communicator.destroy()

    def _serve(self, connection: Any, link: IceLink) -> None:
        def on_gone(_connection: Any) -> None:
            self._links.pop(connection, None)
            who = "this program" if self._is_closed else link.peer_address
            link.on_closed(Unreachable(f"{who} closed the connection"))

        self._links[connection] = link
        connection.setCloseCallback(on_gone)
        connection.setAdapter(self._adapter)


class IceLink:
    """The opener's end of one connection of Ice."""

    def __init__(self, connection: Any, on_frame: OnFrame, on_closed: OnClosed) -> None:
        self.on_closed = on_closed
        self.peer_address = _peer_of(connection)
        self._on_frame = on_frame
        self._connection = connection
        self._limit = MAX_UNAUTHENTICATED_FRAME_SIZE  # of the size of a frame
        self.shown = _shown_by(connection)  # the peer's certificate, under TLS
        self._peer = _CONTRACT.EndpointPrx.uncheckedCast(
            connection.createProxy(_IDENTITY).ice_oneway())

    def send(self, frame: bytes) -> None:
        """Sends a frame of at most MAX_PIECE_SIZE, in order. If the peer does not read, waits for
        up to 3 s. Must not be called in a thread of Ice."""
        try:
            self._peer.frame(frame)
        except Ice.Exception:
            raise Unreachable(f"{self.peer_address} is not connected") from None

    def post(self, frame: bytes) -> None:
        """Like send(), but for a thread of Ice. Never waits, and does nothing if the link is
        closed."""
        try:
            self._peer.frameAsync(frame)
        except Ice.Exception:
            pass

    def admit(self) -> None:
        """Called when the peer is authenticated; from then on it may send large frames."""
        self._limit = MAX_PIECE_SIZE

    def close(self) -> None:
        """Closes the connection at once. Ice then calls on_closed."""
        self._connection.close(Ice.ConnectionClose.Forcefully)

    def deliver(self, data: bytes | None) -> None:
        """Handles one message of Ice; disconnects a peer that sends anything but frames."""
        frame = None if data is None else read_frame(data, self._limit)
        if frame is None:
            self.close()
        else:
            self._on_frame(*frame)


class _Endpoint(Ice.Blobject):  # type: ignore[misc]
    """Receives the messages of all connections. Reads them itself, because the code that Ice
    generates from the contract crashes on a malformed message, in Python as in C++."""

    def __init__(self, links: dict[Any, IceLink]) -> None:
        self._links = links

    def ice_invoke(self, parameters: bytes, current: Any) -> tuple[bool, bytes]:
        """Called by Ice for each operation that a peer invokes."""
        link = self._links.get(current.con)
        if link is None:
            raise Ice.ObjectNotExistException(current.id, current.facet, current.operation)
        if current.operation not in ("frame", "ask"):
            raise Ice.OperationNotExistException(current.id, current.facet, current.operation)
        link.deliver(only_parameter(parameters))
        return True, _NO_REPLY_YET if current.operation == "ask" else _NOTHING


def only_parameter(encapsulation: bytes) -> bytes | None:
    """The bytes that are the only parameter of an operation. None if the encapsulation is malformed
    or contains anything else."""
    if len(encapsulation) < _ENCAPSULATION.size + 1:
        return None
    claimed, major, minor = _ENCAPSULATION.unpack_from(encapsulation)
    if claimed != len(encapsulation) or major != 1 or minor > 1:
        return None
    start = _ENCAPSULATION.size + 1
    size = encapsulation[start - 1]
    if size == 255:  # the size follows in four bytes
        start += 4
        size = int.from_bytes(encapsulation[start - 4:start], "little")
    return encapsulation[start:] if start + size == len(encapsulation) else None


def _close(opened: Any) -> None:
    if opened.exception() is None:
        opened.result().close(Ice.ConnectionClose.Forcefully)


def _left(deadline: float) -> float:
    return max(0.0, deadline - time.monotonic())


def _tls_settings(credentials: Credentials | None) -> dict[str, str]:
    """The settings for TLS, as in core/tendon/ice/tls.cpp. Ice reads the list of revoked
    certificates once, when it starts."""
    if credentials is None:
        return {}
    return {
        "Ice.Plugin.IceSSL": "IceSSL:createIceSSL",
        "IceSSL.Protocols": "TLS1_2, TLS1_3",
        "IceSSL.VerifyPeer": "2",
        "IceSSL.VerifyDepthMax": "2",
        "IceSSL.CAs": str(credentials.authority / "ca.crt"),
        "IceSSL.CertFile": str(credentials.certificate),
        "IceSSL.KeyFile": str(credentials.key),
        "IceSSL.RevocationCheck": "1",
        "IceSSL.CertificateRevocationListFiles": str(credentials.authority / "crl.pem"),
    }


def _why_not_started(why: Any, credentials: Credentials | None) -> Error:
    reason = str(getattr(why, "reason", why.ice_id())).strip()
    if credentials is None:
        return Failed(f"Ice does not start: {reason}")
    return Invalid(f"{credentials.certificate}, its key or the CA in {credentials.authority} "
                   f"cannot be used: {reason}")


def _shown_by(connection: Any) -> Shown | None:
    info = connection.getInfo()
    if not isinstance(info, Ice.SSLConnectionInfo):
        return None
    return holder_of(info.certs[0] if info.certs else "")


def _peer_of(connection: Any) -> str:
    """The address of the peer, in the form that the handshake uses."""
    info = connection.getInfo()
    while info.underlying is not None:
        info = info.underlying
    host = info.remoteAddress.removeprefix("::ffff:")  # an IPv4 address on an IPv6 socket
    return str(Address(host, info.remotePort))


def _why_not_opened(why: Any, address: Address, timeout: float,
                    credentials: Credentials | None) -> Error:
    if credentials is not None and isinstance(why, Ice.SecurityException):
        return Denied(f"{address} is not trusted: {why.reason.strip()}; the CA is in "
                      f"{credentials.authority}")
    if credentials is not None and isinstance(why, (Ice.ConnectionLostException,
                                                    Ice.ProtocolException)):
        return Unreachable(f"{address} does not accept {credentials.certificate}, or does not "
                           "use TLS: see the log of that program")
    if isinstance(why, Ice.TimeoutException):
        return TimedOut(f"no reply from {address} within {timeout * 1000:.0f} ms")
    if isinstance(why, Ice.SyscallException):
        reason = str(why).strip().rpartition("\n")[2]
        return Unreachable(f"nobody answers at {address} ({reason})")
    return Unreachable(f"no program of Tendon answers at {address} ({why.ice_id()})")
