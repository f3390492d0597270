#!/usr/bin/env python3
"""Prints an unused port on 127.0.0.1. If a program imports this module, no other test gets the port
before the program ends, as with FreePort() of tests/support/program.h."""
import random
import socket

# These ports are below the ports that the kernel assigns to connecting sockets. Otherwise a client that keeps trying to
# reach an ended GCM could be assigned the port of that GCM.
PORTS = range(20000, 32000)
reserved = []  # abstract sockets, which leave no files behind


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
