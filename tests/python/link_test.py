"""Tests a link over Ice. The acceptor is written here, from only the contract and the messages of the package."""
import contextlib
import os
import pathlib
import struct
import tempfile
import threading
import time
import unittest

import Ice

from tendon import Denied, Failed, Incompatible, Invalid, TimedOut, Unreachable, messages
from tendon.messages import MessageType
from tendon.middleware.address import parse_address
from tendon.middleware.frame import (HEADER_SIZE, MAX_BODY_SIZE, MAX_PIECE_SIZE, PROTOCOL_VERSION,
                                     Header, read_frame, write_frame)
from tendon.middleware.handshake import ACCEPTOR, Opener
from tendon.middleware.ice import Network, only_parameter
from tendon.middleware.link import Link
from tendon.paths import Path
from tendon.processes import Processes

TIMEOUT = 60  # s, for a machine that is busy
COOKIE = 0x1f
IDENTITY = Ice.Identity("tendon", "")
ECHO, REFUSE, IGNORE, TELL, HANG_UP, TALK_NONSENSE, TALK_NO_ICE, GATHER = range(0x1000, 0x1008)

# Parameters of `frame` that claim more bytes than they have. Some of them crash the code that Ice generates.
NO_ICE = [b"", b"\x06\0\0\0\x01\x01", b"\x07\0\0\0\x01\x01\x05",
          b"\x0b\0\0\0\x01\x01\xff\xff\xff\xff\x7f", b"\x0b\0\0\0\x01\x01\xff\0\0\0\x80",
          b"\xff\xff\xff\x7f\x01\x01\x01\x05", b"\x01\0\0\0\x01\x01\x01\x05"]


class Acceptor(Ice.openModule("tendon").Endpoint):
    """The acceptor of the tests. Answers each request according to its type: ECHO, REFUSE and so on."""

    def __init__(self, cookie=COOKIE):
        self.cookie = cookie
        self.is_mute = False
        self.is_impostor = False
        self.version = PROTOCOL_VERSION
        self.versions = set()  # protocol versions of the received frames
        self.heard = []
        self.is_greeted = threading.Event()
        self.begun = bytearray()
        self.gathered = b""
        self.taken = self.told_taken = 0
        self.communicator = Ice.initialize()
        adapter = self.communicator.createObjectAdapterWithEndpoints("a", "tcp -h 127.0.0.1 -p 0")
        adapter.add(self, IDENTITY)
        adapter.activate()
        self.address = f"127.0.0.1:{adapter.getEndpoints()[0].getInfo().port}"

    def frame(self, frame, current=None):
        header, body = read_frame(frame)
        self.heard.append(header.type)
        self.versions.add(header.version)
        self.is_greeted.set()
        peer = Ice.openModule("tendon").EndpointPrx.uncheckedCast(
            current.con.createProxy(IDENTITY).ice_oneway())

        def send(message_type, answer, request=None, handle=0):
            request = header.request if request is None else request
            whole = write_frame(Header(message_type, request, handle, self.version), answer)
            if len(whole) <= MAX_PIECE_SIZE:
                peer.frame(whole)
                return
            size = MAX_PIECE_SIZE - HEADER_SIZE
            for start in range(0, len(whole), size):
                peer.frame(write_frame(Header(MessageType.PART, 0, 9, self.version), whole[start:start + size]))

        if header.type == MessageType.PART:
            self.begun += body
            self.taken += len(body)
            send(MessageType.PARTS_TAKEN, self.taken.to_bytes(8, "little"), request=0)
            whole = read_frame(bytes(self.begun), HEADER_SIZE + MAX_BODY_SIZE)
            if whole is None:
                return
            self.begun.clear()
            header, body = whole
        if header.type == MessageType.HELLO and self.is_impostor:
            for message_type in (MessageType.WELCOME, MessageType.ROWS):
                send(message_type, b"\0", request=0)
        elif header.type == MessageType.HELLO and not self.is_mute:
            send(MessageType.CHALLENGE, self.challenge(messages.decode("Greeting", body)))
        elif header.type == MessageType.PROOF:
            send(MessageType.WELCOME, b"\0")
        elif header.type == ECHO:
            send(MessageType.REPLY, body)
        elif header.type == GATHER:  # sends all answers in one message after a request with a body
            self.gathered += struct.pack("<QI", header.request, len(body)) + body
            if body:
                send(MessageType.REPLIES, self.gathered, request=0)
        elif header.type == REFUSE:
            send(MessageType.REFUSAL, messages.encode("Error", {"code": "FAILED", "message": "no"}))
        elif header.type == TELL:
            send(MessageType.REPLY, body)
            for handle in range(100):
                send(MessageType.ROWS, b"", request=0, handle=handle)
        elif header.type == MessageType.PARTS_TAKEN:
            self.told_taken = int.from_bytes(body, "little")
        elif header.type == HANG_UP:
            current.con.close(Ice.ConnectionClose.Forcefully)
        elif header.type == TALK_NO_ICE:
            peer.ice_invoke("frame", Ice.OperationMode.Normal, NO_ICE[body[0]])
            send(MessageType.REPLY, b"")
        elif header.type == TALK_NONSENSE:
            peer.frame(body)

    def challenge(self, opener):
        greeting = {"instance": 42, "name": "acceptor", "nonce": bytes(16)}
        prover = Opener("", self.address, self.cookie)
        prover._mine = opener  # pylint: disable=protected-access
        proof = prover._proof(ACCEPTOR, greeting)  # pylint: disable=protected-access
        return messages.encode("Challenge", {"greeting": greeting, "proof": proof})


