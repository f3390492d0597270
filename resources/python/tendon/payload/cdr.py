"""Writes and reads the primitives of CDR (XCDR1, little-endian). A number is aligned to its size,
counted from the start of the body. Padding is zero."""

from __future__ import annotations

import struct
from typing import Any

from ..errors import Invalid

MAX_ALIGNMENT = 8


class Writer:
    """Builds a body. Each function appends to it."""

    def __init__(self) -> None:
        self.body = bytearray()

    def numbers(self, letter: str, *values: Any) -> None:
        """Writes numbers of one kind. `letter` is their format character in the module struct.
        Raises struct.error or OverflowError if a number does not fit."""
        if not values:
            return
        packed = struct.pack(f"<{len(values)}{letter}", *values)
        self.body.extend(bytes(-len(self.body) % struct.calcsize(letter)))
        self.body.extend(packed)

    def raw(self, data: bytes) -> None:
        """Writes bytes as they are."""
        self.body.extend(data)

    def string(self, text: str) -> None:
        """Writes the length with the final zero, the characters as UTF-8, and the zero."""
        data = text.encode("utf-8", "surrogateescape") + b"\0"
        self.numbers("I", len(data))
        self.raw(data)


class Reader:
    """Reads from untrusted bytes; raises Invalid if there are too few."""

    def __init__(self, body: bytes) -> None:
        self._body = memoryview(body)
        self._position = 0

    def numbers(self, letter: str, count: int) -> tuple[Any, ...]:
        """Reads `count` numbers of one kind. Checks that there are enough bytes before it allocates
        memory."""
        if count == 0:
            return ()
        size = struct.calcsize(letter)
        start = self._take(count * size, size)
        return struct.unpack_from(f"<{count}{letter}", self._body, start)

    def number(self, letter: str) -> Any:
        """Reads one number."""
        return self.numbers(letter, 1)[0]

    def raw(self, size: int) -> bytes:
        """Reads bytes as they are."""
        start = self._take(size, 1)
        return bytes(self._body[start:start + size])

    def string(self) -> str:
        """Reads a string; bytes that are not UTF-8 become surrogates."""
        size = self.number("I")
        data = self.raw(size)
        if not data or data[-1] != 0:
            raise Invalid("a string without its end")
        return data[:-1].decode("utf-8", "surrogateescape")

    def length(self, minimum_size: int) -> int:
        """Reads the length of a sequence. Refuses it if the remaining bytes cannot hold so many
        elements of at least `minimum_size` bytes each."""
        length = self.number("I")
        if length > self.remaining // minimum_size:
            raise Invalid(f"a sequence of {length}, for which too few bytes follow")
        return length

    @property
    def remaining(self) -> int:
        """The number of bytes that were not read yet."""
        return len(self._body) - self._position

    @property
    def at_end(self) -> bool:
        """True if everything was read, apart from padding up to the next multiple of eight."""
        return len(self._body) <= self._position + -self._position % MAX_ALIGNMENT

    def _take(self, size: int, alignment: int) -> int:
        start = self._position + -self._position % alignment
        if size > len(self._body) - start:
            raise Invalid(f"{size} more bytes belong there")
        self._position = start + size
        return start
