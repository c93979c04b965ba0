# SPDX-License-Identifier: MIT
"""The same work on all shards of an ensemble, over some processes."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import TypeVar

import numpy as np

#: Parts into which the shards are dealt, however many processes there are: what parts give is added
#: in their order, so that the sums have the same bits with any number of processes.
MOST_PARTS = 128

Task = TypeVar("Task")
Result = TypeVar("Result")


def parts_of(paths: Sequence[Path]) -> list[list[Path]]:
    """The shards in parts of about the same size."""
    parts = np.array_split(np.arange(len(paths)), min(MOST_PARTS, len(paths)))
    return [[paths[k] for k in part] for part in parts]


def each_part(
    work: Callable[[Task], Result], tasks: Sequence[Task], workers: int
) -> Iterator[Result]:
    """The results of all tasks, in their order.

    One task more than there are processes is under way or done at most: a result may be large.
    """
    if workers == 1:
        yield from map(work, tasks)
        return
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
        waiting: deque[Future[Result]] = deque()
        for task in tasks:
            waiting.append(pool.submit(work, task))
            if len(waiting) > workers:
                yield waiting.popleft().result()
        while waiting:
            yield waiting.popleft().result()
