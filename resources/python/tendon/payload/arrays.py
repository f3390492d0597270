"""Decodes many values of one type into an array of numpy.

Numbers keep their types. A structure becomes a structured array, an enum int32, and a duration
timedelta64[ns], which is exact. An array of n numbers adds an axis of length n. Values that contain
text or a sequence differ in size; they become an array of Python objects.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Sequence

import numpy as np

from ..errors import Invalid, NotFound, did_you_mean
from ..paths import select, steps_of
from .schema import NANOSECONDS, NUMBERS, Duration, Enum, Field, List, Number, Schema, Structure

MOST_PIECES = 10_000
"""The most parts (numbers or arrays of numbers) of a value for which each part is copied
separately. Types with more parts are decoded like types of variable size."""

_OF_LETTER = {"B": "u1", "b": "i1", "h": "i2", "H": "u2", "i": "i4", "I": "u4", "q": "i8",
              "Q": "u8", "f": "f4", "d": "f8"}


class Shape(NamedTuple):
    """The numpy type of one value, and the axes that the value adds to an array."""

    dtype: np.dtype[Any]
    axes: tuple[int, ...] = ()


class Part(NamedTuple):
    """A part of a type, such as ".position[3]"."""

    schema: Schema
    unit: str
    start: int | None
    """The position of the part in a body, before alignment. None if it differs from value to
    value."""


def part_of(schema: Schema, field: str, unit: str = "") -> Part:
    """The part at `field`; the whole type if that is empty."""
    part = Part(schema, unit, 0)
    for step in steps_of(field):
        part = _inside(part, step)
    return part


def shape_of(schema: Schema) -> Shape | None:
    """The numpy type of a schema. None if its values differ in size, or have no content."""
    if isinstance(schema, Number):
        return Shape(np.dtype("?" if schema.kind == "bool" else _OF_LETTER[NUMBERS[schema.kind]]))
    if isinstance(schema, Enum):
        return Shape(np.dtype("i4"))
    if isinstance(schema, Duration):
        return Shape(np.dtype("m8[ns]"))
    if isinstance(schema, List) and schema.length is not None:
        element = shape_of(schema.element)
        return element and Shape(element.dtype, (schema.length, *element.axes))
    if isinstance(schema, Structure) and schema.fields:
        shapes = [shape_of(field.schema) for field in schema.fields]
        fields = [(field.name, shape.dtype, shape.axes)
                  for field, shape in zip(schema.fields, shapes) if shape is not None]
        return Shape(np.dtype(fields)) if len(fields) == len(shapes) else None
    return None


def leaves_of(schema: Schema, unit: str = "", prefix: str = "") -> list[tuple[str, str]]:
    """All fields except for structures, each with its unit: [(".position", "rad"), ...]."""
    if not isinstance(schema, Structure) or not schema.fields:
        return [(prefix, unit)]
    return [leaf for field in schema.fields
            for leaf in leaves_of(field.schema, field.unit or unit, f"{prefix}.{field.name}")]


def is_vectorised(schema: Schema, field: str) -> bool:
    """True if decode_fixed() can decode this part. It takes about 10 ns for each number."""
    part = part_of(schema, field)
    return part.start is not None and shape_of(part.schema) is not None \
        and _pieces(part.schema) <= MOST_PIECES


def decode_fixed(bodies: np.ndarray[Any, Any], schema: Schema, field: str) -> np.ndarray[Any, Any]:
    """The part at `field` of many values. The bodies are the rows of an array of bytes, and have at
    least fixed_end() bytes. is_vectorised() must be true for the part."""
    part = part_of(schema, field)
    shape = shape_of(part.schema)
    assert part.start is not None and shape is not None
    values = np.empty((len(bodies), *shape.axes), shape.dtype)
    _fill(values, bodies, part.schema, part.start)
    return values


def decode_each(bodies: Sequence[bytes], schema: Schema, field: str) -> np.ndarray[Any, Any]:
    """Like decode_fixed(), for bodies of any size. Takes some microseconds for each value."""
    part = part_of(schema, field)
    shape = shape_of(part.schema)
    if shape is None:
        values = np.empty(len(bodies), object)
    elif any(len(body) < schema.minimum_size for body in bodies):
        raise Invalid(f"a value is too short for {schema.type_name}")
    else:
        values = np.empty((len(bodies), *shape.axes), shape.dtype)
    for index, body in enumerate(bodies):
        try:
            value = select(schema.decode(body), field)
        except NotFound as why:  # the sequence of this row is too short
            raise NotFound(f"row {index}: {why}") from None
        if shape is None:
            values[index] = value
        else:
            _store(values, index, part.schema, value)
    return values


def fixed_end(schema: Schema, start: int = 0) -> int | None:
    """The end of a value in a body if the value begins at `start`. None if the end differs from
    value to value."""
    if isinstance(schema, (Number, Enum)):
        return _aligned(start, schema.minimum_size) + schema.minimum_size
    if isinstance(schema, Duration):
        return _aligned(start, 4) + schema.minimum_size
    if isinstance(schema, List) and schema.length is not None:
        if isinstance(schema.element, Number):
            size = schema.element.minimum_size
            return _aligned(start, size) + schema.length * size
        if _pieces(schema) > MOST_PIECES:
            return None
        return _end_of_all([schema.element] * schema.length, start)
    if isinstance(schema, Structure):
        return _end_of_all([field.schema for field in schema.fields], start + (not schema.fields))
    return None


def _end_of_all(schemas: Sequence[Schema], start: int) -> int | None:
    end: int | None = start
    for schema in schemas:
        end = fixed_end(schema, end)
        if end is None:
            return None
    return end


def _inside(part: Part, step: str | int) -> Part:
    schema, unit, start = part
    if isinstance(step, int):
        if not isinstance(schema, List) or (schema.length is not None and step >= schema.length):
            raise NotFound(f"there is no element [{step}] in {schema.type_name}")
        if schema.length is None or start is None or _pieces(schema) > MOST_PIECES:
            return Part(schema.element, unit, None)
        if isinstance(schema.element, Number):
            size = schema.element.minimum_size
            return Part(schema.element, unit, _aligned(start, size) + step * size)
        return Part(schema.element, unit, _end_of_all([schema.element] * step, start))
    fields: tuple[Field, ...] = schema.fields if isinstance(schema, Structure) else ()
    names = [field.name for field in fields]
    if step not in names:
        hint = did_you_mean(step, names) or (f"; there is {', '.join(names[:8])}" if names else "")
        raise NotFound(f"there is no field '{step}' in {schema.type_name}{hint}")
    index = names.index(step)
    if start is not None:
        start = _end_of_all([field.schema for field in fields[:index]], start)
    return Part(fields[index].schema, fields[index].unit or unit, start)


def _pieces(schema: Schema) -> int:
    if isinstance(schema, List) and schema.length is not None:
        return 1 if isinstance(schema.element, Number) else schema.length * _pieces(schema.element)
    if isinstance(schema, Structure):
        return sum(_pieces(field.schema) for field in schema.fields)
    return 1


def _fill(values: np.ndarray[Any, Any], bodies: np.ndarray[Any, Any], schema: Schema,
          start: int) -> int:
    """Fills `values` with the part of each body at `start`. Returns the end of the part."""
    if isinstance(schema, Number) or (isinstance(schema, List)
                                      and isinstance(schema.element, Number)):
        number = schema.element if isinstance(schema, List) else schema
        assert isinstance(number, Number)
        count = schema.length or 1 if isinstance(schema, List) else 1
        found = _numbers(bodies, _OF_LETTER[NUMBERS[number.kind]], start, count)
        if number.kind == "bool" and (found > 1).any():
            raise Invalid("a bool other than 0 and 1")
        values[...] = found.reshape(values.shape)
        return _aligned(start, number.minimum_size) + count * number.minimum_size
    if isinstance(schema, Enum):
        values[...] = _numbers(bodies, "i4", start, 1).reshape(values.shape)
        return _aligned(start, 4) + 4
    if isinstance(schema, Duration):
        seconds = _numbers(bodies, "i4", start, 1)[:, 0].astype(np.int64)
        nanoseconds = _numbers(bodies, "u4", start + 4, 1)[:, 0]
        if (nanoseconds >= NANOSECONDS).any():
            raise Invalid("a duration's second of a billion nanoseconds")
        values[...] = (seconds * NANOSECONDS + nanoseconds).astype("m8[ns]")
        return _aligned(start, 4) + 8
    if isinstance(schema, List):
        assert schema.length is not None
        for index in range(schema.length):
            start = _fill(values[:, index], bodies, schema.element, start)
        return start
    assert isinstance(schema, Structure)
    for field in schema.fields:
        start = _fill(values[field.name], bodies, field.schema, start)
    return start


def _numbers(bodies: np.ndarray[Any, Any], dtype: str, start: int,
             count: int) -> np.ndarray[Any, Any]:
    """`count` numbers of each body, without a copy."""
    kind = np.dtype(dtype).newbyteorder("<")
    start = _aligned(start, kind.itemsize)
    return bodies[:, start:start + count * kind.itemsize].view(kind)


def _store(values: Any, index: int, schema: Schema, value: Any) -> None:
    """Stores a value that Schema.decode() returned into an element of an array."""
    if isinstance(schema, Structure):
        for field in schema.fields:
            _store(values[field.name], index, field.schema, value[field.name])
    elif isinstance(schema, List):
        if isinstance(value, bytes):
            values[index] = list(value)
        else:
            for place, one in enumerate(value):
                _store(values[index], place, schema.element, one)
    elif isinstance(schema, Enum):
        values[index] = schema.values.get(value, value)
    elif isinstance(schema, Duration):
        values[index] = np.timedelta64(round(value * NANOSECONDS), "ns")
    else:
        values[index] = value


def _aligned(position: int, size: int) -> int:
    return position + -position % size
