# SPDX-License-Identifier: MIT
"""Clashscore: how many atoms run into each other, as MolProbity counts them.

Serious clashes (overlaps of van der Waals spheres of 0.4 Angstrom and more) of atoms more than
three bonds apart, four if one of them is a hydrogen, for each 1000 atoms, all hydrogens included
(Word et al., J. Mol. Biol. 285 (1999) 1711; Chen et al., Acta Cryst. D66 (2010) 12). A hydrogen on
N, O or S may come 0.6 Angstrom nearer to an acceptor (N, O, S) before it counts. Spheres are
compared by distance, not by dots: neighbours that hide a clash from a probe do not hide it here.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree

SERIOUS = 0.4  #: Angstrom of overlap
BONDED = 0.6  #: Angstrom that a hydrogen bond allows besides
#: Angstrom, of Probe with hydrogens at nuclear positions
RADII = {1: 1.22, 6: 1.70, 7: 1.55, 8: 1.40, 15: 1.80, 16: 1.80, 34: 1.90}
POLAR_H, AROMATIC_H, CARBONYL_C = 1.05, 1.05, 1.65  #: Angstrom
OTHER = 1.80  #: Angstrom, of elements that are not listed
POLAR = (7, 8, 16)


class Clashes:
    """Counts clashes of a molecule in any of its frames."""

    def __init__(self, elements: np.ndarray, bonds: np.ndarray) -> None:
        """elements: (N,) atomic numbers; bonds: (M, 2) atoms."""
        self._elements = np.asarray(elements, dtype=np.int64)
        self._count = len(self._elements)
        self._graph = _graph(np.asarray(bonds, dtype=np.int64).reshape(-1, 2), self._count)
        parents = self._parents()
        self._is_polar_h = (self._elements == 1) & np.isin(parents, POLAR)
        self._is_acceptor = np.isin(self._elements, POLAR)
        self._radii = self._radii_of(parents)
        self._near3, self._near4 = self._within(3), self._within(4)

    def pairs(self, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(K, 2) atoms that clash at positions (N, 3), and (K,) their overlaps, Angstrom."""
        reach = 2.0 * self._radii.max() - SERIOUS
        pairs = cKDTree(positions).query_pairs(reach, output_type="ndarray")
        a, b = pairs[:, 0], pairs[:, 1]
        apart = np.linalg.norm(positions[a] - positions[b], axis=1)
        overlap = self._radii[a] + self._radii[b] - apart
        overlap -= BONDED * self._may_bond(a, b)
        kept = (overlap >= SERIOUS) & ~self._is_bonded(a, b)
        order = np.lexsort((b[kept], a[kept]))
        return pairs[kept][order], overlap[kept][order]

    def score(self, positions: np.ndarray) -> float:
        """Clashes per 1000 atoms at positions (N, 3)."""
        return 1000.0 * len(self.pairs(positions)[0]) / self._count

    def _parents(self) -> np.ndarray:
        """(N,) the element of the first atom that each is bonded to; 0: of none."""
        parents = np.zeros(self._count, dtype=np.int64)
        rows, columns = self._graph.nonzero()
        parents[rows[::-1]] = self._elements[columns[::-1]]
        return parents

    def _radii_of(self, parents: np.ndarray) -> np.ndarray:
        radii = np.array([RADII.get(int(element), OTHER) for element in self._elements])
        radii[self._is_polar_h] = POLAR_H
        degree = np.diff(self._graph.indptr)
        is_flat = (self._elements == 6) & (degree == 3)
        rows, columns = self._graph.nonzero()
        ends_in_oxygen = np.zeros(self._count, dtype=bool)
        ends_in_oxygen[rows[(self._elements[columns] == 8) & (degree[columns] == 1)]] = True
        radii[is_flat & ends_in_oxygen] = CARBONYL_C
        on_flat = np.zeros(self._count, dtype=bool)
        on_flat[rows[is_flat[columns]]] = True
        radii[(self._elements == 1) & (parents == 6) & on_flat] = AROMATIC_H
        return radii

    def _within(self, bonds: int) -> csr_matrix:
        """(N, N) whether atoms are at most so many bonds apart."""
        near = self._graph.copy()
        for _ in range(bonds - 1):
            near = near + near @ self._graph
            near.data[:] = 1
        return near.tocsr()

    def _is_bonded(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        has_hydrogen = (self._elements[a] == 1) | (self._elements[b] == 1)
        near3 = np.asarray(self._near3[a, b]).ravel() > 0
        near4 = np.asarray(self._near4[a, b]).ravel() > 0
        return np.asarray(near3 | (near4 & has_hydrogen))

    def _may_bond(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        one, other = self._is_polar_h, self._is_acceptor
        return np.asarray((one[a] & other[b]) | (one[b] & other[a]))


def _graph(bonds: np.ndarray, count: int) -> csr_matrix:
    ends = np.concatenate([bonds, bonds[:, ::-1]])
    made = csr_matrix(
        (np.ones(len(ends), dtype=np.int32), (ends[:, 0], ends[:, 1])), shape=(count, count)
    )
    made.sum_duplicates()
    made.data[:] = 1
    return made
