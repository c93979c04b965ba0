# SPDX-License-Identifier: MIT
"""The first bytes of an HDF5 file, set right where what they must be is known."""

from __future__ import annotations

import os

SIGNATURE = b"\x89HDF\r\n\x1a\n"
NOWHERE = b"\xff" * 8
#: Of version 0, as we write it: versions, sizes of addresses and lengths, and of tree nodes.
OLD_HEAD = bytes([0, 0, 0, 0, 0, 8, 8, 0, 4, 0, 16, 0, 0, 0, 0, 0])
END = 40  #: where the length of the file stands


def mend_superblock(path: str) -> str:
    """Mends the superblock (version 0) of a file in place. Returns what was wrong, or ""."""
    with open(path, "r+b") as file:
        start = file.read(96)
        if len(start) < 96 or (start[:8] == SIGNATURE and start[8] != 0):
            return ""
        size = os.fstat(file.fileno()).st_size
        stated = int.from_bytes(start[END : END + 8], "little")
        head = start[:END]
        faults = []
        if start[:16] != SIGNATURE + OLD_HEAD[:8]:
            head = SIGNATURE + OLD_HEAD + bytes(8) + NOWHERE
            faults.append("had wrong bytes")
        if stated > size:
            faults.append(f"states {stated} bytes, the file has {size}")
        file.seek(0)
        file.write(head + size.to_bytes(8, "little"))
        return ", ".join(faults)
