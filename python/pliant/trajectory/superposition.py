# SPDX-License-Identifier: MIT
"""Least-squares superposition (Kabsch fit): the rigid motion that brings atoms onto a reference."""

from __future__ import annotations

import numpy as np


class Superposition:
    """Brings positions onto a reference by the best rotation and translation.

    Minimises sum_i w_i |R (x_i - x_c) - (r_i - r_c)|^2 over proper rotations R (W. Kabsch, Acta
    Cryst. A 32 (1976) 922), by a singular value decomposition, which also serves points on a line
    or in a plane, where R is not unique and one of the best is taken.

    reference: (n, 3) Angstrom; weights: (n,).
    """

    def __init__(self, reference: np.ndarray, weights: np.ndarray) -> None:
        self.weights = weights / weights.sum()
        self.centre = self.weights @ reference
        self.reference = reference - self.centre

    def motion(self, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Rotation (3, 3) and centre (3,) of positions (n, 3): x -> (x - centre) @ rotation."""
        centre = self.weights @ positions
        u, _, vt = np.linalg.svd(((positions - centre) * self.weights[:, None]).T @ self.reference)
        if np.linalg.det(u) * np.linalg.det(vt) < 0:
            u[:, -1] = -u[:, -1]
        return u @ vt, centre

    def apply(self, positions: np.ndarray, fitted: np.ndarray | None = None) -> np.ndarray:
        """`positions` (m, 3) moved as the `fitted` (n, 3) must be to lie on the reference.

        Without `fitted` the positions themselves are fitted.
        """
        rotation, centre = self.motion(positions if fitted is None else fitted)
        moved: np.ndarray = (positions - centre) @ rotation + self.centre
        return moved
