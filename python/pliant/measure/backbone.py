# SPDX-License-Identifier: MIT
"""Backbone torsions of structures, by names of atoms and bonds."""

from __future__ import annotations

import numpy as np

from pliant._core import Structure
from pliant.measure.geometry import torsions_of
from pliant.measure.ramachandran import OUTLIER, judged


def neighbours_of(structure: Structure) -> list[list[int]]:
    """(N) the atoms that each is bonded to."""
    lists: list[list[int]] = [[] for _ in range(len(structure))]
    for a, b in np.asarray(structure.bonds, dtype=np.int64).reshape(-1, 2).tolist():
        lists[a].append(b)
        lists[b].append(a)
    return lists


def peptide_links(structure: Structure, neighbours: list[list[int]]) -> list[tuple[int, ...]]:
    """Rows CA, C, N, CA across each peptide bond."""
    names, residue = structure.names, structure.residue_of
    place = {(int(residue[k]), str(names[k])): int(k) for k in range(len(structure))}
    links: list[tuple[int, ...]] = []
    for c in np.flatnonzero((names == "C") & (structure.elements == 6)).tolist():
        for n in neighbours[c]:
            ends = place.get((int(residue[c]), "CA")), place.get((int(residue[n]), "CA"))
            if str(names[n]) == "N" and residue[n] != residue[c] and None not in ends:
                links.append((int(ends[0] or 0), c, n, int(ends[1] or 0)))
    return links


def phi_psi_atoms(structure: Structure, links: list[tuple[int, ...]]) -> np.ndarray:
    """Rows C, N, CA, C, N of residues between two others, but not glycine and proline."""
    before = {ca: (c, n) for _, c, n, ca in links}
    kinds = structure.residue_names
    rows = []
    for ca, c, n, _ in links:
        if ca in before and str(kinds[ca]) not in ("GLY", "PRO"):
            rows.append([*before[ca], ca, c, n])
    return np.array(rows, dtype=np.int64).reshape(-1, 5)


def ramachandran_outliers(structure: Structure, frames: np.ndarray) -> np.ndarray:
    """(F,) shares of residues outside the allowed regions, in frames (F, N, 3); 0 without any."""
    rows = phi_psi_atoms(structure, peptide_links(structure, neighbours_of(structure)))
    found = []
    for frame in frames:
        phi, psi = (torsions_of(frame, rows[:, k : k + 4]) for k in (0, 1))
        found.append(float((judged(phi, psi) == OUTLIER).mean()) if len(rows) else 0.0)
    return np.array(found)
