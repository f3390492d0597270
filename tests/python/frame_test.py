"""Frames, whole and in pieces."""
import struct
import unittest

from tendon import Invalid
from tendon.middleware.frame import (HEADER_SIZE, MAGIC, MAX_FRAME_SIZE, MAX_STRANGERS_FRAME_SIZE,
                                     MAX_REPLIES, MAX_REPLIES_SIZE, PROTOCOL_VERSION, Header,
                                     Pieces, claimed_size, read_frame, read_replies, write_frame)

HEADER = Header(type=0x201, request=5, handle=9)
FRAME = write_frame(HEADER, b"body")


class Frame(unittest.TestCase):
    def test_has_the_bytes_of_the_protocol(self):
        self.assertEqual(FRAME, b"TNDN" + struct.pack("<HHQII", PROTOCOL_VERSION, 0x201, 5, 4, 9)
                         + b"body")
        self.assertEqual(read_frame(FRAME), (HEADER, b"body"))

    def test_of_another_size_than_it_claims_is_none(self):
        for frame in (b"", FRAME[:HEADER_SIZE - 1], FRAME[:-1], FRAME + b"\0",
                      b"TNDM" + FRAME[4:]):
            with self.subTest(frame=frame):
                self.assertIsNone(read_frame(frame))

    def test_claims_no_more_than_a_frame_may_have(self):
        def claiming(size):
            return claimed_size(struct.pack("<IHHQII", MAGIC, 3, 1, 0, size, 0))

        self.assertEqual(claiming(MAX_FRAME_SIZE - HEADER_SIZE), MAX_FRAME_SIZE)
        self.assertIsNone(claiming(MAX_FRAME_SIZE - HEADER_SIZE + 1))


class InPieces(unittest.TestCase):
    def test_a_frame_is_put_together(self):
        whole = Pieces()
        self.assertIsNone(whole.add(FRAME[:25], is_end=False))
        self.assertIsNone(whole.add(FRAME[25:27], is_end=False))
        self.assertEqual(whole.add(FRAME[27:], is_end=True), (HEADER, b"body"))
        self.assertEqual(whole.add(FRAME, is_end=True), (HEADER, b"body"))

    def test_a_stranger_may_send_little(self):
        large = write_frame(HEADER, bytes(MAX_STRANGERS_FRAME_SIZE))
        for pieces in ([(large, True)], [(large[:25], False)]):
            stranger = Pieces()
            with self.subTest(pieces=len(pieces)), self.assertRaises(Invalid):
                for data, is_end in pieces:
                    stranger.add(data, is_end)
        known = Pieces()
        known.limit = MAX_FRAME_SIZE
        self.assertEqual(known.add(large, is_end=True), read_frame(large))

    def test_what_is_no_piece_is_refused(self):
        for pieces in ([(b"nonsense" * 4, False)], [(FRAME[:10], False)], [(FRAME + b"\0", False)],
                       [(FRAME[:25], False), (FRAME[25:] + b"\0", True)],
                       [(FRAME[:25], False), (b"", True)], [(FRAME[:-1], True)]):
            whole = Pieces()
            with self.subTest(pieces=pieces), self.assertRaises(Invalid):
                for data, is_end in pieces:
                    whole.add(data, is_end)


def batch(*replies):
    """A batch of answers, each with its request and the size that it claims to have."""
    return b"".join(struct.pack("<QI", request, size) + answer
                    for request, size, answer in replies)


class Replies(unittest.TestCase):
    def test_come_in_order(self):
        self.assertEqual(read_replies(batch((7, 2, b"ab"), (2**64 - 1, 0, b""), (1, 1, b"c"))),
                         [(7, b"ab"), (2**64 - 1, b""), (1, b"c")])
        self.assertEqual(len(read_replies(batch((1, 0, b"")) * MAX_REPLIES)), MAX_REPLIES)

    def test_that_are_malformed_are_refused(self):
        whole = batch((7, 2, b"ab"), (8, 3, b"def"))
        too_many = batch((1, 0, b"")) * (MAX_REPLIES + 1)
        too_large = batch((1, MAX_REPLIES_SIZE, bytes(MAX_REPLIES_SIZE)))
        for body in (b"", whole[:-1], whole + b"\0", whole[:11], batch((7, 2**32 - 1, b"ab")),
                     too_many, too_large):
            with self.subTest(body=body[:40]), self.assertRaises(Invalid):
                read_replies(body)


if __name__ == "__main__":
    unittest.main()
