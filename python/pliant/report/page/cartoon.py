# SPDX-License-Identifier: MIT
"""Helices and strands of the first frame, for the cartoon of a page."""

from __future__ import annotations

import contextlib
import warnings
from collections.abc import Iterator
from typing import TYPE_CHECKING

import numpy as np

from pliant.measure.stages.names import chains_of

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

#: Residues among which hydrogen bonds are looked for at once: DSSP keeps tables of all their pairs.
MOST_AT_ONCE = 500


def secondary_structure(atoms: AtomGroup) -> str:
    """One letter an atom for the cartoon of a protein: h, s or c; l where it has none.

    Empty if there is no protein.

    Of more than MOST_AT_ONCE residues each chain is looked at by itself, and one that is still
    longer in stretches of so many: strands that only another chain or stretch pairs are missed.
    """
    if not hasattr(atoms, "resnames") or len(set(atoms.resindices)) < 4:
        return ""
    protein = atoms.select_atoms("protein")
    if len(protein.select_atoms("name CA")) < 4:
        return ""
    letters = np.full(len(atoms.universe.residues), "l")
    letters[atoms.select_atoms("protein or nucleic").residues.ix] = "c"
    for part in _parts(protein):
        with contextlib.suppress(Exception), warnings.catch_warnings():
            warnings.simplefilter("ignore")  # needs MDAnalysis 2.8 and a whole backbone
            from MDAnalysis.analysis.dssp import DSSP

            found = DSSP(part).run(stop=1).results.dssp[0]
            letters[part.residues.ix] = np.select([found == "H", found == "E"], ["h", "s"], "c")
    return "".join(letters[atoms.resindices])


def _parts(protein: AtomGroup) -> Iterator[AtomGroup]:
    residues = protein.residues
    if len(residues) <= MOST_AT_ONCE:
        yield protein
        return
    chains = chains_of(residues)
    begins = np.flatnonzero(chains[1:] != chains[:-1]) + 1
    for chain in np.split(residues.ix, begins):
        for stretch in np.array_split(chain, -(-len(chain) // MOST_AT_ONCE)):
            yield protein[np.isin(protein.resindices, stretch)]
