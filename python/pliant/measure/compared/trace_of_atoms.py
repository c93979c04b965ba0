# SPDX-License-Identifier: MIT
"""Residues by one atom each, of atoms of MDAnalysis: the alpha carbon of amino acids, P of
nucleotides."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant._core import Trace
from pliant.trajectory.chains import chain_of

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

AMINO, NUCLEIC = "CA", "P"  #: kinds of residues, by the atom that stands for them


def trace_of_atoms(atoms: AtomGroup) -> Trace:
    """The trace of atoms of MDAnalysis; empty where they have no names."""
    if not hasattr(atoms, "names") or not hasattr(atoms, "resnames"):
        return Trace([], [], [], [], [], [])
    names, residues = atoms.names.astype(str), atoms.resnames.astype(str)
    chosen = np.flatnonzero(np.isin(names, [AMINO, NUCLEIC]) & (names != residues))
    codes = getattr(atoms, "icodes", np.full(len(atoms), ""))
    return Trace(
        chosen,
        names[chosen].tolist(),
        residues[chosen].tolist(),
        [chain_of(segment) for segment in atoms.segids[chosen]],
        np.asarray(atoms.resids)[chosen],
        np.asarray(codes, dtype=str)[chosen].tolist(),
    )
