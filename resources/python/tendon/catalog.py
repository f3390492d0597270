"""A copy of the catalogue of the GCM, in which paths that people type are looked up."""

from __future__ import annotations

from typing import Any, Iterable

from .errors import Failed, Invalid, NotFound, Unreachable, did_you_mean
from .paths import Path

MOST_LISTED = 8

Description = dict[str, Any]
"""A structure of tendon/process/process_description.h as a dict: its fields by name."""


class Process:
    """A process with its components and connections."""

    def __init__(self, description: Description) -> None:
        self.description = description
        self.components: dict[str, Description] = {}
        self.connections: dict[int, Description] = {}  # by id


class Catalogue:
    """All processes of a system. The GCM sends changes with consecutive numbers. Not
    thread-safe."""

    def __init__(self, revision: int = 0) -> None:
        self.revision = revision
        self.processes: dict[str, Process] = {}

    def copy(self) -> Catalogue:
        """Copies the catalogue for apply(). The copies share the descriptions, which never
        change."""
        other = Catalogue(self.revision)
        for name, process in self.processes.items():
            entry = other.processes[name] = Process(process.description)
            entry.components = dict(process.components)
            entry.connections = dict(process.connections)
        return other

    def apply(self, change: dict[str, Any]) -> bool:
        """Applies the next change. Changes nothing and returns False if the change is invalid or
        its revision is not the next one; then request the whole catalogue again."""
        if change["revision"] != self.revision + 1:
            return False
        name = change["process"]
        if change["kind"] == "process":
            applied = self._apply_process(name, change["processes"])
        elif name not in self.processes:
            applied = False
        elif change["kind"] == "process_removed":
            applied = self.processes.pop(name) is not None
        else:
            applied = _apply_to(self.processes[name], change)
        self.revision += applied
        return applied

    def process(self, name: str) -> Process:
        """The process of this name. Raises NotFound if there is none."""
        if name not in self.processes:
            raise _not_found("process", name, name, self.processes)
        return self.processes[name]

    def present(self, name: str) -> Description:
        """The process of this name. Raises Failed or Unreachable if no request can be sent to
        it."""
        process = self.process(name).description
        if process["state"] not in ("alive", "suspect"):
            state = "has left" if process["state"] == "left" else "is lost"
            reason = f" ({process['reason']})" if process["reason"] else ""
            raise Failed(f"process '{name}' {state}{reason}; start it again first")
        if not process["address"]:
            raise Unreachable(f"process '{name}' does not listen")
        return process

    def component(self, path: Path) -> Description:
        """The component of a path. Raises NotFound if there is none."""
        components = self.process(path.process).components
        if path.component not in components:
            full = f"{path.process}/{path.component}"
            raise _not_found("component", full, path.component, components)
        return components[path.component]

    def command(self, path: Path) -> Description:
        """The tendon.MemberDescription of a command. A column of a table counts as a read
        command."""
        if not path.member:
            raise Invalid(f"'{'/'.join(filter(None, path))}' does not name a command: "
                          "expected process/component/interface.member")
        component = self.component(path)
        provided = _named(component["provided"])
        tables = _named(component["tables"])
        if path.interface in provided:
            commands = _named(provided[path.interface]["commands"])
        elif path.interface in tables:
            commands = {column["name"]: _read_of(column)
                        for column in tables[path.interface]["columns"]}
        else:
            full = path.command.rpartition(".")[0]
            raise _not_found("provided interface", full, path.interface, {**provided, **tables})
        if path.member not in commands:
            raise _not_found("command", path.command, path.member, commands)
        return commands[path.member]

    def table(self, path: Path) -> Description:
        """The tendon.TableDescription of a table: "robot/arm/state-Fast", or "robot/arm" for its
        table "state"."""
        tables = _named(self.component(path)["tables"])
        name = path.interface or "state"
        if name not in tables:
            full = f"{path.process}/{path.component}/{name}"
            raise _not_found("state table", full, name, tables)
        return tables[name]

    def _apply_process(self, name: str, described: list[Description]) -> bool:
        if len(described) != 1 or described[0]["name"] != name:
            return False
        process = self.processes.get(name)
        if process is None or process.description["instance"] != described[0]["instance"]:
            process = self.processes[name] = Process(described[0])
        process.description = described[0]
        return True


def _apply_to(process: Process, change: dict[str, Any]) -> bool:
    kind = change["kind"]
    if kind == "component" and len(change["components"]) == 1:
        component = change["components"][0]
        process.components[component["name"]] = component
        return True
    if kind == "connection" and len(change["connections"]) == 1:
        connection = change["connections"][0]
        process.connections[connection["id"]] = connection
        return True
    if kind == "component_removed":
        return process.components.pop(change["component"], None) is not None
    if kind == "connection_removed":
        return process.connections.pop(change["connection"], None) is not None
    return False


def _read_of(column: Description) -> Description:
    return {"name": column["name"], "out_type": column["type"],
            "signature": {"kind": "read", "out": column["fingerprint"]}}


def _named(elements: Iterable[Description]) -> dict[str, Description]:
    return {element["name"]: element for element in elements}


def _not_found(what: str, full: str, name: str, candidates: Iterable[str]) -> NotFound:
    """The error for an unknown name. It suggests a similar name, or else lists up to MOST_LISTED
    existing names."""
    names = list(candidates)
    hint = did_you_mean(name, names)
    if not names:
        hint = "; there is none"
    elif not hint and len(names) <= MOST_LISTED:
        hint = "; there is " + ", ".join(f"'{one}'" for one in names)
    return NotFound(f"no {what} '{full}'{hint}")
