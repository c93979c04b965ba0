# SPDX-License-Identifier: MIT
"""How nearly all bars can be whole at once: least squares of relative residuals, by scipy."""

from __future__ import annotations

import numpy as np

from pliant.lab.bench.stress_cases import Broken
from pliant.measure import bars as _bars

MOST_BARS = 200  #: with more, it takes too long
STARTS = 4
GOOD_ENOUGH = 1e-10  #: rms; nobody needs to look further


def least_squares_floor(start: Broken) -> np.ndarray | None:
    """(N, 3) positions about the origin at the lowest of a few local minima.

    None if lengths are out of range. Not bound by the rounding of coordinates far away.
    A floor above zero is what these few starts found, not a proof that there is nothing lower.
    """
    from scipy.optimize import least_squares

    if not 1e-8 < start.rest_lengths.min() <= start.rest_lengths.max() < 1e8:
        return None
    free = np.setdiff1d(np.arange(len(start.positions)), start.pinned)
    near = start.positions - start.positions.mean(axis=0)  # where doubles are close together
    best: np.ndarray = near
    lowest = np.inf
    for k in range(STARTS):
        x = near.copy()
        x[free] += _jitter(start, len(free), k)

        def residuals(values: np.ndarray, x: np.ndarray = x) -> np.ndarray:
            x[free] = values.reshape(-1, 3)
            errors: np.ndarray = _bars.lengths(x, start.bars) / start.rest_lengths - 1.0
            return errors

        def slopes(values: np.ndarray, x: np.ndarray = x) -> np.ndarray:
            x[free] = values.reshape(-1, 3)
            return _slopes(start, x)[:, free].reshape(len(start.bars), -1)

        found = least_squares(
            residuals, x[free].ravel(), slopes, xtol=1e-15, ftol=1e-15, gtol=1e-15, max_nfev=200
        )
        rms = float(np.sqrt(np.mean(residuals(found.x) ** 2)))
        if rms < lowest:
            lowest, best = rms, x.copy()
        if lowest < GOOD_ENOUGH:
            break
    return best


def _jitter(start: Broken, count: int, seed: int) -> np.ndarray:
    size = (0.01, 0.1, 0.5, 1.0)[seed] * float(np.median(start.rest_lengths))
    return np.random.Generator(np.random.PCG64(seed)).normal(scale=size, size=(count, 3))


def _slopes(start: Broken, x: np.ndarray) -> np.ndarray:
    """(B, N, 3) how each relative residual changes with each coordinate."""
    a, b = start.bars.T
    along = x[b] - x[a]
    length = np.linalg.norm(along, axis=1)
    unit = along / np.maximum(length * start.rest_lengths, 1e-300)[:, None]
    slopes = np.zeros((len(a), len(x), 3))
    rows = np.arange(len(a))
    slopes[rows, a] = -unit
    slopes[rows, b] = unit
    return slopes
