# SPDX-License-Identifier: MIT
"""One ligand whose file may state no bond orders: which of three ways finds them."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pliant._core import InputError, Structure
from pliant._extras import need
from pliant.adapters.rdkit import charges_of
from pliant.adapters.smiles import metals_in
from pliant.conformers.bond_orders import HYDROGEN, as_stated, from_hydrogens
from pliant.conformers.options import ConformerOptions
from pliant.conformers.template import by_smiles

if TYPE_CHECKING:
    from rdkit.Chem import Mol


def needs_orders(structure: Structure, options: ConformerOptions) -> bool:
    """Whether a SMILES is given, an order is not known, or charges follow from known ones alone."""
    if options.smiles is not None or (structure.bond_orders == 0).any():
        return True
    return len(structure.charges) == 0 and bool((charges_of(structure) > 0).any())


def ordered(
    structure: Structure, options: ConformerOptions, place: str
) -> tuple[Mol, list[str], list[str]]:
    """RDKit's molecule with bond orders, notes, and warnings of what was guessed.

    Raises InputError, which begins with `place`, where they cannot be known, and says what helps.
    """
    need("a ligand without bond orders", "rdkit")
    if metals := metals_in(structure.symbols.tolist()):
        raise InputError(f"{place}: RDKit finds no bond orders at the metal {', '.join(metals)}")
    if options.smiles is not None:
        return by_smiles(structure, options.smiles, place)
    if (structure.bond_orders > 0).all():
        return as_stated(structure, options, place)
    if not (structure.elements == HYDROGEN).any():
        raise InputError(
            f"{place}: the ligand has no hydrogens, and its bond orders are not known: "
            f"{options.asked_smiles} gives both"
        )
    return from_hydrogens(structure, options, place)
