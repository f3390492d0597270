"""Tests batches of rows of a state table."""
import struct
import threading
import unittest

from tendon import Failed, Invalid, TimedOut, messages
from tendon.messages import MessageType
from tendon.middleware.frame import Header
from tendon.payload.schema_text import parse
from tendon.rows import MOST_WAITING, Batch, Column, Feed, Feeds, Watch

TIMEOUT = 60  # s, for a machine that is busy

# A column of numbers, whose cells have one size, and a column of texts, whose cells differ in size.
SCHEMAS = [parse("float64"), parse("string")]
COLUMNS = [Column("Speed", 0, ""), Column("Name", 1, "")]


def body_of(rows_before, rows, lost_table=0):
    """The body of a batch, in the form of core/tendon/process/telemetry. A row is (tick, time, number,
    text or None)."""
    head = struct.pack("<QQQII", rows_before, lost_table, 0, len(rows), 2)
    head += struct.pack("<II", 8, 0)
    start = len(head) + len(rows) * 32
    fixed = loose = b""
    for tick, time, number, text in rows:
        cell = b"" if text is None else SCHEMAS[1].encode(text)
        fixed += struct.pack("<QqdII", tick, time, number, start + len(loose), len(cell))
        loose += cell + bytes(-len(cell) % 8)
    return head + fixed + loose


class FakeLink:
    def __init__(self):
        self.notices = []

    def notify(self, message_type, handle):
        self.notices.append((message_type, handle))


class Rows(unittest.TestCase):
    def setUp(self):
        self.link = FakeLink()
        self.feeds = Feeds()
        self.feed = Feed()
        self.feeds.add(7, self.feed)
        self.watch = Watch(self.link, self.feeds, 7, self.feed, SCHEMAS, COLUMNS, 0.01)

    def hear(self, body, message_type=MessageType.ROWS, handle=7):
        self.feeds.on_notice(Header(message_type, handle=handle), body)

    def test_arrive_in_order_with_their_values(self):
        self.hear(body_of(0, [(5, 100, 0.5, "one"), (6, -200, 1.5, "a longer one")]))
        self.hear(body_of(2, [(7, 300, 2.5, None)]))

        rows = [next(self.watch) for _ in range(3)]

        self.assertEqual([(row.tick, row.time, row["Speed"], row["Name"]) for row in rows],
                         [(5, 100, 0.5, "one"), (6, -200, 1.5, "a longer one"),
                          (7, 300, 2.5, None)])

    def test_lost_rows_are_counted_by_place(self):
        self.hear(body_of(0, [(1, 0, 0, "")], lost_table=3))
        self.hear(body_of(5, [(6, 0, 0, "")]))

        self.assertEqual((self.watch.lost_table, self.watch.lost_network), (3, 4))

    def test_unread_rows_are_dropped_and_counted(self):
        def body(count):
            return body_of(count, [(count, 0, 0, "x" * (1 << 20))])

        for count in range(40):
            self.hear(body(count))

        kept = MOST_WAITING // len(body(0))
        self.assertEqual(self.watch.lost_viewer, 40 - kept)
        self.assertEqual(self.watch.lost_network, 0)
        taken = [next(self.watch).tick for _ in range(kept)]
        self.assertEqual(taken, list(range(40 - kept, 40)), "the oldest made room")
        self.hear(body(40))
        self.assertEqual(next(self.watch).tick, 40)

    def test_a_row_larger_than_the_limit_is_kept(self):
        self.hear(body_of(0, [(1, 0, 0, "x" * (MOST_WAITING + 1))]))
        self.assertEqual(next(self.watch).tick, 1)
        self.assertEqual(self.watch.lost_viewer, 0)

    def test_waiting_for_a_row_times_out(self):
        with self.assertRaisesRegex(TimedOut, "no row within 0.01 s"):
            next(self.watch)

    def test_the_watch_ends_with_a_reason_after_the_last_row(self):
        self.hear(body_of(0, [(1, 0, 0, "")]))
        self.hear(messages.encode("Error", {"code": "FAILED", "message": "removed"}),
                  MessageType.ROWS_ENDED)

        self.assertEqual(next(self.watch).tick, 1)
        for _ in range(2):
            with self.assertRaisesRegex(Failed, "^removed$"):
                next(self.watch)

    def test_rows_of_other_watches_are_ignored(self):
        self.hear(body_of(0, [(1, 0, 0, "")]), handle=8)
        with self.assertRaises(TimedOut):
            next(self.watch)

    def test_closing_unsubscribes_once(self):
        with self.watch:
            pass
        self.watch.close()
        self.assertEqual(self.link.notices, [(MessageType.UNSUBSCRIBE, 7)])
        self.assertEqual(list(self.watch), [])
        self.hear(body_of(0, [(1, 0, 0, "")]))
        self.assertIsNone(self.feed.take(0))

    def test_closing_wakes_a_waiting_thread(self):
        endless = Watch(self.link, self.feeds, 7, self.feed, SCHEMAS, COLUMNS, None)
        is_waiting, rows = threading.Event(), []

        def take():
            for row in endless:
                rows.append(row.tick)
                is_waiting.set()

        thread = threading.Thread(target=take, daemon=True)
        thread.start()
        self.hear(body_of(0, [(1, 0, 0, "")]))
        self.assertTrue(is_waiting.wait(TIMEOUT))
        endless.close()
        thread.join(TIMEOUT)

        self.assertFalse(thread.is_alive())
        self.assertEqual(rows, [1])

    def test_a_dropped_watch_is_closed(self):
        del self.watch
        self.assertEqual(self.link.notices, [(MessageType.UNSUBSCRIBE, 7)])

    def test_one_field_of_a_column_can_be_watched(self):
        schema = parse("struct t.T {\n  p: float64[2]\n}")
        columns = [Column("J.p[1]", 0, ".p[1]"), Column("J", 0, "")]
        watch = Watch(self.link, self.feeds, 7, self.feed, [schema], columns, 0.01)
        self.hear(struct.pack("<QQQIIIxxxxQqdd", 0, 0, 0, 1, 1, 16, 9, 9, 0.5, 1.5))
        self.assertEqual(next(watch).values, {"J.p[1]": 1.5, "J": {"p": [0.5, 1.5]}})


class MalformedBatch(unittest.TestCase):
    BODY = body_of(0, [(5, 100, 0.5, "one"), (6, 200, 1.5, "two")])

    def test_a_truncated_batch_is_rejected(self):
        for size in range(len(self.BODY)):
            with self.subTest(size=size), self.assertRaises(Invalid):
                cells = list(Batch.open(self.BODY[:size]).cells())
                for cell in (cells[0][2][1], cells[1][2][1]):
                    SCHEMAS[1].decode(cell)

    def test_an_oversized_claim_is_rejected(self):
        for place, size in ((24, 4), (28, 4), (32, 4), (64, 4), (68, 4)):
            body = bytearray(self.BODY)
            body[place:place + size] = b"\xff" * size
            with self.subTest(place=place), self.assertRaises(Invalid):
                for _ in Batch.open(bytes(body)).cells():
                    pass

    def test_ends_the_watch(self):
        feed = Feed()
        feed.add(b"nonsense")
        self.assertIsInstance(feed.take(0), Invalid)


if __name__ == "__main__":
    unittest.main()
