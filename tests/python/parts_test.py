"""Tests frames that are sent in parts."""
import threading
import unittest

from tendon import Invalid, TimedOut, Unreachable, messages
from tendon.messages import MessageType
from tendon.middleware.frame import HEADER_SIZE, MAX_BODY_SIZE, Header, read_frame, write_frame
from tendon.middleware.parts import (LEAST_PART_SIZE, MAX_PART_SIZE, PART_SIZE, PARTS_AHEAD,
                                     PartAssembly, PartSender)

TIMEOUT = 60  # s, for a machine that is busy
BODY = bytes(range(256)) * 4096
FRAME = write_frame(Header(0x201, 5), BODY)
PARTS = [FRAME[start:start + PART_SIZE] for start in range(0, len(FRAME), PART_SIZE)]


def header_of(body_size):
    """The header of a frame with a body of this size, without the body."""
    return write_frame(Header(0x201), b"")[:16] + body_size.to_bytes(4, "little") + bytes(4)


class Assembly(unittest.TestCase):
    def test_frames_are_assembled_side_by_side(self):
        assembly = PartAssembly()
        for part in PARTS[:-1]:
            self.assertIsNone(assembly.add(1, part))
            self.assertIsNone(assembly.add(2, part))
        for number in (1, 2):
            self.assertEqual(assembly.add(number, PARTS[-1]), (Header(0x201, 5), BODY))
        self.assertEqual(assembly.taken, 2 * len(FRAME))

    def test_parts_of_any_allowed_size_are_assembled(self):
        assembly = PartAssembly()
        self.assertIsNone(assembly.add(1, FRAME[:MAX_PART_SIZE]))
        end = MAX_PART_SIZE + LEAST_PART_SIZE
        self.assertIsNone(assembly.add(1, FRAME[MAX_PART_SIZE:end]))
        rest = FRAME[end:]
        for start in range(0, len(rest), MAX_PART_SIZE):
            whole = assembly.add(1, rest[start:start + MAX_PART_SIZE])
        self.assertEqual(whole, (Header(0x201, 5), BODY))

    def test_malformed_parts_are_rejected(self):
        for parts in ([b"nonsense" * PART_SIZE], [FRAME[:LEAST_PART_SIZE - 1]],
                      [FRAME[:MAX_PART_SIZE + 1]], [PARTS[0], b""], [*PARTS[:-1], PARTS[-1] + b"\0"],
                      [header_of(MAX_BODY_SIZE + 1) + bytes(PART_SIZE - HEADER_SIZE)]):
            assembly = PartAssembly()
            with self.subTest(sizes=list(map(len, parts))), self.assertRaises(Invalid):
                for part in parts:
                    assembly.add(1, part)

    def test_memory_is_limited_to_the_senders_window(self):
        assembly = PartAssembly()
        first = header_of(MAX_BODY_SIZE) + bytes(PART_SIZE - HEADER_SIZE)
        assembly.add(1, first)
        with self.assertRaises(Invalid):
            assembly.add(2, first)


class Sender(unittest.TestCase):
    def setUp(self):
        self.sent = []
        self.sender = PartSender(self.sent.append)

    def take(self):
        """Acknowledges all bytes that were sent."""
        taken = sum(len(frame) - HEADER_SIZE for frame in self.sent)
        self.sender.on_taken(messages.encode("PartsTaken", taken))

    def test_a_frame_is_sent_in_parts(self):
        for number in (1, 2):
            self.sent.clear()
            self.sender.send(FRAME, TIMEOUT)
            self.assertEqual([read_frame(frame) for frame in self.sent],
                             [(Header(MessageType.PART, 0, number), part) for part in PARTS])
            if number == 1:
                self.take()

    def test_sending_stops_at_the_window(self):
        with self.assertRaisesRegex(TimedOut, "reads too slowly"):
            self.sender.send(FRAME + bytes(2 * PARTS_AHEAD), 0.01)
        ahead = sum(len(frame) - HEADER_SIZE for frame in self.sent)
        self.assertLess(ahead, PARTS_AHEAD + PART_SIZE)

    def test_sending_continues_after_an_acknowledgement(self):
        sender = PartSender(lambda frame: (self.sent.append(frame), self.take()))
        self.sender = sender
        sender.send(FRAME + bytes(8 * PARTS_AHEAD), 0)
        self.assertGreater(len(self.sent), 8)

    def test_closing_wakes_a_waiting_sender(self):
        thread = threading.Timer(0.01, lambda: self.sender.close(Unreachable("gone")))
        thread.start()
        with self.assertRaisesRegex(Unreachable, "^gone$"):
            self.sender.send(FRAME + bytes(2 * PARTS_AHEAD), TIMEOUT)
        thread.join()

    def test_false_acknowledgements_are_rejected(self):
        self.sender.send(FRAME, TIMEOUT)
        self.take()
        for taken in (len(FRAME) + 1, len(FRAME) - 1):
            with self.subTest(taken=taken), self.assertRaises(Invalid):
                self.sender.on_taken(messages.encode("PartsTaken", taken))


if __name__ == "__main__":
    unittest.main()
