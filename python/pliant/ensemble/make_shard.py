# SPDX-License-Identifier: MIT
"""Makes one shard, wherever there is the package: in a worker of Dask, or in a job of a queue."""

from __future__ import annotations

import contextlib
import json
import os
import re
import subprocess
import sys
import uuid
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

from pliant._core import Error, InputError, OptionError
from pliant._processes import die_with_parent
from pliant.console import command_path, warn
from pliant.ensemble.inspect_shard import ShardRecord, check_shard, inspect_shard
from pliant.ensemble.plan import EnsemblePlan, Shard

MAKING = "making"  #: folder of unfinished shards; what killed workers leave there is removed
_WITH_FRAMES = (0, 3)  #: exit codes of a command that has written all that it could
_BAD_OPTION = 2


class ShardError(Error):
    """A shard could not be made; another attempt might succeed."""


def make_shard(plan: EnsemblePlan, shard: Shard, folder: str) -> ShardRecord:
    """Makes a shard, unless it is there and whole, and returns its record.

    The file takes its name when it is whole, and then replaces one that is not. Where two make the
    same shard, the first one's file stays. Raises OptionError if the command takes an option for
    bad, ShardError if it fails.
    """
    target = Path(folder, shard.name)
    is_damaged = False
    if target.exists():
        try:
            return check_shard(plan, shard, None, target)
        except InputError as error:
            warn(f"{error}: it is made again")
            is_damaged = True
    with _partial_name(Path(folder, MAKING)) as partial_file:
        _run(plan.words(shard, str(partial_file)))
        record = inspect_shard(plan, shard, partial_file)
        if _publish(partial_file, target, is_damaged):
            return record
    return inspect_shard(plan, shard, target)


@contextlib.contextmanager
def _partial_name(folder: Path) -> Iterator[Path]:
    folder.mkdir(exist_ok=True)
    path = folder / f"{uuid.uuid4().hex}.h5md"
    try:
        yield path
    finally:
        path.unlink(missing_ok=True)


def _publish(made: Path, target: Path, replaces: bool) -> bool:
    """On the disk before it has its name; False where another file of that name is to stay."""
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


def check_options(plan: EnsemblePlan, folder: str) -> None:
    """Raises as make_shard does where the input or the options are bad; makes nothing."""
    words = plan.words(plan.shard(0), str(Path(folder, "nothing.h5md")))
    _call([*words, "--dry-run"])


def _run(words: list[str]) -> dict[str, Any]:
    """The summary of the command, as JSON."""
    summary: dict[str, Any] = json.loads(_call(words))
    return summary


def _call(words: list[str]) -> str:
    """What the command printed."""
    done = subprocess.run(
        [command_path(), *words],
        capture_output=True,
        text=True,
        errors="surrogateescape",
        start_new_session=True,  # Ctrl-C is for the ensemble
        preexec_fn=partial(die_with_parent, os.getpid()) if sys.platform == "linux" else None,
    )
    if done.returncode in _WITH_FRAMES:
        return done.stdout
    why = (done.stderr.strip().splitlines() or [f"ended with {done.returncode}"])[0]
    why = re.sub(r"^pliant( \w+)?: error: ", "", why)
    raise (OptionError if done.returncode == _BAD_OPTION else ShardError)(why)
