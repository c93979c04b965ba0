# SPDX-License-Identifier: MIT
"""What stages of a study find, where it is more than an array."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

ENSEMBLE = "ensemble"  #: `pliant sample`: frames are independent
PATH = "path"  #: `pliant run`, or sampler `walk`: each frame is the one before, pushed
TRANSITION = "transition"  #: `pliant path`: each frame is nearer to another structure
TRAJECTORY = "trajectory"  #: another program's: frames may be anything


@dataclass(frozen=True)
class Reference:
    """A structure with the atoms of the trajectory."""

    positions: np.ndarray  #: (N, 3) Angstrom
    name: str  #: what it is, for readers


@dataclass(frozen=True)
class Units:
    """n units, and the m atoms that stand for them."""

    what: str  #: "residue" or "atom"
    labels: list[str]  #: (n,) "A:LYS12", "C4"
    numbers: np.ndarray  #: (n,) of the residue, or of the atom from 1
    chains: np.ndarray  #: (n,) chain, "" where there is none
    owners: np.ndarray  #: (n,) resindex, or index of the atom
    atoms: np.ndarray  #: (m,) indices in the universe
    unit: np.ndarray  #: (m,) the unit of each
    of_chain: np.ndarray  #: (n,) bool: a residue of a chain, by its CA or P

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


@dataclass(frozen=True)
class Contacts:
    """Pairs of residues in contact (heavy atoms within 4.5 Angstrom) and how often."""

    pairs: np.ndarray  #: (k, 2) numbers of units
    share: np.ndarray  #: (k,) of the frames looked at
    at_start: np.ndarray  #: (k,) bool: in the reference
    frames: int  #: that were looked at
