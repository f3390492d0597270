"""The numbers of the messages, and the schemas of their bodies. The schemas are in messages.txt, as
the C++ code prints them; a test compares the file with the output of the C++ code."""

from __future__ import annotations

import enum
from pathlib import Path
from typing import Any

from .errors import Error, Failed, Invalid, error_of
from .payload.schema import Number, Schema, Structure
from .payload.schema_text import parse_all


class MessageType(enum.IntEnum):
    """The messages of the protocol that a viewer sends or receives."""

    HELLO = 1
    WELCOME = 2
    REPLY = 3
    REFUSAL = 4
    CHALLENGE = 5
    PROOF = 6
    PART = 7
    PARTS_TAKEN = 8
    REPLIES = 9
    # Messages to a process.
    GET_SCHEMAS = 0x200
    CALL_MEMBER = 0x201
    SUBSCRIBE = 0x202
    UNSUBSCRIBE = 0x203
    # Messages from a process.
    ROWS = 0x204
    ROWS_ENDED = 0x205
    # Messages to a GCM.
    RENEW = 0x302
    WATCH = 0x310
    CONNECT = 0x311
    DISCONNECT = 0x312
    # Messages from a GCM.
    CHANGES = 0x320


SCHEMAS: dict[str, Schema] = {
    **parse_all(Path(__file__).with_name("messages.txt").read_text(encoding="utf-8")),
    "tendon.None": Structure("tendon.None", ()),
    "tendon.PartsTaken": Number("uint64"),
}


def encode(name: str, value: Any = None) -> bytes:
    """The body of a message, as in encode("ConnectionEnds", {...})."""
    return SCHEMAS[f"tendon.{name}"].encode(value)


def decode(name: str, body: bytes) -> Any:
    """Decodes the untrusted body of a message."""
    return SCHEMAS[f"tendon.{name}"].decode(body)


def read_refusal(body: bytes, peer: str) -> Error:
    """The exception for the body of a refusal."""
    try:
        refused = decode("Error", body)
    except Invalid:
        return Failed(f"{peer} refused the request, but the reason that it sent cannot be read")
    return error_of(str(refused["code"]), refused["message"])
