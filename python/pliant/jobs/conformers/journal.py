# SPDX-License-Identifier: MIT
"""The output of a library: molecules are committed one by one, and a killed run can be resumed.

Beside OUT.sdf stand .OUT.sdf.partial, with the records so far, and .OUT.sdf.journal: a line for
what was asked for, then one for each molecule with the bytes up to its end and their checksum. Each
line begins with a checksum of itself and of all before it. A molecule counts once its line is
complete, and both are on the disk. At the end the first gets its name and the second goes.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import IO, Any

from pliant import _core
from pliant._core import FileError, InputError
from pliant.base.console import printable_name
from pliant.base.file_lock import take_lock
from pliant.base.new_file import take_name
from pliant.jobs.conformers.workers import Outcome


def places(output: Path) -> tuple[Path, Path]:
    """The unfinished file, and its journal."""
    return (
        output.with_name(f".{output.name}.partial"),
        output.with_name(f".{output.name}.journal"),
    )


class Journal:
    """An output that is being written. Leaves both files behind unless it was published."""

    def __init__(
        self,
        output: Path,
        asked: dict[str, Any],
        records: IO[bytes],
        notes: IO[bytes],
        chained: str,
    ) -> None:
        self.output, self.asked = output, asked
        self.outcomes: list[Outcome] = []
        self._records, self._notes, self._sum = records, notes, chained

    @staticmethod
    def expect_free(output: Path) -> None:
        """Raises FileError where an output, or an unfinished one, is in the way."""
        name = printable_name(output)
        if output.exists():
            raise FileError(f"{name}: exists; --overwrite replaces it")
        if places(output)[1].exists():
            raise FileError(
                f"{name}: an earlier run is unfinished: --continue {name} goes on, --overwrite "
                "begins anew"
            )

    @classmethod
    def begin(cls, output: Path, asked: dict[str, Any], overwrite: bool) -> Journal:
        """A new one, where expect_free has looked. Raises FileError."""
        partial, journal = places(output)
        try:
            notes = _locked(journal, "ab+", output)
            notes.truncate(0)
            partial.unlink(missing_ok=True)  # a killed run may have given it its name, too
            made = cls(output, {**asked, "overwrite": overwrite}, _opened(partial, "wb"), notes, "")
        except OSError as error:
            raise FileError(f"{printable_name(output)}: {error.strerror}") from None
        made._note({"pliant": _core.version(), **made.asked})
        return made

    @classmethod
    def resume(cls, output: Path) -> Journal:
        """An unfinished one, with what is committed. Raises FileError and InputError."""
        partial, journal = places(output)
        if not journal.exists():
            there = "it is finished" if output.exists() else "there is no such run"
            raise FileError(f"{printable_name(output)}: nothing to continue: {there}")
        notes = _locked(journal, "rb+", output)
        whole = list(_whole_lines(notes, output))
        if whole and _is_named(partial, output):  # ended while it was given its name
            partial.unlink(missing_ok=True)
            journal.unlink()
            raise FileError(f"{printable_name(output)}: nothing to continue: it is finished")
        if not whole or not partial.exists():
            raise _unusable(output)
        (asked, *_), *lines = whole
        lines_end, chained = whole[-1][1:]
        if asked.pop("pliant") != _core.version():
            raise _unusable(output)
        if output.exists() and not asked["overwrite"]:
            raise _in_the_way(output)
        made, end = cls(output, asked, _opened(partial, "rb+"), notes, chained), 0
        for line, *_ in lines:
            end, before = line.pop("end"), end
            if line.pop("sha256") != hashlib.sha256(made._records.read(end - before)).hexdigest():
                raise _unusable(output)
            made.outcomes.append(Outcome(**line))
        for file, length in ((made._records, end), (notes, lines_end)):
            file.truncate(length)
            file.seek(length)
        return made

    def add(self, outcome: Outcome) -> None:
        """Writes what was made of a record, then commits it."""
        self._records.write(outcome.text)
        _synced(self._records)
        found, outcome.text = hashlib.sha256(outcome.text).hexdigest(), b""
        line = asdict(outcome)
        del line["text"]
        self._note({**line, "end": self._records.tell(), "sha256": found})
        self.outcomes.append(outcome)

    def _note(self, line: dict[str, Any]) -> None:
        text = json.dumps(line).encode()
        self._sum = _chained(self._sum, text)
        self._notes.write(self._sum.encode() + b" " + text + b"\n")
        _synced(self._notes)

    def publish(self) -> None:
        """Gives the output its name; without any record both files go.

        Raises FileError, and leaves both, where another file has the name, unless it may go.
        """
        partial, journal = places(self.output)
        if self._records.tell() == 0:
            partial.unlink()
        elif self.asked["overwrite"]:
            os.replace(partial, self.output)
        elif not take_name(partial, self.output):
            raise _in_the_way(self.output)
        journal.unlink()

    def close(self) -> None:
        """Lets others write it."""
        self._records.close()
        self._notes.close()


def _opened(path: Path, mode: str) -> IO[bytes]:
    return open(path, mode)


def _locked(path: Path, mode: str, output: Path) -> IO[bytes]:
    file = _opened(path, mode)
    try:
        take_lock(file)
    except OSError:
        file.close()
        raise FileError(f"{printable_name(output)}: another process is writing it") from None
    return file


def _synced(file: IO[bytes]) -> None:
    file.flush()
    os.fsync(file.fileno())


def _is_named(partial: Path, output: Path) -> bool:
    return output.exists() and (not partial.exists() or partial.samefile(output))


def _in_the_way(output: Path) -> FileError:
    name = printable_name(output)
    return FileError(
        f"{name}: came to be meanwhile: once it has another name or place, --continue {name} "
        "ends the run"
    )


def _unusable(output: Path) -> InputError:
    return InputError(
        f"{printable_name(output)}: its unfinished run is damaged, or of another version of "
        "Pliant; --overwrite begins anew"
    )


def _chained(before: str, text: bytes) -> str:
    return hashlib.sha256(before.encode() + text).hexdigest()


def _whole_lines(file: IO[bytes], output: Path) -> Iterator[tuple[dict[str, Any], int, str]]:
    """Each line, where it ends, and its checksum. A kill may have cut the last one: it is none."""
    end, found = 0, ""
    for line in file:
        if not line.endswith(b"\n"):
            return
        end += len(line)
        said, _, text = line[:-1].partition(b" ")
        found = _chained(found, text)
        if said != found.encode():
            raise _unusable(output)
        yield json.loads(text), end, found
