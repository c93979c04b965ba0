# SPDX-License-Identifier: MIT
"""Processes that work for this one: how many, and that none of them outlives it."""

from __future__ import annotations

import contextlib
import ctypes
import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Iterator
from multiprocessing.connection import wait

_DIE_WITH_PARENT = 1  # PR_SET_PDEATHSIG of Linux


def usual_workers() -> int:
    """As many as this process may use cores."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def end_with_parent() -> None:
    """Ends this process of multiprocessing as soon as its parent has ended, however that was.

    The queue from which it takes its work says nothing of that: it holds both of its ends.
    """
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_after, args=(parent.sentinel,), daemon=True).start()


def _end_after(sentinel: int) -> None:
    wait([sentinel])
    os._exit(1)


@contextlib.contextmanager
def ended_by_sigterm(command: str) -> Iterator[None]:
    """SIGTERM unwinds like Ctrl-C, so that whatever the command has started ends with it."""

    def end(number: int, frame: object) -> None:
        print(f"pliant {command}: ended by SIGTERM", file=sys.stderr)
        raise SystemExit(128 + number)

    if threading.current_thread() is not threading.main_thread():
        yield  # which alone hears signals
        return
    before = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def die_with_parent(parent: int, end: int) -> None:
    """Between fork and exec, on Linux: a command that gets this signal when its parent ends.

    `parent` is the number of that process, which may have ended before this is called.
    """
    if sys.platform != "linux":
        return
    ctypes.CDLL(None).prctl(_DIE_WITH_PARENT, end)
    if os.getppid() != parent:
        os.kill(os.getpid(), end)
