"""Recordings of `gcm record` as arrays of numpy, by the paths of the system.

    import tendon

    run = tendon.open("run.mcap")
    position = run["robot/arm/state.Joints.position"]   # an array of rows x 7, in rad
    seconds = run.times("robot/arm/state") / 1e9        # since 1970
"""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any, Iterable, NamedTuple

import numpy as np

from . import mcap
from .errors import Error, Invalid, NotFound, did_you_mean
from .paths import steps_of
from .payload import arrays
from .payload.ros_text import parse_message
from .payload.schema import Enum, Schema
from .payload.schema_text import parse

ENCAPSULATION = b"\0\1\0\0"  # before each body: little-endian CDR, as in ROS 2
MOST_CACHED = 256 << 20  # bytes of columns that were read
LEVELS = {10: "debug", 20: "info", 30: "warning", 40: "error", 50: "fatal"}
LOG_TOPIC = "rosout"
LOSS_TOPIC = "tendon/lost"

GAP_DTYPE = np.dtype([("row", "i8"), ("begin", "i8"), ("end", "i8"), ("missing", "i8")])

Array = Any  # numpy.ndarray, of any type and shape


class DamagedRecording(UserWarning):
    """The warning that a part of a file is damaged or missing, and where."""


class LogRecord(NamedTuple):
    """A record of the log."""

    time: int
    """When the record was written, in ns since 1970."""
    level: str
    """"debug", "info", "warning" or "error"."""
    source: str
    """A process or a component: "robot/arm"."""
    text: str


class Loss(NamedTuple):
    """Rows that were not recorded, and where they were lost."""

    time: int
    """The time of the first row after the lost rows, in ns since 1970."""
    path: str
    """The path of the table."""
    table: int
    """The number of rows that the table had overwritten before they could be sent."""
    network: int
    """The number of rows that were lost on the network."""
    recorder: int
    """The number of rows that the recorder could not write in time."""


class _Member(NamedTuple):
    """A column, an event or a command, and its channel."""

    path: str
    channel: mcap.Channel
    schema: Schema | None
    """None if the text of the schema cannot be read."""


class _Run:
    """The channels of a table, an event or a command, from one start of its process to the next."""

    def __init__(self) -> None:
        self.members: dict[str, _Member] = {}
        self.rows: np.ndarray[Any, Any] | None = None
        """The heads of the first column's messages, without the rows that lack a column."""
        self.is_partial: set[int] = set()
        """The channels that have messages of incomplete rows."""


