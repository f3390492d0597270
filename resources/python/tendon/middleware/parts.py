"""Frames that are too large for one piece travel in parts, which are frames of type PART, beside
others; each end tells the other how many bytes of parts it has taken, so that no more than a
little is on its way."""

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
"""Of every part of a frame but the last."""
PART_SIZE = 2 * LEAST_PART_SIZE
"""Of those that are sent: on a slow line, too, one does not take long, and each is a sign of life."""
PARTS_AHEAD = 1 << 20
"""So many bytes may be on their way that the peer has not taken."""
MAX_CLAIMED = HEADER_SIZE + MAX_BODY_SIZE + (8 << 20)
"""What a peer may have on its way: one huge frame, and a window of others."""


class PartAssembly:
    """Puts together what a peer sends in parts. No more is kept than frames claim. Not
    thread-safe."""

    def __init__(self) -> None:
        self.taken = 0
        """Bytes that have come."""
        self._begun: dict[int, tuple[int, bytearray]] = {}

    def add(self, number: int, part: bytes) -> tuple[Header, bytes] | None:
        """The frame that this part makes whole, or None; `number` tells frames apart that come at
        one time. Raises Invalid where it is part of none."""
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
        """Waits for a peer that takes no more, at most `timeout` seconds in all. Where that did not
        suffice the link must be closed: the peer has a part of the frame."""
        deadline = time.monotonic() + timeout
        with self._turn:
            self._last_number += 1
            for start in range(0, len(frame), PART_SIZE):
                self._wait_for_room(deadline)
                part = frame[start:start + PART_SIZE]
                with self._changed:
                    self._sent += len(part)  # before the peer can have taken it
                header = Header(MessageType.PART, 0, self._last_number)
                self._send(write_frame(header, part))

    def on_taken(self, body: bytes) -> None:
        """In a thread of Ice: the body of PARTS_TAKEN. Raises Invalid where it cannot be."""
        taken = messages.decode("PartsTaken", body)
        with self._changed:
            if not self._taken <= taken <= self._sent:
                raise Invalid("the peer acknowledged more than was sent to it")
            self._taken = taken
            self._changed.notify_all()

    def close(self, reason: Error) -> None:
        """Whoever waits hears the reason."""
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
                raise TimedOut("the peer does not keep up: it takes no more of a large message")
