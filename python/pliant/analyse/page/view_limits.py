# SPDX-License-Identifier: MIT
"""What the 3-D views of the pages hold to, and how positions are put into them."""

from __future__ import annotations

import base64
from collections.abc import Callable

import numpy as np

#: atoms that a browser draws fluently
MAX_ATOMS = 12_000

#: of more atoms than these the hydrogens are not shown
MAX_WITH_HYDROGENS = 1_500


def drawn_atoms(
    count: int, heavy: np.ndarray, trace: Callable[[], np.ndarray], most: int = MAX_ATOMS
) -> tuple[np.ndarray, list[str]]:
    """Which of `count` atoms are drawn, and what is said of the others: all, but hydrogens, the
    trace (CA and P), or every so many."""
    every = np.arange(count)
    if count <= min(most, MAX_WITH_HYDROGENS) or len(heavy) == count <= most:
        return every, []
    if len(heavy) <= most:
        return heavy, [f"the molecule without the {count - len(heavy)} hydrogens"]
    if 4 <= len(found := trace()) <= most:
        return found, ["the CA and P atoms only"]
    stride = -(-count // most)
    return every[::stride], [f"every {stride}th atom only"]


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
