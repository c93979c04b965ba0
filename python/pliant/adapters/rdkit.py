# SPDX-License-Identifier: MIT
"""RDKit: a molecule with a conformer as a structure."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from pliant._checked import checked, having
from pliant._core import InputError, PliantWarning, Structure

if TYPE_CHECKING:
    from rdkit.Chem import Mol


@checked(molecule=having("GetConformers", "an rdkit.Chem.Mol"))
def from_rdkit(molecule: Mol, conformer: int = -1) -> Structure:
    """Return an RDKit molecule as a structure: its atoms, bonds with orders, and one conformer.

    Parameters
    ----------
    molecule : rdkit.Chem.Mol
    conformer : int
        Id of the conformer (Angstrom); -1 for the first.

    Raises
    ------
    InputError
        The molecule has no such conformer.

    Warns
    -----
    PliantWarning
        Implicit hydrogens are left out, as they have no positions.
    """
    ids = [known.GetId() for known in molecule.GetConformers()]
    if not ids:
        raise InputError(
            "the molecule has no conformer, so that its atoms have no positions: make one with "
            "rdkit.Chem.AllChem.EmbedMolecule(molecule)"
        )
    if conformer != -1 and conformer not in ids:
        raise InputError(f"the molecule has no conformer {conformer}; it has {ids}")
    _warn_of_implicit_hydrogens(molecule)
    atoms = list(molecule.GetAtoms())
    places = [_place(atom) for atom in atoms]
    bonds = list(molecule.GetBonds())
    return Structure(
        molecule.GetConformer(conformer).GetPositions(),
        elements=[atom.GetAtomicNum() for atom in atoms],
        names=[name for name, *_ in places],
        residue_names=[name for _, name, *_ in places],
        residue_ids=[number for *_, number, _, _ in places],
        insertion_codes=[code for *_, code, _ in places],
        chains=[chain for *_, chain in places],
        bonds=[(bond.GetBeginAtomIdx(), bond.GetEndAtomIdx()) for bond in bonds],
        bond_orders=[_order(bond) for bond in bonds],
        title=molecule.GetProp("_Name") if molecule.HasProp("_Name") else "",
    )


def _warn_of_implicit_hydrogens(molecule: Mol) -> None:
    count = sum(atom.GetTotalNumHs() for atom in molecule.GetAtoms())
    if count:
        warnings.warn(
            f"hydrogens without positions are left out: {count}; Chem.AddHs(molecule, "
            "addCoords=True) gives them some",
            PliantWarning,
            stacklevel=4,
        )


def _place(atom: Any) -> tuple[str, str, int, str, str]:
    """Name, residue name and number, insertion code and chain."""
    known = atom.GetPDBResidueInfo()
    if known is None:
        symbol = atom.GetSymbol() if atom.GetAtomicNum() else "X"
        return symbol, "UNK", 1, "", ""
    return (
        known.GetName().strip() or atom.GetSymbol(),
        known.GetResidueName().strip() or "UNK",
        known.GetResidueNumber(),
        known.GetInsertionCode().strip(),
        known.GetChainId().strip(),
    )


def _order(bond: Any) -> int:
    return {"SINGLE": 1, "DOUBLE": 2, "TRIPLE": 3, "AROMATIC": 4}.get(str(bond.GetBondType()), 0)
