# SPDX-License-Identifier: MIT
"""How alike two ensembles are, or an ensemble and a displacement: r, RMSIP, overlaps, errors.

Frames are (F, n, 3), modes (K, 3 n) rows of unit length, all in Angstrom. The same code measures
ours and others: what differs is where fluctuations and modes come from.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from pliant.trajectory.superposition import superpose_all, superpose_onto

TEN = 10  #: modes of RMSIP and of cumulative overlaps
NOTHING = float("nan")
MOST_ITERATIONS = 50
SETTLED = 1e-7  #: Angstrom, RMS change of an average structure that counts as none
LEAST_VARIANCE = 1e-12  #: Angstrom^2; less is the rounding of 32-bit coordinates
LEAST_SHARE = 1e-12  #: of the largest variance; less is rounding


@dataclass(frozen=True)
class Figure:
    """A value and its standard error by bootstrap; not-a-number where there is none."""

    value: float = NOTHING
    error: float = NOTHING


@dataclass(frozen=True)
class Modes:
    """Principal components of an ensemble, largest variance first."""

    vectors: np.ndarray  #: (K, 3 n) unit vectors
    variances: np.ndarray  #: (K,) Angstrom^2
    total: float  #: variance of all components, Angstrom^2

    @property
    def share(self) -> float:
        """The share of the total variance that these components explain."""
        return float(self.variances.sum() / self.total) if self.total > 0 else 0.0


def superposed(
    frames: np.ndarray, reference: np.ndarray, fit: np.ndarray | None = None
) -> np.ndarray:
    """Each frame moved as a whole onto the reference (n, 3), least squares over atoms `fit`."""
    chosen = slice(None) if fit is None else fit
    return superpose_onto(np.asarray(frames, dtype=np.float64), chosen, reference[chosen])


def superposed_on_mean(frames: np.ndarray, fit: np.ndarray | None = None) -> np.ndarray:
    """Each frame on the mean of all, which is found by repeating."""
    return superpose_all(frames, fit, MOST_ITERATIONS, SETTLED)


def turned_as_one(frames: np.ndarray, reference: np.ndarray, fit: np.ndarray) -> np.ndarray:
    """All frames moved by the one motion that brings their mean onto the reference."""
    mean = frames.mean(axis=0)
    corners = np.concatenate([np.zeros((1, 3)), np.eye(3)])
    carried = np.concatenate([mean, mean[fit].mean(axis=0) + corners])[None]
    moved = superposed(carried, np.concatenate([reference, corners]), fit)[0, len(mean) :]
    turned: np.ndarray = (frames - mean[fit].mean(axis=0)) @ (moved[1:] - moved[0]) + moved[0]
    return turned


def fluctuations(frames: np.ndarray) -> np.ndarray:
    """RMSF (n,) of frames as they lie: root of the mean squared distance from the mean."""
    spread = frames - frames.mean(axis=0)
    rmsf: np.ndarray = np.sqrt((spread**2).sum(axis=2).mean(axis=0))
    return rmsf


def principal_modes(frames: np.ndarray, most: int = TEN) -> Modes:
    """The first `most` principal components that have variance, of frames as they lie."""
    table = (frames - frames.mean(axis=0)).reshape(len(frames), -1)
    variances, vectors = _right_singular(table, most)
    total = float((table**2).sum() / max(len(frames) - 1, 1))
    variances = variances / max(len(frames) - 1, 1)
    kept = variances > max(LEAST_VARIANCE, LEAST_SHARE * variances.max(initial=0.0))
    return Modes(vectors[kept], variances[kept], total)


def _right_singular(table: np.ndarray, most: int) -> tuple[np.ndarray, np.ndarray]:
    """Squares of the largest singular values (K,), falling, and right singular vectors (K, D).

    From the smaller of the two products of the table with itself: an order quicker than a singular
    value decomposition. What is lost are digits of values below 1e-8 of the largest.
    """
    rows, columns = table.shape
    if min(rows, columns) <= 2 * most:
        _, singular, vectors = np.linalg.svd(table, full_matrices=False)
        return singular[:most] ** 2, vectors[:most]
    wide = rows < columns
    squares, found = np.linalg.eigh(table @ table.T if wide else table.T @ table)
    squares, found = np.maximum(squares[::-1][:most], 0.0), found[:, ::-1][:, :most]
    if not wide:
        return squares, np.ascontiguousarray(found.T)
    lengths = np.sqrt(np.where(squares > 0.0, squares, 1.0))
    return squares, (found.T @ table) / lengths[:, None]


def components(frames: np.ndarray, count: int = TEN) -> np.ndarray:
    """Principal components (K, 3 n) of frames as they lie, of largest variance first."""
    return principal_modes(frames, count).vectors


def orthonormal(modes: np.ndarray, atoms: np.ndarray, count: int = TEN) -> np.ndarray:
    """The first modes (K, m, 3) on some atoms alone, made orthogonal again."""
    part = modes[:count, atoms].reshape(min(count, len(modes)), -1)
    rows: np.ndarray = np.linalg.qr(part.T)[0].T
    return rows


def correlation(a: np.ndarray, b: np.ndarray) -> float:
    """Pearson's r; not a number if one of them does not vary or there are under 3."""
    x, y = a - np.mean(a), b - np.mean(b)
    scale = np.sqrt(np.sum(x**2) * np.sum(y**2))
    return float(np.sum(x * y) / scale) if len(a) > 2 and scale > 0 else NOTHING


