# SPDX-License-Identifier: MIT
"""Progress bars of calls that take seconds: in notebooks and on terminals, nowhere else.

They are tqdm's where it is installed (MDAnalysis brings it). TQDM_DISABLE=1 hides them.
"""

from __future__ import annotations

import os
import sys
import time
import warnings
from types import TracebackType
from typing import Any, Protocol

DELAY = 2.0  #: seconds that a call takes before its bar is shown
INTERVAL = 0.1  #: seconds from one look of a call at its bar, and at Ctrl-C, to the next
WIDTH = 24  #: characters of a bar of our own

_hidden = False


class Bar(Protocol):
    """What `begin` gives."""

    def show(self, done: int) -> None:
        """Draws how much is done."""

    def close(self) -> None:
        """Takes the bar away."""


def hide() -> None:
    """Shows no bars in this process: commands have their own, or --quiet."""
    global _hidden
    _hidden = True


def in_notebook() -> bool:
    """Whether a notebook's kernel runs this process."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return getattr(shell, "kernel", None) is not None


def _is_one_of_several() -> bool:
    """Whether multiprocessing has begun this process; it is then imported, else need not be."""
    multiprocessing = sys.modules.get("multiprocessing")
    return multiprocessing is not None and multiprocessing.parent_process() is not None


def _is_wanted() -> bool:
    if _hidden or os.environ.get("TQDM_DISABLE", "0") not in ("", "0"):
        return False
    if _is_one_of_several():  # all would draw at once
        return False
    return in_notebook() or (sys.stderr is not None and sys.stderr.isatty())


def begin(what: str, total: int) -> Bar | None:
    """A bar of `total` things, which appears once DELAY has gone; None if nobody would see it."""
    if not _is_wanted():
        return None
    try:
        return _TqdmBar(what, total)
    except ImportError:
        return None if in_notebook() else _PlainBar(what, total)


class _TqdmBar:
    def __init__(self, what: str, total: int) -> None:
        with warnings.catch_warnings():  # without ipywidgets tqdm draws text, and warns of it
            warnings.simplefilter("ignore")
            from tqdm.auto import tqdm

            self._bar: Any = tqdm(total=total, desc=what, delay=DELAY, leave=False)

    def show(self, done: int) -> None:
        self._bar.update(done - self._bar.n)

    def close(self) -> None:
        self._bar.close()


class _PlainBar:
    """For terminals without tqdm."""

    def __init__(self, what: str, total: int) -> None:
        self._what, self._total = what, total
        self._begun, self._is_shown = time.monotonic(), False

    def show(self, done: int) -> None:
        if time.monotonic() - self._begun < DELAY:
            return
        self._is_shown = True
        bar = "#" * (WIDTH * done // max(self._total, 1))
        text = f"{self._what}: [{bar:.<{WIDTH}}] {done} / {self._total}"
        print(f"\r{text}\x1b[K", end="", file=sys.stderr, flush=True)

    def close(self) -> None:
        if self._is_shown:
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)


class Stages:
    """A bar of stages, each named as it begins: ``with Stages("analyse", 3) as on_stage``."""

    def __init__(self, what: str, total: int) -> None:
        self._bar = begin(what, total)
        self._done = 0

    def __enter__(self) -> Stages:
        return self

    def __call__(self, name: str) -> None:
        """One more stage begins."""
        if self._bar is not None:
            self._bar.show(self._done)
        self._done += 1

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.close()
