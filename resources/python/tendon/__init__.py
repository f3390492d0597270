"""Tendon from Python: see, read, watch, call and connect the components of a running system.

    import tendon

    with tendon.connect("127.0.0.1:10705") as system:
        print(system.read("robot/arm/state.Joints.position[0]"))

What this package sends and hears stays on this machine, and programs of other users are refused,
unless a certificate is shown: then all of it is under TLS.
"""

from .errors import (Denied, Error, Exists, Failed, Incompatible, Invalid, NotFound, TimedOut,
                     Unreachable)
from .rows import Row, Watch
from .system import System, connect

__all__ = ["Denied", "Error", "Exists", "Failed", "Incompatible", "Invalid", "NotFound", "Row",
           "System", "TimedOut", "Unreachable", "Watch", "connect"]
