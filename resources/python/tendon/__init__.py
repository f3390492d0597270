"""Tendon from Python: see, read, watch, call and connect the components of a running system.

    import tendon

    with tendon.connect("127.0.0.1:10705") as system:
        print(system.read("robot/arm/state.Joints.position[0]"))

Without a certificate, this package talks only to programs of the same user on this machine. With a
certificate, all links use TLS.
"""

from .errors import (Denied, Error, Exists, Failed, Incompatible, Invalid, NotFound, TimedOut,
                     Unreachable)
from .rows import Row, Watch
from .system import System, connect

__all__ = ["Denied", "Error", "Exists", "Failed", "Incompatible", "Invalid", "NotFound", "Row",
           "System", "TimedOut", "Unreachable", "Watch", "connect"]
