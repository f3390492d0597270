"""Writes recordings with a chosen content, in the format of core/tendon/recording."""
import pathlib
import struct
import zlib

MAGIC = b"\x89MCAP0\r\n"
WHEEL = """struct cart.Wheel {
  speed: float64 in rad/s
  mode: enum cart.Mode {
    idle = 0
    moving = 7
  }
  uptime: duration
  ready: bool
  legs: struct cart.Leg {
    load: int8
    force: float64[3] in N
  }[2]
}"""


def string(text):
    data = text.encode()
    return struct.pack("<I", len(data)) + data


def strings(values):
    inner = b"".join(string(key) + string(value) for key, value in values.items())
    return struct.pack("<I", len(inner)) + inner


def record(opcode, content):
    return struct.pack("<BQ", opcode, len(content)) + content


class Writer:
    """Builds a recording. chunk() ends a chunk; finish() writes the index and returns the file."""

    def __init__(self, compress=lambda data: ("", data)):
        self._compress = compress
        self._file = bytearray(MAGIC + record(1, string("ros2") + string("a test")))
        self._records = bytearray()
        self._entries = {}
        self._channels, self._indexes, self._metadata = [], [], []
        self._schemas = []
        self._counts = {}
        self.chunk_starts = []

    def channel(self, path, schema, kind="column", epoch=1, clock=0, topic=None):
        metadata = {"tendon.kind": kind, "tendon.path": path, "tendon.epoch": str(epoch),
                    "tendon.clock_ns": str(clock), "tendon.schema": schema}
        return self.foreign_channel(topic or path.replace(".", "/"), metadata)

    def schema(self, name, text, encoding="ros2msg"):
        number = len(self._schemas) + 1
        self._schemas.append(record(3, struct.pack("<H", number) + string(name) + string(encoding)
                                    + string(text)))
        self._records += self._schemas[-1]
        return number

    def foreign_channel(self, topic, metadata=None, schema=0, encoding="cdr"):
        number = len(self._channels) + 1
        self._channels.append(record(4, struct.pack("<HH", number, schema) + string(topic)
                                     + string(encoding) + strings(metadata or {})))
        self._records += self._channels[-1]
        return number

    def message(self, channel, sequence, time, body, source_time=None):
        self._entries.setdefault(channel, []).append((time, len(self._records)))
        self._counts[channel] = self._counts.get(channel, 0) + 1
        head = struct.pack("<HIQQ", channel, sequence, time,
                           time if source_time is None else source_time)
        self._records += record(5, head + b"\0\1\0\0" + body)

    def metadata(self, name, values):
        content = record(12, string(name) + strings(values))
        self._metadata.append(record(13, struct.pack("<QQ", len(self._file), len(content))
                                     + string(name)))
        self._file += content

    def chunk(self):
        times = [time for entries in self._entries.values() for time, _ in entries] or [0]
        name, stored = self._compress(bytes(self._records))
        content = record(6, struct.pack("<QQQI", min(times), max(times), len(self._records),
                                        zlib.crc32(self._records)) + string(name)
                         + struct.pack("<Q", len(stored)) + stored)
        start = len(self._file)
        self.chunk_starts.append(start)
        self._file += content
        places = b""
        for channel, entries in self._entries.items():
            places += struct.pack("<HQ", channel, len(self._file))
            listed = b"".join(struct.pack("<QQ", *entry) for entry in entries)
            self._file += record(7, struct.pack("<HI", channel, len(listed)) + listed)
        self._indexes.append(record(8, struct.pack(
            "<QQQQ", min(times), max(times), start, len(content))
            + struct.pack("<I", len(places)) + places
            + struct.pack("<Q", len(self._file) - start - len(content)) + string(name)
            + struct.pack("<QQ", len(stored), len(self._records))))
        self._records.clear()
        self._entries.clear()

    def finish(self):
        if self._records:
            self.chunk()
        self._file += record(15, struct.pack("<I", 0))
        start = len(self._file)
        counts = b"".join(struct.pack("<HQ", *one) for one in self._counts.items())
        summary = b"".join([*self._schemas, *self._channels, *self._indexes, *self._metadata])
        summary += record(11, struct.pack(
            "<QHIIIIQQ", sum(self._counts.values()), len(self._schemas), len(self._channels), 0,
            len(self._metadata), len(self._indexes), 0, 0) + struct.pack("<I", len(counts))
            + counts)
        summary += struct.pack("<BQQQ", 2, 20, start, 0)
        return bytes(self._file) + summary + struct.pack("<I", zlib.crc32(summary)) + MAGIC

    def save(self, path):
        pathlib.Path(path).write_bytes(self.finish())
