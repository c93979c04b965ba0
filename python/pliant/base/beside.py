# SPDX-License-Identifier: MIT
"""Work that a copy of this process does meanwhile, where that is safe."""

from __future__ import annotations

import os
import pickle
import signal
import sys
import tempfile
import threading
import warnings
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Generic, TypeVar

if TYPE_CHECKING:
    from typing_extensions import Self

Result = TypeVar("Result")


def may_fork() -> bool:
    """Whether this process may be copied, and there is a processor for the copy.

    Not where it has other threads, whose locks the copy would never see released, nor on other
    systems than Linux, whose libraries do not all survive a fork.
    """
    return sys.platform == "linux" and len(os.sched_getaffinity(0)) > 1 and _is_alone()


def _is_alone() -> bool:
    """Whether no other thread may hold a lock; tqdm's monitor only has those of progress bars."""
    others = (one for one in threading.enumerate() if one is not threading.current_thread())
    return all(type(thread).__name__ == "TMonitor" for thread in others)


def forked(work: Callable[[], object]) -> int:
    """The number of a copy of this process that does the work, and ends with 0 if it is done."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # threads of BLAS, which it restarts
        child = os.fork()
    if child == 0:
        status = 1
        try:
            work()
            status = 0
        finally:
            os._exit(status)
    return child


class _Pickler(pickle.Pickler):
    """Leaves objects that both processes have where they are."""

    shared: Sequence[object] = ()

    def persistent_id(self, obj: object) -> int | None:
        """Its place among them."""
        return next((k for k, one in enumerate(self.shared) if one is obj), None)


class _Unpickler(pickle.Unpickler):
    shared: Sequence[object] = ()

    def persistent_load(self, pid: Any) -> object:
        return self.shared[pid]


def _nameless_file() -> Any:
    return tempfile.TemporaryFile(prefix="pliant-")


class Beside(Generic[Result]):
    """What a copy of this process works out, from now on; nothing where NumPy has threads of its
    own: those of two processes wait for each other by counting, ten times as long.

    shared: objects of this process that the result may refer to, and which are not copied.
    """

    def __init__(self, work: Callable[[], Result], shared: Sequence[object] = ()) -> None:
        self._shared = shared
        self._file = _nameless_file()
        is_safe = may_fork() and os.environ.get("OPENBLAS_NUM_THREADS") == "1"
        self._child: int | None = forked(lambda: self._send(work())) if is_safe else None

    def _send(self, result: Result) -> None:
        pickler = _Pickler(self._file, pickle.HIGHEST_PROTOCOL)
        pickler.shared = self._shared
        pickler.dump(result)
        self._file.flush()

    def result(self) -> Result | None:
        """Waits for it. None where there is no copy, or it failed: an error here has its text."""
        child, self._child = self._child, None
        if child is None or os.waitpid(child, 0)[1] != 0:
            return None
        self._file.seek(0)
        unpickler = _Unpickler(self._file)
        unpickler.shared = self._shared
        found: Result = unpickler.load()
        return found

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Ends the work if nobody has waited for it."""
        if self._child is not None:
            os.kill(self._child, signal.SIGKILL)
            os.waitpid(self._child, 0)
        self._file.close()
