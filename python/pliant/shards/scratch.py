# SPDX-License-Identifier: MIT
"""Unfinished shards: on a disk of the machine that makes them, or in the ensemble's folder.

Beside each lies a lock, which the process that makes the shard and its command hold. What a killed
process has left is known by its name, which tells the ensemble, and by its lock, which nobody has.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import os
import re
import shutil
import time
import uuid
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from pliant._core import FileError, OptionError
from pliant.base.file_lock import take_lock
from pliant.base.new_file import take_name
from pliant.shards.plan_made import MAKING

#: What --scratch without a folder means: queues set it for each job.
USUAL = "$TMPDIR"

LOCK = ".lock"  #: how the name of a lock ends
_PAUSE = 0.02  #: seconds between two looks at a lock


@dataclass(frozen=True)
class Unfinished:
    """A name for a shard that is being made, and its lock."""

    path: Path
    lock: BinaryIO

    def remove(self) -> None:
        """Removes what is there under this name."""
        _remove(Path(self.lock.name))
        self.lock.close()


@contextlib.contextmanager
def unfinished(place: Path, folder: Path, owner: str) -> Iterator[Unfinished]:
    """A name in `place` for a shard of the ensemble in `folder`; nothing of it is left at the end.

    `owner` is a word of the command that makes shards.
    """
    made = _begun(place, f"{_name_of(folder)}-{owner}")
    try:
        yield made
    finally:
        made.remove()


def remove_left(place: Path, folder: Path, owner: str = "", wait: float = 0.0) -> None:
    """Removes unfinished shards of an ensemble that nobody makes any more.

    What is still being made for `owner` has `wait` seconds to end; else it stays.
    """
    begin, end = _name_of(folder), time.monotonic() + wait
    for lock in place.glob(f"{begin}-*{LOCK}"):
        is_own = lock.name.startswith(f"{begin}-{owner}-")
        with contextlib.suppress(OSError), open(lock, "r+b") as file:
            if _is_free(file, end if is_own else 0.0):
                _remove(lock)


def making_in(folder: Path) -> Path:
    """The folder in an ensemble's own for what is being made."""
    making = folder / MAKING
    making.mkdir(exist_ok=True)
    return making


def place_of(folder: Path, scratch: str | None) -> Path:
    """Where shards are made. Raises OptionError where a variable is not set."""
    return making_in(folder) if scratch is None else local_folder(scratch)


def local_folder(scratch: str) -> Path:
    """The folder, where the shard is made. Raises OptionError where a variable is not set."""
    path = os.path.expanduser(os.path.expandvars(scratch))
    unset = re.search(r"\$\{?(\w+)", path)
    if unset:
        raise OptionError(f"--scratch {scratch}: {unset[1]} is not set where the shard is made")
    if not os.path.isdir(path):
        raise OptionError(f"--scratch {scratch}: {path}: expected a folder where the shard is made")
    return Path(path)


def publish(made: Path, folder: Path, target: Path, replaces: bool, owner: str = "") -> bool:
    """On the disk before it has its name; False where another file of that name is to stay.

    From a scratch disk it is copied first, under a name that nobody looks for.
    """
    if made.parent == folder / MAKING:
        return _named(made, target, replaces)
    with unfinished(making_in(folder), folder, owner) as near:
        try:
            shutil.copyfile(made, near.path)
            return _named(near.path, target, replaces)
        except OSError as error:
            raise FileError(f"{near.path}: {error.strerror}") from None


def _name_of(folder: Path) -> str:
    """How names of what is made for an ensemble begin."""
    return f"pliant-{hashlib.sha256(os.fsencode(os.path.realpath(folder))).hexdigest()[:16]}"


def _begun(place: Path, begin: str) -> Unfinished:
    while True:
        path = place / f"{begin}-{uuid.uuid4().hex}.h5md"
        file = open(f"{path}{LOCK}", "xb")  # noqa: SIM115  (as long as the shard is made)
        try:
            take_lock(file)
        except OSError as error:
            if _is_taken(error):  # by another, which has taken it for one that was left
                file.close()
                continue  # a file system without locks keeps what is left
        if os.path.exists(file.name):
            return Unfinished(path, file)
        file.close()


def _is_taken(error: OSError) -> bool:
    return error.errno in (errno.EAGAIN, errno.EACCES)


def _is_free(file: BinaryIO, end: float) -> bool:
    """Whether nobody has the lock, at the latest at that time. Raises OSError without locks."""
    while True:
        try:
            take_lock(file)
            return True
        except OSError as error:
            if not _is_taken(error):
                raise
        if time.monotonic() >= end:
            return False
        time.sleep(_PAUSE)


def _remove(lock: Path) -> None:
    """The lock last: as long as it is there, the rest is known to be ours."""
    path = lock.with_name(lock.name.removesuffix(LOCK))
    for one in (path, path.with_name(f".{path.name}.partial"), lock):
        one.unlink(missing_ok=True)


def _named(made: Path, target: Path, replaces: bool) -> bool:
    with open(made, "rb") as file:
        os.fsync(file.fileno())
    if replaces:
        made.rename(target)
    return replaces or take_name(made, target)
