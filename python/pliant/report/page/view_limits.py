# SPDX-License-Identifier: MIT
"""What the 3-D views of the pages hold to, and how positions are put into them."""

from __future__ import annotations

import base64
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

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
    if len(heavy) <= most:
        return DrawnAtoms(heavy, (f"all atoms except the {count - len(heavy)} hydrogens",))
    if 4 <= len(found := trace()) <= most:
        return DrawnAtoms(found, ("the CA and P atoms only",), trace_only=True)
    stride = -(-count // most)
    return DrawnAtoms(every[::stride], (f"every {stride}th atom only",), trace_only=True)


def facing_the_reader(positions: np.ndarray) -> np.ndarray:
    """Turned so that the first frame is longest along x and thinnest along z, around 0."""
    positions = positions - positions[0].mean(axis=0)
    # All three axes: two points have one alone. Of more, the full left matrix would be N x N.
    _, _, axes = np.linalg.svd(positions[0], full_matrices=len(positions[0]) < 3)
    if np.linalg.det(axes) < 0:
        axes[2] = -axes[2]
    turned: np.ndarray = positions @ axes.T
    return turned


def as_base64(array: np.ndarray) -> str:
    """The bytes of an array as text."""
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode("ascii")
