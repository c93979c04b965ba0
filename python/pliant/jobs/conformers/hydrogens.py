# SPDX-License-Identifier: MIT
"""Hydrogens that a molecule in 3-D lacks: found by valence, added by RDKit."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant._core import InputError, Structure
from pliant.base.console import counted
from pliant.base.extras import MissingPackageError, late, need

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")

AROMATIC = 4  #: order of a bond
NAMED = 8  #: atoms in a message
#: Elements that are looked at: B C N O Si P S As Se.
_ELEMENTS = (5, 6, 7, 8, 14, 15, 16, 33, 34)
_PAIR_OF_RING = (8, 16, 34)  #: their place in an aromatic ring takes a lone pair, no valence
#: Valences by atomic number less charge: a charged atom has those of the element that has as many
#: electrons.
_GROUPS = ((3,), (4,), (3, 5), (2, 4, 6), (1,))
_VALENCES = {first + k: one for first in (5, 13, 31) for k, one in enumerate(_GROUPS)}
_VALENCES |= {7: (3,), 8: (2,)}


def missing_hydrogens(structure: Structure, radicals: Collection[int]) -> dict[int, int]:
    """Atoms with valences to spare, and how many: of their hydrogens as many are missing.

    None of atoms in `radicals`, nor of those with a bond of unknown order.
    """
    used = _valences_in_use(structure).tolist()
    charges = structure.charges.tolist() or [0] * len(structure)
    unknown = {*radicals, *structure.bonds[structure.bond_orders == 0].ravel().tolist()}
    elements, missing = structure.elements, {}
    for k in np.flatnonzero(np.isin(elements, _ELEMENTS)).tolist():
        valences = _VALENCES.get(int(elements[k]) - int(charges[k]), ())
        spare = next((one for one in valences if one >= used[k]), used[k]) - used[k]
        if spare and k not in unknown:
            missing[k] = spare
    return missing


def _valences_in_use(structure: Structure) -> npt.NDArray[np.int64]:
    orders = structure.bond_orders.astype(np.int64)
    aromatic = orders == AROMATIC
    used, rings = np.zeros((2, len(structure)), np.int64)
    for end in structure.bonds.T:
        np.add.at(used, end, np.where(aromatic, 1, orders))
        np.add.at(rings, end, aromatic)
    return used + ((rings > 0) & ~np.isin(structure.elements, _PAIR_OF_RING))


def is_bare(structure: Structure, missing: Mapping[int, int]) -> bool:
    """Whether it has no hydrogen at all, though it needs some."""
    return bool(missing) and not (structure.elements == 1).any()


def labels_of(molecule: Mol) -> list[str]:
    """Names of its atoms in messages: those of the PDB, else elements with numbers from 1."""
    known = [atom.GetPDBResidueInfo() for atom in molecule.GetAtoms()]
    labels = numbered(atom.GetSymbol() for atom in molecule.GetAtoms())
    return [
        one.GetName().strip() if one else label for one, label in zip(known, labels, strict=True)
    ]


def names_of(structure: Structure) -> list[str]:
    """The same of a structure: names of atoms in residues, else elements with numbers."""
    rows = zip(structure.names, structure.residue_names, numbered(structure.symbols), strict=True)
    return [label if residue == "UNK" else str(name) for name, residue, label in rows]


def numbered(symbols: Iterable[str]) -> list[str]:
    """ "C1", "H2"."""
    return [f"{symbol}{number}" for number, symbol in enumerate(symbols, 1)]


def check_addable(missing: Mapping[int, int], labels: Sequence[str], place: str) -> None:
    """Raises InputError where RDKit, which adds hydrogens, is not installed."""
    try:
        need(f"adding missing hydrogens ({_named(missing, labels)})", "rdkit")
    except MissingPackageError as error:
        raise InputError(f"{place}: {error}") from None


def completed(
    molecule: Mol, missing: Collection[int], labels: Sequence[str]
) -> tuple[Mol, list[str]]:
    """The molecule with hydrogens at atoms of which RDKit, too, finds some missing; and a warning.

    All given positions stay.
    """
    totals = {k: molecule.GetAtomWithIdx(k).GetTotalNumHs() for k in missing}
    lacking = {k: count for k, count in totals.items() if count}
    if not lacking:
        return molecule, []
    made = Chem.AddHs(molecule, addCoords=True, onlyOnAtoms=list(lacking))
    count = sum(lacking.values())
    were = f"{counted(count, 'missing hydrogen')} {'was' if count == 1 else 'were'} added"
    return made, [f"{were}: {_named(lacking, labels)}"]


def _named(missing: Mapping[int, int], labels: Sequence[str]) -> str:
    """ "2 to C4, 1 to N7"."""
    parts = [f"{count} to {labels[k]}" for k, count in missing.items()]
    more = len(parts) - NAMED
    return ", ".join(parts if more <= 0 else [*parts[:NAMED], f"and to {more} more atoms"])
