# SPDX-License-Identifier: MIT
"""The parts of an analysis: what its stages return, each whole and under the name of its type."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from MDAnalysis.analysis.base import Results

    from pliant.measure.frames import FrameAnalysis

#: units of correlations and domains; more are thinned along their chains
MOST_SITES = 1000


@dataclass(frozen=True, kw_only=True)
class Part:
    """What was measured."""

    notes: tuple[str, ...] = ()  #: what a reader of the results should know
    #: what was left out, or not found, so that something else is analysed
    cautions: tuple[str, ...] = ()


@dataclass(frozen=True)
class Measurement(Part):
    """What an analysis over frames measured."""

    measured: FrameAnalysis

    @property
    def found(self) -> Results:
        """Its results, which the analysis describes."""
        return self.measured.results


@dataclass(frozen=True)
class ReferenceStructure(Part):
    """The structure that frames are compared with; it has the atoms of the trajectory."""

    positions: np.ndarray  #: (N, 3) Angstrom
    name: str  #: what it is, for readers


@dataclass(frozen=True)
class Units(Part):
    """The n residues or atoms that are reported on, and the m atoms that stand for them."""

    what: str  #: "residue" or "atom"
    labels: list[str]  #: (n,) "A:LYS12", "C4"
    numbers: np.ndarray  #: (n,) of the residue, or of the atom from 1
    chains: np.ndarray  #: (n,) chain, "" where there is none
    owners: np.ndarray  #: (n,) resindex, or index of the atom
    atoms: np.ndarray  #: (m,) indices in the universe
    unit: np.ndarray  #: (m,) the unit of each
    of_chain: np.ndarray  #: (n,) bool: a residue of a chain, by its CA or P

    @property
    def ranked(self) -> np.ndarray:
        """(n,) bool: residues of chains, which ligands are not ranked with; all without chains."""
        return self.of_chain if self.of_chain.any() else np.ones(len(self.labels), dtype=bool)

    @property
    def site_stride(self) -> int:
        """Correlations and domains are of every so many units."""
        return -(-len(self.labels) // MOST_SITES)

    def of_atoms(self, atoms: np.ndarray) -> np.ndarray | None:
        """(k,) the units that atoms (k,), indices in the universe, alone stand for; or None."""
        place = np.minimum(np.searchsorted(self.atoms, atoms), len(self.atoms) - 1)
        own = self.unit[place]
        alone = np.bincount(self.unit)[own] == 1
        return own if np.all(self.atoms[place] == atoms) and alone.all() else None

    def sites(self, positions: np.ndarray) -> np.ndarray:
        """(F, n, 3) centre of each unit's atoms, of positions (F, m, 3)."""
        if len(self.atoms) == len(self.labels):
            return positions
        share = 1.0 / np.bincount(self.unit, minlength=len(self.labels))
        found = np.zeros((len(positions), len(self.labels), 3))
        for sites, frame in zip(found, positions, strict=True):
            np.add.at(sites, self.unit, share[self.unit, None] * frame)
        return found
