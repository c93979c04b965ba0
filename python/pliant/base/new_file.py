# SPDX-License-Identifier: MIT
"""The one way to write a file: beside its place, checked, and named once it is complete."""

from __future__ import annotations

import io
import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from pliant._core import FileError, InputError, OutputFile
from pliant.base.console import NO_ROOM, printable_name

if TYPE_CHECKING:
    from _typeshed import ReadableBuffer


def check_folder(folder: Path) -> None:
    """Asked before the input is read; the folder is made when there is something to write."""
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder}: is a file, expected a folder for the results")


def expect_none(places: Iterable[str | os.PathLike[str]], overwrite: bool) -> None:
    """Raises FileError where one of the files to write is there, before any work is done."""
    for place in () if overwrite else places:
        if os.path.exists(place):
            raise FileError(f"{os.fspath(place)}: exists; --overwrite replaces it")


class NewFile(io.FileIO):
    """A file for bytes, which remembers if one could not be written.

    Libraries that need a name may write to `path`; whoever lets them checks what they made.
    """

    def __init__(self, path: Path, tells_late: bool = False) -> None:
        super().__init__(path, "r+")
        self.path = path
        self.failure: OSError | None = None  #: the first
        self._tells_late = tells_late

    def fileno(self) -> int:
        """Has none to give: errors of C that writes by number would not be heard."""
        raise io.UnsupportedOperation("fileno")

    def write(self, data: ReadableBuffer) -> int:
        """Writes all of it."""
        left = memoryview(data).cast("B")
        size = len(left)
        try:
            while left:
                left = left[super().write(left) :]
        except OSError as error:
            self._fail(error)
        return size

    def truncate(self, size: int | None = None) -> int:
        """Makes it so long."""
        try:
            return super().truncate(size)
        except OSError as error:
            self._fail(error)
            return size or 0

    def _fail(self, error: OSError) -> None:
        self.failure = self.failure or error
        if not self._tells_late:
            raise error


@contextmanager
def new_file(
    place: str | os.PathLike[str], *, overwrite: bool = False, tells_late: bool = False
) -> Iterator[NewFile]:
    """A file that takes its name when the block ends well, and is gone otherwise.

    Without `overwrite` it never replaces another file, nor one that came to be meanwhile. Raises
    FileError where the file is there, or not all could be written; with `tells_late` this is told
    at the end alone: HDF5 prints what it cannot raise.
    """
    output = OutputFile(Path(place), overwrite=overwrite)
    try:
        file = NewFile(output.partial, tells_late)
        try:
            with file:
                yield file
        except Exception as error:
            reason = file.failure or error
            if isinstance(reason, OSError) and (file.failure or reason.errno in NO_ROOM):
                raise cannot_write(output.target, reason) from error
            raise
        if file.failure:
            raise cannot_write(output.target, file.failure)
        output.publish()
    finally:
        output.close()


def take_name(made: Path, target: Path) -> bool:
    """Gives a file its name. False, and it stays where it is, where another has that name."""
    try:
        os.link(made, target)
    except OSError:  # the name is taken, or a file system without links
        if target.exists():
            return False
        made.rename(target)
    else:
        made.unlink()
    return True


def cannot_write(place: str | os.PathLike[str], reason: OSError) -> FileError:
    """What the library says, too."""
    return FileError(f"{printable_name(place)}: cannot write: {reason.strerror}")


@contextmanager
def new_text(place: str | os.PathLike[str], *, overwrite: bool = False) -> Iterator[TextIO]:
    """The same for text in UTF-8, whose ends of lines are written as they are."""
    with (
        new_file(place, overwrite=overwrite) as file,
        io.TextIOWrapper(io.BufferedWriter(file), encoding="utf-8", newline="") as text,
    ):
        yield text


def write_text(place: str | os.PathLike[str], text: str, *, overwrite: bool = False) -> None:
    """Writes a complete file or none. Raises FileError as `new_file` does."""
    write_bytes(place, text.encode(), overwrite=overwrite)


def write_bytes(place: str | os.PathLike[str], data: bytes, *, overwrite: bool = False) -> None:
    """The same for bytes."""
    with new_file(place, overwrite=overwrite) as file:
        file.write(data)
