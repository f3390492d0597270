"""A system of processes, as the GCM knows it."""

from __future__ import annotations

import os
import pwd
import socket
import time
import weakref
from typing import Any, Callable, Sequence

from .catalog import Description
from .errors import Invalid, NotFound, TimedOut, did_you_mean
from .gcm import GcmLink
from .messages import MessageType
from .middleware.address import gcm_address
from .middleware.certificate import Credentials, chosen_credentials
from .middleware.ice import Network
from .paths import parse_interface, parse_path, split_member, steps_of
from .processes import Processes, Wanted
from .rows import Column, Watch

DEFAULT_TIMEOUT = 2.0  # s; longer than the GCM waits for a process


class System:
    """What connect() returns: lists, reads, calls, watches and connects what is there.

    Each function waits for an answer, at most `timeout` seconds, and raises an Error that says what
    went wrong. They may be called in any thread. A path is `process/component/interface.member`, as
    for the console `gcm`; descriptions are dicts with the fields that the C++ gives them.
    """

    def __init__(self, address: str | None, name: str, timeout: float,
                 credentials: Credentials | None = None) -> None:
        network = Network(credentials)
        self._ending = weakref.finalize(self, network.close)
        self._gcm = GcmLink(network, gcm_address(address), name, timeout)
        self._processes = Processes(network, name, timeout)
        try:
            self._gcm.fresh()
        except BaseException:
            self.close()
            raise

    def close(self) -> None:
        """Ends all links; done at the end of a `with` block, too."""
        self._ending()

    def __enter__(self) -> System:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def processes(self) -> list[Description]:
        """Each with name, state ("alive", "suspect", "lost", "left", "starting"), host, pid, address ..."""
        return [one.description for one in self._gcm.fresh().processes.values()]

    def components(self, process: str) -> list[Description]:
        """Of one process: name, state, class_name, fault, provided and required interfaces with
        their members, tables with their columns ..."""
        return list(self._gcm.fresh().process(process).components.values())

    def connections(self) -> list[Description]:
        """Of all processes: required, provided, state ("pending", "active", "failed") ..."""
        return [connection for process in self._gcm.fresh().processes.values()
                for connection in process.connections.values()]

    def wait_until(self, condition: Callable[[System], Any], timeout: float = 10.0) -> Any:
        """Waits until `condition(self)` is true, and returns what it is; it is asked again whenever
        the catalogue has changed. Raises TimedOut when it does not come true within `timeout`."""
        deadline = time.monotonic() + timeout
        while True:
            changes = self._gcm.changes
            if result := condition(self):
                return result
            if not self._gcm.wait_for_change(changes, deadline):
                raise TimedOut(f"what was waited for has not come about within {timeout:g} s")

    def read(self, path: str, argument: Any = None) -> Any:
        """The value of a column of a state table ("robot/arm/state.Joints"), of a field in it
        ("robot/arm/state.Joints.position[0]"), or of a read command, which may take an argument.
        Nothing is changed by it: other commands are refused."""
        return self._execute(path, argument, only_reads=True)

    def call(self, path: str, argument: Any = None) -> Any:
        """Executes a command with its argument and returns what it answers, None where it answers
        nothing. A void or write command is queued to its component then."""
        return self._execute(path, argument, only_reads=False)

    def watch(self, path: str, columns: Sequence[str] | None = None, period: float = 0.0,
              timeout: float | None = None) -> Watch:
        """Every row of a state table from now on: "robot/arm" has the table `state`, others are
        "robot/arm/state-NAME". Columns may name a field, "Joints.position[0]"; all where none are
        named. With a period in seconds, the first row of each such stretch of the process' clock.
        Raises TimedOut when no row comes within `timeout` seconds."""
        wanted = parse_path(path)
        if wanted.member:
            raise Invalid(f"'{path}' names a column: expected process/component, "
                          "and the column in `columns`")
        catalog = self._gcm.known()
        table = catalog.table(wanted)
        known = [column["name"] for column in table["columns"]]
        chosen, names = _columns_of(known if columns is None else columns, known, path)
        rows = Wanted(wanted.component, table["name"], names, chosen, period)
        return self._processes.watch(catalog.present(wanted.process), rows, timeout)

    def connect(self, required: str, provided: str) -> Description:
        """Connects a required interface to a provided one, both `process/component/interface`. The
        connection it returns is pending where the provider's process is not there yet."""
        wire = {"required": parse_interface(required), "provided": parse_interface(provided)}
        return self._gcm.request(MessageType.CONNECT, "Wire", wire, "ConnectionDescription")

    def disconnect(self, required: str) -> None:
        """Ends the connection of a required interface."""
        nobody = {"process": "", "component": "", "interface": ""}
        wire = {"required": parse_interface(required), "provided": nobody}
        self._gcm.request(MessageType.DISCONNECT, "Wire", wire, "None")

    def _execute(self, text: str, argument: Any, only_reads: bool) -> Any:
        path = parse_path(text)
        catalog = self._gcm.known()
        command = catalog.command(path)
        kind = command["signature"]["kind"]
        if only_reads and kind not in ("read", "qualified_read"):
            raise Invalid(f"{path.command} is a {kind.replace('_', '-')} command, not a read: "
                          "use call()")
        return self._processes.call(catalog.present(path.process), path, command, argument)


def _own_name() -> str:
    """As gcm calls itself: the program, and whose it is."""
    try:
        user = pwd.getpwuid(os.geteuid()).pw_name
    except KeyError:  # in a container
        user = str(os.geteuid())
    return f"python of {user}@{socket.gethostname()}"


def connect(address: str | None = None, name: str | None = None,
            timeout: float = DEFAULT_TIMEOUT,
            certificate: str | os.PathLike[str] | None = None,
            authority: str | os.PathLike[str] | None = None) -> System:
    """Joins the system of the GCM at `address`: $TENDON_GCM or 127.0.0.1:10705 where none is given.
    `name` is for histories and audit logs: "python of USER@HOST" where none is given. Raises
    Unreachable when nobody answers.

    With a `certificate`, the file that the programs take as --certificate, all is under TLS and the
    GCM may be on another machine; `authority` is the folder of --ca. Where they are not given,
    $TENDON_CERTIFICATE and $TENDON_CA are taken."""
    return System(address, name or _own_name(), timeout, chosen_credentials(certificate, authority))


def _columns_of(asked: Sequence[str], known: list[str],
                path: str) -> tuple[list[Column], list[str]]:
    """What is wanted, and the columns to subscribe to for that, each once."""
    columns: list[Column] = []
    names: list[str] = []
    if isinstance(asked, str) or not asked:
        raise Invalid(f"columns of {path}: expected a list of names")
    for text in asked:
        name, field = split_member(text)
        steps_of(field)
        if name not in known:
            raise NotFound(f"{path} has no column '{name}'{did_you_mean(name, known)}")
        if name not in names:
            names.append(name)
        columns.append(Column(text, names.index(name), field))
    return columns, names
