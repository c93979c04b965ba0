# SPDX-License-Identifier: MIT
"""What the library says while a command runs, in lines as the commands in C++ do."""

from __future__ import annotations

import contextlib
import logging
import warnings
from collections.abc import Callable, Iterator
from typing import TextIO

from pliant._core import PliantWarning


@contextlib.contextmanager
def warnings_shown_by(tell: Callable[[str], None]) -> Iterator[None]:
    """Has our warnings shown without the place in the program, which users have no use for."""
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


class _NoteHandler(logging.Handler):
    def __init__(self, tell: Callable[[str], None]) -> None:
        super().__init__(logging.INFO)
        self._tell = tell

    def emit(self, record: logging.LogRecord) -> None:
        self._tell(record.getMessage())


@contextlib.contextmanager
def notes_shown_by(tell: Callable[[str], None]) -> Iterator[None]:
    """Has notes of the library shown, such as those on molecules made whole."""
    logger, handler = logging.getLogger("pliant"), _NoteHandler(tell)
    level = logger.level
    logger.addHandler(handler)
    logger.setLevel(logging.INFO)
    try:
        yield
    finally:
        logger.setLevel(level)
        logger.removeHandler(handler)


@contextlib.contextmanager
def noted() -> Iterator[list[str]]:
    """A list that warnings of ours within go to, each once, instead of to the screen."""
    notes: list[str] = []
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        yield notes
    texts = [str(one.message) for one in caught if issubclass(one.category, PliantWarning)]
    notes += dict.fromkeys(texts)
