"""Paths: the names of the parts of a system, as in all tools of Tendon:
`process/component/interface.member(.field or [i])*`."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

from .errors import Invalid, NotFound, did_you_mean

_NAME = re.compile(r"[A-Za-z0-9_-]{1,64}")
_STEP = re.compile(r"\.([A-Za-z0-9_]+)|\[([0-9]{1,10})\]")
_MEMBER = re.compile(r"([^.\[]*)(.*)", re.DOTALL)


class Path(NamedTuple):
    """A path. Its last parts may be empty: `robot/arm` is a path. `field` begins with '.' or
    '['."""

    process: str
    component: str = ""
    interface: str = ""
    member: str = ""
    field: str = ""

    @property
    def command(self) -> str:
        """The path without the field."""
        return f"{self.process}/{self.component}/{self.interface}.{self.member}"


def parse_path(text: str) -> Path:
    """Reads a path; the error names the part that is wrong."""
    process, _, rest = text.partition("/")
    component, _, rest = rest.partition("/")
    interface, dot, after = rest.partition(".")
    member, field = split_member(after)
    if dot and not member:
        raise _no_path(text, "nothing follows the '.'")
    path = Path(process, component, interface, member, field)
    for what, name in zip(("process", "component", "interface", "member"), path):
        if not _NAME.fullmatch(name) and (name or what == "process"):
            raise _no_path(text, f"{what} name '{name[:64]}' is none; "
                                 "allowed: letters digits _ - (max 64)")
    if path.field:
        steps_of(path.field)
    return path


def parse_interface(text: str) -> dict[str, str]:
    """Reads "process/component/interface" as a tendon.InterfaceName."""
    parts = text.split("/")
    if len(parts) != 3 or not all(map(_NAME.fullmatch, parts)):
        raise Invalid(f"'{text[:200]}' is not an interface: expected process/component/interface")
    return dict(zip(("process", "component", "interface"), parts))


def split_member(text: str) -> tuple[str, str]:
    """Splits "Joints.position[0]" into ("Joints", ".position[0]")."""
    found = _MEMBER.fullmatch(text)
    assert found is not None
    return found[1], found[2]


def steps_of(field: str) -> list[str | int]:
    """Splits ".position[0]" into ["position", 0]."""
    steps: list[str | int] = []
    position = 0
    while position < len(field):
        found = _STEP.match(field, position)
        if found is None:
            raise Invalid(f"'{field[:200]}' is not a field: expected .name or [index]")
        steps.append(found[1] if found[1] is not None else int(found[2]))
        position = found.end()
    return steps


def select(value: Any, field: str) -> Any:
    """The part of a value at ".position[0]"; the whole value if the field is empty."""
    for step in steps_of(field):
        if isinstance(step, int):
            if not isinstance(value, (list, bytes)) or step >= len(value):
                raise NotFound(f"there is no element [{step}]")
        elif not isinstance(value, dict) or step not in value:
            known = value if isinstance(value, dict) else ()
            raise NotFound(f"there is no field '{step}'{did_you_mean(step, known)}")
        value = value[step]
    return value


def _no_path(text: str, why: str) -> Invalid:
    return Invalid(f"'{text[:200]}' is not a path: {why}; "
                   "expected process/component/interface.member")
