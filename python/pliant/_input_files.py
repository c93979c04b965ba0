# SPDX-License-Identifier: MIT
"""Files that are read, whoever wrote them: none is waited for, and no JSON ends the program."""

from __future__ import annotations

import errno
import json
import os
import stat
from typing import Any


def open_file(path: str, flags: int) -> int:
    """For ``open(path, opener=open_file)``: files alone. Raises OSError.

    A pipe that nobody writes to would be waited for, and a device may have no end.
    """
    number = os.open(path, flags | getattr(os, "O_NONBLOCK", 0))
    mode = os.fstat(number).st_mode
    if stat.S_ISREG(mode):
        return number
    os.close(number)
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), path)
    what = "pipe" if stat.S_ISFIFO(mode) else "device"
    raise OSError(errno.EINVAL, f"is a {what}, not a file", path)


def expect_file(path: str | os.PathLike[str]) -> None:
    """Raises FileError "... is a pipe, not a file" for what is there and is none; else returns.

    Before a path is handed to another library. A folder may be an ensemble, or a store of Zarr.
    """
    from pliant._core import FileError

    if not os.path.exists(path) or os.path.isdir(path):
        return
    try:
        os.close(open_file(os.fspath(path), os.O_RDONLY))
    except OSError as error:
        raise FileError(f"{os.fspath(path)}: {error.strerror}") from None


def json_object(text: str | bytes) -> dict[str, Any]:
    """Raises ValueError for whatever is none, and for what is nested too deeply."""
    try:
        found = json.loads(text)
    except RecursionError:
        raise ValueError("nested too deeply") from None
    if not isinstance(found, dict):
        raise ValueError(f"expected a JSON object, found {json.dumps(found)[:40]}")
    return found
