# SPDX-License-Identifier: MIT
"""Clashes of heavy atoms as MolProbity counts them, measured anew by NumPy and SciPy.

Overlaps above 0.4 Angstrom of C, N, O and S four or more bonds apart (Word et al., J. Mol. Biol.
285 (1999) 1711). Two of N, O and S, one of which has a hydrogen, may bind each other: no clash.
"""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from pliant._core import Structure
from pliant.measure.overlaps import within_three_bonds

SERIOUS = 0.4  #: Angstrom of overlap
RADII = {6: 1.70, 7: 1.55, 8: 1.52, 16: 1.80}  #: Angstrom
POLAR = (7, 8, 16)


class HeavyClashes:
    """Counts clashes of a molecule, whose bonds are known, in any of its frames."""

    def __init__(self, structure: Structure) -> None:
        elements = np.asarray(structure.elements, dtype=np.int64)
        bonds = np.asarray(structure.bonds, dtype=np.int64).reshape(-1, 2)
        self._radii = np.array([RADII.get(int(element), 0.0) for element in elements])
        self._atoms = np.flatnonzero(self._radii)
        self._is_polar = np.isin(elements, POLAR)
        self._has_hydrogen = np.zeros(len(elements), dtype=bool)
        for one, other in (bonds.T, bonds.T[::-1]):
            self._has_hydrogen[one[elements[other] == 1]] = True
        self._bonded = within_three_bonds(bonds, len(elements))
        self._heavy = int((elements > 1).sum())

    def pairs(self, positions: np.ndarray) -> np.ndarray:
        """(K, 2) atoms that clash at positions (N, 3), Angstrom; the lower number first."""
        reach = 2.0 * self._radii.max(initial=SERIOUS) - SERIOUS
        near = cKDTree(positions[self._atoms]).query_pairs(reach, output_type="ndarray")
        pairs = np.sort(self._atoms[near.astype(np.int64)].reshape(-1, 2), axis=1)
        a, b = pairs.T
        apart = np.linalg.norm(positions[a] - positions[b], axis=1)
        may_bond = self._is_polar[a] & self._is_polar[b]
        may_bond &= self._has_hydrogen[a] | self._has_hydrogen[b]
        is_near = self._radii[a] + self._radii[b] - apart > SERIOUS
        codes = a * len(self._radii) + b
        kept: np.ndarray = pairs[is_near & ~may_bond & ~np.isin(codes, self._bonded)]
        return kept

    def score(self, positions: np.ndarray) -> float:
        """Clashes for each 1000 heavy atoms at positions (N, 3), Angstrom."""
        return 1000.0 * len(self.pairs(positions)) / max(self._heavy, 1)
