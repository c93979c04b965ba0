# SPDX-License-Identifier: MIT
"""The output of a library: molecules are committed one by one, and a killed run can be resumed.

Beside OUT.sdf stand .OUT.sdf.partial, with the records so far, and .OUT.sdf.journal: a line for
what was asked for, then one for each molecule with the bytes up to its end. A molecule counts once
its line is whole. At the end the first gets its name and the second goes.
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
from pliant._file_lock import take_lock
from pliant.conformers.workers import Outcome
from pliant.console import printable_name

_LOOKED_AT = 2**20  #: bytes of the input by which it is known again


def places(output: Path) -> tuple[Path, Path]:
    """The unfinished file, and its journal."""
    return (
        output.with_name(f".{output.name}.partial"),
        output.with_name(f".{output.name}.journal"),
    )


def fingerprint(path: Path) -> dict[str, Any]:
    """By which an input is known again."""
    try:
        with open(path, "rb") as file:
            head = hashlib.sha256(file.read(_LOOKED_AT)).hexdigest()
        return {"size": path.stat().st_size, "head": head}
    except OSError as error:
        raise FileError(f"{printable_name(path)}: {error.strerror}") from None


class Journal:
    """An output that is being written. Leaves both files behind unless it was published."""

    def __init__(
        self, output: Path, asked: dict[str, Any], records: IO[bytes], notes: IO[bytes]
    ) -> None:
        self.output, self.asked = output, asked
        self.outcomes: list[Outcome] = []
        self._records, self._notes = records, notes

    @classmethod
    def begin(cls, output: Path, asked: dict[str, Any], overwrite: bool) -> Journal:
        """A new one. Raises FileError where an output, or an unfinished one, is in the way."""
        partial, journal = places(output)
        if not overwrite:
            if output.exists():
                raise FileError(f"{printable_name(output)}: exists; --overwrite replaces it")
            if journal.exists():
                raise FileError(
                    f"{printable_name(output)}: an earlier run is unfinished: --continue "
                    f"{printable_name(output)} goes on, --overwrite begins anew"
                )
        try:
            notes = _locked(journal, "ab+", output)
            notes.truncate(0)
            made = cls(output, asked, _opened(partial, "wb"), notes)
        except OSError as error:
            raise FileError(f"{printable_name(output)}: {error.strerror}") from None
        made._note({"pliant": _core.version(), **asked})
        return made

    @classmethod
    def resume(cls, output: Path) -> Journal:
        """An unfinished one, with what is committed. Raises FileError and InputError."""
        partial, journal = places(output)
        if not journal.exists():
            there = "it is finished" if output.exists() else "there is no such run"
            raise FileError(f"{printable_name(output)}: nothing to continue: {there}")
        notes = _locked(journal, "rb+", output)
        whole = list(_whole_lines(notes))
        if whole and not partial.exists() and output.exists():  # ended while it was given its name
            journal.unlink()
            raise FileError(f"{printable_name(output)}: nothing to continue: it is finished")
        if not whole or not partial.exists():
            raise InputError(
                f"{printable_name(output)}: its unfinished run is damaged; --overwrite begins anew"
            )
        asked = whole[0][0]
        if asked.pop("pliant") != _core.version():
            raise InputError(
                f"{printable_name(output)}: was begun by another version of Pliant; --overwrite "
                "begins anew"
            )
        records = _opened(partial, "rb+")
        size = records.seek(0, os.SEEK_END)
        made = cls(output, asked, records, notes)
        end, lines_end = 0, whole[0][1]
        for line, line_end in whole[1:]:
            if line["end"] > size:  # the system lost it
                break
            end, lines_end = line.pop("end"), line_end
            made.outcomes.append(Outcome(**line))
        for file, length in ((records, end), (notes, lines_end)):
            file.truncate(length)
            file.seek(length)
        return made

    def add(self, outcome: Outcome) -> None:
        """Writes what was made of a record, then commits it."""
        self._records.write(outcome.text)
        self._records.flush()
        outcome.text = b""
        line = asdict(outcome)
        del line["text"]
        self._note({**line, "end": self._records.tell()})
        self.outcomes.append(outcome)

    def _note(self, line: dict[str, Any]) -> None:
        self._notes.write(json.dumps(line).encode() + b"\n")
        self._notes.flush()

    def publish(self) -> None:
        """Gives the output its name; without any record both files go."""
        partial, journal = places(self.output)
        os.fsync(self._records.fileno())
        if self._records.tell() > 0:
            os.replace(partial, self.output)
        else:
            partial.unlink()
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


def _whole_lines(file: IO[bytes]) -> Iterator[tuple[dict[str, Any], int]]:
    """Each line with where it ends; a line that a kill cut short, and what follows, is none."""
    end = 0
    for line in file:
        end += len(line)
        try:
            found = json.loads(line)
        except ValueError:
            return
        if not line.endswith(b"\n") or not isinstance(found, dict):
            return
        yield found, end
