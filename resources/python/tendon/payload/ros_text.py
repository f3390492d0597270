"""Reads the definition of a ROS 2 message, which is untrusted, as a schema.

Behind it are the definitions of nested messages, as in MCAP files. A time and a duration become a
duration; bounds, default values and constants are left out.
"""

from __future__ import annotations

import re

from ..errors import Invalid
from .schema import NUMBERS, Duration, Field, List, Number, Schema, String, Structure
from .schema_text import MAX_DEPTH, MAX_TEXT, parse

_RULE = re.compile(r"^===.*\n\s*MSG:\s*(\S+).*$", re.MULTILINE)
_FIELD = re.compile(r"(?P<type>\S+)\s+(?P<name>[^\s=#]+)\s*(?P<constant>=)?")
_TYPE = re.compile(r"(?P<item>[^\[<]+)(<=\d+)?(?P<list>\[(<=\d+|(?P<length>\d{1,10}))?\])?",
                   re.ASCII)
_LINE = 32  # bytes of a line of a schema's text, about

_TIMES = ("time", "duration", "builtin_interfaces/Time", "builtin_interfaces/Duration")


def parse_message(name: str, text: str) -> Schema:
    """The schema of the message `name`, "arm/msg/JointState". The error names the message."""
    if len(text) > MAX_TEXT:
        raise Invalid(f"the message definition has {len(text)} letters of text; at most {MAX_TEXT} "
                      "are read")
    schema, _ = _Messages(_short(name), text.replace("\r", "")).message(_short(name), 0)
    return parse(schema.text())  # checks names and limits


def _short(name: str) -> str:
    return name.replace("/msg/", "/", 1)


class _Messages:
    """The definitions of some messages, by their names."""

    def __init__(self, root: str, text: str) -> None:
        pieces = _RULE.split(text)
        self._texts = {root: pieces[0]} if root else {}
        for other, definition in zip(pieces[1::2], pieces[2::2]):
            self._texts.setdefault(_short(other), definition)
        self._known: dict[str, tuple[Schema, int]] = {}
        self._open: set[str] = set()

    def message(self, name: str, level: int) -> tuple[Schema, int]:
        """The schema, and about the size of its text."""
        if name in self._known:
            return self._known[name]
        if name not in self._texts:
            raise _mistake(name, "the definition is missing")
        if level == MAX_DEPTH:
            raise _mistake(name, f"more than {MAX_DEPTH} levels")
        if name in self._open:
            raise _mistake(name, "the message contains itself")
        self._open.add(name)
        fields: list[Field] = []
        size = 0
        for line in map(str.strip, self._texts[name].split("\n")):
            if not line or line.startswith("#"):
                continue
            found = _FIELD.match(line)
            if not found:
                raise _mistake(name, f"'{line[:100]}' is no field")
            if found["constant"]:
                continue
            schema, inner = self._type(name, found["type"], level)
            size += len(found["name"]) + _LINE + inner
            if size > MAX_TEXT:
                raise _mistake(name, "the type has more than 1 MiB of text")
            fields.append(Field(found["name"], schema))
        self._open.remove(name)
        self._known[name] = Structure(name.replace("/", "."), tuple(fields)), size
        return self._known[name]

    def _type(self, owner: str, text: str, level: int) -> tuple[Schema, int]:
        found = _TYPE.fullmatch(text)
        if not found:
            raise _mistake(owner, f"'{text[:100]}' is no type")
        item, size = self._item(owner, _short(found["item"]), level)
        if not found["list"]:
            return item, size
        return List(item, int(found["length"]) if found["length"] else None), size

    def _item(self, owner: str, name: str, level: int) -> tuple[Schema, int]:
        if name in ("byte", "char"):
            return Number("uint8"), 0
        if name in NUMBERS:
            return Number(name), 0
        if name == "string":
            return String(), 0
        if name in _TIMES:
            return Duration(), 0
        if name == "wstring":
            raise _mistake(owner, "wstring is not read, because its encoding differs between "
                                  "programs")
        full = self._resolve(owner, name)
        if full is None:
            raise _mistake(owner, f"the definition of '{name[:100]}' is missing")
        return self.message(full, level + 1)

    def _resolve(self, owner: str, name: str) -> str | None:
        """A name without a package is of the same package, or the only one of this name."""
        if name in self._texts:
            return name
        if "/" in name:
            return None
        sibling = f"{owner.partition('/')[0]}/{name}"
        if sibling in self._texts:
            return sibling
        others = [one for one in self._texts if one.endswith(f"/{name}")]
        return others[0] if len(others) == 1 else None


def _mistake(message: str, what: str) -> Invalid:
    return Invalid(f"message '{message[:100]}': {what}")
