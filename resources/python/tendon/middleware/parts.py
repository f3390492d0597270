"""Frames that are too large for one piece are sent in parts: frames of type PART, between which
other frames may pass. Each end reports to the other how many bytes of parts it has received, so
that only a limited number of bytes is on the way."""

from __future__ import annotations

import threading
import time
from typing import Callable

from .. import messages
from ..errors import Error, Invalid, TimedOut
from ..messages import MessageType
from .frame import (HEADER_SIZE, MAX_BODY_SIZE, MAX_PIECE_SIZE, Header, claimed_size, read_frame,
                    write_frame)

MAX_PART_SIZE = MAX_PIECE_SIZE - HEADER_SIZE
LEAST_PART_SIZE = (16 << 10) - HEADER_SIZE
"""The smallest size of a part, except for the last part of a frame."""
PART_SIZE = 2 * LEAST_PART_SIZE
"""The size of the parts that are sent. It is small, because each part is a sign of life and must
not take long on a slow line."""
PARTS_AHEAD = 1 << 20
"""The maximum number of sent bytes that the peer has not acknowledged."""
MAX_CLAIMED = HEADER_SIZE + MAX_BODY_SIZE + (8 << 20)
"""The limit of the total size of a peer's unfinished frames: one of the largest size, and 8 MiB of
others."""


class PartAssembly:
    """Assembles the frames that a peer sends in parts. Keeps no more bytes than the frames claim.
    Not thread-safe."""

    def __init__(self) -> None:
        self.taken = 0
        """The number of bytes of parts that were received."""
        self._begun: dict[int, tuple[int, bytearray]] = {}

    def add(self, number: int, part: bytes) -> tuple[Header, bytes] | None:
        """Adds a part. Returns the frame if the part completes it, otherwise None. `number` tells
        apart frames that arrive at the same time. Raises Invalid if the part belongs to no
        frame."""
        if number not in self._begun:
            size = claimed_size(part, HEADER_SIZE + MAX_BODY_SIZE)
            claimed = sum(one for one, _ in self._begun.values())
            if size is None or size > MAX_CLAIMED - claimed:
                raise Invalid("the peer sent parts that are not a valid message")
            self._begun[number] = (size, bytearray())
        size, begun = self._begun[number]
        left = size - len(begun)
        if not min(LEAST_PART_SIZE, left) <= len(part) <= min(MAX_PART_SIZE, left):
            raise Invalid("the peer sent parts that are not a valid message")
        self.taken += len(part)
        begun += part
        if len(begun) < size:
            return None
        del self._begun[number]
        return read_frame(bytes(begun), HEADER_SIZE + MAX_BODY_SIZE)


class PartSender:
    """Sends large frames in parts, one frame after the other. Thread-safe."""

    def __init__(self, send: Callable[[bytes], None]) -> None:
        self._send = send
        self._turn = threading.Lock()
        self._changed = threading.Condition()
        self._last_number = 0
        self._sent = 0
        self._taken = 0
        self._reason: Error | None = None  # why the link is closed

    def send(self, frame: bytes, timeout: float) -> None:
        """Sends one frame in parts. Waits for a slow peer for at most `timeout` seconds in total,
        then raises TimedOut. The caller must then close the link, because the peer has only a part
        of the frame."""
        deadline = time.monotonic() + timeout
        with self._turn:
            self._last_number += 1
            for start in range(0, len(frame), PART_SIZE):
                self._wait_for_room(deadline)
                part = frame[start:start + PART_SIZE]
                with self._changed:
                    self._sent += len(part)  # before the peer can acknowledge the part
                header = Header(MessageType.PART, 0, self._last_number)
                self._send(write_frame(header, part))

    def on_taken(self, body: bytes) -> None:
        """Called in a thread of Ice with the body of PARTS_TAKEN. Raises Invalid if the number is
        impossible."""
        taken = messages.decode("PartsTaken", body)
        with self._changed:
            if not self._taken <= taken <= self._sent:
                raise Invalid("the peer acknowledged more than was sent to it")
            self._taken = taken
            self._changed.notify_all()

    def close(self, reason: Error) -> None:
        """Makes waiting and later calls of send() raise the reason."""
        with self._changed:
            self._reason = reason
            self._changed.notify_all()

    def _wait_for_room(self, deadline: float) -> None:
        with self._changed:
            has_room = self._changed.wait_for(
                lambda: self._reason is not None or self._sent - self._taken < PARTS_AHEAD,
                max(0.0, deadline - time.monotonic()))
            if self._reason is not None:
                raise self._reason
            if not has_room:
                raise TimedOut("the peer reads too slowly: it does not accept more of a "
                               "large message")
