# SPDX-License-Identifier: MIT
"""Files that are read, whoever wrote them: none is waited for, none fills the memory."""

from __future__ import annotations

import bz2
import errno
import gzip
import hashlib
import io
import json
import lzma
import os
import stat
import zlib
from collections.abc import Callable, Iterator
from typing import IO, Any, cast

from pliant._core import FileError, InputError

_EXPANDERS: dict[bytes, Callable[[IO[bytes]], Any]] = {
    b"\x1f\x8b": gzip.open,
    b"BZ": bz2.open,
    b"\xfd7": lzma.open,
}


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


def file_digest(path: str | os.PathLike[str]) -> str:
    """SHA-256 of a file's bytes. Raises FileError."""
    try:
        with open(path, "rb", opener=open_file) as file:
            digest = hashlib.sha256()
            while block := file.read(1 << 20):
                digest.update(block)
            return digest.hexdigest()
    except OSError as error:
        raise FileError(f"{os.fspath(path)}: {error.strerror}") from None


def lines_of(path: str, longest: int, most: int, remedy: str) -> Iterator[str]:
    """Lines of text, also of a compressed file; one that is too long comes in pieces of `longest`.

    Bytes that are not UTF-8 are kept, and written as they were. Raises FileError where it cannot be
    read, InputError where its compression is damaged, or where it expands to more than `most`
    letters, each of one byte or more; `remedy` is the option that allows more.
    """
    left = most
    try:
        with open(path, "rb", opener=open_file) as file, _expanded(file) as lines:
            while line := lines.readline(longest):
                left -= len(line)
                if left < 0:
                    size = f"{most} bytes" if most % 10**6 else f"{most // 10**6} MB"
                    raise InputError(
                        f"{path}: holds more than {size}, the most that is read; {remedy} allows "
                        "more"
                    )
                yield line
    except (EOFError, gzip.BadGzipFile, lzma.LZMAError, zlib.error) as error:
        raise InputError(f"{path}: its compression is damaged: {error}") from None
    except OSError as error:
        raise FileError(f"{path}: {error.strerror or error}") from None


def _expanded(file: io.BufferedReader) -> IO[str]:
    expander = _EXPANDERS.get(file.peek(2)[:2])
    binary = cast("IO[bytes]", expander(file)) if expander else file
    return io.TextIOWrapper(binary, encoding="utf-8-sig", errors="surrogateescape")


def expect_file(path: str | os.PathLike[str]) -> None:
    """Raises FileError "... is a pipe, not a file" for what is there and is none; else returns.

    Before a path is handed to another library. A folder may be an ensemble, or a store of Zarr.
    """
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
