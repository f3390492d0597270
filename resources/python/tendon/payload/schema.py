"""The type of a payload at run time; converts values to bytes and back.

A structure is a dict with a key for each field, an enum is the name of its value, a list is a list
(or bytes for uint8), a duration is a number of seconds, and None means no content.
`Schema.encode()` and `Schema.decode()` check everything: they raise Invalid with the mistake, and
allocate no more than the received bytes can fill.
"""

from __future__ import annotations

import math
import operator
import struct
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Callable

from ..errors import Error, Invalid, did_you_mean
from .cdr import Reader, Writer

NANOSECONDS = 1_000_000_000  # in a second
MAX_SECONDS = 1 << 31


class Mistake(Exception):
    """A value does not fit its type. `place` is the part of the value: ".position[3]"."""

    def __init__(self, what: str) -> None:
        super().__init__(what)
        self.what = what
        self.place = ""


class Schema:
    """A type; one of the classes below. Immutable."""

    minimum_size = 1
    """The fewest bytes a value takes in a body; at least 1."""

    @property
    def type_name(self) -> str:
        """A short name of the type for tables and errors: "arm.JointState", "float64[7]"."""
        raise NotImplementedError

    def text(self, indent: str = "") -> str:
        """The canonical text. It has exactly the properties that must be equal at both ends of a
        link."""
        return self.type_name

    def encode(self, value: Any) -> bytes:
        """The body of a value. An error names the place, what was expected and what was found:
        "position[3]: expected a number (rad), got string 'x'"."""
        writer = Writer()
        try:
            self.write(writer, value, "")
        except Mistake as mistake:
            place = mistake.place.removeprefix(".")
            raise Invalid(f"{place}: {mistake.what}" if place else mistake.what) from None
        return bytes(writer.body)

    def decode(self, body: bytes) -> Any:
        """The value of an untrusted body. Only padding may follow the value."""
        reader = Reader(body)
        try:
            value = self.read(reader)
        except Error as error:
            raise Invalid(
                f"these {len(body)} bytes are not a valid {self.type_name}: {error}") from None
        if not reader.at_end:
            raise Invalid(f"these {len(body)} bytes are not a valid {self.type_name}: there is "
                          "more data after the end of the value")
        return value

    def write(self, writer: Writer, value: Any, unit: str) -> None:
        """Appends a value, or raises Mistake. `unit` is the unit of the field that has the
        value."""
        raise NotImplementedError

    def read(self, reader: Reader) -> Any:
        """Reads the next value, or raises Invalid."""
        raise NotImplementedError


@dataclass(frozen=True)
class Number(Schema):
    """bool, an integer or a float; `kind` is its name in a schema's text."""

    kind: str

    @cached_property
    def letter(self) -> str:
        """The format character in the module struct."""
        return NUMBERS[self.kind]

    @cached_property
    def minimum_size(self) -> int:  # type: ignore[override]
        return struct.calcsize(self.letter)

    @property
    def type_name(self) -> str:
        return self.kind

    def write(self, writer: Writer, value: Any, unit: str) -> None:
        if self.kind == "bool":
            if not isinstance(value, bool):
                raise expected("True or False", unit, value)
            writer.numbers("B", value)
        elif self.kind.startswith("float"):
            self._write_real(writer, value, unit)
        else:
            self._write_integer(writer, value, unit)

    def _write_real(self, writer: Writer, value: Any, unit: str) -> None:
        if isinstance(value, (bool, str, bytes)) or not hasattr(value, "__float__"):
            raise expected("a number", unit, value)
        try:
            writer.numbers(self.letter, float(value))
        except OverflowError:
            raise expected(f"a number that {self.kind} can hold", unit, value) from None

    def _write_integer(self, writer: Writer, value: Any, unit: str) -> None:
        bits = 8 * self.minimum_size
        lowest = 0 if self.kind.startswith("u") else -(1 << (bits - 1))
        highest = lowest + (1 << bits) - 1
        is_integer = hasattr(value, "__index__") and not isinstance(value, bool)
        if not is_integer or not lowest <= operator.index(value) <= highest:
            raise expected(f"an integer from {lowest} to {highest}", unit, value)
        writer.numbers(self.letter, operator.index(value))

    def read(self, reader: Reader) -> Any:
        return self.read_many(reader, 1)[0]

    def read_many(self, reader: Reader, count: int) -> list[Any] | bytes:
        """Reads `count` values, one after the other."""
        if self.kind == "uint8":
            return reader.raw(count)
        values = reader.numbers(self.letter, count)
        if self.kind != "bool":
            return list(values)
        if any(value > 1 for value in values):
            raise Invalid("a bool other than 0 and 1")
        return [value == 1 for value in values]


