"""The rows of a state table, as they arrive."""

from __future__ import annotations

import struct
import threading
import weakref
from collections import deque
from dataclasses import dataclass
from typing import Any, Iterator, NamedTuple

from . import messages
from .errors import Error, Invalid, TimedOut
from .messages import MessageType
from .middleware.frame import Header
from .middleware.link import Link
from .paths import select
from .payload.schema import Schema

MOST_WAITING = 32 << 20  # bytes of rows that wait in a Feed; one batch may be larger

_HEADER_SIZE = messages.SCHEMAS["tendon.RowsHeader"].minimum_size
_STAMP = struct.Struct("<Qq")  # tick, time
_REFERENCE = struct.Struct("<II")  # offset, size


@dataclass(frozen=True)
class Row:
    """One row; `row["Joints"]` is the value of one column."""

    tick: int
    """The number of the row. A gap between two rows means lost rows."""
    time: int
    """When the row was written, in ns on the clock of its process."""
    values: dict[str, Any]
    """The values by column, as named in the request; None if the row has no value."""

    def __getitem__(self, column: str) -> Any:
        return self.values[column]


class Column(NamedTuple):
    """A requested column, or a field of it: "Joints.position[0]" has `field` ".position[0]"."""

    asked: str
    index: int
    field: str


class Batch(NamedTuple):
    """A body of ROWS in the layout of core/tendon/process/viewer_messages.h."""

    body: bytes
    rows_before: int
    lost_table: int
    rows: int
    sizes: tuple[int, ...]

    @classmethod
    def open(cls, body: bytes) -> Batch:
        """Reads the header of a body. Raises Invalid if the sizes do not fit the body."""
        header = messages.decode("RowsHeader", body[:_HEADER_SIZE])
        columns = header["columns"]
        if columns > (len(body) - _HEADER_SIZE) // 4:
            raise Invalid("the rows have more columns than bytes")
        sizes = struct.unpack_from(f"<{columns}I", body, _HEADER_SIZE)
        batch = cls(body, header["rows_before"], header["lost_table"], header["rows"], sizes)
        if batch.rows > (len(body) - batch._first_row) // batch._row_size:
            raise Invalid("there are more rows than bytes")
        return batch

    def cells(self) -> Iterator[tuple[int, int, list[bytes]]]:
        """Yields the tick and the time of each row, with the body of each column's value."""
        place = self._first_row
        for _ in range(self.rows):
            tick, time = _STAMP.unpack_from(self.body, place)
            place += _STAMP.size
            cells = []
            for size in self.sizes:
                cells.append(self._cell(place, size))
                place += _padded(size) if size else _REFERENCE.size
            yield tick, time, cells

    def _cell(self, place: int, size: int) -> bytes:
        if size:
            return self.body[place:place + size]
        offset, size = _REFERENCE.unpack_from(self.body, place)
        if offset > len(self.body) or size > len(self.body) - offset:
            raise Invalid("a row refers to bytes that do not exist")
        return self.body[offset:offset + size]

    @property
    def _first_row(self) -> int:
        return _padded(_HEADER_SIZE + 4 * len(self.sizes))

    @property
    def _row_size(self) -> int:
        return _STAMP.size + sum(_padded(size) if size else _REFERENCE.size for size in self.sizes)


class Feed:
    """A queue of batches from the thread of Ice to the thread that reads the rows."""

    def __init__(self) -> None:
        self.lost_table = 0  # rows
        self.lost_network = 0
        self.lost_viewer = 0
        self._sent = 0  # rows that the peer has sent, as its batches say
        self._change = threading.Condition()
        self._queue: deque[Batch | Error | None] = deque()
        self._waiting = 0  # bytes

    def add(self, body: bytes) -> None:
        """Adds the body of a batch. Called in a thread of Ice."""
        try:
            batch = Batch.open(body)
        except Invalid as why:
            self.end(why)
            return
        self.lost_table += batch.lost_table
        self.lost_network += max(0, batch.rows_before - self._sent)
        self._sent = batch.rows_before + batch.rows
        with self._change:
            while self._waiting + len(body) > MOST_WAITING and self._drop_oldest():
                pass
            self._waiting += len(body)
            self._queue.append(batch)
            self._change.notify()

    def end(self, reason: Error) -> None:
        """Adds the reason why no more rows come."""
        self._put(reason)

    def wake(self) -> None:
        """Ends take() in another thread; it returns None."""
        self._put(None)

    def take(self, timeout: float | None) -> Batch | Error | None:
        """The next batch; None if there is none within `timeout` seconds, or after wake()."""
        with self._change:
            if not self._change.wait_for(lambda: self._queue, timeout):
                return None
            batch = self._queue.popleft()
            if isinstance(batch, Batch):
                self._waiting -= len(batch.body)
            return batch

    def _put(self, last: Error | None) -> None:
        with self._change:
            self._queue.append(last)
            self._change.notify()

    def _drop_oldest(self) -> bool:
        """Called with the lock held. Returns False if no rows wait."""
        if not self._queue or not isinstance(self._queue[0], Batch):
            return False
        oldest = self._queue.popleft()
        self._waiting -= len(oldest.body)
        self.lost_viewer += oldest.rows
        return True


