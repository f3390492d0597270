"""Links to processes: calls, and subscriptions to state tables."""

from __future__ import annotations

import threading
from typing import Any, NamedTuple

from . import messages
from .catalog import Description
from .errors import Denied, Error, Failed, Invalid, NotFound, TimedOut, Unreachable
from .messages import MessageType
from .middleware.ice import Network
from .middleware.link import Link, reading
from .paths import Path, select
from .payload.schema import Schema
from .payload.schema_text import parse
from .rows import Column, Feed, Feeds, Watch

_TAKE_ARGUMENTS = ("write", "qualified_read", "write_return")  # kinds of commands
_WITHOUT_RESULT = ("void", "write")

# The text after the name of a command that was not executed, by Status::Code.
_DONE = 2  # commands with a lower code were executed
_REFUSALS: list[tuple[type[Error], str]] = [
    (Failed, "done"), (Failed, "queued"), (Failed, "not connected"),
    (Failed, "not active; start its component first"),
    (Failed, "queue full; its component executes the calls too slowly: try again; if it fails each "
             "time, check that Run() of the component calls ProcessQueuedCommands()"),
    (Failed, "no sample"),
    (TimedOut, "timeout"), (TimedOut, "outcome unknown"), (Failed, "would deadlock"),
    (Denied, "denied"), (Failed, "disabled"), (Failed, "unsupported"), (Invalid, "invalid"),
    (Failed, "failed")]


class _Peer(NamedTuple):
    """An open link to a process."""

    link: Link
    feeds: Feeds
    schemas: dict[tuple[int, int], Schema]  # by fingerprint, as the process described them


class Wanted(NamedTuple):
    """A request for rows of a state table. Subscribes to the columns `names`; a row has the values
    of `columns`, which may be fields of them."""

    component: str
    table: str
    names: list[str]
    columns: list[Column]
    period: float


class Processes:
    """The links to processes. A link is opened when it is first needed, and kept. Thread-safe."""

    def __init__(self, network: Network, name: str, timeout: float) -> None:
        self._network = network
        self._name = name
        self._timeout = timeout
        self._opening: dict[str, threading.Lock] = {}  # by process
        self._peers: dict[str, _Peer] = {}

    def call(self, process: Description, path: Path, command: Description, argument: Any) -> Any:
        """Executes a command and returns its result, or None. `command` is a MemberDescription."""
        signature = command["signature"]
        takes = signature["kind"] in _TAKE_ARGUMENTS
        if argument is not None and not takes:
            raise Invalid(f"{path.command} takes no argument")
        if argument is None and takes:
            raise Invalid(f"{path.command} needs an argument of {command['in_type']}")
        peer = self._peer(process)
        body = b""
        if takes:
            try:
                body = self._schema(peer, signature["in"]).encode(argument)
            except Invalid as why:
                raise Invalid(f"{path.command}: {why}") from None
        called = self._ask(peer, MessageType.CALL_MEMBER, "CallMember", {
            "component": path.component, "interface": path.interface, "member": path.member,
            "argument": body, "timeout": self._timeout * 3 / 4}, "CallMemberReply")
        if called["status"] >= _DONE:
            kind, words = _REFUSALS[min(called["status"], len(_REFUSALS) - 1)]
            raise kind(f"{path.command}: {words}")
        if signature["kind"] in _WITHOUT_RESULT:
            return None
        return select(self._schema(peer, signature["out"]).decode(called["result"]), path.field)

    def watch(self, process: Description, wanted: Wanted, timeout: float | None) -> Watch:
        """Subscribes to rows of a table."""
        peer = self._peer(process)
        feed = Feed()

        def on_reply(body: bytes) -> Any:
            reply = messages.decode("SubscribeReply", body)
            peer.feeds.add(reply["handle"], feed)
            return reply

        value = {"component": wanted.component, "table": wanted.table, "columns": wanted.names,
                 "rows": {"period": wanted.period, "delivery": "ALL"}}
        reply = peer.link.request(MessageType.SUBSCRIBE, messages.encode("Subscribe", value),
                                   self._timeout, on_reply)
        schemas = [parse(text) for text in reply["schemas"]]
        if len(schemas) != len(wanted.names):
            raise Invalid(f"{process['name']} answered with another number of columns")
        return Watch(peer.link, peer.feeds, reply["handle"], feed, schemas,
                     wanted.columns, timeout)

    def _peer(self, process: Description) -> _Peer:
        name = process["name"]
        with self._opening.setdefault(name, threading.Lock()):
            peer = self._peers.get(name)
            if peer is not None and peer.link.is_open:
                if peer.link.peer_instance == process["instance"]:
                    return peer
                peer.link.close()
            feeds = Feeds()
            where = f"process '{name}' does not answer at {process['address']}"
            try:
                link = Link(self._network, self._network.address(process["address"]), self._name,
                            self._timeout, feeds.on_notice, feeds.on_closed, wanted=name)
            except Error as why:
                raise type(why)(f"{where}: {why}") from None
            if link.peer_instance != process["instance"]:
                link.close()
                raise Unreachable(f"{where}: another program listens at this address")
            self._peers[name] = peer = _Peer(link, feeds, {})
            return peer

    def _schema(self, peer: _Peer, fingerprint: Description) -> Schema:
        key = (fingerprint["high"], fingerprint["low"])
        if key not in peer.schemas:
            reply = self._ask(peer, MessageType.GET_SCHEMAS, "GetSchemas",
                               {"fingerprints": [fingerprint]}, "Schemas")
            text = next(iter(reply["texts"]), "")
            if not text:
                raise NotFound(f"process '{peer.link.peer_name}' has no payload type with the "
                               f"fingerprint {key[0]:016x}{key[1]:016x}")
            peer.schemas[key] = parse(text)
        return peer.schemas[key]

    def _ask(self, peer: _Peer, message_type: MessageType, name: str, value: Any,
             reply: str) -> Any:
        return peer.link.request(message_type, messages.encode(name, value), self._timeout,
                                 reading(reply))