class Recording:
    """A recording that is open, the result of open(). Use it in one thread at a time.

    Paths are those of the console: a table is `robot/arm/state`, a column of it
    `robot/arm/state.Joints`, an event `robot/arm/Control.LimitExceeded`, a command
    `robot/arm/Control.MoveTo`; fields and indexes may follow, as in
    `robot/arm/state.Joints.position[0]`. Topics of other programs, whose type is a ROS 2 message in
    CDR, are used like events: `/arm/pose.position.x`. Rows are in the order of the file, also
    across restarts of a process. All columns of a table have the same rows: a row is left out if
    any part of it was in a damaged chunk.

    open() reads the index of the file; the functions read the chunks that they need, and keep up to
    256 MiB of columns.
    """

    def __init__(self, path: str | Path) -> None:
        self._file = mcap.File(path, _warn)
        self._runs: dict[str, list[_Run]] = {}  # by the path of a table, an event or a command
        self._members: dict[str, str] = {}  # the key in _runs, by column, event or command
        self._own: dict[str, list[_Member]] = {}  # channels of the recorder itself, by topic
        self._foreign: set[str] = set()  # topics of other programs, which are members
        self._left_out: dict[str, str] = {}  # the reasons, by topic
        self._cache: dict[tuple[str, str], np.ndarray[Any, Any]] = {}
        counts = self._file.contents.counts
        for number, channel in sorted(self._file.contents.channels.items()):
            if not counts or counts.get(number):
                self._add(channel)

    def close(self) -> None:
        """Closes the file; the end of a `with` block does so as well. Arrays stay valid."""
        self._file.close()

    def __enter__(self) -> Recording:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"<recording {self._file.name}: {len(self._members)} columns and events>"

    @property
    def problems(self) -> list[str]:
        """Which parts of the file are damaged or missing. Covers only the parts read so far."""
        return list(self._file.problems)

    @property
    def about(self) -> dict[str, str]:
        """The metadata of the recording: who made it, and of which paths. A complete recording also
        says how many rows it has, and how many were lost."""
        about: dict[str, str] = {}
        for place in self._file.contents.metadata:
            if place.name not in ("tendon.recording", "tendon.end"):
                continue
            try:
                record = self._file.record(place.start, place.length, mcap.METADATA)
                about.update(mcap.read_metadata(record))
            except Invalid as why:
                self._file.tell(str(why))
        return about

    def attachments(self) -> list[str]:
        """The names of the attached files. `system.json` describes the system that was recorded."""
        return [place.name for place in self._file.contents.attachments]

    def attachment(self, name: str) -> bytes:
        """The content of an attached file."""
        for place in self._file.contents.attachments:
            if place.name == name:
                return self._file.attachment(place)
        raise NotFound(f"{self._file.name} has no attachment '{name}'"
                       f"{did_you_mean(name, self.attachments())}")

    def tables(self) -> list[str]:
        """The paths of all state tables: ["robot/arm/state", ...]."""
        return sorted(path for path in self._runs if path not in self._members)

    def events(self) -> list[str]:
        """The paths of all events that were raised: ["robot/arm/Control.LimitExceeded", ...]."""
        return self._paths_of("event")

    def commands(self) -> list[str]:
        """The paths of all commands that were called: ["robot/arm/Control.MoveTo", ...]. Each call
        is a structure with `outcome`, `client` and, if the command has one, `argument`.
        """
        return self._paths_of("command")

    def other_topics(self) -> list[str]:
        """The topics of other programs whose values can be read: ["/arm/pose", ...]."""
        return sorted(self._foreign)

    @property
    def left_out(self) -> dict[str, str]:
        """The topics whose values cannot be read, and a sentence about each: the number of its
        messages, if it is known, and why."""
        return dict(self._left_out)

    def paths(self) -> list[str]:
        """The paths of all fields of columns, events and commands, except for structures."""
        return sorted(path + field for path in self._members
                      for field, _ in arrays.leaves_of(self._schema(path)))

    def topics(self) -> list[str]:
        """All topics of the file, also those whose values cannot be read: see left_out."""
        return sorted({one.topic for one in self._file.contents.channels.values()})

    def __getitem__(self, path: str) -> Array:
        """The values of a column, an event or a part of one: one value for each row.

        Numbers keep their types: an array of 7 numbers is an array of rows x 7. Structures are
        structured arrays, enums int32 (see enumerators()), durations timedelta64[ns]. Texts,
        sequences, and types that contain one of them are Python objects.

        Cost: reads the chunks that have this column. About 1 us a row for values of fixed size, and
        more than 10 us for others.
        """
        member, field = self._split(path)
        arrays.part_of(self._schema(member), field)  # refuses a field that is not there
        self._load_rows(self._members[member])
        key = (member, field)
        if key not in self._cache:
            parts = [self._decode(run, run.members[member], field)
                     for run in self._runs[self._members[member]] if member in run.members]
            self._keep(key, np.concatenate(parts) if len(parts) != 1 else parts[0])
        return self._cache[key].copy()

    def times(self, path: str) -> Array:
        """The time of each row of a table, a column or an event, in ns since 1970, as int64. It was
        measured with the clock of the computer that recorded."""
        return self._heads(path)["log_time"].astype(np.int64)

    def source_times(self, path: str) -> Array:
        """The time of each row on the steady clock of its process, in ns: int64."""
        parts = [self._run_heads(run)["publish_time"].astype(np.int64) - _clock_of(run)
                 for run in self._runs_of(path)]
        return np.concatenate([np.empty(0, np.int64), *parts])

    def ticks(self, path: str) -> Array:
        """The tick of each row of a table or a column, as uint64. The file has only the low 32 bits
        of a tick, so the first tick after a start of the process is below 2^32. Ticks begin again
        with each start of the process. For an event: a number that counts up."""
        parts = [_continued(self._run_heads(run)["sequence"]) for run in self._runs_of(path)]
        return np.concatenate([np.empty(0, np.uint64), *parts])

    def starts(self, path: str) -> Array:
        """The index of the first row after each start of the process, as int64. The first one is
        0."""
        sizes = [len(self._run_heads(run)) for run in self._runs_of(path)]
        return np.cumsum([0, *sizes[:-1]], dtype=np.int64)[:len(sizes)]

    def gaps(self, path: str) -> Array:
        """The gaps in the rows of a table, as a structured array: `row` is the first row after the
        gap, `begin` and `end` are the times in ns of the rows before and after the gap, and
        `missing` is the number of missing rows."""
        found = [np.empty(0, GAP_DTYPE)]
        first = 0
        for run in self._runs_of(path):
            heads = self._run_heads(run)
            missing = np.diff(_continued(heads["sequence"]).astype(np.int64)) - 1
            rows = np.nonzero(missing > 0)[0]
            gaps = np.empty(len(rows), GAP_DTYPE)
            gaps["row"] = first + rows + 1
            gaps["begin"] = heads["log_time"][rows]
            gaps["end"] = heads["log_time"][rows + 1]
            gaps["missing"] = missing[rows]
            found.append(gaps)
            first += len(heads)
        return np.concatenate(found)

    def losses(self) -> list[Loss]:
        """How many rows were lost, when and where, as far as the recorder knows. gaps() says
        which."""
        return [Loss(time, value["path"], value["table"], value["network"], value["recorder"])
                for time, value in self._own_values(LOSS_TOPIC)]

    @property
    def log(self) -> list[LogRecord]:
        """The log of all processes, sorted by time."""
        records = [LogRecord(time, LEVELS.get(value["level"], str(value["level"])), value["name"],
                             value["msg"]) for time, value in self._own_values(LOG_TOPIC)]
        return sorted(records, key=lambda record: record.time)

    def unit(self, path: str) -> str:
        """The unit of a column or a field, such as "rad"; empty if it has none."""
        member, field = self._split(path)
        return arrays.part_of(self._schema(member), field).unit

    def units(self) -> dict[str, str]:
        """The unit of each path in paths() that has one."""
        return {path + field: unit for path in self._members
                for field, unit in arrays.leaves_of(self._schema(path)) if unit}

    def enumerators(self, path: str) -> dict[int, str]:
        """The names of the values of an enum, or of an array of enums."""
        member, field = self._split(path)
        schema = arrays.part_of(self._schema(member), field).schema
        while hasattr(schema, "element"):
            schema = schema.element
        if not isinstance(schema, Enum):
            raise Invalid(f"{path} is not an enum, but {schema.type_name}")
        return {number: name for name, number in schema.values.items()}

    def _add(self, channel: mcap.Channel) -> None:
        path = channel.metadata.get("tendon.path", "")
        text = channel.metadata.get("tendon.schema", "")
        if not text:
            self._add_foreign(channel)
            return
        try:
            schema: Schema | None = parse(text)
        except Invalid as why:
            self._file.tell(f"the type of {path or channel.topic} cannot be read: {why}")
            return
        member = _Member(path, channel, schema)
        kind = channel.metadata.get("tendon.kind", "")
        if kind not in ("column", "event", "command") or "." not in path:
            self._own.setdefault(channel.topic, []).append(member)
            return
        key = path.rpartition(".")[0] if kind == "column" else path
        runs = self._runs.setdefault(key, [])
        self._members[path] = key
        if not runs or not _belongs(member, runs[-1]):
            runs.append(_Run())
        runs[-1].members[path] = member

    def _paths_of(self, kind: str) -> list[str]:
        return sorted(path for path, runs in self._runs.items() if path in self._members
                      and runs[0].members[path].channel.metadata.get("tendon.kind") == kind)

    def _add_foreign(self, channel: mcap.Channel) -> None:
        """Adds a channel of another program."""
        definition = self._file.contents.schemas.get(channel.schema_id)
        encoding = definition.encoding if definition else ""
        if channel.encoding != "cdr" or definition is None or encoding != "ros2msg":
            schema = f"with a schema in '{encoding}'" if definition else "without a schema"
            self._leave_out(channel, f"their encoding is '{channel.encoding[:60]}' {schema}, and "
                                     "only 'cdr' with a schema in 'ros2msg' is read")
            return
        try:
            schema_of = parse_message(definition.name, definition.text)
        except Invalid as why:
            self._leave_out(channel, f"their type cannot be read: {why}")
            return
        topic = channel.topic
        if topic not in self._foreign and (topic in self._runs or topic in self._members):
            self._leave_out(channel, "the topic has the name of a table, an event or a command")
            return
        self._foreign.add(topic)
        self._members[topic] = topic
        run = _Run()
        run.members[topic] = _Member(topic, channel, schema_of)
        self._runs.setdefault(topic, []).append(run)

    def _leave_out(self, channel: mcap.Channel, why: str) -> None:
        count = self._file.contents.counts.get(channel.id)
        messages = "its messages are" if count is None else \
            "1 message is" if count == 1 else f"{count} messages are"
        self._left_out[channel.topic] = f"{messages} left out: {why}"

    def _split(self, path: str) -> tuple[str, str]:
        """The path of a column, an event or a command, and the field in it."""
        for topic in self._foreign:  # which may have any letters
            field = path.removeprefix(topic)
            if path.startswith(topic) and (not field or field[0] in ".["):
                steps_of(field)
                return topic, field
        dot = path.find(".")
        end = min((place for place in (path.find(".", dot + 1), path.find("[", dot + 1))
                   if place >= 0), default=len(path))
        member, field = path[:end], path[end:]
        steps_of(field)
        if dot < 0 or member not in self._members:
            raise self._unknown(path)
        return member, field

    def _unknown(self, path: str) -> NotFound:
        for topic, sentence in self._left_out.items():
            if path.startswith(topic):
                return NotFound(f"{topic} of {self._file.name} cannot be read: {sentence}")
        if path in self._runs:
            columns = ", ".join(sorted(one.rpartition(".")[2] for one, table
                                       in self._members.items() if table == path)[:8])
            return NotFound(f"{path} is a table: name a column of it, as in {path}.NAME; there is "
                            f"{columns}")
        member = path[:path.find(".") + 1] + path[path.find(".") + 1:].split(".")[0].split("[")[0]
        hint = did_you_mean(member, self._members) or "; to list all: paths()"
        return NotFound(f"{self._file.name} has no column, event or command '{path[:200]}'{hint}")

    def _schema(self, member: str) -> Schema:
        schemas = [run.members[member].schema for run in self._runs[self._members[member]]
                   if member in run.members]
        assert schemas[0] is not None
        if any(one != schemas[0] for one in schemas):
            raise Invalid(f"{member} has several types in {self._file.name}, because the "
                          "process was restarted with other code: split the file with gcm cut")
        return schemas[0]

    def _runs_of(self, path: str) -> list[_Run]:
        """The runs that have rows of a table, a column or an event."""
        if path in self._runs:
            self._load_rows(path)
            return self._runs[path]
        member, _ = self._split(path)
        self._load_rows(self._members[member])
        return [run for run in self._runs[self._members[member]] if member in run.members]

    def _heads(self, path: str) -> np.ndarray[Any, Any]:
        return np.concatenate([np.empty(0, mcap.MESSAGE_DTYPE),
                               *(self._run_heads(run) for run in self._runs_of(path))])

    @staticmethod
    def _run_heads(run: _Run) -> np.ndarray[Any, Any]:
        assert run.rows is not None
        return run.rows

    def _load_rows(self, key: str) -> None:
        """Finds the rows of a table or an event, once."""
        runs = self._runs[key]
        if runs[0].rows is not None:
            return
        heads: dict[int, list[np.ndarray[Any, Any]]] = {
            one.channel.id: [np.empty(0, mcap.MESSAGE_DTYPE)]
            for run in runs for one in run.members.values()}
        for messages in self._file.messages(heads):
            for channel, offsets in messages.offsets.items():
                heads[channel].append(mcap.heads(messages.data, offsets))
        for run in runs:
            self._assemble(key, run, {one.channel.id: np.concatenate(heads[one.channel.id])
                                      for one in run.members.values()})

    def _assemble(self, key: str, run: _Run, heads: dict[int, np.ndarray[Any, Any]]) -> None:
        """Finds the rows of one run. Leaves out rows that lack a column."""
        first = next(iter(heads.values()))
        run.rows = first
        if all(_same_rows(first, other) for other in heads.values()):
            return
        complete = set.intersection(*(set(_keys(other)) for other in heads.values()))
        run.is_partial = {channel for channel, other in heads.items()
                          if len(other) != len(complete)}
        most = max(map(len, heads.values()))
        run.rows = first[[one in complete for one in _keys(first)]]
        self._file.tell(f"{most - len(run.rows)} rows of {key} are left out, because a part of "
                        "each row is missing")

    def _decode(self, run: _Run, member: _Member, field: str) -> np.ndarray[Any, Any]:
        """The values of one column in one run."""
        assert member.schema is not None
        channel = member.channel.id
        complete = set(_keys(self._run_heads(run))) if channel in run.is_partial else None
        end = arrays.fixed_end(member.schema)
        is_fixed = end is not None and arrays.is_vectorised(member.schema, field)
        parts = []
        for messages in self._file.messages([channel]):
            offsets = messages.offsets[channel]
            heads = mcap.heads(messages.data, offsets)
            if complete is not None:
                chosen = [one in complete for one in _keys(heads)]
                offsets, heads = offsets[chosen], heads[chosen]
            sizes = heads["length"].astype(np.int64) - mcap.CONTENT_HEAD
            try:
                if is_fixed:
                    assert end is not None
                    bodies = _fixed_bodies(messages.data, offsets, sizes, end)
                    parts.append(arrays.decode_fixed(bodies, member.schema, field))
                else:
                    variable = list(_bodies(messages.data, offsets, sizes))
                    parts.append(arrays.decode_each(variable, member.schema, field))
            except NotFound:
                raise
            except Invalid as why:
                raise Invalid(f"{member.path} in {self._file.name}: {why}") from None
        if not parts:
            parts = [arrays.decode_each([], member.schema, field)]
        return np.concatenate(parts)

    def _keep(self, key: tuple[str, str], values: np.ndarray[Any, Any]) -> None:
        while self._cache and values.nbytes + sum(
                one.nbytes for one in self._cache.values()) > MOST_CACHED:
            del self._cache[next(iter(self._cache))]
        self._cache[key] = values

    def _own_values(self, topic: str) -> Iterable[tuple[int, Any]]:
        """Yields the time and the value of each message that the recorder itself wrote."""
        members = {one.channel.id: one for one in self._own.get(topic, [])}
        for messages in self._file.messages(members):
            for channel, offsets in messages.offsets.items():
                schema = members[channel].schema
                assert schema is not None
                heads = mcap.heads(messages.data, offsets)
                sizes = heads["length"].astype(np.int64) - mcap.CONTENT_HEAD
                try:
                    for time, body in zip(heads["log_time"].tolist(),
                                          _bodies(messages.data, offsets, sizes)):
                        yield time, schema.decode(body)
                except Error as why:
                    raise Invalid(f"{topic} in {self._file.name}: {why}") from None


