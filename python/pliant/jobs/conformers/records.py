# SPDX-License-Identifier: MIT
"""The records of a library, one after the other: SDF, MOL and SMILES files, also compressed."""

from __future__ import annotations

import itertools
import os
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path

from pliant._core import InputError
from pliant.base.input_files import lines_of
from pliant.jobs.conformers.options import USUAL, ConformerOptions

SDF = (".sdf", ".sd", ".mol", ".mdl")
SMILES = (".smi", ".smiles")
#: Formats of files of one ligand, by their endings.
LIGANDS = {
    **dict.fromkeys((".pdb", ".ent", ".pdbqt"), "pdb"),
    **dict.fromkeys((".cif", ".mmcif", ".mcif"), "mmcif"),
    **dict.fromkeys((".xyz", ".extxyz"), "xyz"),
}
COMPRESSED = (".gz", ".bz2", ".xz")
END = "$$$$"
#: Letters and lines of a record: more is no molecule, and must not fill the memory.
MOST_TEXT, MOST_LINES = 20_000_000, 200_000
TOO_LONG = "expected a record of at most 20 MB and 200000 lines, found more"
LONGEST_NAME = 60  #: letters of a name in messages
HEADERS = ("smiles", "canonical_smiles", "isomeric_smiles")  #: first words of a line of titles


@dataclass(frozen=True)
class Record:
    """One molecule as its file has it."""

    number: int  #: in the file, from 1
    text: str  #: from the title to the last data item; or the SMILES alone
    name: str  #: may be empty
    is_smiles: bool = False
    source: str = ""  #: name of the file
    fault: str = ""  #: why it was not read
    format: str = "sdf"  #: or that of a ligand
    items: tuple[tuple[str, str], ...] = ()  #: data items beside a SMILES

    @property
    def place(self) -> str:
        """ "library.sdf record 3", for messages."""
        return f"{self.source} record {self.number}" if self.source else f"record {self.number}"


def short(name: str) -> str:
    """A name, or a SMILES, as messages have it."""
    return name if len(name) <= LONGEST_NAME else f"{name[:LONGEST_NAME]}..."


def format_of(path: str | os.PathLike[str], asked: str | None = None) -> str:
    """The ending that says the format, such as ".sdf" of x.sdf.gz; that of the format `asked`."""
    if asked:
        return f".{asked}"
    name = Path(path)
    if name.suffix.lower() in COMPRESSED:
        name = name.with_suffix("")
    return name.suffix.lower()


def is_library(path: str | os.PathLike[str]) -> bool:
    """Whether the name is that of a file of small molecules."""
    return format_of(path) in (*SDF, *SMILES, *LIGANDS)


def read_records(
    path: str | os.PathLike[str], options: ConformerOptions = USUAL
) -> Iterator[Record]:
    """The records of a file; one at a time is in memory.

    Raises FileError where it cannot be read, InputError where its name is that of another format,
    where it holds more than `max_input`, or where a compressed file ends early.
    """
    name, kind = os.fspath(path), format_of(path, options.molecule.get("format"))
    if kind not in (*SDF, *SMILES, *LIGANDS):
        raise InputError(
            f"{name}: expected SDF, MOL, SMILES, PDB, mmCIF or XYZ (.sdf, .mol, .smi, .pdb, .cif, "
            ".xyz, each also .gz, .bz2, .xz)"
        )
    lines = lines_of(name, MOST_TEXT, options.max_input * 10**6, options.called("max_input"))
    if kind in LIGANDS:
        yield from _ligand_records(lines, Path(name).name, LIGANDS[kind])
    else:
        split = _sdf_records if kind in SDF else _smiles_records
        yield from split(lines, Path(name).name)


def _sdf_records(lines: Iterable[str], source: str) -> Iterator[Record]:
    number, size, is_long, kept = 0, 0, False, list[str]()
    for line in itertools.chain(lines, [END]):
        if not line.startswith(END):
            size += len(line)
            is_long |= size > MOST_TEXT or len(kept) == MOST_LINES
            if not is_long:
                kept.append(line)
            continue
        if is_long:
            number += 1
            name = kept[0][:LONGEST_NAME].strip()
            yield Record(number, "", name, source=source, fault=TOO_LONG)
        elif _has_text(kept):
            number += 1
            yield Record(number, "".join(kept), kept[0].strip(), source=source)
        size, is_long, kept = 0, False, []


def _has_text(lines: list[str]) -> bool:
    return any(line.strip() for line in lines)


def _smiles_records(lines: Iterable[str], source: str) -> Iterator[Record]:
    """Where tabs part columns, those after the name are data items, by the words of the header."""
    number, titles = 0, list[str]()
    for line in lines:
        if len(line) == MOST_TEXT:
            raise InputError(f"{source} record {number + 1}: {TOO_LONG}")
        words = line.split("\t") if "\t" in line.strip() else line.split(maxsplit=1)
        smiles, name, *more = (word.strip() for word in (*words, "", "")[: max(2, len(words))])
        if not smiles or smiles.startswith("#"):
            continue
        if number == 0 and smiles.lower() in HEADERS:
            titles = [one.strip().strip("<>") for one in words[2:]]
            continue
        number += 1
        called = (*titles, *(f"column {k}" for k in range(len(titles) + 3, len(words) + 1)))
        yield smiles_record(smiles, name, number, source, tuple(zip(called, more, strict=False)))


def _ligand_records(lines: Iterable[str], source: str, kind: str) -> Iterator[Record]:
    kept, size = list[str](), 0
    for line in lines:
        size += len(line)
        if size > MOST_TEXT:
            raise InputError(
                f"{source}: expected one ligand, found more than {MOST_TEXT // 10**6} MB; "
                "pliant sample takes proteins"
            )
        kept.append(line)
    name = source[: source.lower().rindex(format_of(source))]
    if _has_text(kept):
        yield Record(1, "".join(kept), name, source=source, format=kind)


def smiles_record(
    smiles: str,
    name: str = "",
    number: int = 1,
    source: str = "",
    items: tuple[tuple[str, str], ...] = (),
) -> Record:
    """The record of one SMILES."""
    return Record(number, smiles, name, True, source, items=items)