def overlaps(ours: np.ndarray, theirs: np.ndarray) -> np.ndarray:
    """(K, L) |u_i . v_j|: 1 where two modes are the same motion, 0 where they are perpendicular."""
    products: np.ndarray = np.abs(ours @ theirs.T)
    return products


def rmsip(a: np.ndarray, b: np.ndarray, count: int = TEN) -> float:
    """Root mean square inner product sqrt(sum_ij (u_i . v_j)^2 / K) of the first K modes of two.

    1: the same subspace, 0: perpendicular ones (Amadei, Ceruso, Di Nola, Proteins 36 (1999) 419).
    Of sets of fewer modes K is that of the smaller; not a number where one has none.
    """
    count = min(count, len(a), len(b))
    if count == 0:
        return NOTHING
    return float(np.sqrt(((a[:count] @ b[:count].T) ** 2).sum() / count))


def chance_rmsip(modes: int, atoms: int) -> float:
    """What RMSIP random subspaces have: sqrt(K / D) with D = 3n - 6 internal dimensions.

    The cumulative overlap of any direction with K random modes is on average the same.
    """
    dimensions = 3 * atoms - 6
    return float(np.sqrt(min(1.0, modes / dimensions))) if dimensions > 0 else 1.0


def covered(vectors: np.ndarray, modes: np.ndarray) -> np.ndarray:
    """(K,) cumulative overlap of each unit vector (K, 3 n) with modes: its length within them."""
    lengths: np.ndarray = np.sqrt(((vectors @ modes.T) ** 2).sum(axis=1))
    return np.asarray(np.minimum(lengths, 1.0))


def cumulative_overlap(modes: np.ndarray, displacement: np.ndarray, count: int = TEN) -> float:
    """Length of the part of a displacement (n, 3) within the first modes, as a share of all."""
    along = modes[:count] @ displacement.ravel()
    return float(np.linalg.norm(along) / np.linalg.norm(displacement))


def bootstrap(
    count: int, figure: Callable[[np.ndarray], Sequence[float]], draws: int
) -> np.ndarray:
    """Standard deviations of figures over draws of `count` things with replacement.

    Numbers are the same in every call: a figure's error depends on its data alone. Draws of which a
    figure is not a number (all of one kind were drawn) are left out of it.
    """
    random = np.random.default_rng(0)
    values = [figure(random.integers(0, count, count)) for _ in range(draws)]
    table = np.array(values, dtype=float)
    if np.isfinite(table).all():
        return np.asarray(np.std(table, axis=0))
    finite = (column[np.isfinite(column)] for column in table.T)
    return np.array([np.std(column) if len(column) > 1 else NOTHING for column in finite])


def correlation_over_residues(a: np.ndarray, b: np.ndarray, draws: int = 1000) -> Figure:
    """r of two profiles, its error over residues."""
    error = bootstrap(len(a), lambda i: [correlation(a[i], b[i])], draws)[0]
    return Figure(correlation(a, b), float(error))


def halves(
    frames: np.ndarray, draws: int = 20, fit: np.ndarray | None = None
) -> tuple[float, float]:
    """r of RMSF and RMSIP of random halves of an ensemble, means: the ceiling of both.

    Only atoms `fit` are superposed and compared. Half as many frames are less sure than all: no
    ensemble can be expected to agree better than these halves do.
    """
    random = np.random.default_rng(0)
    chosen = frames if fit is None else frames[:, fit]
    found = []
    for _ in range(draws):
        order = random.permutation(len(chosen))
        found.append(compared_halves(chosen[order[::2]], chosen[order[1::2]]))
    r, inner = np.mean(found, axis=0)
    return float(r), float(inner)


def compared_halves(one: np.ndarray, other: np.ndarray) -> tuple[float, float]:
    """r of RMSF and RMSIP of two ensembles, the second superposed on the first's mean."""
    first = superposed_on_mean(one)
    second = superposed(superposed_on_mean(other), first.mean(axis=0))
    r = correlation(fluctuations(first), fluctuations(second))
    return r, rmsip(components(first), components(second))
