# SPDX-License-Identifier: MIT
"""Atoms that are nearer than steric limits allow, and residues in contact."""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_array, eye_array
from scipy.spatial import cKDTree

#: outer limits of contact, Angstrom (G. N. Ramachandran, V. Sasisekharan, Adv. Protein Chem. 23
#: (1968) 283); sulphur by its van der Waals radius. Pairs that are not named have none.
OUTER_LIMITS = {
    ("C", "C"): 3.0, ("C", "N"): 2.8, ("C", "O"): 2.7, ("C", "S"): 3.1,
    ("N", "N"): 2.6, ("N", "O"): 2.6, ("N", "S"): 3.0,
    ("O", "O"): 2.6, ("O", "S"): 2.9, ("S", "S"): 3.2,
}  # fmt: skip  # some pairs a line

_KINDS = ("C", "N", "O", "S")


class Overlaps:
    """Finds heavy atoms that are nearer than the outer limits, more than three bonds apart.

    elements: (N,) symbols; bonds: (B, 2).
    """

    def __init__(self, elements: np.ndarray, bonds: np.ndarray) -> None:
        kinds = np.array([_KINDS.index(e) if e in _KINDS else -1 for e in elements])
        self._atoms = np.flatnonzero(kinds >= 0)
        self._kinds = kinds[self._atoms]
        self._limits = np.zeros((len(_KINDS), len(_KINDS)))
        for (a, b), limit in OUTER_LIMITS.items():
            one, two = _KINDS.index(a), _KINDS.index(b)
            self._limits[one, two] = self._limits[two, one] = limit
        self._size = len(elements)
        self._near = within_three_bonds(bonds, self._size)

    def of(self, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Keys (k,) of the pairs of atoms that overlap, rising, and by how much (k,), Angstrom.

        positions: (N, 3). The key of atoms i < j is N i + j.
        """
        points = positions[self._atoms]
        pairs = cKDTree(points).query_pairs(self._limits.max(), output_type="ndarray")
        apart = np.linalg.norm(points[pairs[:, 0]] - points[pairs[:, 1]], axis=1)
        depth = self._limits[self._kinds[pairs[:, 0]], self._kinds[pairs[:, 1]]] - apart
        pairs, depth = pairs[depth > 0], depth[depth > 0]
        keys = self._size * self._atoms[pairs[:, 0]] + self._atoms[pairs[:, 1]]
        far = ~_among(keys, self._near)
        order = np.argsort(keys[far], kind="stable")
        return keys[far][order], depth[far][order]


def _among(keys: np.ndarray, rising: np.ndarray) -> np.ndarray:
    """Which keys are among the rising ones: isin, which would sort the latter every time."""
    place = np.minimum(np.searchsorted(rising, keys), len(rising) - 1)
    return np.zeros(len(keys), bool) if len(rising) == 0 else rising[place] == keys


def within_three_bonds(bonds: np.ndarray, count: int) -> np.ndarray:
    """Keys N i + j, rising, of the N = `count` atoms i < j that are at most three bonds apart."""
    i, j = np.asarray(bonds, dtype=np.int64).reshape(-1, 2).T
    step = csr_array((np.ones(len(i)), (i, j)), shape=(count, count))
    step = step + step.T + eye_array(count, format="csr")
    rows, columns = (step @ step @ step).nonzero()
    upper = rows < columns
    keys: np.ndarray = np.sort(rows[upper].astype(np.int64) * count + columns[upper])
    return keys


class ResidueContacts:
    """Finds residues in contact: heavy atoms within a distance, more than three residues apart.

    units: (m,) residue of each atom, chains: (R,) of each residue, cutoff: Angstrom.
    """

    def __init__(self, units: np.ndarray, chains: np.ndarray, cutoff: float = 4.5) -> None:
        self._units = units
        self._chains = chains
        self._cutoff = cutoff

    def of(self, positions: np.ndarray) -> np.ndarray:
        """Keys R i + j of the residues i < j in contact, rising; positions: (m, 3)."""
        pairs = cKDTree(positions).query_pairs(self._cutoff, output_type="ndarray")
        one, other = self._units[pairs].T
        first, last = np.minimum(one, other), np.maximum(one, other)
        apart = (last - first > 3) | (self._chains[first] != self._chains[last])
        return np.asarray(np.unique(len(self._chains) * first[apart] + last[apart]))
