# SPDX-License-Identifier: MIT
"""Proteins of files, without warnings: the part that is amino acids, alpha carbons, models."""

from __future__ import annotations

import contextlib
import os
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

import pliant
from pliant._core import InputError, MolecularModel, Structure, amino_acid_letters

#: of amino acids, with the names of force fields and of what stands for them in crystals
LETTERS = amino_acid_letters()


@dataclass(frozen=True)
class Trace:
    """The alpha carbons of R residues, in the order of the file."""

    atoms: np.ndarray  #: (R,) indices into the structure
    sequence: str  #: R letters, X for what is no amino acid of the table
    positions: np.ndarray  #: (R, 3) Angstrom

    def owners(self, structure: Structure) -> np.ndarray:
        """(N,) to which of the R residues each atom belongs, where all have an alpha carbon."""
        residues = np.asarray(structure.residue_of)
        places = {int(residues[atom]): k for k, atom in enumerate(self.atoms)}
        return np.array([places[int(residue)] for residue in residues])


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Without warnings of columns, alternates, links, chain breaks and missing hydrogens."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", pliant.PliantWarning)
        yield


def read_quietly(path: str | os.PathLike[str], model: int = 1) -> Structure:
    """A model of a file."""
    with quiet():
        return pliant.read(path, model)


def protein_model(
    path: str | os.PathLike[str], *, polar_hydrogens: bool = False, chain: str = "", **options: Any
) -> MolecularModel:
    """Of the residues of a file, or of one chain, that are amino acids.

    Raises as `amino_part`, `chain_part` and ``build_model`` do.
    """
    part = chain_part(amino_part(read_quietly(path)), chain)
    with quiet():
        return pliant.build_model(heavy_part(part) if polar_hydrogens else part, **options)


def trace_of(structure: Structure) -> Trace:
    """Carbons of the name CA. Raises InputError where there are fewer than two."""
    is_alpha = (structure.names == "CA") & (structure.elements == 6)
    atoms = np.flatnonzero(is_alpha)
    if len(atoms) < 2:
        raise InputError(f"{structure.source}: fewer than two alpha carbons")
    letters = (LETTERS.get(str(name), "X") for name in structure.residue_names[atoms])
    return Trace(atoms, "".join(letters), structure.positions[atoms])


def heavy_part(structure: Structure) -> Structure:
    """A copy without hydrogens: a model places polar ones by rule."""
    return _atoms_of(structure, np.flatnonzero(np.asarray(structure.elements) != 1))


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


def chain_part(structure: Structure, chain: str) -> Structure:
    """A copy of one chain; the structure itself where none is named.

    Raises InputError where there is no such chain.
    """
    if not chain:
        return structure
    kept = np.flatnonzero(np.asarray(structure.chains) == chain)
    if len(kept) == 0:
        raise InputError(f"{structure.source}: no chain is named '{chain}'")
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
