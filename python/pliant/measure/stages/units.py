# SPDX-License-Identifier: MIT
"""The units whose flexibility is reported: residues of a chain, or atoms of a small molecule."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from pliant.measure.rotatable import is_hydrogen
from pliant.measure.stages.names import atom_labels, chains_of, numbers_of, residue_labels
from pliant.measure.stages.parts import Units

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup, Universe

    from pliant.measure.stages.analysis import Analysis


def units_of(analysis: Analysis) -> Units:
    """Residues where there are several: each by its atom of the trace (CA, P), if it has one, else
    by its atoms but hydrogens. In a single residue each atom but hydrogens is a unit."""
    atoms = analysis.atoms
    heavy = atoms[~is_hydrogen(atoms)]
    if len(heavy) == 0:
        heavy = atoms
    if len(set(atoms.resindices)) < 2:
        return single_atoms(heavy)
    trace = trace_of(heavy)
    of_trace = np.isin(heavy.ix, trace.ix)
    others = ~np.isin(heavy.resindices, trace.resindices)
    chosen = heavy[of_trace | others]
    owners, unit = np.unique(chosen.resindices, return_inverse=True)
    residues = atoms.universe.residues
    labels = residue_labels(residues)
    return Units(
        "residue",
        [labels[k] for k in owners],
        numbers_of(residues)[owners],
        chains_of(residues)[owners],
        owners,
        chosen.ix,
        unit,
        np.isin(owners, trace.resindices),
    )


def trace_atoms(atoms: AtomGroup) -> AtomGroup:
    """CA of amino acids and P of nucleotides; nothing where atoms or residues have no names.

    Modified residues, whose names MDAnalysis may not know, count if their N or C is bonded to
    another residue: "A:CSO67".
    """
    if not hasattr(atoms, "names") or not hasattr(atoms, "resnames"):
        return atoms[:0]
    known = atoms.select_atoms("(protein and name CA) or (nucleic and name P)")
    others = atoms.select_atoms("name CA and not protein and not nucleic")
    if len(known) == 0 or len(others) == 0 or not hasattr(atoms.universe, "bonds"):
        return known
    return known | others[np.isin(others.resindices, _linked(atoms.universe))]


def _linked(universe: Universe) -> np.ndarray:
    """Numbers of residues whose N or C has a bond to the C or N of another residue."""
    ends = universe.bonds.indices
    owners, names = universe.atoms.resindices[ends], universe.atoms.names[ends]
    peptide = np.sort(names, axis=1) == np.array(["C", "N"], dtype=object)
    found: np.ndarray = owners[peptide.all(axis=1) & (owners[:, 0] != owners[:, 1])]
    return np.unique(found)


def trace_of(atoms: AtomGroup) -> AtomGroup:
    """The atoms of the trace where each residue has one at most; else nothing."""
    trace = trace_atoms(atoms)
    return trace if len(set(trace.resindices)) == len(trace) else atoms[:0]


def trace_units(trace: AtomGroup) -> Units:
    """The residues of a trace, each by its one atom."""
    residues, owners = trace.universe.residues, trace.resindices
    labels = residue_labels(residues)
    names, whole = [labels[k] for k in owners], np.ones(len(trace), dtype=bool)
    numbers, chains = numbers_of(residues)[owners], chains_of(residues)[owners]
    return Units("residue", names, numbers, chains, owners, trace.ix, np.arange(len(trace)), whole)


def single_atoms(atoms: AtomGroup) -> Units:
    """Each atom as a unit."""
    count = len(atoms)
    labels = atom_labels(atoms)
    if len(set(labels)) < count:
        labels = [f"{label}({k + 1})" for label, k in zip(labels, atoms.ix, strict=True)]
    places, chains = np.arange(count), np.full(count, "")
    free = np.zeros(count, dtype=bool)
    return Units("atom", labels, atoms.ix + 1, chains, atoms.ix, atoms.ix, places, of_chain=free)
