"""Tests the opener's side of the handshake, and reading the cookie."""
import hashlib
import hmac
import os
import pathlib
import struct
import tempfile
import unittest

from tendon import Denied, Incompatible, Invalid, NotFound, Unreachable, messages
from tendon.messages import MessageType
from tendon.middleware.certificate import Shown
from tendon.middleware.frame import PROTOCOL_VERSION, Header
from tendon.middleware.handshake import Opener, loopback_cookie

COOKIE = 0x0123456789ABCDEF
ADDRESS = "127.0.0.1:10705"
ACCEPTOR = {"instance": 42, "name": "gcm", "nonce": bytes(range(16))}


def greeting_bytes(greeting, position):
    """The bytes of a greeting that begins at `position` of a message. Written without the package,
    in the form of core/tendon/middleware/handshake."""
    def pad(size):
        nonlocal body
        body += bytes(-(position + len(body)) % size)

    body = b""
    pad(8)
    body += struct.pack("<Q", greeting["instance"])
    name = greeting["name"].encode() + b"\0"
    body += struct.pack("<I", len(name)) + name + greeting["nonce"]
    return body


def proof_of(cookie, role, opener, acceptor):
    covered = bytes([role])
    covered += greeting_bytes(opener, len(covered))
    covered += greeting_bytes(acceptor, len(covered))
    covered += bytes(-len(covered) % 4)
    covered += struct.pack("<I", len(ADDRESS) + 1) + ADDRESS.encode() + b"\0"
    covered += bytes(-len(covered) % 8) + struct.pack("<Q", 0)
    return hmac.new(struct.pack("<Q", cookie), covered, hashlib.sha256).digest()


def challenge_of(cookie, hello, acceptor=None):
    acceptor = acceptor or ACCEPTOR
    proof = proof_of(cookie, 1, messages.decode("Greeting", hello.body), acceptor)
    return messages.encode("Challenge", {"greeting": acceptor, "proof": proof})


