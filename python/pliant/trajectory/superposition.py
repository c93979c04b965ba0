# SPDX-License-Identifier: MIT
"""Least-squares superposition (W. Kabsch, Acta Cryst. A 32 (1976) 922), and the RMSD it leaves.

The rotation is found by a singular value decomposition, which also serves points on a line or in a
plane, where it is not unique and one of the best is taken. Hands are not turned over.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pliant.trajectory.frame_store import FrameStore, sum_of

#: the average structure is final when an iteration moves it by less (RMS over atoms, Angstrom)
AVERAGE_TOLERANCE = 1e-5
#: pairs of frames that are superposed at a time
PAIRS_AT_ONCE = 1 << 17


def rotations(products: np.ndarray) -> np.ndarray:
    """The proper rotations R (..., 3, 3), x -> x @ R, of products (..., 3, 3).

    A product is x^T w r of centred positions x (n, 3), weights w and the centred reference r.
    """
    u, _, vt = np.linalg.svd(products)
    u[..., -1] *= np.sign(np.linalg.det(u) * np.linalg.det(vt))[..., None]
    found: np.ndarray = u @ vt
    return found


class Superposition:
    """Brings positions onto a reference by the best rotation and translation.

    Minimises sum_i w_i |R (x_i - x_c) - (r_i - r_c)|^2 over proper rotations R.

    reference: (n, 3) Angstrom; weights: (n,).
    """

    def __init__(self, reference: np.ndarray, weights: np.ndarray) -> None:
        self.weights = weights / weights.sum()
        self.centre = self.weights @ reference
        self.reference = reference - self.centre

    def motion(self, positions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Rotation (3, 3) and centre (3,) of positions (n, 3): x -> (x - centre) @ rotation."""
        centre = self.weights @ positions
        weighted = (positions - centre) * self.weights[:, None]
        return rotations(weighted.T @ self.reference), centre

    def apply(self, positions: np.ndarray, fitted: np.ndarray | None = None) -> np.ndarray:
        """`positions` (m, 3) moved as the `fitted` (n, 3) must be to lie on the reference.

        Without `fitted` the positions themselves are fitted.
        """
        rotation, centre = self.motion(positions if fitted is None else fitted)
        moved: np.ndarray = (positions - centre) @ rotation + self.centre
        return moved


def superpose_all(
    positions: np.ndarray,
    fitted: np.ndarray | None = None,
    iterations: int = 20,
    tolerance: float = AVERAGE_TOLERANCE,
) -> np.ndarray:
    """All frames superposed on their average, which is found by iteration, as Rmsf finds it.

    positions: (F, n, 3), Angstrom; fitted: which of the n atoms are fitted (mask or indices),
    all by default; tolerance: the average is final when it moves by less, Angstrom. Returns the
    moved positions (F, n, 3), float64.
    """
    store = FrameStore.of(np.array(positions, dtype=np.float64))
    superpose_frames(store, fitted, iterations, tolerance)
    assert store.array is not None
    return store.array


def superpose_frames(
    store: FrameStore,
    fitted: np.ndarray | None = None,
    iterations: int = 20,
    tolerance: float = AVERAGE_TOLERANCE,
) -> None:
    """The same in place, of frames that need not be in memory."""
    chosen = slice(None) if fitted is None else fitted
    average = store.take(np.arange(1))[0, chosen]
    for _ in range(iterations):
        total = sum_of(_fitted_anew(store, chosen, average))
        before, average = average, total / len(store)
        if np.sqrt(np.mean(np.sum((average - before) ** 2, axis=1))) < tolerance:
            break


def _fitted_anew(
    store: FrameStore, chosen: np.ndarray | slice, average: np.ndarray
) -> Iterator[np.ndarray]:
    """Moves all frames; their chosen atoms as they are then."""
    for part in store.parts():
        moved = superpose_onto(store.take(part), chosen, average)
        store.put(int(part[0]), moved)
        yield moved[:, chosen]


def superpose_onto(
    positions: np.ndarray, chosen: np.ndarray | slice, reference: np.ndarray
) -> np.ndarray:
    """Each frame (n, 3) moved so that its chosen atoms lie on the reference (m, 3)."""
    middle = reference.mean(axis=0)
    centres = positions[:, chosen].mean(axis=1, keepdims=True)
    part = positions[:, chosen] - centres
    turns = rotations(np.swapaxes(part, 1, 2) @ (reference - middle))
    del part
    moved: np.ndarray = (positions - centres) @ turns
    moved += middle
    return moved


def pairwise_rmsd(positions: np.ndarray) -> np.ndarray:
    """(F, F) RMSD of all pairs of frames (F, n, 3), each pair superposed by itself.

    n RMSD^2 = |x|^2 + |y|^2 - 2 (s1 + s2 +- s3), with s the singular values of the 3 x 3 matrix
    x^T y of the centred frames, and - where its determinant is negative.
    """
    frames, atoms, _ = positions.shape
    centred = positions - positions.mean(axis=1, keepdims=True)
    columns = np.ascontiguousarray(centred.transpose(1, 0, 2).reshape(atoms, 3 * frames))
    squares = np.einsum("fni,fni->f", centred, centred)
    found = np.zeros((frames, frames))
    rows = max(1, PAIRS_AT_ONCE // frames)
    for first in range(0, frames, rows):
        last = min(first + rows, frames)
        products = columns[:, 3 * first : 3 * last].T @ columns[:, 3 * first :]
        matrices = products.reshape(last - first, 3, -1, 3).transpose(0, 2, 1, 3)
        both = squares[first:last, None] + squares[first:]
        found[first:last, first:] = _rmsd(matrices, both, atoms)
    upper = np.triu(found, 1)
    return np.asarray(upper + upper.T)


def rmsd_to(positions: np.ndarray, others: np.ndarray) -> np.ndarray:
    """(F, k) RMSD of frames (F, n, 3) from others (k, n, 3), each pair superposed by itself."""
    atoms = positions.shape[1]
    ours = positions - positions.mean(axis=1, keepdims=True)
    theirs = others - others.mean(axis=1, keepdims=True)
    matrices = np.einsum("fni,knj->fkij", ours, theirs, optimize=True)
    squares = np.einsum("fni,fni->f", ours, ours)[:, None] + np.einsum("kni,kni->k", theirs, theirs)
    return _rmsd(matrices, squares, atoms)


def _rmsd(matrices: np.ndarray, squares: np.ndarray, atoms: int) -> np.ndarray:
    """(F, k) of the matrices x^T y (F, k, 3, 3) and |x|^2 + |y|^2 (F, k) of centred frames."""
    values = np.linalg.svd(matrices, compute_uv=False)
    values[..., 2] *= np.sign(np.linalg.det(matrices))
    return np.asarray(np.sqrt(np.maximum(squares - 2.0 * values.sum(axis=2), 0.0) / atoms))
