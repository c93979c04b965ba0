# SPDX-License-Identifier: MIT
"""Makes one shard, wherever there is the package: in a worker of Dask, or in a job of a queue."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import uuid
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path

from pliant._core import InputError
from pliant.base.console import EXIT_INTERRUPTED, warn
from pliant.base.processes import die_with_parent
from pliant.jobs.process import JobEndedError, run_job
from pliant.shards.commits import remove_logs, take_log
from pliant.shards.scratch import Unfinished, place_of, publish, remove_left, unfinished
from pliant.shards.time_limit import OutOfTimeError, seconds_left
from pliant.trajectory.shards.inspect_shard import ShardRecord, check_shard, inspect_shard
from pliant.trajectory.shards.plan import EnsemblePlan, Shard

#: Tells a command to commit and end, however often it comes.
_END = getattr(signal, "SIGUSR1", signal.SIGTERM)

#: Seconds until a command has done so.
END_SECONDS = 60.0


@dataclass(frozen=True)
class Making:
    """How shards are made, which changes nothing of them."""

    scratch: str | None = None  #: folder on a disk of the machine; may hold variables
    deadline: float | None = None  #: when to commit and end (time.time())
    commit_seconds: float | None = None  #: between commits; None: the command's own
    #: a word in the names of unfinished shards, by which a command knows its own
    owner: str = field(default_factory=lambda: uuid.uuid4().hex[:8])


def make_shard(
    plan: EnsemblePlan, shard: Shard, folder: str, how: Making | None = None
) -> ShardRecord:
    """Makes a shard, unless it is there and complete, and returns its record.

    What an attempt before this one has committed is not made again; the bytes are the same.

    The file takes its name when it is complete, and then replaces one that is not. Where two make
    the same shard, the first one's file stays. Raises as `run_job`, OptionError where no other
    attempt would succeed, and OutOfTimeError where the deadline came first.
    """
    target = Path(folder, shard.name)
    is_damaged = False
    if target.exists():
        try:
            return check_shard(plan, shard, None, target)
        except InputError as error:
            warn(f"{error}: it is made again")
            is_damaged = True
    how, whole = how or Making(), Path(folder)
    place = place_of(whole, how.scratch)
    remove_left(place, whole)
    with unfinished(place, whole, how.owner) as made:
        _call_for(plan, shard, made, whole, how)
        record = inspect_shard(plan, shard, made.path)
        is_ours = publish(made.path, whole, target, is_damaged, how.owner)
    remove_logs(whole, shard)
    return record if is_ours else inspect_shard(plan, shard, target)


def _call_for(
    plan: EnsemblePlan, shard: Shard, made: Unfinished, folder: Path, how: Making
) -> None:
    """Calls the command that makes a shard. It is told to commit and end where this process has to.

    It holds the lock as long as it lives, also longer than this process.
    """
    job = plan.job(shard, str(made.path)) | {"commits": str(take_log(folder, plan, shard))}
    if how.commit_seconds is not None:
        job["commit_seconds"] = how.commit_seconds
    try:
        run_job(
            job,
            "--quiet",
            talk=partial(_until, how.deadline),
            start_new_session=True,  # Ctrl-C is for the ensemble
            preexec_fn=_end_with_parent(),
            pass_fds=[made.lock.fileno()] if made.lock is not None and os.name == "posix" else [],
        )
    except JobEndedError as error:
        # -_END: told before it had begun to listen, as on a busy machine
        if how.deadline is not None and error.args[1] in (EXIT_INTERRUPTED, -_END):
            raise OutOfTimeError from None
        raise


def check_options(plan: EnsemblePlan, folder: str) -> None:
    """Raises as make_shard does where the input or the options are bad; makes nothing."""
    run_job(plan.job(plan.shard(0), str(Path(folder, "nothing.h5md"))), "--dry-run")


def _until(deadline: float | None, command: subprocess.Popen[bytes], text: bytes) -> bytes:
    try:
        return command.communicate(text, seconds_left(deadline))[0]
    except subprocess.TimeoutExpired:
        return _told_to_end(command)
    except BaseException:
        _told_to_end(command)
        raise


def _told_to_end(command: subprocess.Popen[bytes]) -> bytes:
    """What it printed, once it has committed; it is killed if that takes too long."""
    command.send_signal(_END)
    try:
        return command.communicate(timeout=END_SECONDS)[0]
    except subprocess.TimeoutExpired:
        command.kill()
        return command.communicate()[0]


def _end_with_parent() -> Callable[[], None] | None:
    """A worker that is killed takes its command along, which commits before."""
    if sys.platform != "linux":
        return None
    return partial(die_with_parent, os.getpid(), _END)
