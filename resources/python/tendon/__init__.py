"""Tendon from Python: see, read, watch, call and connect the components of a running system, and
read recordings.

    import tendon

    with tendon.connect("127.0.0.1:10705") as system:
        print(system.read("robot/arm/state.Joints.position[0]"))

    run = tendon.open("run.mcap")
    print(run["robot/arm/state.Joints.position"])

Without a certificate, this package talks only to programs of the same user on this machine. With a
certificate, all links use TLS.
"""

from typing import Any

from .errors import (Denied, Error, Exists, Failed, Incompatible, Invalid, NotFound, TimedOut,
                     Unreachable)

# The modules of the names that need another package. Only scripts that use such a name need that package.
_LAZY = {"System": ("system", "System"), "connect": ("system", "connect"),
         "Row": ("rows", "Row"), "Watch": ("rows", "Watch"),
         "open": ("recording", "open_recording"), "Recording": ("recording", "Recording"),
         "DamagedRecording": ("recording", "DamagedRecording")}
_PACKAGES = {"Ice": "python3-zeroc-ice", "numpy": "python3-numpy"}

__all__ = ["DamagedRecording", "Denied", "Error", "Exists", "Failed", "Incompatible", "Invalid",
           "NotFound", "Recording", "Row", "System", "TimedOut", "Unreachable", "Watch", "connect",
           "open"]


def __getattr__(name: str) -> Any:
    """Imports a module of _LAZY at the first use of one of its names."""
    import importlib  # pylint: disable=import-outside-toplevel

    if name not in _LAZY:
        raise AttributeError(f"module 'tendon' has no attribute '{name}'")
    module, attribute = _LAZY[name]
    try:
        return getattr(importlib.import_module(f".{module}", __name__), attribute)
    except ModuleNotFoundError as why:
        if why.name not in _PACKAGES:
            raise
        raise Failed(f"tendon.{name} needs the module {why.name}, which this Python does not have: "
                     f"install {_PACKAGES[why.name]}") from None
