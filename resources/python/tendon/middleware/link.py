"""A link to one program of Tendon: requests with replies, and notices."""

from __future__ import annotations

import contextlib
import queue
import threading
import time
from concurrent.futures import Future
from concurrent.futures import TimeoutError as NoReply
from typing import Any, Callable, NamedTuple

from .. import messages
from ..errors import Error, Invalid, TimedOut, Unreachable
from ..messages import MessageType
from .address import Address
from .frame import (MAX_BODY_SIZE, MAX_PIECE_SIZE, PROTOCOL_VERSION, Header, read_replies,
                    write_frame)
from .handshake import Opener, loopback_cookie
from .ice import Network
from .parts import PartAssembly, PartSender

OnNotice = Callable[[Header, bytes], None]
OnReply = Callable[[bytes], Any]
OnClosed = Callable[[Error], None]

_STEPS = 4  # frames of a handshake, at most
_OF_HANDSHAKES = (MessageType.HELLO, MessageType.CHALLENGE, MessageType.PROOF, MessageType.WELCOME)


class Asked(NamedTuple):
    """A request that waits for its reply."""

    request: int
    reply: Future[Any]
    on_reply: OnReply | None


class Link:
    """One end of a link. The constructor opens the link, or raises the reason why it cannot. Under
    TLS, it also raises an error if the process at the address is not called `wanted`. Thread-safe.

    `on_notice` and `on_closed` are called in a thread of Ice and must not wait for anything.
    """

    def __init__(self, network: Network, address: Address, name: str, timeout: float,
                 on_notice: OnNotice | None = None, on_closed: OnClosed | None = None,
                 wanted: str = "") -> None:
        self._on_notice = on_notice
        self._on_closed = on_closed
        self._timeout = timeout
        self._lock = threading.Lock()
        self._last_request = 1  # the number of the handshake's request
        self._pending: dict[int, Asked] = {}
        self._greeting: queue.Queue[tuple[Header, bytes] | None] | None
        self._greeting = queue.Queue(_STEPS)
        self._is_known = False  # True after the peer has proved its identity
        self._reason: Error | None = None  # why the link is closed
        self._assembly = PartAssembly()  # used only in the thread of Ice
        self._parts = PartSender(self._send_piece)
        self.peer_name = str(address)  # until the peer sends its name
        deadline = time.monotonic() + timeout
        cookie = 0 if network.is_encrypted else loopback_cookie()
        self._link = network.open(address, self._on_frame, self._closed, timeout)
        opener = Opener(name, self._link.peer_address, cookie, self._link.shown, wanted)
        try:
            self._greet(opener, deadline)
        except Error:
            self._link.close()
            raise
        self.peer_name = opener.peer["name"]
        self.peer_instance: int = opener.peer["instance"]

    @property
    def is_open(self) -> bool:
        """False after the link was closed or was found to be lost."""
        return self._reason is None

    def close(self) -> None:
        """Closes the link; waiting requests fail."""
        self._end(Unreachable("the connection was closed by this program"))

    def notify(self, message_type: MessageType, handle: int) -> None:
        """Sends a notice without a body."""
        self._send(Header(message_type, 0, handle), b"")

    def start(self, message_type: MessageType, body: bytes, on_reply: OnReply | None) -> Asked:
        """Sends a request. `on_reply` converts the reply. A thread of Ice calls it before it
        handles the next message of the peer."""
        with self._lock:
            if self._reason is not None:
                raise self._reason
            self._last_request += 1
            asked = Asked(self._last_request, Future(), on_reply)
            self._pending[asked.request] = asked
        try:
            self._send(Header(message_type, asked.request), body)
        except Error:
            self._give_up(asked)
            raise
        return asked

    def request(self, message_type: MessageType, body: bytes, timeout: float,
                on_reply: OnReply | None = None) -> Any:
        """Sends a request and waits for its reply; raises the peer's reason if it refuses."""
        asked = self.start(message_type, body, on_reply)
        try:
            return asked.reply.result(timeout)
        except NoReply:
            self._give_up(asked)
            raise TimedOut(f"{self.peer_name} did not answer within {timeout * 1000:.0f} ms; "
                           "outcome unknown") from None

    def _greet(self, opener: Opener, deadline: float) -> None:
        incoming = self._greeting
        assert incoming is not None
        reply = opener.greet()
        while True:
            if reply is not None:
                if reply.type == MessageType.PROOF:
                    self._link.admit()
                    self._is_known = True
                self._send(Header(reply.type, 1), reply.body)
            if opener.is_welcome:
                return
            try:
                frame = incoming.get(timeout=max(0.0, deadline - time.monotonic()))
            except queue.Empty:
                raise TimedOut(f"{self._link.peer_address} accepted the connection but did not "
                               "answer in time: check that a program of Tendon listens "
                               "at this address") from None
            if frame is None:
                raise self._reason or Unreachable(f"{self._link.peer_address} is not connected")
            reply = opener.take(*frame)

    def _send(self, header: Header, body: bytes) -> None:
        if len(body) > MAX_BODY_SIZE:
            raise Invalid(f"a message of {len(body)} bytes is too large: at most "
                          f"{MAX_BODY_SIZE} bytes can be sent")
        frame = write_frame(header, body)
        if len(frame) <= MAX_PIECE_SIZE:
            self._send_piece(frame)
            return
        try:
            self._parts.send(frame, self._timeout)
        except TimedOut:
            self.close()
            raise

    def _send_piece(self, frame: bytes) -> None:
        try:
            self._link.send(frame)
        except Unreachable as why:
            self._end(why)  # do not wait until the thread of Ice notices the lost connection
            raise

    def _end(self, reason: Error) -> None:
        with self._lock:
            self._reason = self._reason or reason
        self._link.close()

    def _on_frame(self, header: Header, body: bytes) -> None:
        """Called in a thread of Ice."""
        try:
            if self._greeting is None:
                self._on_message(header, body)
                return
            self._greeting.put_nowait((header, body))
            if self._is_known and header.type == MessageType.WELCOME:
                self._greeting = None  # the handshake is complete
        except (Invalid, queue.Full):
            self._link.close()

    def _on_message(self, header: Header, body: bytes) -> None:
        """Handles a message after the handshake. Raises Invalid if the peer may not send it."""
        if header.version != PROTOCOL_VERSION or header.type in _OF_HANDSHAKES:
            raise Invalid(f"{self.peer_name} said Hello twice, or speaks another protocol")
        if header.type == MessageType.PART:
            self._on_part(header, body)
        elif header.type == MessageType.PARTS_TAKEN:
            self._parts.on_taken(body)
        elif header.type == MessageType.REPLY:
            self._finish(header.request, body, None)
        elif header.type == MessageType.REPLIES:
            for request, reply in read_replies(body):
                self._finish(request, reply, None)
        elif header.type == MessageType.REFUSAL:
            self._finish(header.request, body, messages.read_refusal(body, self.peer_name))
        elif header.request == 0 and self._on_notice is not None:
            self._on_notice(header, body)

    def _on_part(self, header: Header, body: bytes) -> None:
        whole = self._assembly.add(header.handle, body)
        taken = messages.encode("PartsTaken", self._assembly.taken)
        self._link.post(write_frame(Header(MessageType.PARTS_TAKEN), taken))
        if whole is None:
            return
        if whole[0].type in (MessageType.PART, MessageType.PARTS_TAKEN):
            raise Invalid(f"{self.peer_name} sent parts that are not a valid message")
        self._on_message(*whole)

    def _finish(self, request: int, body: bytes, refusal: Error | None) -> None:
        with self._lock:
            asked = self._pending.pop(request, None)
        if asked is None:
            return  # the reply came too late
        try:
            if refusal is not None:
                raise refusal
            asked.reply.set_result(asked.on_reply(body) if asked.on_reply else body)
        except Exception as why:  # passed on to the thread that waits for the reply
            asked.reply.set_exception(why)

    def _give_up(self, asked: Asked) -> None:
        with self._lock:
            self._pending.pop(asked.request, None)

    def _closed(self, reason: Error) -> None:
        """Called in a thread of Ice."""
        with self._lock:
            reason = self._reason = self._reason or reason
            pending = list(self._pending.values())
            self._pending.clear()
            greeting = self._greeting
        if greeting is not None:
            with contextlib.suppress(queue.Full):  # then _greet() does not wait anyway
                greeting.put_nowait(None)
        self._parts.close(reason)
        for asked in pending:
            asked.reply.set_exception(
                Unreachable(f"{self.peer_name} did not answer: {reason}; outcome unknown"))
        if self._on_closed is not None:
            self._on_closed(reason)


def reading(name: str) -> OnReply:
    """Returns a function that decodes a reply as the message `name`."""
    def read(body: bytes) -> Any:
        return messages.decode(name, body)
    return read
