# SPDX-License-Identifier: MIT
"""A molecule on its way into a file: what every writer needs."""

from collections import Counter
from dataclasses import dataclass, field

import numpy as np


@dataclass
class Sketch:
    """Atoms with positions (Angstrom), bonds, and the residues they belong to."""

    elements: list[str]
    positions: np.ndarray  # (N, 3)
    bonds: list[tuple[int, int, int]]  # two atoms from 0, and 1, 2, 3 or 4 (aromatic)
    names: list[str] = field(default_factory=list)
    residues: list[tuple[str, int]] = field(default_factory=list)  # (N) name and number
    stated_bonds: list[tuple[int, int]] = field(default_factory=list)  # those for CONECT
    charges: dict[int, int] = field(default_factory=dict)

    def __post_init__(self):
        """Names atoms C1, C2, H1 and puts them into one residue where nothing is given."""
        counts = Counter()
        if not self.names:
            for element in self.elements:
                counts[element] += 1
                self.names.append(f"{element}{counts[element]}")
        if not self.residues:
            self.residues = [("UNL", 1)] * len(self.elements)

    @classmethod
    def of_rdkit(cls, molecule, conformer: int, residue: str = "UNL") -> "Sketch":
        """The conformer of an RDKit molecule."""
        orders = {1.0: 1, 2.0: 2, 3.0: 3, 1.5: 4}
        atoms = list(molecule.GetAtoms())
        return cls(
            [atom.GetSymbol() for atom in atoms],
            np.array(molecule.GetConformer(conformer).GetPositions()),
            [
                (b.GetBeginAtomIdx(), b.GetEndAtomIdx(), orders[b.GetBondTypeAsDouble()])
                for b in molecule.GetBonds()
            ],
            residues=[(residue, 1)] * len(atoms),
            charges={a.GetIdx(): a.GetFormalCharge() for a in atoms if a.GetFormalCharge()},
        )

    def ordered(self, order: list[int]) -> "Sketch":
        """The same with its atoms in another order."""
        place = {atom: k for k, atom in enumerate(order)}
        return Sketch(
            [self.elements[k] for k in order],
            self.positions[order],
            [(place[a], place[b], kind) for a, b, kind in self.bonds],
            [self.names[k] for k in order],
            [self.residues[k] for k in order],
            [(place[a], place[b]) for a, b in self.stated_bonds],
            {place[k]: charge for k, charge in self.charges.items()},
        )

    def centred(self) -> "Sketch":
        """The same around the origin."""
        self.positions = self.positions - self.positions.mean(axis=0)
        return self