class Feeds:
    """The subscriptions of one link, by their handles, which the peer has given."""

    def __init__(self) -> None:
        self._feeds: dict[int, Feed] = {}

    def add(self, handle: int, feed: Feed) -> None:
        """Called in a thread of Ice, before the first row arrives."""
        self._feeds[handle] = feed

    def remove(self, handle: int) -> None:
        """Removes a subscription, and ends take() of its feed in another thread."""
        feed = self._feeds.pop(handle, None)
        if feed is not None:
            feed.wake()

    def on_notice(self, header: Header, body: bytes) -> None:
        """Called by the link."""
        feed = self._feeds.get(header.handle)
        if feed is None:
            return
        if header.type == MessageType.ROWS:
            feed.add(body)
        elif header.type == MessageType.ROWS_ENDED:
            feed.end(messages.read_refusal(body, "the process"))

    def on_closed(self, reason: Error) -> None:
        """Called by the link."""
        for feed in list(self._feeds.values()):
            feed.end(reason)


class Watch:
    """Iterates over the rows of a state table from now on. Raises the reason if no more rows can
    come. The subscription ends with close(), with the end of a `with` block, or with the object."""

    def __init__(self, link: Link, feeds: Feeds, handle: int, feed: Feed,
                 schemas: list[Schema], columns: list[Column], timeout: float | None) -> None:
        self._feed = feed
        self._schemas = schemas
        self._columns = columns
        self._timeout = timeout
        self._rows: Iterator[tuple[int, int, list[bytes]]] = iter(())
        self._ending = weakref.finalize(self, _unsubscribe, link, feeds, handle)

    @property
    def lost_table(self) -> int:
        """Rows that were overwritten before they could be sent."""
        return self._feed.lost_table

    @property
    def lost_network(self) -> int:
        """Rows that were lost on the network."""
        return self._feed.lost_network

    @property
    def lost_viewer(self) -> int:
        """Rows that this program did not read in time, and that newer rows replaced."""
        return self._feed.lost_viewer

    def close(self) -> None:
        """Ends the subscription. The loop over the rows ends."""
        self._ending()

    def __enter__(self) -> Watch:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def __iter__(self) -> Watch:
        return self

    def __next__(self) -> Row:
        while self._ending.alive:
            for tick, time, cells in self._rows:
                return Row(tick, time, self._values(cells))
            self._next_batch()
        raise StopIteration

    def _next_batch(self) -> None:
        batch = self._feed.take(self._timeout)
        if batch is None:
            if not self._ending.alive:
                return  # closed in another thread
            raise TimedOut(f"no row within {self._timeout:g} s; does the component run?")
        if isinstance(batch, Error):
            self._feed.end(batch)  # the next call raises it again
            raise batch
        if len(batch.sizes) != len(self._schemas):
            raise Invalid("the rows do not have the requested number of columns")
        self._rows = batch.cells()

    def _values(self, cells: list[bytes]) -> dict[str, Any]:
        whole: dict[int, Any] = {}
        values: dict[str, Any] = {}
        for column in self._columns:
            cell = cells[column.index]
            if not cell:
                values[column.asked] = None
                continue
            if column.index not in whole:
                whole[column.index] = self._schemas[column.index].decode(cell)
            values[column.asked] = select(whole[column.index], column.field)
        return values


def _unsubscribe(link: Link, feeds: Feeds, handle: int) -> None:
    feeds.remove(handle)
    try:
        link.notify(MessageType.UNSUBSCRIBE, handle)
    except Error:
        pass  # the link is gone, and with it the subscription


def _padded(size: int) -> int:
    return size + -size % 8
