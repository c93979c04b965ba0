# SPDX-License-Identifier: MIT
"""What the 3-D views of the pages draw of a molecule, and how it is put into them."""

from __future__ import annotations

import base64
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from pliant._core import Structure

#: atoms that a browser draws fluently
MAX_ATOMS = 12_000

#: of more atoms than these the hydrogens are not shown
MAX_WITH_HYDROGENS = 1_500


@dataclass(frozen=True)
class DrawnAtoms:
    """Which atoms of a molecule are drawn."""

    chosen: np.ndarray  #: (n,) numbers
    notes: tuple[str, ...] = ()  #: what is left out
    trace_only: bool = False  #: they are not bonded to each other


def drawn_atoms(
    count: int, heavy: np.ndarray, trace: Callable[[], np.ndarray], most: int = MAX_ATOMS
) -> DrawnAtoms:
    """All of `count` atoms, or all but hydrogens, or the trace (CA and P), or every so many."""
    every = np.arange(count)
    if count <= min(most, MAX_WITH_HYDROGENS) or len(heavy) == count <= most:
        return DrawnAtoms(every)
    if 0 < len(heavy) <= most:
        return DrawnAtoms(heavy, (f"all atoms except the {count - len(heavy)} hydrogens",))
    if 4 <= len(found := trace()) <= most:
        return DrawnAtoms(found, ("the CA and P atoms only",), trace_only=True)
    stride = -(-count // most)
    return DrawnAtoms(every[::stride], (f"every {stride}th atom only",), trace_only=True)


def drawn_molecule(structure: Structure, chosen: np.ndarray) -> dict[str, Any]:
    """Its chosen atoms and their residues; secondary structure is that of all atoms."""
    residues, first, owner = np.unique(
        structure.residue_of[chosen], return_index=True, return_inverse=True
    )
    letters = structure.secondary_structure()
    firsts = np.asarray(chosen)[first]
    numbers = zip(structure.residue_ids[firsts], structure.insertion_codes[firsts], strict=True)
    return {
        "atoms": {
            "names": structure.names[chosen].tolist(),
            "elements": structure.elements[chosen].tolist(),
            "residue": owner.tolist(),
        },
        "residues": {
            "names": structure.residue_names[firsts].tolist(),
            "numbers": [f"{number}{code}" for number, code in numbers],
            "chains": structure.chains[firsts].tolist(),
            "secondary": "".join(letters[k] for k in residues),
        },
    }


def drawn_positions(positions: np.ndarray, about: np.ndarray | None = None) -> dict[str, Any]:
    """Positions (f, n, 3) as 16-bit multiples of a step, about a point (3,) or the middle of the
    first frame."""
    positions = positions - (positions[0].mean(axis=0) if about is None else about)
    step = max(float(np.abs(positions).max(initial=0.0)) / 32767, 1e-6)
    return {"step": step, "positions": as_base64(np.round(positions / step).astype("<i2"))}


def as_base64(array: np.ndarray) -> str:
    """The bytes of an array as text."""
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode("ascii")
