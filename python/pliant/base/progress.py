# SPDX-License-Identifier: MIT
"""Progress of what takes seconds: bars in notebooks and on terminals, nowhere else.

Those of calls are tqdm's where it is installed (MDAnalysis brings it); TQDM_DISABLE=1 hides them.
Those of commands are their own, with --quiet none; where there is no terminal, what takes minutes
says lines.
"""

from __future__ import annotations

import contextlib
import os
import sys
import time
import warnings
from collections.abc import Callable, Iterator
from types import TracebackType
from typing import Any, Protocol

from pliant.base.extras import late

tqdm_auto = late("tqdm.auto")

DELAY = 2.0  #: seconds that a call takes before its bar is shown
INTERVAL = 0.1  #: seconds from one look of a call at its bar, and at Ctrl-C, to the next
WIDTH = 24  #: characters of a bar of our own
LINE_EVERY = 10.0  #: seconds between lines of progress where there is no terminal

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
            self._bar: Any = tqdm_auto.tqdm(total=total, desc=what, delay=DELAY, leave=False)

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
        _draw(self._what, done, self._total)

    def close(self) -> None:
        if self._is_shown:
            _over_the_line("")


def _draw(what: str, done: int, total: int, more: str = "") -> None:
    bar = "#" * (WIDTH * done // max(total, 1))
    _over_the_line(f"{what}: [{bar:.<{WIDTH}}] {done} / {total}{more}")


def _over_the_line(text: str) -> None:
    print(f"\r{text}\x1b[K", end="", file=sys.stderr, flush=True)


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


@contextlib.contextmanager
def progress(
    what: str, quiet: bool = False, *, lines: bool = False, rate: bool = False
) -> Iterator[Callable[[int, int], None]]:
    """Gives a function (done, total) that draws a bar over itself: on a terminal, in a notebook.

    Elsewhere nothing is drawn, or with `lines`, for work of minutes, a line now and then. With
    `rate` the bar says how many are done in a second.
    """
    shown = not quiet and sys.stderr.isatty()
    bars: list[Bar | None] = []
    last, shown_done = time.monotonic(), -1
    began: list[tuple[int, float]] = []

    def show(done: int, total: int) -> None:
        if shown:
            began[:] = began or [(done, time.monotonic())]
            first, at = began[0]
            speed = (done - first) / max(time.monotonic() - at, 1e-3)
            _draw(what, done, total, f", {speed:.1f} a second" if rate else "")
        elif not quiet and in_notebook():
            bars[:] = bars or [begin(what, total)]
            if bars[0] is not None:
                bars[0].show(done)
        elif not quiet and lines:
            say(done, total)

    def say(done: int, total: int) -> None:
        nonlocal last, shown_done
        if time.monotonic() - last >= LINE_EVERY and done != shown_done:
            last, shown_done = time.monotonic(), done
            print(f"{what}: {done} of {total}", file=sys.stderr, flush=True)

    try:
        yield show
    finally:
        if shown:
            _over_the_line("")
        for one in filter(None, bars):
            one.close()


@contextlib.contextmanager
def stages(quiet: bool) -> Iterator[Callable[[str], None]]:
    """Gives a function that shows what is under way, on a terminal once DELAY has gone."""
    shown = not quiet and sys.stderr.isatty()
    began = time.monotonic()

    def show(name: str) -> None:
        if shown and time.monotonic() - began >= DELAY:
            _over_the_line(f"{name} ...")

    try:
        yield show
    finally:
        if shown:
            _over_the_line("")
