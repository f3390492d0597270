#!/usr/bin/env python3
"""Prints a port on 127.0.0.1 that nobody uses. A program which imports it keeps the port to itself among the tests
until it ends, as FreePort() of tests/support/program.h does."""
import random
import socket

# Below those which the kernel gives to whoever connects: a client that tries again and again to reach a GCM which has
# gone could be given the very port of that GCM.
PORTS = range(20000, 32000)
reserved = []  # names of sockets in no folder: nothing is left behind


def free_port():
    for _ in range(1000):
        port = random.choice(PORTS)
        try:
            with socket.socket() as probe:
                probe.bind(("127.0.0.1", port))
            name = socket.socket(socket.AF_UNIX)
            name.bind(f"\0tendon-test-port-{port}")
        except OSError:
            continue
        reserved.append(name)
        return port
    raise OSError("no free port")


if __name__ == "__main__":
    print(free_port())