def open_recording(file: str | Path) -> Recording:
    """Opens a recording of `gcm record`. The MCAP file may be damaged, cut off, or still being
    written.

    Damaged parts are left out. A warning tells of each, and Recording.problems lists them. Files
    that are compressed with zstd or lz4 need the module zstandard or lz4.

    Cost: reads the index of the file. If that is missing, reads the whole file once.
    """
    return Recording(file)


def _warn(sentence: str) -> None:
    warnings.warn(sentence, DamagedRecording, stacklevel=2)


def _belongs(member: _Member, run: _Run) -> bool:
    """True if the member is another column of the rows of this run."""
    if member.path in run.members:
        return False
    other = next(iter(run.members.values())).channel.metadata
    return all(other.get(key) == member.channel.metadata.get(key)
               for key in ("tendon.epoch", "tendon.clock_ns"))


def _clock_of(run: _Run) -> int:
    text = next(iter(run.members.values())).channel.metadata.get("tendon.clock_ns", "0")
    try:
        return int(np.int64(int(text)))
    except (ValueError, OverflowError):
        return 0


def _same_rows(heads: np.ndarray[Any, Any], other: np.ndarray[Any, Any]) -> bool:
    return np.array_equal(heads["sequence"], other["sequence"]) \
        and np.array_equal(heads["log_time"], other["log_time"])


