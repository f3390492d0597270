"""Reads the canonical text of schemas. The text is untrusted.

    struct arm.JointState {
      position: float64[7] in rad
      mode: enum arm.Mode {
        off = 0
      }
    }
"""

from __future__ import annotations

import re

from ..errors import Invalid
from .schema import NUMBERS, Duration, Enum, Field, List, Number, Schema, String, Structure

MAX_TEXT = 1 << 20
MAX_VALUE = 1 << 31  # bytes
MAX_DEPTH = 64

_SPACE = re.compile(r"[ \n]*")
_WORD = re.compile(r"[A-Za-z0-9_.]*")
_NUMBER = re.compile(r"-?[0-9]{1,10}(?![0-9])")
_LINE = re.compile(r"[^\n]*")
_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_TYPE_NAME = re.compile(r"[A-Za-z_]\w*(\.[A-Za-z_]\w*)*", re.ASCII)


def parse(text: str) -> Schema:
    """The schema of a text. An error names the line and the column."""
    parser = _Parser(text)
    schema, _ = parser.type(1)
    parser.end()
    return schema


def parse_all(text: str) -> dict[str, Structure]:
    """The structures of a text with several structures, by their names."""
    parser = _Parser(text)
    found: dict[str, Structure] = {}
    while not parser.is_at_end():
        schema, _ = parser.type(1)
        if not isinstance(schema, Structure):
            raise parser.mistake("expected a structure")
        found[schema.name] = schema
    return found


class _Parser:
    """A recursive-descent parser. The functions that read a type also return its depth."""

    def __init__(self, text: str) -> None:
        if len(text) > MAX_TEXT:
            raise Invalid(f"schema: {len(text)} letters of text; at most {MAX_TEXT} are read")
        self._text = text
        self._position = 0

    def type(self, depth: int) -> tuple[Schema, int]:
        """Reads a type with its suffixes, as in "float64[7]"."""
        if depth > MAX_DEPTH:
            raise self.mistake(f"more than {MAX_DEPTH} levels")
        word = self._word()
        height = 1
        schema: Schema
        if word == "struct":
            schema, height = self._structure(depth)
        elif word == "enum":
            schema = self._enum()
        elif word == "string":
            schema = String()
        elif word == "duration":
            schema = Duration()
        elif word in NUMBERS:
            schema = Number(word)
        else:
            self._position -= len(word)
            raise self.mistake("expected a type")
        while self._accept("["):
            height += 1
            if depth + height > MAX_DEPTH + 1:
                raise self.mistake(f"more than {MAX_DEPTH} levels")
            schema = self._list(schema)
        return schema, height

    def is_at_end(self) -> bool:
        """True if only spaces and line ends follow."""
        self._match(_SPACE)
        return self._position == len(self._text)

    def end(self) -> None:
        """Raises Invalid if anything but spaces and line ends follows."""
        if not self.is_at_end():
            raise self.mistake("expected the end")

    def mistake(self, what: str) -> Invalid:
        """An error with the current line and column."""
        before = self._text[:self._position]
        column = len(before) - (before.rfind("\n") + 1) + 1
        return Invalid(f"schema line {before.count(chr(10)) + 1} column {column}: {what}")

    def _list(self, element: Schema) -> List:
        """Reads the rest after '[': a length for an array, nothing for a sequence."""
        if self._accept("]"):
            return List(element)
        length = self._number(0, (1 << 32) - 1)
        self._expect("]")
        if length == 0:
            raise self.mistake("an array has at least one element")
        if length > MAX_VALUE // element.minimum_size:
            raise self.mistake("values of over 2 GiB")
        return List(element, length)

    def _structure(self, depth: int) -> tuple[Structure, int]:
        name = self._name(_TYPE_NAME, "a type's name, like arm.JointState")
        fields: dict[str, Field] = {}
        height = size = 0
        self._expect("{")
        while not self._accept("}"):
            while self._accept("#") or self._accept("@"):  # skips help texts and ranges
                self._match(_LINE)
            field = self._name(_IDENTIFIER, "a field's name or '}'")
            if field in fields:
                raise self.mistake("a second field of this name")
            self._expect(":")
            schema, its_height = self.type(depth + 1)
            fields[field] = Field(field, schema, self._unit())
            height = max(height, its_height)
            size += schema.minimum_size
            if size > MAX_VALUE:
                raise self.mistake("values of over 2 GiB")
        return Structure(name, tuple(fields.values())), height + 1

    def _enum(self) -> Enum:
        name = self._name(_TYPE_NAME, "a type's name, like arm.Mode")
        values: dict[str, int] = {}
        taken: set[int] = set()
        self._expect("{")
        while not self._accept("}"):
            enumerator = self._name(_IDENTIFIER, "an enumerator's name or '}'")
            self._expect("=")
            value = self._number(-(1 << 31), (1 << 31) - 1)
            if enumerator in values or value in taken:
                raise self.mistake("a second enumerator of this name or value")
            taken.add(value)
            values[enumerator] = value
        if not values:
            raise self.mistake("an enum has at least one enumerator")
        return Enum(name, values)

    def _unit(self) -> str:
        """Reads the unit of a field up to the end of the line: "rad" of " in rad", or nothing."""
        if not self._text.startswith(" in ", self._position):
            return ""
        self._position += len(" in ")
        unit = self._match(_LINE)
        if not unit or not unit.isprintable() or unit != unit.strip(" "):
            raise self.mistake("expected a unit")
        return unit

    def _name(self, pattern: re.Pattern[str], what: str) -> str:
        name = self._word()
        if not pattern.fullmatch(name):
            self._position -= len(name)
            raise self.mistake(f"expected {what}")
        return name

    def _number(self, lowest: int, highest: int) -> int:
        self._match(_SPACE)
        digits = self._match(_NUMBER)
        if not digits or not lowest <= int(digits) <= highest:
            raise self.mistake("expected a number of 32 bits")
        return int(digits)

    def _word(self) -> str:
        self._match(_SPACE)
        return self._match(_WORD)

    def _expect(self, wanted: str) -> None:
        if not self._accept(wanted):
            self._match(_SPACE)
            raise self.mistake(f"expected '{wanted}'")

    def _accept(self, wanted: str) -> bool:
        """Skips spaces. If this letter follows, skips it and returns True."""
        before = self._position
        self._match(_SPACE)
        if self._text.startswith(wanted, self._position):
            self._position += 1
            return True
        self._position = before
        return False

    def _match(self, pattern: re.Pattern[str]) -> str:
        found = pattern.match(self._text, self._position)
        if found is None:
            return ""
        self._position = found.end()
        return found.group()
