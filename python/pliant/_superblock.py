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
        if len(start) < 96 or start[8:9] not in (b"\0", b"\1") and start[:8] == SIGNATURE:
            return ""
        size = os.fstat(file.fileno()).st_size
        stated = int.from_bytes(start[END : END + 8], "little")
        mended = SIGNATURE + OLD_HEAD + bytes(8) + NOWHERE + start[END : END + 8] + NOWHERE
        faults = []
        if start[: END] + start[END + 8 : 56] != mended[: END] + mended[END + 8 : 56]:
            faults.append("had wrong bytes")
        if stated != size:
            faults.append(f"states {stated} bytes, the file has {size}")
            mended = mended[:END] + size.to_bytes(8, "little") + mended[END + 8 :]
        if not faults:
            return ""
        file.seek(0)
        file.write(mended)
        return ", ".join(faults)
