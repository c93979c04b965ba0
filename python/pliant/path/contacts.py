# SPDX-License-Identifier: MIT
"""Contacts of two structures of one molecule: which both have, and which are there in a frame."""

from __future__ import annotations

from typing import Any

import numpy as np

from pliant._core import Structure

#: (residue, atom) -> the atom that stands for both of two that are alike
ALIKE = {
    ("ASP", "OD2"): "OD1",
    ("GLU", "OE2"): "OE1",
    ("ARG", "NH2"): "NH1",
    **{(ring, f"C{x}2"): f"C{x}1" for ring in ("PHE", "TYR") for x in "DE"},
    ("VAL", "CG2"): "CG1",
    ("LEU", "CD2"): "CD1",
    ("ILE", "CD"): "CD1",
}

BROKEN = 0.1  #: a contact so far outside its interval is none, Angstrom


def names_of(atoms: dict[tuple[int, str], int]) -> dict[int, tuple[int, str]]:
    """Names by atom of atoms by name."""
    return {atom: name for name, atom in atoms.items()}


def keys(
    contacts: np.ndarray, names: dict[int, tuple[int, str]], structure: Structure
) -> list[Any]:
    """What each contact joins, in either order; None where it is not between matched residues.

    Atoms that a turn of the side chain would swap are one: OD1 and OD2 of ASP.
    """

    residue_names = structure.residue_names

    def end(atom: int) -> tuple[int, str] | None:
        if atom not in names:
            return None
        number, name = names[atom]
        return number, ALIKE.get((str(residue_names[atom]), name), name)

    found: list[Any] = []
    for row in contacts:
        ends = (end(int(row["a"])), end(int(row["b"])))
        found.append(None if None in ends else (str(row["kind"]), *sorted(e for e in ends if e)))
    return found


def with_ligands(
    ours: Structure, theirs: Structure, our_residues: np.ndarray, their_residues: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Matched residues, and besides others that have the same chain, number and name in both."""
    here, there = _by_label(ours), _by_label(theirs)
    known, known_there = set(our_residues.tolist()), set(their_residues.tolist())
    more = [
        (residue, there[label])
        for label, residue in here.items()
        if residue not in known and label in there and there[label] not in known_there
    ]
    one, other = np.array(more, dtype=np.int64).reshape(-1, 2).T
    return np.concatenate([our_residues, one]), np.concatenate([their_residues, other])


def _by_label(structure: Structure) -> dict[tuple[str, int, str, str], int]:
    residues, first = np.unique(structure.residue_of, return_index=True)
    columns = (
        structure.chains[first],
        structure.residue_ids[first].tolist(),
        structure.insertion_codes[first],
        structure.residue_names[first],
    )
    labels = zip(*columns, strict=True)
    return {
        (str(chain), number, str(code), str(name)): int(residue)
        for (chain, number, code, name), residue in zip(labels, residues, strict=True)
    }


def off(positions: np.ndarray, contacts: np.ndarray) -> np.ndarray:
    """(C,) how far the distance of each is outside its interval, Angstrom."""
    apart = np.linalg.norm(positions[contacts["a"]] - positions[contacts["b"]], axis=1)
    outside = np.maximum(apart - contacts["most"], contacts["least"] - apart)
    return np.asarray(np.maximum(0.0, outside))


def rms(moves: np.ndarray) -> float:
    """r.m.s. length of moves (n, 3)."""
    return float(np.sqrt(np.mean(np.sum(moves**2, axis=1))))
