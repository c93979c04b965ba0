# SPDX-License-Identifier: MIT
"""Which of several molecules in a record is kept, and what is refused because of the others."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError, Structure
from pliant.adapters.smiles import metals_in
from pliant.base.refusals import shown

if TYPE_CHECKING:
    from rdkit.Chem import Mol

HYDROGENS = ("H", "D", "T")
COUNTER_IONS = frozenset("Li Na K Rb Cs Fr Be Mg Ca Sr Ba Ra".split())


def kept_part(parts: Sequence[Sequence[str]], place: str) -> tuple[int, str]:
    """Which of several molecules, given by the elements of their atoms, is kept; and a note.

    That with most heavy atoms, then most atoms; the first of equals. Raises InputError where a
    metal that is no counter-ion would be left out.
    """
    sizes = [(sum(symbol not in HYDROGENS for symbol in one), len(one)) for one in parts]
    kept = max(range(len(parts)), key=lambda k: (*sizes[k], -k))
    _check_left_out(parts, kept, place)
    return kept, f"the largest of {len(parts)} molecules is kept"


def check_elements(structure: Structure, written: list[str], place: str) -> None:
    """Raises InputError where an atom, given as it is `written`, is of no element."""
    for k in np.flatnonzero(structure.elements == 0).tolist():
        raise InputError(f"{place}: atom {k + 1} is {shown(written[k])}: expected an element")


def check_elements_of_mol(molecule: Mol, place: str) -> None:
    """Raises InputError where an atom is of no element."""
    for atom in molecule.GetAtoms():
        if atom.GetAtomicNum() == 0:
            symbol = shown(atom.GetSymbol())
            raise InputError(f"{place}: atom {atom.GetIdx() + 1} is {symbol}: expected an element")


def _check_left_out(parts: Sequence[Sequence[str]], kept: int, place: str) -> None:
    """Raises InputError where a metal that is no counter-ion would be left out."""
    for k, symbols in enumerate(parts):
        is_ion = len(symbols) == 1 and symbols[0] in COUNTER_IONS
        if k != kept and not is_ion and (metals := metals_in(symbols)):
            raise InputError(
                f"{place}: the metal {', '.join(metals)} is not bonded to the largest of "
                f"{len(parts)} molecules: only lone ions of groups 1 and 2 are left out"
            )
