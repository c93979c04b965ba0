# SPDX-License-Identifier: MIT
"""Where a run listens, as it is given on a command line."""

from __future__ import annotations

import argparse


def server_address(text: str) -> tuple[str, int]:
    """For ``type=``: HOST:PORT; without HOST this machine."""
    host, _, port = text.rpartition(":")
    if not port.isascii() or not port.isdigit() or not 1 <= int(port) <= 65535:
        raise argparse.ArgumentTypeError(f"expected HOST:PORT, found '{text}'")
    return host or "127.0.0.1", int(port)
