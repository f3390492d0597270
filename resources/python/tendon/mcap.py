"""Reads MCAP files, version 0, by the public specification of the format: mcap.dev/spec.

Works like core/tendon/recording/mcap/reader.h. Uses the index at the end of the file. If the index
is missing or damaged, reads the whole file once. Skips records whose length, checksum or index
entry is wrong, and reports them in `File.problems`. Compares lengths with the size of the file
before it allocates memory.
"""

from __future__ import annotations

import struct
import zlib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Callable, Iterable, Iterator, NamedTuple

import numpy as np

from .errors import Error, Failed, Invalid, NotFound

MAGIC = b"\x89MCAP0\r\n"
MOST_CHUNK = 256 << 20  # bytes, decompressed
MOST_TEXT = 64 << 20  # bytes of a schema, channel, metadata or index
MOST_SUMMARY = 256 << 20  # bytes
MOST_ATTACHMENT = 1 << 30  # bytes
MOST_PROBLEMS = 100  # sentences in File.problems

HEADER, FOOTER, SCHEMA, CHANNEL, MESSAGE, CHUNK, MESSAGE_INDEX, CHUNK_INDEX, ATTACHMENT, \
    ATTACHMENT_INDEX, STATISTICS, METADATA, METADATA_INDEX, SUMMARY_OFFSET, DATA_END = range(1, 16)

HEAD = struct.Struct("<BQ")  # opcode, length of the content
CHUNK_HEAD = struct.Struct("<QQQI")  # first and last time, size, checksum
MESSAGE_HEAD = struct.Struct("<BQHIQQ")  # fields as in MESSAGE_DTYPE
MESSAGE_DTYPE = np.dtype([("opcode", "u1"), ("length", "<u8"), ("channel", "<u2"),
                          ("sequence", "<u4"), ("log_time", "<u8"), ("publish_time", "<u8")])
ENTRY_DTYPE = np.dtype([("log_time", "<u8"), ("offset", "<u8")])
CONTENT_HEAD = MESSAGE_HEAD.size - HEAD.size
assert MESSAGE_DTYPE.itemsize == MESSAGE_HEAD.size


@dataclass
class Channel:
    """A series of messages of one type; several channels may have the same topic."""

    id: int
    schema_id: int
    topic: str
    encoding: str
    metadata: dict[str, str]


@dataclass
class Definition:
    """A schema of the file: the description of a type."""

    name: str
    encoding: str
    text: str


@dataclass
class Chunk:
    """A chunk: records that are compressed and read together."""

    start: int
    """The position of the chunk in the file."""
    length: int
    channels: dict[int, int]
    """The position of the message index in the file, by channel. Empty if it is unknown which
    channels the chunk has."""
    index_length: int = 0
    """The size of all message indexes, which follow the chunk."""
    is_loose: bool = False
    """True for messages of a file without chunks. They have no checksum."""


class Place(NamedTuple):
    """The position and the name of an attachment or a metadata record."""

    start: int
    length: int
    name: str


@dataclass
class Contents:
    """The index of a file: what it contains, and where."""

    channels: dict[int, Channel] = field(default_factory=dict)
    schemas: dict[int, Definition] = field(default_factory=dict)  # by id
    chunks: list[Chunk] = field(default_factory=list)
    attachments: list[Place] = field(default_factory=list)
    metadata: list[Place] = field(default_factory=list)
    counts: dict[int, int] = field(default_factory=dict)  # messages by channel; may be empty


class Messages(NamedTuple):
    """The messages of some channels in one chunk."""

    data: memoryview
    """The records of the chunk."""
    offsets: dict[int, np.ndarray[Any, Any]]
    """The positions of the messages in `data` by channel, in the order of the file."""


