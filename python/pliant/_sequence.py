# SPDX-License-Identifier: MIT
"""Sequences of residues as letters, and which residue of one is which of another."""

from __future__ import annotations

import numpy as np

#: of amino acids, with the names of force fields and of what stands for them in crystals
LETTERS = {
    "ALA": "A", "ARG": "R", "ASN": "N", "ASP": "D", "CYS": "C", "GLN": "Q", "GLU": "E", "GLY": "G",
    "HIS": "H", "ILE": "I", "LEU": "L", "LYS": "K", "MET": "M", "PHE": "F", "PRO": "P", "SER": "S",
    "THR": "T", "TRP": "W", "TYR": "Y", "VAL": "V", "MSE": "M", "SEC": "C", "CSO": "C", "CME": "C",
    "CYX": "C", "HID": "H", "HIE": "H", "HIP": "H", "HSD": "H", "HSE": "H", "HSP": "H",
}  # fmt: skip
#: of nucleotides of RNA and DNA
NUCLEOTIDES = {
    "A": "A", "C": "C", "G": "G", "U": "U", "DA": "A", "DC": "C", "DG": "G", "DT": "T",
    "RA": "A", "RC": "C", "RG": "G", "RU": "U", "ADE": "A", "CYT": "C", "GUA": "G", "URA": "U",
    "THY": "T",
}  # fmt: skip
UNKNOWN = "X"
MATCH, MISMATCH, GAP = 2, -1, -2


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
