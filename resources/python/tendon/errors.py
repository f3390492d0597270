"""The exceptions of this package. The text of each is one sentence. It says what failed, where, and
what to do next."""

from __future__ import annotations

import difflib
from typing import Iterable


class Error(Exception):
    """The reason why a request was refused. Most errors are of one of the classes below."""

    code = "FAILED"

    def __init__(self, message: str) -> None:
        super().__init__(message)
        self.message = message


class Failed(Error):
    """The operation was refused or failed."""


class Invalid(Error):
    """An argument, an address, a path or a message is malformed."""

    code = "INVALID"


class Unreachable(Error):
    """No program answers at an address, or it does not answer any more."""

    code = "UNREACHABLE"


class NotFound(Error):
    """There is no process, component, interface, member or field of this name."""

    code = "NOT_FOUND"


class Exists(Error):
    """The name is taken, or the required interface is connected already."""

    code = "EXISTS"


class Incompatible(Error):
    """Two interfaces, types or protocol versions do not fit each other."""

    code = "INCOMPATIBLE"


class TimedOut(Error):
    """There was no reply in time. It is unknown whether the request was executed."""

    code = "TIMEOUT"


class Denied(Error):
    """The caller does not have the right to do this."""

    code = "DENIED"


_CLASSES = (Failed, Invalid, Unreachable, NotFound, Exists, Incompatible, TimedOut, Denied)
_BY_CODE = {one.code: one for one in _CLASSES}


def error_of(code: str, message: str) -> Error:
    """The exception for a code of tendon.ErrorCode; Failed for an unknown code."""
    return _BY_CODE.get(code, Failed)(message)


def did_you_mean(name: str, candidates: Iterable[str]) -> str:
    """The end of an error: "; did you mean 'arm'?". Empty if no name is similar."""
    near = difflib.get_close_matches(name, list(candidates), n=1)
    return f"; did you mean '{near[0]}'?" if near else ""
