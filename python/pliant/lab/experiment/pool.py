# SPDX-License-Identifier: MIT
"""Worker processes: tasks in, results out as they are done; none outlives the command."""

from __future__ import annotations

import multiprocessing
import multiprocessing.connection
import os
import signal
import threading
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

Task = TypeVar("Task")
Result = TypeVar("Result")


def usable_cores() -> int:
    """How many processes may run at once here."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def each_done(
    work: Callable[[Task], Result], tasks: Sequence[Task], workers: int
) -> Iterator[Result]:
    """Results of `work` on each task, in the order in which they are done.

    With one worker all is done in this process. `work` must be a function of a module, or a
    functools.partial of one.
    """
    if workers <= 1 or len(tasks) <= 1:
        yield from map(work, tasks)
        return
    context = multiprocessing.get_context("spawn")
    # Leaving the block, also by Ctrl-C, ends the workers at once.
    with context.Pool(min(workers, len(tasks)), _begin_worker) as pool:
        yield from pool.imap_unordered(work, tasks)


def _begin_worker() -> None:
    """Leaves Ctrl-C to the parent, and ends with it even if it was killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_with, args=(parent.sentinel,), daemon=True).start()


def _end_with(sentinel: int) -> None:
    multiprocessing.connection.wait([sentinel])
    os._exit(1)
