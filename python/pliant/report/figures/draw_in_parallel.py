# SPDX-License-Identifier: MIT
"""Draws the figures of a report, in a second process beside the first where that is safe."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Generic

from pliant.base.beside import forked, may_fork
from pliant.base.png import save_png
from pliant.base.style import styled
from pliant.report.section import Found, Picture

if TYPE_CHECKING:
    from typing_extensions import Self


class Drawing(Generic[Found]):
    """The figures of a report being drawn.

    A forked process begins at once, and the caller may do other work meanwhile; finish() draws what
    is left and returns all. The figures that are still to be drawn stand in a pipe, a byte each,
    from which both processes take the next one. Not forked where `may_fork` says so.
    """

    def __init__(
        self, found: Found, pictures: Sequence[Picture[Found]], folder: Path, dpi: int
    ) -> None:
        self._found, self.dpi = found, dpi
        self._pictures = [(picture, folder / f"{picture.name}.png") for picture in pictures]
        self._left, write = os.pipe()
        os.write(write, bytes(range(len(pictures))))
        os.close(write)
        self._child = forked(self._draw_all) if len(pictures) > 1 and may_fork() else None

    def finish(self) -> list[tuple[Picture[Found], Path]]:
        """Draws what is left, waits, and returns [(picture, its PNG)]."""
        self._draw_all()
        if not self._child_succeeded():
            for picture, path in self._pictures:  # here an error has its own text
                save_picture(picture, self._found, path, self.dpi)
        return self._pictures

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._child_succeeded()
        os.close(self._left)

    def _child_succeeded(self) -> bool:
        """Waits for the other process, if there is one."""
        child, self._child = self._child, None
        return child is None or os.waitpid(child, 0)[1] == 0

    def _draw_all(self) -> None:
        while taken := os.read(self._left, 1):
            picture, path = self._pictures[taken[0]]
            save_picture(picture, self._found, path, self.dpi)


def save_picture(picture: Picture[Found], found: Found, path: Path, dpi: int) -> None:
    """Draws a figure and writes its PNG."""
    with styled():
        save_png(picture.draw(found), path, dpi)
