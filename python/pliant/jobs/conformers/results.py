# SPDX-License-Identifier: MIT
"""What `conformers` gives for a molecule."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant._core import Structure
from pliant.adapters.rdkit import add_conformer
from pliant.base.display import Displayed, Facts
from pliant.base.extras import late
from pliant.jobs.conformers.axes import hands_text
from pliant.jobs.conformers.make import Made, as_sdf
from pliant.trajectory.frames import FramesInMemory
from pliant.trajectory.trajectory import HasFrames, Trajectory

if TYPE_CHECKING:
    from rdkit.Chem import Mol

Chem = late("rdkit.Chem")


class Conformers(HasFrames, Displayed):
    """The conformers of one molecule, lowest energy first, with the interface of a `Trajectory`."""

    def __init__(self, made: Made, number: int = 1) -> None:
        self._made = made
        self.number = number  #: of the record in its file, from 1
        self.name = made.subject.name  #: of the molecule; may be empty
        self.asked = made.asked  #: conformers asked for; `len` may be less
        #: what there is to know, such as that a salt was left out; what was guessed comes first
        self.notes = [*made.subject.warnings, *made.notes]
        self.energy_name = made.energy_name  #: in words, with its unit; "" where none was asked for
        self.worst_bar = made.worst_bar  #: largest error of a held length, relative; nan: minimised
        self.starts: npt.NDArray[np.int64] = made.starts  #: (n,) start of each conformer, from 0
        #: (n,) kcal/mol; None where none was asked for
        self.energies: npt.NDArray[np.float64] | None = made.energies

    @property
    def structure(self) -> Structure:
        """The molecule: of a salt the largest."""
        return self._made.subject.structure

    @property
    def positions(self) -> npt.NDArray[np.float64]:
        """(n, N, 3) float64, Angstrom."""
        return self._made.positions

    @cached_property
    def trajectory(self) -> Trajectory:
        """The conformers as frames, in memory."""
        return Trajectory._of(FramesInMemory(self.structure, self.positions))

    @property
    def sdf(self) -> str:
        """The records that `pliant conformers` writes, with the data items of the molecule."""
        return as_sdf(self._made)

    def to_rdkit(self) -> Mol:
        """An rdkit.Chem.Mol with its properties, and a conformer for each.

        Each conformer has the properties pliant_start (from 1), pliant_energy (kcal/mol) and, where
        there are axes that cannot turn, pliant_axes with their hands, as "C8-N9 M"; the molecule
        has pliant_energy_name.
        """
        molecule: Mol = Chem.Mol(self._made.subject.molecule)
        molecule.RemoveAllConformers()
        for k, positions in enumerate(self.positions):
            conformer = add_conformer(molecule, positions)
            conformer.SetIntProp("pliant_start", int(self.starts[k]) + 1)
            if self._made.axes:
                conformer.SetProp("pliant_axes", hands_text(self._made.axes, positions))
            if self.energies is not None:
                conformer.SetDoubleProp("pliant_energy", float(self.energies[k]))
        for name, value in self._made.subject.block.tags():
            molecule.SetProp(name, value)
        if self.energy_name:
            molecule.SetProp("pliant_energy_name", self.energy_name)
        return molecule

    def facts(self) -> Facts:
        """How many, of what, by which energy."""
        atoms = f"{len(self)} of {self.asked} asked for, of {len(self.structure)} atoms"
        facts = [("molecule", self.name), ("conformers", atoms)]
        if self.energies is not None:
            spread = float(np.ptp(self.energies))
            facts.append(("energy", f"{self.energy_name}; {spread:.1f} from first to last"))
        if not math.isnan(self.worst_bar):
            facts.append(("worst bar", f"{self.worst_bar:.1e}"))
        return [*facts, *(("note", note) for note in self.notes)]

    def __repr__(self) -> str:
        called = f" of {self.name}" if self.name else ""
        return f"<pliant.Conformers: {len(self)}{called}, {len(self.structure)} atoms>"


@dataclass(frozen=True)
class FailedMolecule:
    """A molecule of a library that gave no conformers. It is false, and of length 0."""

    number: int  #: of the record in its file, from 1
    name: str  #: may be empty
    reason: str  #: what was expected, and what was found

    def __bool__(self) -> bool:
        return False

    def __len__(self) -> int:
        return 0
