# SPDX-License-Identifier: MIT
"""Distances of atoms: where they are beside their residues, and what a structure has of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant._core import Error, InputError, Structure, select_atoms
from pliant.jobs.fit.labels import BACKBONE, Labels, local_of

#: what a site is of: one atom, or hydrogens of which any may be the one that is seen
ATOM_KINDS = ("ATOM", "NOE")


@dataclass(frozen=True)
class Place:
    """Where atoms of a residue are."""

    node: int
    local: np.ndarray  #: (3,) their mean in START beside the node, as ``places`` takes it
    slack: float  #: how far they may be from there, Angstrom

    @classmethod
    def of(cls, atoms: np.ndarray, node: int, beside: Labels) -> Place:
        """Side chains turn about the bond to the beta carbon: an atom may be as far from there."""
        points = np.asarray(beside.structure.positions)[atoms]
        if not beside.has_frame(node):
            away = np.linalg.norm(points - beside.nodes[node], axis=1)
            return cls(node, np.zeros(3), float(away.max()))
        away = np.linalg.norm(points - beside.beta(node), axis=1)
        away[np.isin(beside.structure.names[atoms], BACKBONE)] = 0.0
        return cls(node, local_of(beside.nodes, node, points.mean(axis=0)), float(away.max()))


@dataclass(frozen=True)
class AtomSite:
    """Atoms, of which any may be meant."""

    atoms: np.ndarray  #: (n,) of the structure
    places: list[Place]  #: one for each of their residues

    @classmethod
    def of(cls, selection: str, kind: str, beside: Labels) -> AtomSite:
        """Raises InputError: what was expected and found."""
        structure = beside.structure
        try:
            atoms = select_atoms(structure, selection)
        except Error as error:
            raise InputError(str(error)) from None
        if kind == "NOE":
            atoms = _hydrogens(structure, atoms)
        elif len(atoms) != 1:
            raise InputError(f"expected one atom, as 'resid 45 and name CB', found {len(atoms)}")
        residues = np.asarray(structure.residue_of)[atoms]
        some = sorted({int(residue) for residue in residues})
        if not set(some) <= set(beside.node_of):
            raise InputError("expected atoms of residues of a protein or nucleic acid")
        of = [(atoms[residues == residue], beside.node_of[residue]) for residue in some]
        return cls(atoms, [Place.of(*one, beside) for one in of])


def _hydrogens(structure: Structure, atoms: np.ndarray) -> np.ndarray:
    found = atoms[np.asarray(structure.elements)[atoms] == 1]
    if not len(found):
        raise InputError(
            f"expected hydrogens, found {len(atoms)} other atoms; START has those of its file and "
            "on N, O and S; all_hydrogens adds the others, on carbon"
        )
    return np.asarray(found)


def atom_distance(positions: np.ndarray, one: np.ndarray, other: np.ndarray) -> float:
    """(sum of r^-6)^(-1/6) over all pairs of two sets of atoms of (N, 3), Angstrom: what an NOE
    sees of ambiguous hydrogens (M. Nilges, Proteins 17 (1993) 297); of two atoms their distance."""
    apart = np.linalg.norm(positions[one][:, None] - positions[other][None], axis=2)
    return float((apart**-6.0).sum() ** (-1 / 6))
