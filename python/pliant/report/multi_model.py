# SPDX-License-Identifier: MIT
"""Writes frames as the models of a PDB file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from pliant._core import InputError, pdb_lines
from pliant.base.new_file import new_text
from pliant.measure.stages.names import chains_of, codes_of, numbers_of
from pliant.trajectory.frame_store import FrameStore
from pliant.trajectory.superposition import superpose_all

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.stages.analysis import Analysis

MOST_ATOMS = 99_999  #: whose numbers fit into their column
ATOMS_AT_ONCE = 4096  #: whose lines are made


def write_chosen(
    analysis: Analysis, chosen: np.ndarray, output: Path, remark: str, *, overwrite: bool = True
) -> None:
    """Writes frames (places among those analysed), superposed on their average, as models."""
    atoms = analysis.atoms
    both = np.union1d(atoms.ix, analysis.fitted.ix)
    positions = np.array([analysis.positions(k)[both] for k in chosen])
    moved = superpose_all(positions, np.searchsorted(both, analysis.fitted.ix))
    remarks = [remark]
    remarks += [f"model {k + 1}: frame {analysis.frames[one]}" for k, one in enumerate(chosen)]
    kept = moved[:, np.searchsorted(both, atoms.ix)]
    write_models(output, atoms, kept, np.zeros(len(atoms)), remarks, overwrite=overwrite)


def write_models(
    path: Path,
    atoms: AtomGroup,
    positions: np.ndarray | FrameStore,
    b_factors: np.ndarray,
    remarks: Sequence[str] = (),
    chosen: np.ndarray | None = None,
    *,
    overwrite: bool = True,
) -> None:
    """Writes positions (F, n, 3), Angstrom, of n atoms as F models; one frame has no MODEL line.

    chosen: numbers of the frames; all by default. b_factors: (n,) Angstrom^2; what a PDB file
    cannot hold is written as 999.99. Raises InputError where coordinates or the number of atoms do
    not fit into the columns of the format, FileError where it cannot be written.
    """
    if len(atoms) > MOST_ATOMS:
        raise InputError(f"{path}: a PDB file holds up to {MOST_ATOMS} atoms, not {len(atoms)}")
    store = positions if isinstance(positions, FrameStore) else FrameStore.of(positions)
    if not all(np.all(np.abs(block) < 9999) for block in store.blocks(chosen)):
        raise InputError(f"{path}: a PDB file holds coordinates up to 9999 Angstrom")
    heads, tails = _fixed_parts(atoms, b_factors)
    with new_text(path, overwrite=overwrite) as file:
        for text in remarks:
            file.write(f"REMARK  99 {text[:68]}\n")
        frames = (frame for block in store.blocks(chosen) for frame in block)
        count = len(store) if chosen is None else len(chosen)
        for k, frame in enumerate(frames):
            if count > 1:
                file.write(f"MODEL     {k + 1:4d}\n")
            for first in range(0, len(atoms), ATOMS_AT_ONCE):
                part = slice(first, first + ATOMS_AT_ONCE)
                file.write(pdb_lines(heads[part], frame[part], tails[part]))
            if count > 1:
                file.write("ENDMDL\n")
        file.write("END\n")


def _fixed_parts(atoms: AtomGroup, b_factors: np.ndarray) -> tuple[list[str], list[str]]:
    """What stands before and after the coordinates of each atom."""
    count = len(atoms)
    names = [str(n) for n in getattr(atoms, "names", ["X"] * count)]
    elements = [str(e) for e in getattr(atoms, "elements", [""] * count)]
    residues = [str(r)[:4] for r in getattr(atoms, "resnames", ["UNK"] * count)]
    chains = [str(c)[:1] for c in chains_of(atoms)]
    named = hasattr(atoms, "resnames")
    polymer = np.isin(atoms.ix, atoms.select_atoms("protein or nucleic").ix if named else [])
    heads, tails = [], []
    numbers = [
        f"{number % 10000:4d}{code or ' ':.1}"
        for number, code in zip(numbers_of(atoms).tolist(), codes_of(atoms), strict=True)
    ]
    rows = zip(names, elements, residues, chains, numbers, strict=True)
    for k, (name, element, residue, chain, number) in enumerate(rows):
        kind = "ATOM  " if polymer[k] else "HETATM"
        padded = f"{name:<4s}"[:4] if len(element) == 2 or len(name) > 3 else f" {name:<3s}"
        heads.append(f"{kind}{k + 1:5d} {padded} {residue:<4s}{chain or ' '}{number}   ")
        factor = min(float(b_factors[k]), 999.99)
        tails.append(f"  1.00{factor:6.2f}          {element.upper():>2s}\n")
    return heads, tails
