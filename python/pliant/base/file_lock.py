# SPDX-License-Identifier: MIT
"""A lock on an open file, which ends with the process that holds it, however that ends."""

from __future__ import annotations

import contextlib
import os
import sys
from typing import IO, Any

if sys.platform == "win32":
    import msvcrt
else:
    with contextlib.suppress(ModuleNotFoundError):  # where a test takes it away
        import fcntl

# Windows locks bytes, and lets nobody else read them: one far behind all that the file will hold.
_FAR = 1 << 62


def take_lock(file: IO[Any]) -> None:
    """Raises OSError if another process has it."""
    if sys.platform == "win32":
        number = file.fileno()
        before = os.lseek(number, 0, os.SEEK_CUR)
        os.lseek(number, _FAR, os.SEEK_SET)
        try:
            msvcrt.locking(number, msvcrt.LK_NBLCK, 1)
        finally:
            os.lseek(number, before, os.SEEK_SET)
    else:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