@dataclass(frozen=True)
class String(Schema):
    """Text."""

    minimum_size = 5

    @property
    def type_name(self) -> str:
        return "string"

    def write(self, writer: Writer, value: Any, unit: str) -> None:
        if not isinstance(value, str):
            raise expected("a string", unit, value)
        if "\0" in value:  # DDS and ROS would cut the string there
            raise expected("a string without '\\0'", "", value)
        writer.string(value)

    def read(self, reader: Reader) -> str:
        return reader.string()


@dataclass(frozen=True)
class Duration(Schema):
    """A number of seconds; on the wire int32 seconds and uint32 nanoseconds."""

    minimum_size = 8

    @property
    def type_name(self) -> str:
        return "duration"

    def write(self, writer: Writer, value: Any, unit: str) -> None:
        is_number = isinstance(value, (int, float)) and not isinstance(value, bool)
        if not is_number or not math.isfinite(value) or abs(value) >= MAX_SECONDS:
            raise expected("a number of seconds, below 68 years", unit, value)
        seconds, nanoseconds = divmod(round(value * NANOSECONDS), NANOSECONDS)
        writer.numbers("i", seconds)
        writer.numbers("I", nanoseconds)

    def read(self, reader: Reader) -> float:
        seconds, nanoseconds = reader.number("i"), reader.number("I")
        if nanoseconds >= NANOSECONDS:
            raise Invalid("a duration's second of a billion nanoseconds")
        return (seconds * NANOSECONDS + nanoseconds) / NANOSECONDS


@dataclass(frozen=True)
class Enum(Schema):
    """An enum: some names, each with an int32."""

    name: str
    values: dict[str, int]

    minimum_size = 4

    @property
    def type_name(self) -> str:
        return self.name

    def text(self, indent: str = "") -> str:
        lines = [f"{indent}  {name} = {value}\n" for name, value in self.values.items()]
        return f"enum {self.name} {{\n{''.join(lines)}{indent}}}"

    def write(self, writer: Writer, value: Any, unit: str) -> None:
        if not isinstance(value, str) or value not in self.values:
            mistake = expected("one of " + ", ".join(map(repr, self.values)), "", value)
            if isinstance(value, str):
                mistake.what += did_you_mean(value, self.values)
            raise mistake
        writer.numbers("i", self.values[value])

    def read(self, reader: Reader) -> str | int:
        """The name of the value. A value without a name is returned as a number."""
        number = reader.number("i")
        return self._names.get(number, number)

    @cached_property
    def _names(self) -> dict[int, str]:
        return {value: name for name, value in self.values.items()}


