# SPDX-License-Identifier: MIT
"""Records in V2000 whose numbers do not fit its columns, written in V3000, which has none."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from pliant._core import InputError
from pliant.base.refusals import shown
from pliant.jobs.conformers.mol_block import BY_ATOM, MolBlock, filled, pairs_of

MOST = 999  #: atoms, and bonds
LOWEST, HIGHEST = -9999.99995, 99999.99995  #: Angstrom
RADICAL = 4  #: code of a doublet in an atom line; others are 4 less the charge
NO_VALENCE = 15  #: in an atom line; -1 in V3000
CONFIGURATIONS = {1: 1, 3: 2, 4: 2, 6: 3}  #: of bonds, V2000 to V3000


def text_of(
    block: MolBlock, positions: npt.NDArray[np.float64], masses: npt.NDArray[np.float64]
) -> str:
    """The record with positions (N, 3), Angstrom; `masses` (N,) are those of the elements."""
    if not block.is_v3000 and not fits_v2000(block, positions):
        block = in_v3000(block, masses.tolist())
    return filled(block.form(), positions)


def fits_v2000(block: MolBlock, positions: npt.NDArray[np.float64]) -> bool:
    """Whether all numbers fit the columns."""
    is_near = bool(np.all((positions > LOWEST) & (positions < HIGHEST)))
    return is_near and max(len(block.atoms), len(block.bonds)) <= MOST


def in_v3000(block: MolBlock, masses: Sequence[float]) -> MolBlock:
    """Raises InputError where a record in V2000 says more than of single atoms and bonds."""
    made = MolBlock(block.title, block.comment, f"0 0 {_number(block.counts, 12)}", True)
    made.labels = [str(k + 1) for k in range(len(block.atoms))]
    made.atoms = [
        (after[1:4].strip(), f" {_number(after, 30)}{_words(stated)}")
        for (_, after), stated in zip(block.atoms, _of_atoms(block, masses), strict=True)
    ]
    made.bonds = block.bonds
    made.bond_texts = [
        (text[:3].strip(), _words({"CFG": CONFIGURATIONS.get(_number(text, 3), 0)}))
        for _, text in block.bond_texts
    ]
    made.items, made.radicals = block.items, block.radicals
    return made


def _of_atoms(block: MolBlock, masses: Sequence[float]) -> list[dict[str, int]]:
    """What is said of each atom, by its name in V3000; 0 is the usual."""
    found = [
        _of_line(after, round(mass)) for (_, after), mass in zip(block.atoms, masses, strict=True)
    ]
    begins = {line[:6] for line in block.more}
    if others := sorted(begins - set(BY_ATOM)):
        raise InputError(
            f"the molecule does not fit the columns of V2000, and its lines {shown(others[0])} "
            "have no place in V3000"
        )
    replaced = {"MASS": 0} if "M  ISO" in begins else {}
    if begins - {"M  ISO"}:
        replaced |= {"CHG": 0, "RAD": 0}
    for stated in found:  # of atom lines
        stated.update(replaced)
    for line in block.more:
        for atom, value in pairs_of(line):
            found[atom][BY_ATOM[line[:6]]] = int(value)
    return found


def _of_line(after: str, mass: int) -> dict[str, int]:
    """`after` is the atom line from column 31 on."""
    difference, code, valence = _number(after, 4, 2), _number(after, 6), _number(after, 18)
    return {
        "CHG": 4 - code if 1 <= code <= 7 else 0,
        "RAD": 2 if code == RADICAL else 0,
        "MASS": mass + difference if difference else 0,
        "VAL": -1 if valence == NO_VALENCE else valence,
    }


def _number(line: str, first: int, width: int = 3) -> int:
    word = line[first : first + width].strip()
    return int(word) if word.lstrip("-").isdecimal() else 0


def _words(stated: dict[str, int]) -> str:
    return "".join(f" {name}={value}" for name, value in stated.items() if value)
