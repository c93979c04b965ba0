# SPDX-License-Identifier: MIT
"""Least-squares superposition (Kabsch fit), of one structure or of all frames at once."""

from collections.abc import Iterator

import numpy as np

from pliant.trajectory.frame_store import FrameStore, sum_of
from pliant.trajectory.superposition import Superposition

__all__ = ["Superposition", "superpose_all", "superpose_frames", "superpose_onto"]

#: the average structure is final when an iteration moves it by less (RMS over atoms, Angstrom)
AVERAGE_TOLERANCE = 1e-5


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
    u, _, vt = np.linalg.svd(np.swapaxes(part, 1, 2) @ (reference - middle))
    u[:, :, -1] *= np.sign(np.linalg.det(u) * np.linalg.det(vt))[:, None]
    del part
    moved: np.ndarray = (positions - centres) @ (u @ vt)
    moved += middle
    return moved
