"""Tests writing and reading of frames."""
import struct
import unittest

from tendon import Invalid
from tendon.middleware.frame import (HEADER_SIZE, MAGIC, MAX_PIECE_SIZE, MAX_REPLIES,
                                     MAX_REPLIES_SIZE, MAX_UNAUTHENTICATED_FRAME_SIZE, PROTOCOL_VERSION,
                                     Header, claimed_size, read_frame, read_replies, write_frame)

HEADER = Header(type=0x201, request=5, handle=9)
FRAME = write_frame(HEADER, b"body")


class Frame(unittest.TestCase):
    def test_matches_the_wire_format(self):
        self.assertEqual(FRAME, b"TNDN" + struct.pack("<HHQII", PROTOCOL_VERSION, 0x201, 5, 4, 9)
                         + b"body")
        self.assertEqual(read_frame(FRAME), (HEADER, b"body"))

    def test_a_wrong_size_or_magic_is_rejected(self):
        for frame in (b"", FRAME[:HEADER_SIZE - 1], FRAME[:-1], FRAME + b"\0",
                      b"TNDM" + FRAME[4:]):
            with self.subTest(frame=frame):
                self.assertIsNone(read_frame(frame))

    def test_an_oversized_claim_is_rejected(self):
        def claiming(size):
            return claimed_size(struct.pack("<IHHQII", MAGIC, 3, 1, 0, size, 0))

        self.assertEqual(claiming(MAX_PIECE_SIZE - HEADER_SIZE), MAX_PIECE_SIZE)
        self.assertIsNone(claiming(MAX_PIECE_SIZE - HEADER_SIZE + 1))

    def test_an_unauthenticated_frame_has_a_small_limit(self):
        large = write_frame(HEADER, bytes(MAX_UNAUTHENTICATED_FRAME_SIZE))
        self.assertIsNone(read_frame(large, MAX_UNAUTHENTICATED_FRAME_SIZE))
        self.assertIsNotNone(read_frame(large))


def batch(*replies):
    """A batch of answers. Each has the number of its request and the size that it claims."""
    return b"".join(struct.pack("<QI", request, size) + answer
                    for request, size, answer in replies)


class Replies(unittest.TestCase):
    def test_are_read_in_order(self):
        self.assertEqual(read_replies(batch((7, 2, b"ab"), (2**64 - 1, 0, b""), (1, 1, b"c"))),
                         [(7, b"ab"), (2**64 - 1, b""), (1, b"c")])
        self.assertEqual(len(read_replies(batch((1, 0, b"")) * MAX_REPLIES)), MAX_REPLIES)

    def test_malformed_batches_are_rejected(self):
        whole = batch((7, 2, b"ab"), (8, 3, b"def"))
        too_many = batch((1, 0, b"")) * (MAX_REPLIES + 1)
        too_large = batch((1, MAX_REPLIES_SIZE, bytes(MAX_REPLIES_SIZE)))
        for body in (b"", whole[:-1], whole + b"\0", whole[:11], batch((7, 2**32 - 1, b"ab")),
                     too_many, too_large):
            with self.subTest(body=body[:40]), self.assertRaises(Invalid):
                read_replies(body)


if __name__ == "__main__":
    unittest.main()
