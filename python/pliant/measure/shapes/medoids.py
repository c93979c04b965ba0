# SPDX-License-Identifier: MIT
"""A few frames that stand for all: k-medoids on the RMSD of frames superposed pair by pair."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

MOST_ROUNDS = 100


@dataclass(frozen=True)
class Medoids:
    """k of F frames, and the frames that each stands for."""

    frames: np.ndarray  #: (k,) their places, those that stand for most frames first
    owner: np.ndarray  #: (F,) which of the k each frame is nearest to
    distance: np.ndarray  #: (F,) how far from it


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
    return owned_by(distances, chosen)


def owned_by(distances: np.ndarray, chosen: np.ndarray) -> Medoids:
    """Frames (k,) that were chosen, and which frames (F, F) each stands for."""
    sizes = np.bincount(np.argmin(distances[:, chosen], axis=1), minlength=len(chosen))
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
