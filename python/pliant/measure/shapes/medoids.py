# SPDX-License-Identifier: MIT
"""A few frames that stand for all: k-medoids on the RMSD of frames superposed pair by pair."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

#: pairs of frames that are superposed at a time
PAIRS_AT_ONCE = 1 << 17
MOST_ROUNDS = 100


@dataclass(frozen=True)
class Medoids:
    """k of F frames, and the frames that each stands for."""

    frames: np.ndarray  #: (k,) their places, those that stand for most frames first
    owner: np.ndarray  #: (F,) which of the k each frame is nearest to
    distance: np.ndarray  #: (F,) how far from it


def pairwise_rmsd(positions: np.ndarray) -> np.ndarray:
    """(F, F) RMSD of all pairs of frames (F, n, 3), each pair superposed by itself.

    n RMSD^2 = |x|^2 + |y|^2 - 2 (s1 + s2 +- s3), with s the singular values of the 3 x 3 matrix
    x^T y of the centred frames, and - where its determinant is negative (W. Kabsch, Acta Cryst. A
    32 (1976) 922).
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


def k_medoids(distances: np.ndarray, count: int) -> Medoids:
    """`count` frames whose mean distance to the frames that they stand for is small.

    distances: (F, F). Each next frame is the one that lessens the sum most; then frames are dealt
    to the nearest, and each group takes its best, until nothing changes (H.-S. Park, C.-H. Jun,
    Expert Syst. Appl. 36 (2009) 3336). Nothing is random; of equals the first is taken.
    """
    if not 1 <= count <= len(distances):
        raise ValueError(f"count: expected 1 to {len(distances)}, got {count}")
    chosen = _greedy(distances, count)
    for _ in range(MOST_ROUNDS):
        owner = np.argmin(distances[:, chosen], axis=1)
        better = chosen.copy()
        for k in range(count):
            group = np.flatnonzero(owner == k)
            sums = distances[np.ix_(group, group)].sum(axis=0)
            better[k] = group[np.argmin(sums)] if len(group) else chosen[k]
        if np.array_equal(better, chosen):
            break
        chosen = better
    sizes = np.bincount(np.argmin(distances[:, chosen], axis=1), minlength=count)
    chosen = chosen[np.lexsort((chosen, -sizes))]
    owner = np.argmin(distances[:, chosen], axis=1)
    return Medoids(chosen, owner, distances[np.arange(len(distances)), chosen[owner]])


def _greedy(distances: np.ndarray, count: int) -> np.ndarray:
    chosen = [int(np.argmin(distances.sum(axis=0)))]
    nearest = distances[:, chosen[0]].copy()
    while len(chosen) < count:
        gains = np.maximum(nearest[:, None] - distances, 0.0).sum(axis=0)
        gains[chosen] = -1.0
        chosen.append(int(np.argmax(gains)))
        nearest = np.minimum(nearest, distances[:, chosen[-1]])
    return np.array(chosen)
