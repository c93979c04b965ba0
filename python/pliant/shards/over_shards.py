# SPDX-License-Identifier: MIT
"""The same work on all shards of an ensemble, over some processes or threads."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from multiprocessing import get_context
from typing import TypeVar

import numpy as np

from pliant.base.processes import end_with_parent, usual_workers

#: Parts into which the shards are dealt, however many processes there are: what parts give is added
#: in their order, so that the sums have the same bits with any number of processes.
MOST_PARTS = 128

Item = TypeVar("Item")
Task = TypeVar("Task")
Result = TypeVar("Result")


def parts_of(shards: Sequence[Item]) -> list[list[Item]]:
    """The shards, or something of each, in parts of about the same size."""
    parts = np.array_split(np.arange(len(shards)), min(MOST_PARTS, len(shards)))
    return [[shards[k] for k in part] for part in parts]


def each_part(
    work: Callable[[Task], Result], tasks: Sequence[Task], workers: int
) -> Iterator[Result]:
    """The results of all tasks, in their order, over some processes, which end with this one.

    One task more than there are processes is under way or done at most: a result may be large.
    """
    if workers == 1:
        yield from map(work, tasks)
        return
    context = get_context("spawn")
    with ProcessPoolExecutor(workers, context, initializer=end_with_parent) as pool:
        yield from _in_order(pool, work, tasks, workers + 1)


def in_threads(work: Callable[[Task], Result], tasks: Iterable[Task]) -> Iterator[Result]:
    """The results of tasks that wait for the disk, or for what needs no interpreter, in order."""
    threads = usual_workers()
    with ThreadPoolExecutor(threads) as pool:
        yield from _in_order(pool, work, tasks, 4 * threads)


def _in_order(
    pool: Executor, work: Callable[[Task], Result], tasks: Iterable[Task], most: int
) -> Iterator[Result]:
    waiting: deque[Future[Result]] = deque()
    for task in tasks:
        waiting.append(pool.submit(work, task))
        if len(waiting) >= most:
            yield waiting.popleft().result()
    while waiting:
        yield waiting.popleft().result()
