# SPDX-License-Identifier: MIT
"""Sequences of residues as letters, and which residue of one is which of another."""

from __future__ import annotations

from pliant._core import align as aligned
from pliant._core import amino_acid_letters

__all__ = ["LETTERS", "UNKNOWN", "aligned"]

#: of amino acids, with the names of force fields and of what stands for them in crystals
LETTERS = amino_acid_letters()
UNKNOWN = "X"
