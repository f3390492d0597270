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
    """The result of connect(): lists, reads, calls, watches and connects the parts of a system.

    Each function waits for a reply, at most `timeout` seconds, and raises an Error that says what
    went wrong. Any thread may call them. A path is `process/component/interface.member`, as for the
    console `gcm`. Descriptions are dicts with the same fields as in C++.
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
        """Closes all links; the end of a `with` block does so as well."""
        self._ending()

    def __enter__(self) -> System:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def processes(self) -> list[Description]:
        """All processes: name, state ("alive", "suspect", "lost", "left", "starting"), host, pid,
        address ..."""
        return [one.description for one in self._gcm.fresh().processes.values()]

    def components(self, process: str) -> list[Description]:
        """The components of one process: name, state, class_name, fault, provided and required
        interfaces with their members, tables with their columns ..."""
        return list(self._gcm.fresh().process(process).components.values())

    def connections(self) -> list[Description]:
        """The connections of all processes: required, provided, state ("pending", "active",
        "failed") ..."""
        return [connection for process in self._gcm.fresh().processes.values()
                for connection in process.connections.values()]

    def wait_until(self, condition: Callable[[System], Any], timeout: float = 10.0) -> Any:
        """Waits until `condition(self)` is true, and returns its value. Calls it again whenever the
        catalogue has changed. Raises TimedOut if it is not true within `timeout` seconds."""
        deadline = time.monotonic() + timeout
        while True:
            changes = self._gcm.changes
            if result := condition(self):
                return result
            if not self._gcm.wait_for_change(changes, deadline):
                raise TimedOut(f"the condition was not true within {timeout:g} s")

    def read(self, path: str, argument: Any = None) -> Any:
        """The value of a column of a state table ("robot/arm/state.Joints"), of a field of it
        ("robot/arm/state.Joints.position[0]"), or of a read command, which may take an argument.
        Other commands are refused, so a read changes nothing."""
        return self._execute(path, argument, only_reads=True)

    def call(self, path: str, argument: Any = None) -> Any:
        """Executes a command with its argument and returns its result, or None if it has none. For
        a void or write command, returns as soon as the call is queued at its component."""
        return self._execute(path, argument, only_reads=False)

    def watch(self, path: str, columns: Sequence[str] | None = None, period: float = 0.0,
              timeout: float | None = None) -> Watch:
        """Returns every row of a state table from now on. "robot/arm" means the table `state`;
        other tables are "robot/arm/state-NAME". A column may name a field, "Joints.position[0]";
        without `columns`, all columns are returned. With a period in seconds, returns only the
        first row of each period of the process's clock. Raises TimedOut if no row arrives within
        `timeout` seconds."""
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
        returned connection is pending if the provider's process is not available yet."""
        ends = {"required": parse_interface(required), "provided": parse_interface(provided)}
        return self._gcm.request(MessageType.CONNECT, "ConnectionEnds", ends, "ConnectionDescription")

    def disconnect(self, required: str) -> None:
        """Ends the connection of a required interface."""
        nobody = {"process": "", "component": "", "interface": ""}
        ends = {"required": parse_interface(required), "provided": nobody}
        self._gcm.request(MessageType.DISCONNECT, "ConnectionEnds", ends, "None")

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
    """The name of this program and its user, in the same form as for gcm."""
    try:
        user = pwd.getpwuid(os.geteuid()).pw_name
    except KeyError:  # this user id has no name, as in many containers
        user = str(os.geteuid())
    return f"python of {user}@{socket.gethostname()}"


def connect(address: str | None = None, name: str | None = None,
            timeout: float = DEFAULT_TIMEOUT,
            certificate: str | os.PathLike[str] | None = None,
            authority: str | os.PathLike[str] | None = None) -> System:
    """Joins the system of the GCM at `address`; the default is $TENDON_GCM, or 127.0.0.1:10705.
    `name` appears in histories and audit logs; the default is "python of USER@HOST". Raises
    Unreachable if no GCM answers.

    With a `certificate`, the same file as for the option --certificate of the programs, all links
    use TLS, and the GCM may be on another machine. `authority` is the folder of --ca. The defaults
    are $TENDON_CERTIFICATE and $TENDON_CA."""
    return System(address, name or _own_name(), timeout, chosen_credentials(certificate, authority))


def _columns_of(asked: Sequence[str], known: list[str],
                path: str) -> tuple[list[Column], list[str]]:
    """The requested columns, and the table columns to subscribe to for them, without duplicates."""
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
