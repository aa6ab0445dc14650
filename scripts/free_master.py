#!/usr/bin/env python3
"""Prints a master address on the loopback interface that is not in use:
the wanted one, else the same with the next free port.

    free_master.py http://127.0.0.1:11311

A second mission on one machine then gets a master of its own. An address of
another machine is printed as it is: that master runs already.
"""

import socket
import sys
import urllib.parse

TRIES = 100


def is_free(host, port):
    with socket.socket() as probe:
        probe.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            probe.bind((host, port))
        except OSError:
            return False
    return True


def free_master(uri):
    address = urllib.parse.urlsplit(uri)
    if address.port is None:
        raise SystemExit(f"ROS_MASTER_URI: {uri} has no port")
    if address.hostname not in ("localhost", "127.0.0.1"):
        return uri
    for port in range(address.port, address.port + TRIES):
        if is_free(address.hostname, port):
            return f"http://{address.hostname}:{port}"
    raise SystemExit(f"no free port at or above {address.port}")


if __name__ == "__main__":
    print(free_master(sys.argv[1]))
