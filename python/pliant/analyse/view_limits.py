# SPDX-License-Identifier: MIT
"""What the 3-D views of the pages hold to, and how positions are put into them."""

from __future__ import annotations

import base64

import numpy as np

#: atoms that a browser draws fluently
MAX_ATOMS = 12_000

#: of more atoms than these the hydrogens are not shown
MAX_WITH_HYDROGENS = 1_500


def facing_the_reader(positions: np.ndarray) -> np.ndarray:
    """Turned so that the first frame is longest along x and thinnest along z, around 0."""
    positions = positions - positions[0].mean(axis=0)
    _, _, axes = np.linalg.svd(positions[0], full_matrices=True)
    if np.linalg.det(axes) < 0:
        axes[2] = -axes[2]
    turned: np.ndarray = positions @ axes.T
    return turned


def as_base64(array: np.ndarray) -> str:
    """The bytes of an array as text."""
    return base64.b64encode(np.ascontiguousarray(array).tobytes()).decode("ascii")
