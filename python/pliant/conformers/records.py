# SPDX-License-Identifier: MIT
"""The records of a library, one after the other: SDF, MOL and SMILES files, also compressed."""

from __future__ import annotations

import bz2
import gzip
import io
import lzma
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any, cast

from pliant._core import FileError, InputError

SDF = (".sdf", ".sd", ".mol", ".mdl")
SMILES = (".smi", ".smiles")
COMPRESSED = (".gz", ".bz2", ".xz")
END = "$$$$"
MOST_LINES = 200_000  #: of a record: more is no molecule, and must not fill the memory
HEADERS = ("smiles", "canonical_smiles", "isomeric_smiles")  #: first words of a line of titles

_OPENERS: dict[bytes, Callable[[str, str], Any]] = {
    b"\x1f\x8b": gzip.open,
    b"BZ": bz2.open,
    b"\xfd7": lzma.open,
}


@dataclass(frozen=True)
class Record:
    """One molecule as its file has it."""

    number: int  #: in the file, from 1
    text: str  #: from the title to the last data item; or the SMILES alone
    name: str  #: may be empty
    is_smiles: bool = False
    source: str = ""  #: name of the file

    @property
    def place(self) -> str:
        """ "library.sdf record 3", for messages."""
        return f"{self.source} record {self.number}" if self.source else f"record {self.number}"


def format_of(path: str | os.PathLike[str]) -> str:
    """The ending that says the format, such as ".sdf" of x.sdf.gz."""
    name = Path(path)
    if name.suffix.lower() in COMPRESSED:
        name = name.with_suffix("")
    return name.suffix.lower()


def is_library(path: str | os.PathLike[str]) -> bool:
    """Whether the name is that of a file of small molecules."""
    return format_of(path) in SDF + SMILES


def read_records(path: str | os.PathLike[str]) -> Iterator[Record]:
    """The records of a file; one at a time is in memory.

    Raises FileError where it cannot be read, InputError where its name is that of another format,
    or where a compressed file ends early.
    """
    name, kind = os.fspath(path), format_of(path)
    if kind not in SDF + SMILES:
        raise InputError(
            f"{name}: expected SDF, MOL or SMILES ({', '.join(SDF[:1] + SDF[2:3] + SMILES[:1])}, "
            "each also .gz, .bz2, .xz); pliant sample takes other formats"
        )
    split = _sdf_records if kind in SDF else _smiles_records
    try:
        with _opened(name) as lines:
            yield from split(lines, Path(name).name)
    except (EOFError, gzip.BadGzipFile, lzma.LZMAError) as error:
        raise InputError(f"{name}: its compression is damaged: {error}") from None
    except OSError as error:
        raise FileError(f"{name}: {error.strerror or error}") from None


def _opened(name: str) -> IO[str]:
    """Lines of text. Bytes that are not UTF-8 are kept, and written as they were."""
    with open(name, "rb") as file:
        opener = _OPENERS.get(file.read(2), io.open)
    binary = cast("IO[bytes]", opener(name, "rb"))
    return io.TextIOWrapper(binary, encoding="utf-8-sig", errors="surrogateescape")


def _sdf_records(lines: IO[str], source: str) -> Iterator[Record]:
    number, kept = 0, list[str]()
    for line in lines:
        if line.startswith(END):
            if _has_text(kept):
                number += 1
                yield _sdf_record(number, kept, source)
            kept = []
        elif len(kept) < MOST_LINES:
            kept.append(line)
    if _has_text(kept):
        yield _sdf_record(number + 1, kept, source)


def _has_text(lines: list[str]) -> bool:
    return any(line.strip() for line in lines)


def _sdf_record(number: int, lines: list[str], source: str) -> Record:
    return Record(number, "".join(lines), lines[0].strip(), source=source)


def _smiles_records(lines: IO[str], source: str) -> Iterator[Record]:
    number = 0
    for line in lines:
        words = line.split(maxsplit=1)
        if not words or words[0].startswith("#"):
            continue
        if number == 0 and words[0].lower() in HEADERS:
            continue
        number += 1
        yield smiles_record(words[0], words[1].strip() if len(words) > 1 else "", number, source)


def smiles_record(smiles: str, name: str = "", number: int = 1, source: str = "") -> Record:
    """The record of one SMILES."""
    return Record(number, smiles, name, True, source)
