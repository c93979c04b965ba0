# SPDX-License-Identifier: MIT
"""Chains that the edge of a periodic box has cut, made whole by their alpha carbons."""

from __future__ import annotations

import numpy as np
from MDAnalysis.lib.distances import minimize_vectors


def joined_along(positions: np.ndarray, cell: np.ndarray | None) -> np.ndarray:
    """Each atom at the image next to the one before it, where there is a cell.

    positions: (n, 3) Angstrom of atoms along chains; cell: lengths and angles as MDAnalysis has
    them. A chain begins at the image next to the end of the chain before it: right where that is
    nearer than half a cell. Returns (n, 3), float64.
    """
    wide = np.array(positions, dtype=np.float64)
    if cell is None or len(wide) < 2 or not np.all(np.asarray(cell[:3]) > 0):
        return wide
    steps = minimize_vectors(np.diff(wide, axis=0), box=cell)
    joined: np.ndarray = np.vstack([wide[:1], wide[0] + np.cumsum(steps, axis=0)])
    return joined