@dataclass(frozen=True)
class List(Schema):
    """Several values of one type: an array of `length`, or a sequence if `length` is None."""

    element: Schema
    length: int | None = None

    @cached_property
    def minimum_size(self) -> int:  # type: ignore[override]
        return 4 if self.length is None else self.length * self.element.minimum_size

    @property
    def _suffix(self) -> str:
        return "[]" if self.length is None else f"[{self.length}]"

    @property
    def type_name(self) -> str:
        return self.element.type_name + self._suffix

    def text(self, indent: str = "") -> str:
        return self.element.text(indent) + self._suffix

    def write(self, writer: Writer, value: Any, unit: str) -> None:
        is_list = hasattr(value, "__len__") and not isinstance(value, (str, dict, set, frozenset))
        if not is_list or self.length not in (None, len(value)):
            many = "" if self.length is None else f"{self.length} "
            raise expected(f"a list of {many}{self.element.type_name}", unit, value)
        if self.length is None:
            writer.numbers("I", len(value))
        if isinstance(value, (bytes, bytearray)) and self.element == Number("uint8"):
            writer.raw(value)
            return
        for index, item in enumerate(value):
            inside(f"[{index}]", lambda one=item: self.element.write(writer, one, unit))

    def read(self, reader: Reader) -> list[Any] | bytes:
        count = self.length
        if count is None:
            count = reader.length(self.element.minimum_size)
        if isinstance(self.element, Number):
            return self.element.read_many(reader, count)
        return [self.element.read(reader) for _ in range(count)]


@dataclass(frozen=True)
class Field:
    """A field of a structure; `unit` is empty if it has none."""

    name: str
    schema: Schema
    unit: str = ""


@dataclass(frozen=True)
class Structure(Schema):
    """Named fields in order. Without fields, its only value is None."""

    name: str
    fields: tuple[Field, ...]

    @cached_property
    def minimum_size(self) -> int:  # type: ignore[override]
        return max(1, sum(field.schema.minimum_size for field in self.fields))

    @property
    def type_name(self) -> str:
        return self.name

    def text(self, indent: str = "") -> str:
        lines = [f"{indent}  {field.name}: {field.schema.text(indent + '  ')}"
                 f"{' in ' + field.unit if field.unit else ''}\n" for field in self.fields]
        return f"struct {self.name} {{\n{''.join(lines)}{indent}}}"

    def write(self, writer: Writer, value: Any, unit: str) -> None:
        if not self.fields:
            if value is not None and value != {}:
                raise expected("None", "", value)
            writer.raw(b"\0")
            return
        if not isinstance(value, dict):
            raise expected(f"a dict ({self.name})", unit, value)
        names = [field.name for field in self.fields]
        for key in value:
            if key not in names:
                raise Mistake(f"unknown key {key!r:.66}{did_you_mean(str(key), names)}")
        for field in self.fields:
            if field.name not in value:
                kind = field.schema.type_name + (f" in {field.unit}" if field.unit else "")
                raise Mistake(f"missing key '{field.name}' ({kind})")
            inside(f".{field.name}", lambda one=field: one.schema.write(
                writer, value[one.name], one.unit or unit))

    def read(self, reader: Reader) -> dict[str, Any] | None:
        if not self.fields:
            reader.raw(1)
            return None
        return {field.name: field.schema.read(reader) for field in self.fields}


# The format characters of the module struct, by the names of the types in a schema's text.
NUMBERS = {"bool": "B", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H", "int32": "i",
           "uint32": "I", "int64": "q", "uint64": "Q", "float32": "f", "float64": "d"}


def inside(step: str, write: Callable[[], None]) -> None:
    """Calls `write`. If it raises a Mistake, puts this step before the place of the mistake."""
    try:
        write()
    except Mistake as mistake:
        mistake.place = step + mistake.place
        raise


def expected(what: str, unit: str, value: Any) -> Mistake:
    """The mistake "expected `what` (unit), got `value`"."""
    if isinstance(value, str):
        found = f"string {value[:40]!r}"
    elif isinstance(value, dict):
        found = "a dict"
    elif isinstance(value, (list, tuple, bytes, bytearray)):
        found = f"a list of {len(value)}"
    elif isinstance(value, (int, float)) and not isinstance(value, bool):
        found = f"number {value!r:.40}"
    else:
        found = f"{value!r:.40}"
    return Mistake(f"expected {what}{f' ({unit})' if unit else ''}, got {found}")
