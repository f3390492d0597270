"""Frames, whole and in pieces."""
import struct
import unittest

from tendon import Invalid
from tendon.middleware.frame import (HEADER_SIZE, MAGIC, MAX_FRAME_SIZE, MAX_STRANGERS_FRAME_SIZE,
                                     PROTOCOL_VERSION, Header, Pieces, claimed_size, read_frame,
                                     write_frame)

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


if __name__ == "__main__":
    unittest.main()