class File:
    """An MCAP file that is open. Not thread-safe."""

    def __init__(self, path: str | Path, on_problem: Callable[[str], None]) -> None:
        self.name = str(path)
        self.problems: list[str] = []
        self._on_problem = on_problem
        self._lost: set[int] = set()  # damaged chunks already reported
        try:
            self._file = open(path, "rb")
        except FileNotFoundError:
            raise NotFound(f"there is no file {self.name}") from None
        except OSError as why:
            raise Failed(f"cannot open {self.name}: {why.strerror}") from None
        try:
            self._size = self._file.seek(0, 2)
            self._check_magic()
            contents = _Summary(self).read()
            self.was_scanned = contents is None
            self.contents = _Scan(self).run() if contents is None else contents
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Closes the file. Later reads raise Failed."""
        self._file.close()

    @property
    def size(self) -> int:
        """The size of the file in bytes when it was opened."""
        return self._size

    def at(self, start: int, size: int) -> bytes:
        """Reads `size` bytes from `start`, or fewer at the end of the file."""
        try:
            self._file.seek(start)
            return self._file.read(max(0, min(size, self._size - start)))
        except ValueError:
            raise Failed(f"{self.name} is closed; to read it again: tendon.open()") from None
        except OSError as why:
            raise Failed(f"cannot read {self.name} at {start}: {why.strerror}") from None

    def tell(self, sentence: str) -> None:
        """Reports that a part of the file is damaged or missing."""
        if len(self.problems) < MOST_PROBLEMS:
            self.problems.append(sentence)
            self._on_problem(f"{self.name}: {sentence}")

    def messages(self, channels: Iterable[int]) -> Iterator[Messages]:
        """Yields the messages of these channels, chunk by chunk in the order of the file. Skips
        damaged chunks."""
        wanted = set(channels)
        for chunk in self.contents.chunks:
            if chunk.channels and wanted.isdisjoint(chunk.channels):
                continue
            try:
                records = self.load(chunk)
            except Error as why:
                if isinstance(why, Missing) or self._file.closed:
                    raise
                if chunk.start not in self._lost:
                    self._lost.add(chunk.start)
                    self.tell(f"the chunk at {chunk.start} is lost: {why}")
                continue
            offsets = self._indexed(chunk, records)
            if offsets is None:
                offsets = _walk(records)[0]
            found = {one: offsets[one] for one in wanted if one in offsets}
            if found:
                yield Messages(memoryview(records), found)

    def load(self, chunk: Chunk) -> bytes:
        """The records of a chunk. Raises Invalid if the chunk is damaged."""
        if chunk.is_loose:
            return self.at(chunk.start, chunk.length)
        return self.load_chunk(chunk.start, chunk.length)[0]

    def load_chunk(self, start: int, length: int | None = None) -> tuple[bytes, int]:
        """The records of the chunk at `start`, and the length of the whole chunk. Raises Invalid if
        the chunk is damaged, or if it does not have the expected `length`."""
        head = self.at(start, 128)  # the names of compressions are short
        opcode, size = HEAD.unpack_from(head.ljust(HEAD.size, b"\0"))
        if opcode != CHUNK or size > self._size - start - HEAD.size:
            raise Invalid("there is no chunk")
        if length is not None and size != length - HEAD.size:
            raise Invalid("the length of the chunk differs from the length in the index")
        fields = _Fields(head[HEAD.size:])
        _, _, full, checksum = fields.unpack(CHUNK_HEAD)
        compression = fields.text()
        stored = fields.number(8)
        begin = HEAD.size + fields.position
        if stored > HEAD.size + size - begin:
            raise Invalid("the fields of the chunk do not match the length of the chunk")
        if max(full, stored) > MOST_CHUNK:
            raise Invalid(f"the chunk states {max(full, stored)} bytes; at most "
                          f"{MOST_CHUNK} are read")
        records = _decompressed(compression, self.at(start + begin, stored), full)
        if checksum and zlib.crc32(records) != checksum:
            raise Invalid("the checksum of the chunk is wrong")
        return records, HEAD.size + size

    def attachment(self, place: Place) -> bytes:
        """The content of an attachment. Raises Invalid if the checksum is wrong."""
        content = self.record(place.start, place.length, ATTACHMENT, MOST_ATTACHMENT)
        fields = _Fields(content)
        fields.number(16)
        fields.text()
        fields.text()
        data = fields.raw(fields.number(8))
        end = fields.position
        checksum = fields.number(4)
        if checksum and zlib.crc32(memoryview(content)[:end]) != checksum:
            raise Invalid(f"attachment '{place.name}' of {self.name} is damaged: the checksum "
                          "of the attachment is wrong")
        return data

    def record(self, start: int, length: int, opcode: int, most: int = MOST_TEXT) -> bytes:
        """The content of one record."""
        if not HEAD.size <= length <= min(most, self._size):
            raise Invalid(f"the record at {start} of {self.name} states {length} bytes")
        record = self.at(start, length)
        if len(record) != length or HEAD.unpack_from(record) != (opcode, length - HEAD.size):
            raise Invalid(f"the record at {start} of {self.name} is damaged")
        return record[HEAD.size:]

    def _check_magic(self) -> None:
        begin = self.at(0, len(MAGIC))
        if begin != MAGIC:
            raise Invalid(f"{self.name} is not a recording: an MCAP file begins with {MAGIC!r}, "
                          f"but this file begins with {begin!r}")

    def _indexed(self, chunk: Chunk, records: bytes) -> dict[int, np.ndarray[Any, Any]] | None:
        """The positions of the messages by the indexes that follow the chunk. The indexes have no
        checksum. So each entry is compared with its message, and every message of the chunk must
        have an entry. Returns None if they do not agree."""
        if chunk.is_loose or not chunk.index_length or chunk.index_length > MOST_TEXT:
            return None
        index = self.at(chunk.start + chunk.length, chunk.index_length)
        found: dict[int, np.ndarray[Any, Any]] = {}
        try:
            for opcode, content in _records(index):
                if opcode != MESSAGE_INDEX:
                    continue
                fields = _Fields(content)
                channel = fields.number(2)
                entries = np.frombuffer(fields.block(), ENTRY_DTYPE)
                if len(entries):
                    found[channel] = entries["offset"]
                    _check_entries(channel, entries, records)
            _check_rest(found, records)
        except ValueError:  # numpy: the index ends within an entry
            return None
        except Invalid:
            return None
        return found


class _Fields:
    """Reads the fields of a record; raises Invalid if there are too few bytes."""

    def __init__(self, content: bytes) -> None:
        self._content = content
        self.position = 0

    def raw(self, size: int) -> bytes:
        if size > len(self._content) - self.position:
            raise Invalid("a record is too short")
        self.position += size
        return self._content[self.position - size:self.position]

    def number(self, size: int) -> int:
        return int.from_bytes(self.raw(size), "little")

    def unpack(self, form: struct.Struct) -> tuple[Any, ...]:
        return form.unpack(self.raw(form.size))

    def block(self) -> bytes:
        return self.raw(self.number(4))

    def text(self) -> str:
        return self.block().decode("utf-8", "surrogateescape")

    def texts(self) -> dict[str, str]:
        inner = _Fields(self.block())
        found: dict[str, str] = {}
        while not inner.at_end:
            key, value = inner.text(), inner.text()
            found.setdefault(key, value)
        return found

    @property
    def at_end(self) -> bool:
        return self.position == len(self._content)


def read_metadata(content: bytes) -> dict[str, str]:
    """The keys and values of a metadata record with this content."""
    fields = _Fields(content)
    fields.text()
    return fields.texts()


def _records(data: bytes) -> Iterator[tuple[int, bytes]]:
    """Yields the opcode and the content of each record. Raises Invalid where no record begins."""
    position = 0
    while position < len(data):
        if len(data) - position < HEAD.size:
            raise Invalid("there is no record")
        opcode, length = HEAD.unpack_from(data, position)
        position += HEAD.size
        if not opcode or length > len(data) - position:
            raise Invalid("there is no record")
        yield opcode, data[position:position + length]
        position += length


def _walk(records: bytes) -> tuple[dict[int, np.ndarray[Any, Any]], list[tuple[int, bytes]]]:
    """Finds the positions of the messages by channel, and the schemas and channels as opcode and
    content. Stops where no record begins."""
    found: dict[int, list[int]] = {}
    definitions: list[tuple[int, bytes]] = []
    position, end = 0, len(records)
    while end - position >= HEAD.size:
        opcode, length = HEAD.unpack_from(records, position)
        following = position + HEAD.size + length
        if following > end:
            break
        if opcode == MESSAGE and length >= CONTENT_HEAD:
            channel = records[position + HEAD.size] | records[position + HEAD.size + 1] << 8
            found.setdefault(channel, []).append(position)
        elif opcode in (SCHEMA, CHANNEL):
            definitions.append((opcode, records[position + HEAD.size:following]))
        position = following
    return {one: np.array(places, np.int64) for one, places in found.items()}, definitions


def take(data: memoryview, offsets: np.ndarray[Any, Any], size: int) -> np.ndarray[Any, Any]:
    """Copies `size` bytes from each offset into one row of an array of bytes."""
    if not len(offsets):
        return np.empty((0, size), np.uint8)
    if int(offsets.max()) + size > len(data):
        raise Invalid("a message is too short")
    whole = np.ndarray((len(data) - size + 1,), f"V{size}", data, strides=(1,))
    return whole[offsets.astype(np.int64)].view(np.uint8).reshape(len(offsets), size)


def heads(data: memoryview, offsets: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """The heads of messages, as a structured array."""
    return take(data, offsets, MESSAGE_DTYPE.itemsize).view(MESSAGE_DTYPE)[:, 0]


def _check_entries(channel: int, entries: np.ndarray[Any, Any], records: bytes) -> None:
    if int(entries["offset"].max()) > len(records):
        raise Invalid("an index entry is outside of its chunk")
    found = heads(memoryview(records), entries["offset"])
    if (found["opcode"] != MESSAGE).any() or (found["channel"] != channel).any() \
            or (found["log_time"] != entries["log_time"]).any() \
            or (found["length"] < CONTENT_HEAD).any() or (found["length"] > len(records)).any():
        raise Invalid("an index does not match the messages of its chunk")


def _check_rest(found: dict[int, np.ndarray[Any, Any]], records: bytes) -> None:
    """Raises Invalid if the chunk has a message without an entry in the indexes."""
    starts = np.concatenate([np.empty(0, np.uint64), *found.values()]).astype(np.int64)
    starts.sort(kind="stable")  # fast, because each channel is sorted already
    ends = starts + HEAD.size
    if len(starts):
        ends = ends + heads(memoryview(records), starts)["length"].astype(np.int64)
    gaps_begin = np.concatenate([[0], ends])
    gaps_end = np.concatenate([starts, [len(records)]])
    if (gaps_end < gaps_begin).any():
        raise Invalid("the messages of an index overlap")
    for gap in np.nonzero(gaps_end > gaps_begin)[0]:
        for opcode, _ in _records(records[gaps_begin[gap]:gaps_end[gap]]):
            if opcode == MESSAGE:
                raise Invalid("a message is missing in an index")


def _decompressed(compression: str, data: bytes, size: int) -> bytes:
    """Decompresses the data. Raises Invalid if the result does not have `size` bytes."""
    if compression == "":
        records = data
    elif compression == "zstd":
        records = _zstd(data, size)
    elif compression == "lz4":
        records = _lz4(data, size)
    else:
        raise Invalid(f"the compression '{compression[:40]}' is unknown; known are zstd, lz4 and "
                      "none")
    if len(records) != size:
        raise Invalid(f"the data has {len(records)} bytes after decompression, instead of {size}")
    return records


def _zstd(data: bytes, size: int) -> bytes:
    try:
        import zstandard
    except ModuleNotFoundError:
        raise _missing("zstd", "zstandard") from None
    try:
        claimed = zstandard.frame_content_size(data)
        if claimed not in (-1, size):
            raise Invalid(f"the compressed data states {claimed} bytes, but the chunk "
                          f"states {size}")
        return bytes(zstandard.ZstdDecompressor().decompress(data, max_output_size=size))
    except zstandard.ZstdError as why:
        raise Invalid(f"the data cannot be decompressed: {why}") from None


def _lz4(data: bytes, size: int) -> bytes:
    try:
        import lz4.frame
    except ModuleNotFoundError:
        raise _missing("lz4", "lz4") from None
    try:
        return bytes(lz4.frame.LZ4FrameDecompressor().decompress(data, max_length=size))
    except (RuntimeError, EOFError) as why:
        raise Invalid(f"the data cannot be decompressed: {why}") from None


class Missing(Failed):
    """A module of Python that is needed for the compression is not installed."""


def _missing(what: str, module: str) -> Missing:
    return Missing(f"this recording is compressed with {what}, and this Python has no module "
                   f"'{module}': install python3-{module}, or run: pip install {module}")


class _Summary:
    """Reads the index at the end of a file."""

    def __init__(self, file: File) -> None:
        self._file = file
        self._contents = Contents()
        self._expected: tuple[int, int, int] | None = None  # attachments, metadata, chunks

    def read(self) -> Contents | None:
        """The index; None if it is missing, damaged or incomplete."""
        try:
            records = self._find()
            if records is None:
                return None
            for opcode, content in _records(records):
                self._add(opcode, _Fields(content))
            self._check_chunks(self._file.size)
        except Invalid as why:
            self._file.tell(f"the index at the end of the file cannot be used: {why}; the whole "
                            "file is read instead")
            return None
        return self._contents if self._is_sufficient() else None

    def _find(self) -> bytes | None:
        tail_size = HEAD.size + 20 + len(MAGIC)
        place = self._file.size - tail_size
        tail = self._file.at(max(0, place), tail_size)
        if place < len(MAGIC) or tail[-len(MAGIC):] != MAGIC:
            raise Invalid("the end of the file is missing: the recording was cut off, or is still "
                          "being written")
        if HEAD.unpack_from(tail) != (FOOTER, 20):
            raise Invalid("the footer is damaged")
        start, _, checksum = struct.unpack_from("<QQI", tail, HEAD.size)
        if start == 0:
            return None
        if not len(MAGIC) <= start <= place or place - start > MOST_SUMMARY:
            raise Invalid(f"the summary begins at {start}")
        records = self._file.at(start, place - start)
        if checksum and zlib.crc32(tail[:HEAD.size + 16], zlib.crc32(records)) != checksum:
            raise Invalid("its checksum is wrong")
        return records

    def _add(self, opcode: int, fields: _Fields) -> None:
        if opcode in (SCHEMA, CHANNEL):
            _define(self._contents, opcode, fields)
        elif opcode == CHUNK_INDEX:
            fields.number(16)
            start, length = fields.number(8), fields.number(8)
            offsets = np.frombuffer(_whole(fields.block(), 10), [("id", "<u2"), ("at", "<u8")])
            channels = dict(zip(offsets["id"].tolist(), offsets["at"].tolist()))
            self._contents.chunks.append(Chunk(start, length, channels, fields.number(8)))
        elif opcode == ATTACHMENT_INDEX:
            start, length = fields.number(8), fields.number(8)
            fields.number(24)
            self._contents.attachments.append(Place(start, length, fields.text()))
        elif opcode == METADATA_INDEX:
            start, length = fields.number(8), fields.number(8)
            self._contents.metadata.append(Place(start, length, fields.text()))
        elif opcode == STATISTICS:
            fields.number(8 + 2 + 4)
            self._expected = (fields.number(4), fields.number(4), fields.number(4))
            fields.number(16)
            counts = np.frombuffer(_whole(fields.block(), 10), [("id", "<u2"), ("n", "<u8")])
            self._contents.counts = dict(zip(counts["id"].tolist(), counts["n"].tolist()))

    def _check_chunks(self, size: int) -> None:
        end = len(MAGIC)
        self._contents.chunks.sort(key=lambda chunk: chunk.start)
        for chunk in self._contents.chunks:
            if chunk.start < end or chunk.length > size - chunk.start:
                raise Invalid(f"according to the index, a chunk is at {chunk.start} + "
                              f"{chunk.length}, so it overlaps another chunk or is outside of "
                              "the file")
            end = chunk.start + max(1, chunk.length)

    def _is_sufficient(self) -> bool:
        """False if the index is incomplete, which the format allows."""
        contents = self._contents
        used = {one for chunk in contents.chunks for one in chunk.channels}
        used.update(one for one, count in contents.counts.items() if count)
        there = (len(contents.attachments), len(contents.metadata), len(contents.chunks))
        return self._expected == there and used <= contents.channels.keys() \
            and bool(contents.channels or not contents.chunks)


class _Scan:
    """Builds the index by reading the whole file. Behind damaged records, finds the next chunk."""

    def __init__(self, file: File) -> None:
        self._file = file
        self._contents = Contents()
        self._position = len(MAGIC)
        self._trusted = self._position  # the end of the last valid record
        self._budget = 8 * file.size + MOST_CHUNK  # bytes that the searches may still read
        self._is_finished = False

    def run(self) -> Contents:
        """Reads all records of the file, and returns the index."""
        while not self._is_finished and self._position < self._file.size:
            head = self._file.at(self._position, HEAD.size)
            opcode, length = HEAD.unpack(head.ljust(HEAD.size, b"\0"))
            fits = opcode and length <= self._file.size - self._position - HEAD.size
            if not fits or not self._read(opcode, length):
                self._search()
        return self._contents

    def _read(self, opcode: int, length: int) -> bool:
        """Reads one record. Returns False if the next record may not begin at its end."""
        start, self._position = self._position, self._position + HEAD.size + length
        if opcode == CHUNK:
            try:
                records, _ = self._file.load_chunk(start)
            except Missing:
                raise
            except Error as why:
                self._file.tell(f"the chunk at {start} is lost: {why}")
                return self._can_follow()
            self._add_chunk(Chunk(start, HEAD.size + length, {}), records)
        elif opcode == MESSAGE:
            if not self._add_message(start, length):
                return self._can_follow()
        elif opcode in (DATA_END, FOOTER):
            self._is_finished = True
        elif opcode > DATA_END or (length > MOST_TEXT and opcode != ATTACHMENT):
            return self._can_follow()
        elif not self._read_small(opcode, start, length):
            return self._can_follow()
        self._trusted = self._position
        return True

    def _read_small(self, opcode: int, start: int, length: int) -> bool:
        most = 4096 if opcode == ATTACHMENT else length  # its name is near the beginning
        content = self._file.at(start + HEAD.size, min(length, most))
        try:
            if opcode in (SCHEMA, CHANNEL):
                _define(self._contents, opcode, _Fields(content))
            elif opcode == ATTACHMENT:
                fields = _Fields(content)
                fields.number(16)
                self._contents.attachments.append(Place(start, HEAD.size + length, fields.text()))
            elif opcode == METADATA:
                name = _Fields(content).text()
                read_metadata(content)
                self._contents.metadata.append(Place(start, HEAD.size + length, name))
            elif opcode == MESSAGE_INDEX and self._contents.chunks:
                chunk = self._contents.chunks[-1]
                if chunk.start + chunk.length + chunk.index_length == start:
                    chunk.index_length += HEAD.size + length
        except Invalid:
            self._file.tell(f"the record at {start} is malformed; it is skipped")
            return False
        return True

    def _add_chunk(self, chunk: Chunk, records: bytes) -> None:
        offsets, definitions = _walk(records)
        for opcode, content in definitions:
            try:
                _define(self._contents, opcode, _Fields(content))
            except Invalid:
                self._file.tell(f"the chunk at {chunk.start} has a malformed record")
        chunk.channels = dict.fromkeys(offsets, 0)
        self._count(offsets)
        self._contents.chunks.append(chunk)

    def _count(self, offsets: dict[int, np.ndarray[Any, Any]]) -> None:
        for channel, places in offsets.items():
            self._contents.counts[channel] = self._contents.counts.get(channel, 0) + len(places)

    def _add_message(self, start: int, length: int) -> bool:
        """Adds a message of a file without chunks. In a file with chunks, a record that looks like
        a message outside of them is another record with a damaged opcode."""
        chunks = self._contents.chunks
        head = self._file.at(start, MESSAGE_HEAD.size)
        if (chunks and not chunks[-1].is_loose) or not CONTENT_HEAD <= length <= MOST_CHUNK:
            self._file.tell(f"the message at {start} is outside of the chunks; it is skipped")
            return False
        channel = MESSAGE_HEAD.unpack(head)[2]
        size = HEAD.size + length
        last = chunks[-1] if chunks else None
        if last is None or last.start + last.length != start or last.length + size > 1 << 20:
            last = Chunk(start, 0, {}, is_loose=True)
            chunks.append(last)
        last.length += size
        last.channels[channel] = 0
        self._count({channel: np.empty(1)})
        return True

    def _can_follow(self) -> bool:
        """True if a record fits behind the present one."""
        head = self._file.at(self._position, HEAD.size)
        if not head:
            return True
        opcode, length = HEAD.unpack(head.ljust(HEAD.size, b"\0"))
        return bool(opcode) and length <= self._file.size - self._position - HEAD.size

    def _search(self) -> None:
        """Continues at the next chunk, or ends the scan."""
        broken = self._position
        found = self._next_chunk(self._trusted + 1)
        if found is None:
            self._is_finished = True
            self._file.tell(f"the file ends within the record at {min(broken, self._trusted)}: "
                            "the rest of the file is incomplete")
            return
        self._file.tell(f"the bytes from {self._trusted} to {found} are damaged and skipped; the "
                        "next chunk begins after them")
        self._position = self._trusted = found

    def _next_chunk(self, start: int) -> int | None:
        piece_size = 64 << 10
        while start < self._file.size:
            piece = self._file.at(start, piece_size + HEAD.size)
            place = piece.find(CHUNK)
            while 0 <= place < piece_size:
                if place + HEAD.size > len(piece) or piece[place + 8] == 0:
                    if self._is_chunk(start + place):
                        return start + place
                    if self._budget <= 0:
                        self._file.tell("so much of the file is damaged that the search for "
                                        f"further chunks ends at {start + place}")
                        return None
                place = piece.find(CHUNK, place + 1)
            start += piece_size
        return None

    def _is_chunk(self, start: int) -> bool:
        """True if a chunk with a correct checksum begins at `start`."""
        head = self._file.at(start, 128)
        try:
            fields = _Fields(head)
            _, length = fields.unpack(HEAD)
            _, _, full, checksum = fields.unpack(CHUNK_HEAD)
            compression, stored = fields.text(), fields.number(8)
            exact = fields.position + stored == HEAD.size + length
            if not exact or not checksum or compression not in ("", "zstd", "lz4"):
                return False
            self._budget -= stored + full
            self._file.load_chunk(start)
        except Missing:
            raise
        except Error:
            return False
        return True


def _define(contents: Contents, opcode: int, fields: _Fields) -> None:
    number = fields.number(2)
    if opcode == SCHEMA:
        contents.schemas.setdefault(number, Definition(fields.text(), fields.text(), fields.text()))
    else:
        contents.channels.setdefault(number, Channel(number, fields.number(2), fields.text(),
                                                     fields.text(), fields.texts()))


def _whole(data: bytes, size: int) -> bytes:
    if len(data) % size:
        raise Invalid("a list ends within an element")
    return data
