"""Frames: a header of 24 bytes (little-endian, without padding), then a body."""

from __future__ import annotations

import struct
from typing import NamedTuple

from ..errors import Invalid

MAGIC = 0x4E444E54  # "TNDN"
PROTOCOL_VERSION = 11
HEADER_SIZE = 24
MAX_PIECE_SIZE = 256 << 10
"""The largest frame in bytes, header included. Larger frames are sent in parts."""
MAX_UNAUTHENTICATED_FRAME_SIZE = 64 << 10
"""The largest frame of a peer that is not authenticated yet."""
MAX_BODY_SIZE = (64 << 20) + (64 << 10)
"""The largest body of a frame that is sent in parts: the largest payload plus the other fields of
its message."""
MAX_REPLIES = 256
"""The largest number of replies in one message of type REPLIES."""
MAX_REPLIES_SIZE = (16 << 10) - HEADER_SIZE
"""The largest body of such a message, in bytes."""

_REPLY = struct.Struct("<QI")  # before each reply of a batch: request, size
_HEADER = struct.Struct("<IHHQII")


class Header(NamedTuple):
    """The header of a frame."""

    type: int
    request: int = 0  # 0: no reply is wanted
    handle: int = 0  # a number that the receiver gave, such as that of a subscription
    version: int = PROTOCOL_VERSION


def write_frame(header: Header, body: bytes) -> bytes:
    """A frame of this header and this body."""
    packed = _HEADER.pack(MAGIC, header.version, header.type, header.request, len(body),
                          header.handle)
    return packed + body


def claimed_size(begun: bytes, limit: int = MAX_PIECE_SIZE) -> int | None:
    """The size of the frame that begins with these bytes. None if they are not the beginning of a
    frame, or if it would have more than `limit` bytes."""
    if len(begun) < HEADER_SIZE:
        return None
    magic, _, _, _, size, _ = _HEADER.unpack_from(begun)
    whole = HEADER_SIZE + size
    return whole if magic == MAGIC and whole <= limit else None


def read_frame(frame: bytes, limit: int = MAX_PIECE_SIZE) -> tuple[Header, bytes] | None:
    """The header and the body of a frame. None if the frame does not have the size that it
    claims."""
    if claimed_size(frame, limit) != len(frame):
        return None
    _, version, type_number, request, _, handle = _HEADER.unpack_from(frame)
    return Header(type_number, request, handle, version), frame[HEADER_SIZE:]


def read_replies(body: bytes) -> list[tuple[int, bytes]]:
    """The replies in a message of type REPLIES: for each, the number of its request and its body.
    Raises Invalid if the body is malformed."""
    replies = []
    rest = memoryview(body)
    while rest and len(replies) < MAX_REPLIES:
        if len(rest) < _REPLY.size:
            break
        request, size = _REPLY.unpack_from(rest)
        if size > len(rest) - _REPLY.size:
            break
        replies.append((request, bytes(rest[_REPLY.size:_REPLY.size + size])))
        rest = rest[_REPLY.size + size:]
    if rest or not replies or len(body) > MAX_REPLIES_SIZE:
        raise Invalid("the body is not a batch of replies")
    return replies
