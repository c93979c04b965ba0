# SPDX-License-Identifier: MIT
"""Worker processes: tasks in, results out; none outlives the command."""

from __future__ import annotations

import multiprocessing
import signal
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from pliant.base.processes import end_with_parent

Task = TypeVar("Task")
Result = TypeVar("Result")


def each_done(
    work: Callable[[Task], Result], tasks: Sequence[Task], workers: int
) -> Iterator[Result]:
    """Results of `work` on each task, in their order.

    With one worker all is done in this process. `work` must be a function of a module, or a
    functools.partial of one.
    """
    if workers <= 1 or len(tasks) <= 1:
        yield from map(work, tasks)
        return
    context = multiprocessing.get_context("spawn")
    # Leaving the block, also by Ctrl-C, ends the workers at once.
    with context.Pool(min(workers, len(tasks)), _begin_worker) as pool:
        yield from pool.imap(work, tasks)


def _begin_worker() -> None:
    """Leaves Ctrl-C to the parent, and ends with it even if it was killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    end_with_parent()
