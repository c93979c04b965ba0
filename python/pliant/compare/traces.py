# SPDX-License-Identifier: MIT
"""Residues by one atom each: the alpha carbon of amino acids, P of nucleotides."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pliant._chains import chain_of
from pliant._core import Structure
from pliant._sequence import LETTERS, NUCLEOTIDES, UNKNOWN

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

AMINO, NUCLEIC = "CA", "P"  #: kinds of residues, by the atom that stands for them


@dataclass(frozen=True)
class Trace:
    """R residues in the order of the file."""

    atoms: np.ndarray  #: (R,) place of the atom that stands for each, among those given
    chains: np.ndarray  #: (R,) text; "" where the file has none
    numbers: np.ndarray  #: (R,)
    codes: np.ndarray  #: (R,) insertion codes; "" for none
    names: np.ndarray  #: (R,) "LYS"
    kinds: np.ndarray  #: (R,) AMINO or NUCLEIC
    letters: str  #: R letters, X for a name that is not known

    def __len__(self) -> int:
        return len(self.atoms)

    def label(self, residue: int) -> str:
        """ "A:LYS12", or "LYS12" where the file names no chain."""
        chain = f"{self.chains[residue]}:" if self.chains[residue] else ""
        return f"{chain}{self.names[residue]}{self.numbers[residue]}{self.codes[residue]}"

    def ranges(self, residues: np.ndarray) -> str:
        """ "A:1-3, A:74-76": residues (k,), rising, those next to each other as one."""
        found = []
        for part in np.split(residues, np.flatnonzero(self._breaks(residues)) + 1):
            if len(part):
                first, last = part[0], part[-1]
                chain = f"{self.chains[first]}:" if self.chains[first] else ""
                ends = f"{self.numbers[first]}{self.codes[first]}"
                if last > first:
                    ends += f"-{self.numbers[last]}{self.codes[last]}"
                found.append(chain + ends)
        return ", ".join(found)

    def _breaks(self, residues: np.ndarray) -> np.ndarray:
        other_chain = self.chains[residues[1:]] != self.chains[residues[:-1]]
        broken: np.ndarray = (np.diff(residues) > 1) | other_chain
        return broken


def trace_of_structure(structure: Structure) -> Trace:
    """Of a structure that was read; its first alternate places, as the reader takes them."""
    names = np.asarray(structure.names, dtype=str)
    elements = np.asarray(structure.elements)
    is_amino = (names == "CA") & (elements == 6)
    is_nucleic = (names == "P") & (elements == 15)
    chosen = np.flatnonzero(is_amino | is_nucleic)
    return _trace(
        chosen,
        names[chosen],
        np.asarray(structure.residue_names, dtype=str)[chosen],
        np.asarray(structure.chains, dtype=str)[chosen],
        np.asarray(structure.residue_ids)[chosen],
        np.asarray(structure.insertion_codes, dtype=str)[chosen],
    )


def trace_of_atoms(atoms: AtomGroup) -> Trace:
    """Of atoms of MDAnalysis; empty where they have no names."""
    if not hasattr(atoms, "names") or not hasattr(atoms, "resnames"):
        return _trace(*(np.empty(0, kind) for kind in (int, str, str, str, int, str)))
    names, residues = atoms.names.astype(str), atoms.resnames.astype(str)
    chosen = np.flatnonzero(np.isin(names, [AMINO, NUCLEIC]) & (names != residues))
    codes = getattr(atoms, "icodes", np.full(len(atoms), ""))
    return _trace(
        chosen,
        names[chosen],
        residues[chosen],
        np.array([chain_of(segment) for segment in atoms.segids[chosen]], dtype=str),
        np.asarray(atoms.resids)[chosen],
        np.asarray(codes, dtype=str)[chosen],
    )


def _trace(
    atoms: np.ndarray,
    kinds: np.ndarray,
    names: np.ndarray,
    chains: np.ndarray,
    numbers: np.ndarray,
    codes: np.ndarray,
) -> Trace:
    """Residues of known names; of P those of nucleotides only: phosphates of others are none."""
    known = (kinds == AMINO) | np.isin(names, list(NUCLEOTIDES))
    atoms, kinds, names, chains, numbers, codes = (
        column[known] for column in (atoms, kinds, names, chains, numbers, codes)
    )
    tables = {AMINO: LETTERS, NUCLEIC: NUCLEOTIDES}
    letters = (tables[k].get(n, UNKNOWN) for k, n in zip(kinds, names, strict=True))
    stripped = np.array([code.strip() for code in codes], dtype=str)
    return Trace(atoms, chains, numbers, stripped, names, kinds, "".join(letters))
