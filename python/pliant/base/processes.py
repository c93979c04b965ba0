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
from collections.abc import Iterator, Mapping
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
def ended_by_signals(command: str, others: Mapping[str, int] | None = None) -> Iterator[None]:
    """SIGTERM and SIGHUP unwind like Ctrl-C, so that whatever the command has started ends with it.

    So do the signals named in `others`, with an exit code each: the same command then goes on. What
    whoever started the command has ignored (nohup) stays ignored. Signals that `pliant` has held
    back while Python started come now.
    """
    if threading.current_thread() is not threading.main_thread():
        yield  # which alone hears signals
        return
    codes = {"SIGTERM": 128 + signal.SIGTERM, "SIGHUP": 129, **(others or {})}
    numbers = [getattr(signal, name) for name in codes if hasattr(signal, name)]

    def end(number: int, frame: object) -> None:
        for one in numbers:  # it may come again, which must not disturb the end
            signal.signal(one, signal.SIG_IGN)
        name = signal.Signals(number).name
        again = ": the same command goes on" if name in (others or {}) else ""
        print(f"pliant {command}: ended by {name}{again}", file=sys.stderr)
        raise SystemExit(codes[name])

    before = {one: signal.getsignal(one) for one in numbers}
    heard = [one for one in numbers if before[one] != signal.SIG_IGN]
    for one in heard:
        signal.signal(one, end)
    try:
        if hasattr(signal, "pthread_sigmask"):
            signal.pthread_sigmask(signal.SIG_UNBLOCK, [*numbers, signal.SIGINT])
        yield
    finally:
        for one in heard:
            signal.signal(one, before[one])


def die_with_parent(parent: int, end: int) -> None:
    """Between fork and exec, on Linux: a command that gets this signal when its parent ends.

    `parent` is the number of that process, which may have ended before this is called.
    """
    if sys.platform != "linux":
        return
    ctypes.CDLL(None).prctl(_DIE_WITH_PARENT, end)
    if os.getppid() != parent:
        os.kill(os.getpid(), end)
