# SPDX-License-Identifier: MIT
"""The same work on all shards of an ensemble, over some processes."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path
from typing import TypeVar

import numpy as np

_TASKS_A_PROCESS = 4

Task = TypeVar("Task")
Result = TypeVar("Result")


def parts_of(paths: Sequence[Path], workers: int) -> list[list[Path]]:
    """The shards in parts of about the same size, a few for each process."""
    parts = np.array_split(np.arange(len(paths)), workers * _TASKS_A_PROCESS)
    return [[paths[k] for k in part] for part in parts if len(part)]


def each_part(
    work: Callable[[Task], Result], tasks: Sequence[Task], workers: int
) -> Iterator[Result]:
    """The results of all tasks, in their order."""
    if workers == 1:
        yield from map(work, tasks)
        return
    with ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool:
        yield from pool.map(work, tasks)
