# SPDX-License-Identifier: MIT
"""The fit of a study to measured data: the structures, their distances, what is determined."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from pliant.base import style
from pliant.jobs.fit.fitted import HOLDS, FittedStructure
from pliant.jobs.fit.in_map import at
from pliant.jobs.fit.task import FitTask
from pliant.measure.domains.rigid_turns import RigidTurns, rigid_turns
from pliant.report.page.map_surface import MapSurface
from pliant.report.page.overlay import Overlay
from pliant.trajectory.superposition import Superposition


@dataclass(frozen=True)
class DataFit:
    """What `pliant fit` found."""

    found: FittedStructure
    start: np.ndarray  #: (N, 3) START, in the map if there is one; Angstrom
    atoms: np.ndarray  #: (M,) the atom that stands for each residue
    chains: np.ndarray  #: (M,)
    pairs: np.ndarray  #: (K, 2) residues of the distances
    surface: MapSurface | None = None  #: of the map, about the fitted structure

    @classmethod
    def of(cls, task: FitTask) -> DataFit:
        """Of a molecule whose ensemble is there."""
        found, molecule = task.fitted(), task.molecule
        pairs = np.array([one.pair for one in task.data], dtype=np.int64).reshape(-1, 2)
        surface = None
        if (density := task.density) is not None:
            fitted = at(found.structure, found.positions[0])
            surface = MapSurface.around(density.density, density.resolution, fitted)
        chains = np.asarray(molecule.chains)
        return cls(found, molecule.placed, molecule.atoms, chains, pairs, surface)

    @property
    def numbers(self) -> np.ndarray:
        """(M,) of the residues."""
        return np.asarray(self.found.structure.residue_ids[self.atoms])

    @cached_property
    def labels(self) -> list[str]:
        """(M,) "LYS12", or "A:LYS12" where there are several chains."""
        structure = self.found.structure
        names, chains = structure.residue_names[self.atoms], structure.chains[self.atoms]
        several = len(set(chains.tolist())) > 1
        return [
            f"{chain}:{name}{number}" if several and chain else f"{name}{number}"
            for chain, name, number in zip(chains, names, self.numbers, strict=True)
        ]

    @property
    def off(self) -> np.ndarray:
        """(K,) bool: distances that do not hold, or were let go."""
        data = self.found.data
        return np.array([d.contradicts or abs(d.violation) > HOLDS for d in data], dtype=bool)

    @cached_property
    def turns(self) -> RigidTurns:
        """Of the residues, from START to the fitted structure."""
        fitted = self.found.positions[0]
        return rigid_turns(self.start[self.atoms], fitted[self.atoms], self.chains)

    def overlay(self) -> Overlay:
        """The fitted structure over START, superposed by the largest piece that did not bend; in a
        map both as they are there."""
        core, fitted = self.atoms[self.turns.piece == 0], self.found.positions[0]
        if self.surface is None:
            onto = Superposition(self.start[core], np.ones(len(core)))
            fitted = onto.apply(fitted, fitted[core])
        colours = [style.VERMILION if off else style.SKY for off in self.off]
        pairs, both = self.atoms[self.pairs], np.stack([fitted, self.start])
        return Overlay("fitted, over START", both, pairs, colours, self.surface)
