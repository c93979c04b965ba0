# SPDX-License-Identifier: MIT
"""Node-local disks: shards are written there, and moved to the ensemble's folder when whole."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import uuid
from collections.abc import Iterator
from pathlib import Path

from pliant._core import FileError, OptionError
from pliant.ensemble.plan import MAKING

#: What --scratch without a folder means: queues set it for each job.
USUAL = "$TMPDIR"


@contextlib.contextmanager
def partial_name(folder: Path, scratch: str | None) -> Iterator[Path]:
    """A name for an unfinished shard: on the scratch disk if there is one, else in `folder`."""
    making = folder / MAKING
    making.mkdir(exist_ok=True)
    path = (making if scratch is None else local_folder(scratch)) / f"{uuid.uuid4().hex}.h5md"
    try:
        yield path
    finally:
        path.unlink(missing_ok=True)
        path.with_name(f".{path.name}.partial").unlink(missing_ok=True)


def local_folder(scratch: str) -> Path:
    """The folder, where the shard is made. Raises OptionError where a variable is not set."""
    path = os.path.expanduser(os.path.expandvars(scratch))
    unset = re.search(r"\$\{?(\w+)", path)
    if unset:
        raise OptionError(f"--scratch {scratch}: {unset[1]} is not set where the shard is made")
    if not os.path.isdir(path):
        raise OptionError(f"--scratch {scratch}: {path}: expected a folder where the shard is made")
    return Path(path)


def publish(made: Path, folder: Path, target: Path, replaces: bool) -> bool:
    """On the disk before it has its name; False where another file of that name is to stay.

    From a scratch disk it is copied first, under a name that nobody looks for.
    """
    if made.parent == folder / MAKING:
        return _named(made, target, replaces)
    near = folder / MAKING / made.name
    try:
        shutil.copyfile(made, near)
        return _named(near, target, replaces)
    except OSError as error:
        raise FileError(f"{near}: {error.strerror}") from None
    finally:
        near.unlink(missing_ok=True)


def _named(made: Path, target: Path, replaces: bool) -> bool:
    with open(made, "rb") as file:
        os.fsync(file.fileno())
    if replaces:
        made.rename(target)
        return True
    try:
        os.link(made, target)
    except FileExistsError:
        return False
    except OSError:  # a file system without links
        made.rename(target)
    return True
