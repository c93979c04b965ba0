# SPDX-License-Identifier: MIT
"""What the library says while a command runs: told in lines, as the commands in C++ do."""

from __future__ import annotations

import contextlib
import logging
import warnings
from collections.abc import Callable, Iterator
from typing import TextIO

from pliant._core import PliantWarning


@contextlib.contextmanager
def warnings_told_by(tell: Callable[[str], None]) -> Iterator[None]:
    """Warnings of ours are told without the place in the program, which says users nothing."""
    with warnings.catch_warnings():
        others = warnings.showwarning

        def show(
            message: Warning | str,
            category: type[Warning],
            filename: str,
            lineno: int,
            file: TextIO | None = None,
            line: str | None = None,
        ) -> None:
            if issubclass(category, PliantWarning):
                tell(str(message))
            else:
                others(message, category, filename, lineno, file, line)

        warnings.showwarning = show
        yield


class _Told(logging.Handler):
    def __init__(self, tell: Callable[[str], None]) -> None:
        super().__init__(logging.INFO)
        self._tell = tell

    def emit(self, record: logging.LogRecord) -> None:
        self._tell(record.getMessage())


@contextlib.contextmanager
def notes_told_by(tell: Callable[[str], None]) -> Iterator[None]:
    """Notes of the library are told, of molecules made whole and the like."""
    logger, handler = logging.getLogger("pliant"), _Told(tell)
    level = logger.level
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        logger.setLevel(level)
        logger.removeHandler(handler)
