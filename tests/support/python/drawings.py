# SPDX-License-Identifier: MIT
"""Molecules drawn in every way: all Kekule forms, and with aromatic bonds."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from typing import Any

from rdkit import Chem
from rdkit.Chem import AllChem

MOST_FORMS = 8


def embedded(smiles: str) -> Any:
    """RDKit's molecule with hydrogens and one conformer."""
    made = Chem.AddHs(Chem.MolFromSmiles(smiles))
    assert AllChem.EmbedMolecule(made, randomSeed=7) == 0
    return made


def drawings(made: Any) -> Iterator[str]:
    """Mol blocks of the molecule: with aromatic bonds (type 4), then its Kekule forms, and those
    that RDKit makes by moving charges."""
    yield Chem.MolToMolBlock(made, kekulize=False)
    rings = [bond.GetIdx() for bond in made.GetBonds() if bond.GetIsAromatic()]
    for form in Chem.ResonanceMolSupplier(made, Chem.KEKULE_ALL, MOST_FORMS):
        yield from kekule_forms(form, rings)


def kekule_forms(made: Any, numbers: list[int]) -> Iterator[str]:
    """Each way to pair the ring atoms that have a double bond in one form."""
    kekule = Chem.Mol(made)
    Chem.Kekulize(kekule, clearAromaticFlags=True)
    rings = [kekule.GetBondWithIdx(number) for number in numbers]
    paired = {
        k
        for bond in rings
        if bond.GetBondType() == Chem.BondType.DOUBLE
        for k in (bond.GetBeginAtomIdx(), bond.GetEndAtomIdx())
    }
    pairs = [(bond.GetIdx(), bond.GetBeginAtomIdx(), bond.GetEndAtomIdx()) for bond in rings]
    for double in islice(pairings(sorted(paired), pairs), MOST_FORMS):
        form = Chem.RWMol(kekule)
        for number, _, _ in pairs:
            kind = Chem.BondType.DOUBLE if number in double else Chem.BondType.SINGLE
            form.GetBondWithIdx(number).SetBondType(kind)
        yield Chem.MolToMolBlock(form, kekulize=False)


def pairings(atoms: list[int], pairs: list[tuple[int, int, int]]) -> Iterator[frozenset[int]]:
    """Sets of pairs (number, atom, atom) that have each of the atoms once."""
    if not atoms:
        yield frozenset()
        return
    for number, a, b in pairs:
        if atoms[0] in (a, b) and a in atoms and b in atoms:
            rest = [k for k in atoms if k not in (a, b)]
            yield from (found | {number} for found in pairings(rest, pairs))
