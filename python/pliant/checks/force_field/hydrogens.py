# SPDX-License-Identifier: MIT
"""Hydrogens on carbon that a model leaves out, placed by rule from the atoms around each carbon.

Each frame is completed by itself, in the same way, and nothing is random. Ideal angles; 1.09
Angstrom to sp3 carbon, 1.08 to sp2.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SP3, SP2 = 1.09, 1.08  #: Angstrom, carbon to hydrogen
_HALF = np.deg2rad(109.47 / 2)  #: between the bisector of CH2 and a hydrogen
_TILT = np.deg2rad(180 - 109.47)  #: between the axis of a methyl and a hydrogen

#: Side chains: carbons with the number of their hydrogens; CA has one (two in GLY), others none.
_SIDE_CHAINS = {
    "ALA": "CB3",
    "ARG": "CB2 CG2 CD2",
    "ASN": "CB2",
    "ASP": "CB2",
    "CYS": "CB2",
    "GLN": "CB2 CG2",
    "GLU": "CB2 CG2",
    "GLY": "",
    "HIS": "CB2 CD21 CE11",
    "ILE": "CB1 CG12 CG23 CD13 CD3",
    "LEU": "CB2 CG1 CD13 CD23",
    "LYS": "CB2 CG2 CD2 CE2",
    "MET": "CB2 CG2 CE3",
    "PHE": "CB2 CD11 CD21 CE11 CE21 CZ1",
    "PRO": "CB2 CG2 CD2",
    "SER": "CB2",
    "THR": "CB1 CG23",
    "TRP": "CB2 CD11 CE31 CZ21 CZ31 CH21",
    "TYR": "CB2 CD11 CD21 CE11 CE21",
    "VAL": "CB1 CG13 CG23",
    "ACE": "CH33",
    "NME": "CH33 C3",
}
#: Names of forms of residues, as programs write them.
_FORMS = {
    "HIS": "HID HIE HIP HSD HSE HSP",
    "CYS": "CYX CYM",
    "ASP": "ASH",
    "GLU": "GLH",
    "LYS": "LYN",
}
RESIDUES = {name: name for name in _SIDE_CHAINS} | {
    form: name for name, forms in _FORMS.items() for form in forms.split()
}  #: names that can be completed, and whose side chain each has


def hydrogen_counts(residue: str) -> dict[str, int]:
    """Hydrogens that each carbon must have, by its name, of a residue in RESIDUES."""
    base = RESIDUES[residue]
    counts = {word[:-1]: int(word[-1]) for word in _SIDE_CHAINS[base].split()}
    if base not in ("ACE", "NME"):
        counts["CA"] = 2 if base == "GLY" else 1
    return counts


@dataclass(frozen=True)
class Missing:
    """Carbons around which the same is missing: their neighbours, and how many hydrogens."""

    carbons: np.ndarray  #: (C,)
    around: np.ndarray  #: (C, n) neighbours; of a methyl the neighbour and one of its neighbours
    hydrogens: int  #: on each carbon

    def place(self, positions: np.ndarray) -> np.ndarray:
        """(C, hydrogens, 3) Angstrom, of positions (N, 3)."""
        carbon = positions[self.carbons]
        along = _unit(positions[self.around] - carbon[:, None])
        if self.hydrogens == 3:
            return _beside(carbon, SP3, self._methyl(positions, along[:, 0]))
        away = _unit(-along.sum(axis=1))
        if self.hydrogens == 2:
            across = np.sin(_HALF) * _unit(np.cross(along[:, 0], along[:, 1]))
            ahead = np.cos(_HALF) * away
            return _beside(carbon, SP3, np.stack([ahead + across, ahead - across], axis=1))
        length = SP3 if self.around.shape[1] == 3 else SP2
        return _beside(carbon, length, away[:, None])

    def _methyl(self, positions: np.ndarray, along: np.ndarray) -> np.ndarray:
        """Directions (C, 3, 3) of staggered hydrogens; `along` (C, 3) to the neighbour."""
        beyond = positions[self.around[:, 1]] - positions[self.around[:, 0]]
        level = _unit(beyond - (beyond * along).sum(axis=1, keepdims=True) * along)
        side = np.cross(along, level)
        turns = np.pi + np.deg2rad([0.0, 120.0, 240.0])
        directions: np.ndarray = np.stack(
            [
                -np.cos(_TILT) * along + np.sin(_TILT) * (np.cos(t) * level + np.sin(t) * side)
                for t in turns
            ],
            axis=1,
        )
        return directions


def _beside(carbon: np.ndarray, length: float, directions: np.ndarray) -> np.ndarray:
    """(C, h, 3) from carbons (C, 3) and directions (C, h, 3)."""
    placed: np.ndarray = carbon[:, None] + length * directions
    return placed


def _unit(vectors: np.ndarray) -> np.ndarray:
    """The vectors scaled to length 1; one of length 0 (atoms in one place) is left as it is."""
    length = np.linalg.norm(vectors, axis=-1, keepdims=True)
    scaled: np.ndarray = vectors / np.where(length > 0, length, 1.0)
    return scaled


def find_missing(
    wanted: np.ndarray, elements: np.ndarray, neighbours: list[list[int]]
) -> list[Missing]:
    """Groups of carbons that lack hydrogens; `wanted` (N,) is how many each atom must have, or -1.

    Carbons whose neighbours are no more or fewer than a whole residue has are left as they are.
    """
    groups: dict[tuple[int, int], list[tuple[int, list[int]]]] = {}
    for atom in np.flatnonzero(wanted > 0):
        around = neighbours[atom]
        lacks = int(wanted[atom]) - sum(elements[k] == 1 for k in around)
        if (len(around), lacks) == (1, 3):
            beyond = [k for k in neighbours[around[0]] if k != atom and elements[k] > 1]
            around = [around[0], *beyond[:1]]
            if not beyond:
                continue
        elif (len(around), lacks) not in ((2, 2), (3, 1), (2, 1)):
            continue
        groups.setdefault((len(around), lacks), []).append((int(atom), around))
    return [
        Missing(np.array([c for c, _ in found]), np.array([a for _, a in found]), lacks)
        for (_, lacks), found in sorted(groups.items())
    ]
