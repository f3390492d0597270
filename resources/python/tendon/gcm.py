"""The link to a GCM, and the catalogue that it sends."""

from __future__ import annotations

import threading
import time
from typing import Any

from . import messages
from .catalog import Catalogue
from .errors import Error, Invalid, TimedOut, Unreachable
from .messages import MessageType
from .middleware.frame import Header
from .middleware.ice import Network
from .middleware.link import Link, reading


GCM_NAME = "gcm"


class GcmLink:
    """Watches one GCM. If the link is lost, the next request connects again. Thread-safe."""

    def __init__(self, network: Network, address: str, name: str, timeout: float) -> None:
        self._network = network
        self._address = network.address(address)
        self._name = name
        self._timeout = timeout
        self._opening = threading.Lock()
        self._link: Link | None = None
        self._changed = threading.Condition()
        self._catalog = Catalogue()  # never changed, only replaced
        self._changes = 0

    def request(self, message_type: MessageType, name: str, value: Any, reply: str) -> Any:
        """Sends a request to the GCM, which may have to ask a process."""
        return self._open().request(message_type, messages.encode(name, value), self._timeout,
                                    reading(reply))

    def fresh(self) -> Catalogue:
        """The catalogue with all changes until now. Asks the GCM: its reply follows those
        changes."""
        try:
            self._ask_for_life()
        except Unreachable:
            self._ask_for_life()  # connects again, which brings the whole catalogue
        return self._catalog

    def known(self) -> Catalogue:
        """The last known catalogue. The GCM need not answer: processes can be used without it."""
        link = self._link
        if link is None or not link.is_open:
            try:
                self._open()
            except Error:
                pass
        return self._catalog

    @property
    def changes(self) -> int:
        """How many times the catalogue has changed, or the GCM was lost."""
        with self._changed:
            return self._changes

    def wait_for_change(self, since: int, deadline: float) -> bool:
        """Waits until `changes` is not `since` any more. Returns False after the deadline."""
        with self._changed:
            return self._changed.wait_for(lambda: self._changes != since,
                                          max(0.0, deadline - time.monotonic()))

    def _ask_for_life(self) -> None:
        self._open().request(MessageType.RENEW, messages.encode("None"), self._timeout)

    def _open(self) -> Link:
        with self._opening:
            if self._link is not None and self._link.is_open:
                return self._link
            try:
                self._link = Link(self._network, self._address, self._name, self._timeout,
                                  self._on_notice, self._on_closed, wanted=GCM_NAME)
                self._link.request(MessageType.WATCH, messages.encode("None"), self._timeout,
                                   self._on_snapshot)
                return self._link
            except Error as why:
                if self._link is not None:
                    self._link.close()
                if not isinstance(why, (Unreachable, TimedOut)):
                    raise
                raise Unreachable(f"no GCM at {self._address} ({_briefly(str(why))}); "
                                  "start one with: gcm serve") from None

    def _on_snapshot(self, body: bytes) -> None:
        """Called in the thread of Ice, like _on_notice() and _on_closed()."""
        snapshot = messages.decode("Snapshot", body)
        catalog = Catalogue(snapshot["base"])
        if not all(map(catalog.apply, snapshot["changes"])):
            raise Invalid(f"the GCM at {self._address} sent an invalid catalogue")
        self._replace(catalog)

    def _on_notice(self, header: Header, body: bytes) -> None:
        if header.type != MessageType.CHANGES:
            return
        catalog = self._catalog.copy()
        try:
            fits = all(map(catalog.apply, messages.decode("Changes", body)["changes"]))
        except Invalid:
            fits = False
        if fits:
            self._replace(catalog)
        elif self._link is not None:
            self._link.close()  # the next request fetches the whole catalogue

    def _on_closed(self, _reason: Error) -> None:
        self._replace(self._catalog)

    def _replace(self, catalog: Catalogue) -> None:
        with self._changed:
            self._catalog = catalog
            self._changes += 1
            self._changed.notify_all()


def _briefly(reason: str) -> str:
    """The reason without the words that the caller's error repeats: "Connection refused" of "nobody
    answers at 127.0.0.1:10705 (Connection refused)"."""
    _, found, inner = reason.partition(" (")
    return inner.removesuffix(")") if found and reason.startswith("nobody ") else reason
