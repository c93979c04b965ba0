# SPDX-License-Identifier: MIT
"""Alpha carbons of a structure, and which of them is which of another's."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pliant._core import InputError, Structure

LETTERS = {
    "ALA": "A", "ARG": "R", "ASN": "N", "ASP": "D", "CYS": "C", "GLN": "Q", "GLU": "E", "GLY": "G",
    "HIS": "H", "ILE": "I", "LEU": "L", "LYS": "K", "MET": "M", "PHE": "F", "PRO": "P", "SER": "S",
    "THR": "T", "TRP": "W", "TYR": "Y", "VAL": "V", "MSE": "M", "SEC": "C", "CSO": "C", "CME": "C",
    "CYX": "C", "HID": "H", "HIE": "H", "HIP": "H", "HSD": "H", "HSE": "H", "HSP": "H",
}  # fmt: skip
UNKNOWN = "X"
MATCH, MISMATCH, GAP = 2, -1, -2


@dataclass(frozen=True)
class Trace:
    """The alpha carbons of R residues, in the order of the file."""

    atoms: np.ndarray  #: (R,) indices into the structure
    sequence: str  #: R letters, X for what is no amino acid of the table
    positions: np.ndarray  #: (R, 3) Angstrom


def trace_of(structure: Structure) -> Trace:
    """Carbons of the name CA. Raises InputError where there are fewer than two."""
    is_alpha = (structure.names == "CA") & (structure.elements == 6)
    atoms = np.flatnonzero(is_alpha)
    if len(atoms) < 2:
        raise InputError(f"{structure.source}: fewer than two alpha carbons")
    letters = (LETTERS.get(str(name), UNKNOWN) for name in structure.residue_names[atoms])
    return Trace(atoms, "".join(letters), structure.positions[atoms])


def amino_part(structure: Structure) -> Structure:
    """A copy of the residues that have N, CA and C: no waters, ions or ligands.

    Raises InputError where none has.
    """
    residues = np.asarray(structure.residue_of, dtype=np.int64)
    has = np.ones(structure.residue_count, dtype=bool)
    for name, element in (("N", 7), ("CA", 6), ("C", 6)):
        found = residues[(structure.names == name) & (structure.elements == element)]
        has &= np.isin(np.arange(structure.residue_count), found)
    kept = np.flatnonzero(has[residues])
    if len(kept) == 0:
        raise InputError(f"{structure.source}: no residue has N, CA and C")
    return _atoms_of(structure, kept)


def _atoms_of(structure: Structure, kept: np.ndarray) -> Structure:
    part = Structure(
        structure.positions[kept],
        elements=structure.elements[kept],
        names=[str(name) for name in structure.names[kept]],
        residue_names=[str(name) for name in structure.residue_names[kept]],
        residue_ids=structure.residue_ids[kept],
        insertion_codes=[str(code) for code in structure.insertion_codes[kept]],
        chains=[str(name) for name in structure.chains[kept]],
        title=structure.title,
    )
    part.perceive_bonds()
    return part


def aligned(ours: str, theirs: str) -> np.ndarray:
    """Pairs (K, 2) of residues of two sequences, by global alignment (Needleman and Wunsch).

    Match 2, mismatch -1, gap -2; of equal ways a pair goes before a gap in theirs, and that before
    a gap in ours.
    """
    score = _scores(ours, theirs)
    i, j = len(ours), len(theirs)
    pairs = []
    while i and j:
        if score[i, j] == score[i - 1, j - 1] + _same(ours[i - 1], theirs[j - 1]):
            i, j = i - 1, j - 1
            pairs.append((i, j))
        elif score[i, j] == score[i - 1, j] + GAP:
            i -= 1
        else:
            j -= 1
    return np.array(pairs[::-1], dtype=np.int64).reshape(-1, 2)


def _same(a: str, b: str) -> int:
    return MATCH if a == b else MISMATCH


def _scores(ours: str, theirs: str) -> np.ndarray:
    """Best score of each two beginnings, row by row: a gap in ours is a running maximum."""
    letters = np.array(list(theirs))
    steps = GAP * np.arange(len(theirs) + 1)
    score = np.empty((len(ours) + 1, len(theirs) + 1), dtype=np.int64)
    score[0] = steps
    for i, letter in enumerate(ours, start=1):
        best = score[i - 1] + GAP
        paired = score[i - 1, :-1] + np.where(letters == letter, MATCH, MISMATCH)
        best[1:] = np.maximum(best[1:], paired)
        score[i] = np.maximum.accumulate(best - steps) + steps
    return score
