# SPDX-License-Identifier: MIT
"""One command in one folder: by a lock, where the file system has locks."""

from __future__ import annotations

import contextlib
import errno
import os
import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import TextIO

from pliant._core import FileError
from pliant.base.console import warn
from pliant.base.file_lock import take_lock
from pliant.shards.plan_made import has_begun
from pliant.trajectory.shards.plan import PLAN

_MOUNTS = Path("/proc/self/mounts")

#: Options of a mount with which locks hold on one machine only, by the kind of file system.
_LOCAL_LOCKS = {
    "nfs": {"nolock", "local_lock=all", "local_lock=flock"},
    "nfs4": {"nolock", "local_lock=all", "local_lock=flock"},
    "lustre": {"localflock"},
}

_ALONE = "see to it that no other machine runs pliant ensemble in it (its jobs may)"


@contextlib.contextmanager
def alone_in(folder: Path) -> Iterator[None]:
    """Makes the folder. Raises FileError if that fails, or if another command is at work there.

    Warns where the file system has no locks, or has them for one machine only. A folder that was
    made here and holds neither plan nor shard goes when the work fails.
    """
    is_new = not folder.exists()
    with _lock_file(folder) as file:
        _lock(folder, file)
        try:
            yield
        except Exception:
            if is_new and not (folder / PLAN).exists() and not has_begun(folder):
                shutil.rmtree(folder, ignore_errors=True)
            raise


def _lock_file(folder: Path) -> TextIO:
    try:
        folder.mkdir(parents=True, exist_ok=True)
        return open(folder / ".lock", "w", encoding="utf-8")
    except OSError as error:
        raise FileError(f"{folder}: {error.strerror}: expected a folder for the ensemble") from None


def _lock(folder: Path, file: TextIO) -> None:
    kind, options = mount_of(folder)
    try:
        take_lock(file)
    except OSError as error:
        if error.errno in (errno.EAGAIN, errno.EACCES):
            raise FileError(f"{folder}: another pliant ensemble is at work in it") from None
        warn(f"{folder}: its file system{kind and f' ({kind})'} takes no lock: {_ALONE}")
        return
    if options & _LOCAL_LOCKS.get(kind, set()):
        warn(f"{folder}: locks of its file system ({kind}) hold on this machine only: {_ALONE}")


def mount_of(path: Path) -> tuple[str, set[str]]:
    """Kind and options of the file system that holds a path; "" where the system does not say."""
    try:
        lines = _MOUNTS.read_text(encoding="utf-8", errors="surrogateescape").splitlines()
    except OSError:
        return "", set()
    where = os.path.realpath(path)
    found, longest = ("", set[str]()), -1
    for line in lines:
        words = line.split(" ")
        if len(words) < 4:
            continue
        point = words[1].replace("\\040", " ")
        if len(point) >= longest and os.path.commonpath([where, point]) == point:
            found, longest = (words[2], set(words[3].split(","))), len(point)
    return found
