# SPDX-License-Identifier: MIT
"""How alike two ensembles are, or an ensemble and a displacement: r, RMSIP, overlaps, errors.

Frames are (F, N, 3), modes (K, 3 N) rows of unit length, all in Angstrom. Every figure is the same
for peers: what differs is where their fluctuations and modes come from.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

TEN = 10  #: modes of RMSIP and of cumulative overlaps
ROUNDS = 8  #: of superposing on the mean
NOTHING = float("nan")


@dataclass(frozen=True)
class Figure:
    """A value and its standard error by bootstrap; not-a-number where there is none."""

    value: float = NOTHING
    error: float = NOTHING


def superposed(frames: np.ndarray, reference: np.ndarray) -> np.ndarray:
    """Each frame moved as a whole onto the reference (N, 3), least squares (Kabsch)."""
    centre = reference.mean(axis=0)
    goal = reference - centre
    shifted = frames - frames.mean(axis=1, keepdims=True)
    u, _, vt = np.linalg.svd(np.einsum("fni,nj->fij", shifted, goal))
    u[:, :, 2] *= np.sign(np.linalg.det(u) * np.linalg.det(vt))[:, None]
    moved: np.ndarray = shifted @ (u @ vt) + centre
    return moved


def superposed_on_mean(frames: np.ndarray) -> np.ndarray:
    """Each frame on the mean of all, which is found by repeating."""
    moved = superposed(frames, frames[0])
    for _ in range(ROUNDS):
        moved = superposed(moved, moved.mean(axis=0))
    return moved


def fluctuations(frames: np.ndarray) -> np.ndarray:
    """RMSF (N,) of frames as they lie."""
    spread = frames - frames.mean(axis=0)
    rmsf: np.ndarray = np.sqrt((spread**2).sum(axis=2).mean(axis=0))
    return rmsf


def components(frames: np.ndarray, count: int = TEN) -> np.ndarray:
    """Principal components of frames as they lie, of largest variance first."""
    table = (frames - frames.mean(axis=0)).reshape(len(frames), -1)
    rows: np.ndarray = np.linalg.svd(table, full_matrices=False)[2][:count]
    return rows


def orthonormal(modes: np.ndarray, atoms: np.ndarray, count: int = TEN) -> np.ndarray:
    """The first modes (K, M, 3) on some atoms alone, made orthogonal again."""
    part = modes[:count, atoms].reshape(min(count, len(modes)), -1)
    rows: np.ndarray = np.linalg.qr(part.T)[0].T
    return rows


def correlation(a: np.ndarray, b: np.ndarray) -> float:
    """Pearson's r."""
    return float(np.corrcoef(a, b)[0, 1])


def rmsip(a: np.ndarray, b: np.ndarray, count: int = TEN) -> float:
    """Root mean square inner product of the first modes of two (A. Amadei et al., 1999)."""
    return float(np.sqrt(((a[:count] @ b[:count].T) ** 2).sum() / count))


def cumulative_overlap(modes: np.ndarray, displacement: np.ndarray, count: int = TEN) -> float:
    """Length of the part of a displacement (N, 3) within the first modes, as a share of all."""
    along = modes[:count] @ displacement.ravel()
    return float(np.linalg.norm(along) / np.linalg.norm(displacement))


def bootstrap(
    count: int, figure: Callable[[np.ndarray], Sequence[float]], draws: int
) -> np.ndarray:
    """Standard deviations of figures over draws of `count` things with replacement.

    Numbers are the same in every call: a figure's error depends on its data alone.
    """
    random = np.random.default_rng(0)
    values = [figure(random.integers(0, count, count)) for _ in range(draws)]
    errors: np.ndarray = np.std(np.array(values, dtype=float), axis=0)
    return errors


def correlation_over_residues(a: np.ndarray, b: np.ndarray, draws: int = 1000) -> Figure:
    """r of two profiles, its error over residues."""
    error = bootstrap(len(a), lambda i: [correlation(a[i], b[i])], draws)[0]
    return Figure(correlation(a, b), float(error))


def halves(frames: np.ndarray, draws: int = 20) -> tuple[float, float]:
    """r of RMSF and RMSIP of random halves of an ensemble, means: the ceiling of both."""
    random = np.random.default_rng(0)
    found = []
    for _ in range(draws):
        order = random.permutation(len(frames))
        one = superposed_on_mean(frames[order[::2]])
        other = superposed(superposed_on_mean(frames[order[1::2]]), one.mean(axis=0))
        r = correlation(fluctuations(one), fluctuations(other))
        found.append((r, rmsip(components(one), components(other))))
    r, inner = np.mean(found, axis=0)
    return float(r), float(inner)