def _keys(heads: np.ndarray[Any, Any]) -> Iterable[tuple[int, int]]:
    return zip(heads["sequence"].tolist(), heads["log_time"].tolist())


def _continued(sequences: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Extends numbers of 32 bits, which overflow, to numbers of 64 bits, which do not."""
    if not len(sequences):
        return np.empty(0, np.uint64)
    steps = np.diff(sequences).astype(np.uint32).view(np.int32).astype(np.int64)
    return (int(sequences[0]) + np.concatenate([[0], np.cumsum(steps)])).astype(np.uint64)


def _fixed_bodies(data: memoryview, offsets: np.ndarray[Any, Any], sizes: np.ndarray[Any, Any],
                  end: int) -> np.ndarray[Any, Any]:
    """The bodies of values of one fixed size, as the rows of an array. Padding may follow each
    body."""
    body_sizes = sizes - len(ENCAPSULATION)
    if (body_sizes < end).any() or (body_sizes > end + -end % 8).any():
        raise Invalid(f"a value does not have the {end} bytes of its type")
    messages = mcap.take(data, offsets + mcap.MESSAGE_HEAD.size, len(ENCAPSULATION) + end)
    if len(messages) and (messages[:, :2] != list(ENCAPSULATION[:2])).any():
        raise Invalid("a value is not little-endian CDR")
    return messages[:, len(ENCAPSULATION):]


def _bodies(data: memoryview, offsets: np.ndarray[Any, Any],
            sizes: np.ndarray[Any, Any]) -> Iterable[bytes]:
    for offset, size in zip((offsets + mcap.MESSAGE_HEAD.size).tolist(), sizes.tolist()):
        message = bytes(data[offset:offset + size])
        if message[:2] != ENCAPSULATION[:2] or len(message) != size:
            raise Invalid("a value is not little-endian CDR")
        yield message[len(ENCAPSULATION):]
