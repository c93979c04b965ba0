# SPDX-License-Identifier: MIT
"""Molecules that a library has twice: they are made again, and said."""

from __future__ import annotations

from pliant._core import InputError
from pliant.base.extras import is_there, late
from pliant.jobs.conformers.subject import Subject

Chem = late("rdkit.Chem")
rdBase = late("rdkit.rdBase")


def canonical_smiles(subject: Subject) -> str:
    """That of RDKit, of the isomer as it is in 3-D; "" where RDKit is not there or refuses it."""
    if not is_there("rdkit"):
        return ""
    try:
        molecule = Chem.Mol(subject.molecule)
    except InputError:
        return ""
    with rdBase.BlockLogs():
        Chem.AssignStereochemistryFrom3D(molecule)
        return str(Chem.MolToSmiles(Chem.RemoveHs(molecule)))


class Repeated:
    """Which molecules were there before."""

    def __init__(self) -> None:
        self._first: dict[str, str] = {}

    def warnings(self, smiles: str, record: str) -> list[str]:
        """What to say of a record such as "record 3 (aspirin)"; nothing of a SMILES of ""."""
        first = self._first.setdefault(smiles, record) if smiles else record
        return [] if first == record else [f"the same molecule as {first}: done again"]
