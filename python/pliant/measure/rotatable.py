# SPDX-License-Identifier: MIT
"""Rotatable bonds (torsions, dihedrals) of a molecule, found from its bonds alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from pliant._core import Framework
from pliant.trajectory.chains import chain_of

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe


BACKBONE = ("N", "CA", "C")

# A protein's torsions by the names of the bond's atoms; side chains by the Greek letters in them
# (IUPAC-IUB, Biochemistry 9 (1970) 3471).
_BACKBONE_BONDS = {("N", "CA"): "phi", ("CA", "C"): "psi", ("C", "N"): "omega"}
_SIDE_CHAIN_BONDS = {"AB": "chi1", "BG": "chi2", "GD": "chi3", "DE": "chi4", "EZ": "chi5"}
_OUTER = {"phi": ("C", "C"), "psi": ("N", "N"), "omega": ("CA", "CA")}


@dataclass(frozen=True)
class Torsion:
    """Rotation about the bond between the two middle ones of four atoms."""

    atoms: tuple[int, int, int, int]  #: four atom indices i, j, k, l; j-k is the bond
    kind: str  #: "phi", "psi", "omega", "chi1" ... where the names of the atoms say so, else ""
    label: str  #: "LYS12 chi1", "C3-C4-C5-O1"
    residue: int  #: resindex of atom j (psi, chi) or k (phi), whose torsion it is


def is_hydrogen(atomgroup: AtomGroup) -> np.ndarray:
    """(n,) mask of the hydrogens: by element where there is one, else by mass, else by name."""
    if hasattr(atomgroup, "elements"):
        elements = np.char.upper(np.asarray(atomgroup.elements, dtype=str))
        if np.any(elements != ""):
            return np.isin(elements, ("H", "D", "T"))
    if hasattr(atomgroup, "masses") and np.any(atomgroup.masses > 0):
        light: np.ndarray = (atomgroup.masses > 0) & (atomgroup.masses < 3.5)
        return light
    if hasattr(atomgroup, "names"):
        return np.array([name.lstrip("0123456789")[:1].upper() == "H" for name in atomgroup.names])
    return np.zeros(len(atomgroup), dtype=bool)


def rotatable_torsions(
    atomgroup: AtomGroup, bonds: npt.ArrayLike | None = None, heavy_only: bool = True
) -> list[Torsion]:
    """One Torsion for each rotatable bond among the atoms, by rising atom index.

    A bond is rotatable when it is in no ring and neither end is terminal, that is, each end has
    another neighbour. With `heavy_only` hydrogens count as absent, so that no methyl group turns.
    Of the neighbours the torsion takes backbone atoms (names N, CA, C) first, then the heaviest,
    then in amino acids the first name, then the lowest index, which makes phi, psi, omega and chi
    of a protein what they usually are.

    bonds: (B, 2) atom indices of the universe, default those of its topology.
    Raises ValueError when there are no bonds.
    """
    universe = atomgroup.universe
    pairs = _bonds_of(universe) if bonds is None else np.asarray(bonds, dtype=np.int64)
    member = np.zeros(len(universe.atoms), dtype=bool)
    member[atomgroup.ix] = True
    if heavy_only:
        member &= ~is_hydrogen(universe.atoms)
    pairs = pairs[member[pairs].all(axis=1)]
    pairs = np.unique(np.sort(pairs, axis=1), axis=0)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    degree = np.bincount(pairs.ravel(), minlength=len(member))
    graph = Framework(pairs, np.ones(len(pairs)), len(member))
    rotatable = graph.bridges() & (degree[pairs] > 1).all(axis=1)
    namer = _Namer(universe.atoms, pairs)
    return [namer.torsion(j, k) for j, k in pairs[rotatable].tolist()]


def _bonds_of(universe: Universe) -> np.ndarray:
    if not hasattr(universe, "bonds") or len(universe.bonds) == 0:
        raise ValueError("there are no bonds: give bonds, or a topology that has them")
    bonds: np.ndarray = universe.bonds.indices.astype(np.int64)
    return bonds


class _Namer:
    """Chooses the outer atoms of a torsion and names it."""

    def __init__(self, atoms: AtomGroup, bonds: np.ndarray) -> None:
        self._others: list[list[int]] = [[] for _ in range(len(atoms))]
        for j, k in bonds.tolist():
            self._others[j].append(k)
            self._others[k].append(j)
        self._names = list(atoms.names) if hasattr(atoms, "names") else [""] * len(atoms)
        self._masses = atoms.masses if hasattr(atoms, "masses") else np.zeros(len(atoms))
        self._resindices = atoms.resindices
        self._residues = atoms.universe.residues
        self._several_chains = len(atoms.universe.segments) > 1
        self._amino_acids = set(self._resindices[np.isin(self._names, ("CA",))].tolist())

    def torsion(self, j: int, k: int) -> Torsion:
        kind = self._kind(j, k)
        if not kind and self._kind(k, j):
            j, k, kind = k, j, self._kind(k, j)
        atoms = (self._outer(j, k), j, k, self._outer(k, j))
        outer = tuple(self._names[atom] for atom in (atoms[0], atoms[3]))
        if kind in _OUTER and outer != _OUTER[kind]:
            kind = ""
        residue = int(self._resindices[k if kind == "phi" else j])
        return Torsion(atoms, kind, self._label(atoms, kind, residue), residue)

    def _outer(self, atom: int, other: int) -> int:
        return min((c for c in self._others[atom] if c != other), key=self._preference)

    def _preference(self, atom: int) -> tuple[bool, float, str, int]:
        name = self._names[atom]
        branch = name if self._resindices[atom] in self._amino_acids else ""  # CG1 before CG2
        return (name not in BACKBONE, -float(self._masses[atom]), branch, atom)

    def _kind(self, j: int, k: int) -> str:
        """What the torsion about the bond j-k is called when it is written in this direction."""
        first, second = self._names[j], self._names[k]
        if (first, second) in _BACKBONE_BONDS:
            return _BACKBONE_BONDS[first, second]
        same = self._resindices[j] == self._resindices[k]
        if not same or self._resindices[j] not in self._amino_acids:
            return ""
        return _SIDE_CHAIN_BONDS.get(first[1:2] + second[1:2], "")

    def _label(self, atoms: Sequence[int], kind: str, residue: int) -> str:
        what = kind or "-".join(self._names[atom] or str(atom) for atom in atoms)
        if len(self._residues) == 1:
            return what
        owner = self._residues[residue]
        chain = chain_of(getattr(owner, "segid", ""))
        prefix = f"{chain}:" if chain and self._several_chains else ""
        number = getattr(owner, "resid", residue + 1)
        return f"{prefix}{getattr(owner, 'resname', '')}{number} {what}"