class Handshake(unittest.TestCase):
    def setUp(self):
        self.opener = Opener("test", ADDRESS, COOKIE)
        self.hello = self.opener.greet()

    def test_both_ends_prove_the_cookie(self):
        opener = messages.decode("Greeting", self.hello.body)
        self.assertEqual((self.hello.type, opener["name"]), (MessageType.HELLO, "test"))

        answer = self.opener.take(Header(MessageType.CHALLENGE), challenge_of(COOKIE, self.hello))

        self.assertEqual(answer.type, MessageType.PROOF)
        self.assertEqual(messages.decode("Proof", answer.body)["proof"],
                         proof_of(COOKIE, 0, opener, ACCEPTOR))
        self.assertFalse(self.opener.is_welcome)
        self.assertIsNone(self.opener.take(Header(MessageType.WELCOME), b"\0"))
        self.assertTrue(self.opener.is_welcome)
        self.assertEqual(self.opener.peer["instance"], 42)

    def test_a_peer_without_the_cookie_is_denied(self):
        with self.assertRaisesRegex(Denied, "^gcm does not know 'test': both must run as the same"):
            self.opener.take(Header(MessageType.CHALLENGE), challenge_of(COOKIE + 1, self.hello))
        zeroes = messages.encode("Challenge", {"greeting": ACCEPTOR, "proof": bytes(32)})
        with self.assertRaises(Denied):
            self.opener.take(Header(MessageType.CHALLENGE), zeroes)

    def test_under_tls_the_certificate_identifies_the_peer(self):
        def answer(shown, wanted="gcm"):
            opener = Opener("test", ADDRESS, 0, shown, wanted)
            challenge = {"greeting": ACCEPTOR, "proof": bytes(32)}
            opener.greet()
            return opener.take(Header(MessageType.CHALLENGE),
                               messages.encode("Challenge", challenge))

        proof = messages.decode("Proof", answer(Shown("gcm", "operator")).body)["proof"]
        self.assertEqual(proof, bytes(32))
        for kind, words, shown, wanted in [
                (Denied, "calls itself 'gcm', but shows the certificate of 'robot'",
                 Shown("robot", "operator"), "gcm"),
                (Denied, "has the certificate of a viewer", Shown("gcm", "viewer"), "gcm"),
                (Unreachable, "is 'gcm', but 'robot' was expected", Shown("gcm", "operator"),
                 "robot")]:
            with self.subTest(words), self.assertRaisesRegex(kind, words):
                answer(shown, wanted)

    def test_nonce_and_instance_are_unique(self):
        other = messages.decode("Greeting", Opener("test", ADDRESS, COOKIE).greet().body)
        mine = messages.decode("Greeting", self.hello.body)
        self.assertNotEqual(mine["nonce"], other["nonce"])
        self.assertNotEqual(mine["instance"], other["instance"])

    def test_a_refusal_raises_the_peers_message(self):
        refusal = messages.encode("Error", {"code": "NOT_FOUND", "message": "no room"})
        with self.assertRaisesRegex(NotFound, "^no room$"):
            self.opener.take(Header(MessageType.REFUSAL, version=99), refusal)

    def test_a_version_mismatch_names_the_outdated_program(self):
        newer, older = PROTOCOL_VERSION + 1, PROTOCOL_VERSION - 1
        for version, outdated in [(newer, "this program"), (older, ADDRESS)]:
            words = (f"^{ADDRESS} speaks protocol version {version}, but this program speaks "
                     f"version {PROTOCOL_VERSION}: update {outdated}$")
            with self.subTest(version=version), self.assertRaisesRegex(Incompatible, words):
                self.opener.take(Header(MessageType.CHALLENGE, version=version), b"")

    def test_unexpected_messages_are_rejected(self):
        for header, body in [(Header(MessageType.WELCOME), b"\0"),
                             (Header(MessageType.CHALLENGE), b"nonsense")]:
            with self.subTest(header=header), self.assertRaises(Invalid):
                self.opener.take(header, body)
        self.opener.take(Header(MessageType.CHALLENGE), challenge_of(COOKIE, self.hello))
        with self.assertRaises(Invalid):
            self.opener.take(Header(MessageType.CHALLENGE), challenge_of(COOKIE, self.hello))


class Cookie(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        before = os.environ.get("XDG_RUNTIME_DIR")
        self.addCleanup(lambda: os.environ.pop("XDG_RUNTIME_DIR") if before is None
                        else os.environ.update(XDG_RUNTIME_DIR=before))
        os.environ["XDG_RUNTIME_DIR"] = folder.name
        self.file = pathlib.Path(folder.name) / "tendon" / "cookie"
        self.file.parent.mkdir()

    def write(self, text, mode=0o600):
        self.file.write_text(text, encoding="ascii")
        self.file.chmod(mode)

    def test_is_read_from_this_users_file(self):
        self.write("1f")
        self.assertEqual(loopback_cookie(), 0x1f)

    def test_a_missing_file_names_the_remedy(self):
        with self.assertRaisesRegex(Denied, "gcm serve$"):
            loopback_cookie()

    def test_a_file_readable_by_others_is_rejected(self):
        self.write("1f", mode=0o644)
        with self.assertRaisesRegex(Denied, "mode 0600"):
            loopback_cookie()

    def test_a_symbolic_link_is_rejected(self):
        self.write("1f")
        self.file.rename(self.file.with_name("other"))
        self.file.symlink_to("other")
        with self.assertRaises(Denied):
            loopback_cookie()

    def test_a_damaged_file_is_rejected(self):
        for text in ("", "0", "no number", "1" * 17):
            self.write(text)
            with self.subTest(text=text), self.assertRaisesRegex(Invalid, "is damaged: remove this file"):
                loopback_cookie()


if __name__ == "__main__":
    unittest.main()