class Parameters(unittest.TestCase):
    def test_hold_one_byte_sequence(self):
        for size in (0, 1, 254, 255, 256, 70000):
            data = bytes(size)
            prefix = bytes([size]) if size < 255 else b"\xff" + size.to_bytes(4, "little")
            total = (6 + len(prefix) + size).to_bytes(4, "little")
            with self.subTest(size=size):
                self.assertEqual(only_parameter(total + b"\1\1" + prefix + data), data)

    def test_malformed_parameters_are_rejected(self):
        for parameters in [*NO_ICE, b"\x08\0\0\0\2\1\1a", b"\x08\0\0\0\1\2\1a",
                           b"\x09\0\0\0\1\1\1a", b"\x09\0\0\0\1\1\1ab"]:
            with self.subTest(parameters=parameters):
                self.assertIsNone(only_parameter(parameters))


class OverIce(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        os.environ["XDG_RUNTIME_DIR"] = folder.name
        cookie = pathlib.Path(folder.name) / "tendon" / "cookie"
        cookie.parent.mkdir()
        cookie.touch(mode=0o600)
        cookie.write_text(f"{COOKIE:x}", encoding="ascii")
        self.network = Network()
        self.addCleanup(self.network.close)
        self.acceptor = Acceptor()
        self.addCleanup(self.acceptor.communicator.destroy)
        self.notices = []
        self.closed = threading.Event()

    def link(self, timeout=TIMEOUT):
        return Link(self.network, parse_address(self.acceptor.address), "test", timeout,
                    lambda header, body: self.notices.append(header.handle),
                    lambda reason: self.closed.set())

    def test_a_request_is_answered(self):
        link = self.link()
        self.assertEqual((link.peer_name, link.peer_instance), ("acceptor", 42))
        self.assertEqual(link.request(ECHO, b"hello", TIMEOUT), b"hello")
        self.assertTrue(link.is_open)

    def test_all_frames_have_the_protocol_version(self):
        link = self.link()
        for size in (5, 3 * MAX_PIECE_SIZE):  # one frame, and a frame in parts
            self.assertEqual(link.request(ECHO, bytes(size), TIMEOUT), bytes(size))
        self.assertEqual(self.acceptor.versions, {PROTOCOL_VERSION})

    def test_another_protocol_version_is_rejected(self):
        self.acceptor.version = PROTOCOL_VERSION + 1
        with self.assertRaisesRegex(Incompatible, "speaks protocol version .*: update this program$"):
            self.link()
        self.assertNotIn(MessageType.PROOF, self.acceptor.heard)

    def test_a_refusal_raises_the_peers_message(self):
        with self.assertRaisesRegex(Failed, "^no$"):
            self.link().request(REFUSE, b"", TIMEOUT)

    def test_large_frames_are_sent_in_parts(self):
        link = self.link()
        for _ in range(2):
            body = os.urandom(9 * MAX_PIECE_SIZE + 5)
            self.assertEqual(link.request(ECHO, body, TIMEOUT), body)
        link.request(ECHO, b"", TIMEOUT)  # its answer arrives after the acknowledgements
        self.assertEqual(self.acceptor.taken, self.acceptor.told_taken)

    def test_batched_replies_are_accepted(self):
        link = self.link()
        others = [link.start(GATHER, b"", None) for _ in range(3)]
        self.assertEqual(link.request(GATHER, b"last", TIMEOUT), b"last")
        self.assertEqual([asked.reply.result(0) for asked in others], [b""] * 3)

    def test_a_timeout_keeps_the_link_open(self):
        link = self.link()
        with self.assertRaisesRegex(TimedOut, "^acceptor did not answer within 10 ms; outcome unk"):
            link.request(IGNORE, b"", 0.01)
        self.assertEqual(link.request(ECHO, b"hello", TIMEOUT), b"hello")

    def test_a_reply_is_handled_before_later_notices(self):
        told_before = []
        link = self.link()
        link.request(TELL, b"", TIMEOUT, lambda body: told_before.append(list(self.notices)))
        link.request(ECHO, b"", TIMEOUT)  # its answer arrives after the notices
        self.assertEqual(told_before, [[]])
        self.assertEqual(self.notices, list(range(100)))

    def test_a_lost_peer_ends_waiting_requests(self):
        link = self.link()
        with self.assertRaisesRegex(Unreachable, "acceptor did not answer: .*; outcome unknown"):
            link.request(HANG_UP, b"", TIMEOUT)
        self.assertFalse(link.is_open)
        self.assertTrue(self.closed.wait(TIMEOUT))
        with self.assertRaises(Unreachable):
            link.request(ECHO, b"", TIMEOUT)

    def test_a_send_error_closes_the_link(self):
        is_held, may_go_on = threading.Event(), threading.Event()
        self.addCleanup(may_go_on.set)

        def hold(*_):
            is_held.set()
            may_go_on.wait()

        link = Link(self.network, parse_address(self.acceptor.address), "test", TIMEOUT, hold)
        link.request(TELL, b"", TIMEOUT)
        self.assertTrue(is_held.wait(TIMEOUT))
        link.notify(HANG_UP, 0)  # the held thread of Ice does not notice that the peer hangs up

        with self.assertRaises(Unreachable):
            while True:
                link.notify(IGNORE, 0)
        self.assertFalse(link.is_open)

    def test_a_peer_that_sends_malformed_frames_is_disconnected(self):
        greeting = write_frame(Header(MessageType.WELCOME), b"\0")
        other_version = write_frame(Header(MessageType.REPLY, 2, 0, PROTOCOL_VERSION + 1), b"")
        no_part = write_frame(Header(MessageType.PART, 0, 1), b"nonsense" * 4)
        taken = write_frame(Header(MessageType.PARTS_TAKEN), bytes(range(8)))
        no_replies = write_frame(Header(MessageType.REPLIES), bytes(11))
        for nonsense in (b"nonsense", greeting, other_version, no_part, taken, no_replies):
            with self.subTest(nonsense=nonsense), self.assertRaises(Unreachable):
                self.link().request(TALK_NONSENSE, nonsense, TIMEOUT)

    def test_malformed_ice_messages_do_no_harm(self):
        for number in range(len(NO_ICE)):
            with self.subTest(number=number):
                with contextlib.suppress(Unreachable):  # Ice itself rejects some of them
                    self.link().request(TALK_NO_ICE, bytes([number]), TIMEOUT)
                self.assertEqual(self.link().request(ECHO, b"hello", TIMEOUT), b"hello")

    def test_closing_calls_the_close_handler(self):
        link = self.link()
        link.close()
        self.assertFalse(link.is_open)
        self.assertTrue(self.closed.wait(TIMEOUT))

    def test_a_peer_without_the_cookie_gets_no_proof(self):
        self.acceptor.cookie = COOKIE + 1
        with self.assertRaises(Denied):
            self.link()
        self.assertEqual(self.acceptor.heard, [MessageType.HELLO])

    def test_a_peer_without_a_proof_is_rejected(self):
        self.acceptor.is_impostor = True
        with self.assertRaisesRegex(Invalid, "answered the Hello with an unexpected message"):
            self.link()
        self.assertTrue(self.closed.wait(TIMEOUT))
        self.assertEqual(self.notices, [])

    def test_a_silent_peer_times_out(self):
        self.acceptor.is_mute = True
        with self.assertRaisesRegex(TimedOut, "accepted the connection but did not|^no reply"):
            self.link(timeout=0.5)

    def test_a_slow_process_does_not_block_others(self):
        self.acceptor.is_mute = True
        processes = Processes(self.network, "test", TIMEOUT)
        stop = {"name": "Stop", "signature": {"kind": "void"}}

        def call(process, address):
            processes.call({"name": process, "instance": 42, "address": address},
                           Path(process, "arm", "Control", "Stop"), stop, None)

        def call_slow():
            with contextlib.suppress(Failed, TimedOut, Unreachable):
                call("slow", self.acceptor.address)

        begin = time.monotonic()
        slow = threading.Thread(target=call_slow, daemon=True)
        slow.start()
        self.assertTrue(self.acceptor.is_greeted.wait(TIMEOUT))
        with self.assertRaisesRegex(Unreachable, "^process 'gone' does not answer at "):
            call("gone", "127.0.0.1:1")
        self.assertLess(time.monotonic() - begin, TIMEOUT)  # the slow process still has time
        self.network.close()
        slow.join(TIMEOUT)

    def test_a_refused_connection_is_reported(self):
        self.acceptor.communicator.destroy()
        with self.assertRaisesRegex(Unreachable, r"^nobody answers at .* \(Connection refused\)$"):
            self.link()


if __name__ == "__main__":
    unittest.main()
