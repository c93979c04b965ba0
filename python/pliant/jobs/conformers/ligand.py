# SPDX-License-Identifier: MIT
"""One ligand: the part of a file that it is, and, if that states no bond orders, where from."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from pliant import _core
from pliant._core import InputError, OptionError, Structure
from pliant.adapters.rdkit import charges_of
from pliant.adapters.smiles import metals_in
from pliant.base.extras import need
from pliant.jobs.conformers.bond_orders import HYDROGEN, as_stated, from_hydrogens
from pliant.jobs.conformers.options import ConformerOptions
from pliant.jobs.conformers.template import by_smiles

if TYPE_CHECKING:
    from rdkit.Chem import Mol


#: what says how a file is read, and how `read_text` calls that
_READING = {"frame": "model", "assembly": "assembly", "distance_bonds": "distance_bonds"}


def read_ligand(text: str, place: str, kind: str, asked: Mapping[str, Any]) -> Structure:
    """The part of a file that is asked for by names of `conformer_options()`.

    Raises as `read_text` and `part_of` do.
    """
    reading = {_READING[name]: value for name, value in asked.items() if name in _READING}
    structure = _core.read_text(text, place, format=kind, **reading)
    return part_of(structure, {k: v for k, v in asked.items() if k not in _READING})


def part_of(structure: Structure, asked: Mapping[str, Any]) -> Structure:
    """The selected atoms, prepared where that is asked for.

    Raises as `Structure.select` and `prepare` do; OptionError for what says how a file is read.
    """
    for name in _READING:
        if name in asked:
            raise OptionError(f"{name}: goes with the path of a file of a molecule")
    how = dict(asked)
    if selection := how.pop("select", ""):
        structure = structure.select(selection)
    return _core.prepare(structure, **how).structure if how else structure


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
