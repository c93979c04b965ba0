# SPDX-License-Identifier: MIT
"""Progress of commands: a bar on terminals and in notebooks, lines elsewhere if work takes long."""

from __future__ import annotations

import contextlib
import importlib.util
import sys
import time
from collections.abc import Callable, Iterator

from pliant.base import progress as _progress
from pliant.base.progress import WIDTH, Bar

LINE_EVERY = 10.0  #: seconds between lines of progress where there is no terminal


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
            bar = "#" * (WIDTH * done // max(total, 1))
            text = f"{what}: [{bar:.<{WIDTH}}] {done} / {total}"
            if rate:
                began[:] = began or [(done, time.monotonic())]
                first, at = began[0]
                text += f", {(done - first) / max(time.monotonic() - at, 1e-3):.1f} a second"
            print(f"\r{text}\x1b[K", end="", file=sys.stderr, flush=True)
        elif not quiet and _progress.in_notebook():
            bars[:] = bars or [_progress.begin(what, total)]
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
            print("\r\x1b[K", end="", file=sys.stderr, flush=True)
        for one in filter(None, bars):
            one.close()


@contextlib.contextmanager
def stages(quiet: bool) -> Iterator[Callable[[str], None]]:
    """Gives a function that shows what is under way; only on a terminal, and with `rich`."""
    if quiet or not sys.stderr.isatty() or not importlib.util.find_spec("rich"):
        yield lambda name: None
        return
    from rich.console import Console
    from rich.live import Live

    # Without a thread of its own, which would keep the figures from being drawn in two processes.
    with Live(console=Console(stderr=True), auto_refresh=False, transient=True) as line:
        yield lambda name: line.update(f"{name} ...", refresh=True)
