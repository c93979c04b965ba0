# SPDX-License-Identifier: MIT
"""One sweep near whole bars as a matrix that acts on the length errors of the bars.

Projecting bar k moves its ends along the bar by its error times their shares. To first order that
changes the error of each bar j that shares a joint with k by A_jk times the error of k, where
A = R S, R the rigidity matrix (rows: how a bar's length answers to moves of the joints) and S the
moves (columns: how the joints answer to a bar's error). A sweep over bars k1, k2, ... is

    M = ... (1 + A e_k2 e_k2^T) (1 + A e_k1 e_k1^T)

With shares half and half A is symmetric and a sweep is Gauss-Seidel on J J^T, whose spectral radius
is below 1 wherever the bars are independent. With other shares A is not symmetric.
"""

from __future__ import annotations

import numpy as np

import pliant


def sweep_matrix(
    framework: pliant.Framework,
    positions: np.ndarray,
    root: int,
    weighting: float,
    ordering: str = "bfs_cycle",
) -> np.ndarray:
    """(B, B) matrix of one sweep at `positions`, for joints of equal shares and none pinned."""
    bars = framework.bars.astype(int)
    order, near, is_tree = pliant.order(framework, ordering, root)
    delta = positions[bars[:, 1]] - positions[bars[:, 0]]
    unit = delta / np.linalg.norm(delta, axis=1)[:, None]
    rigidity = _rigidity(bars, unit, len(positions))
    matrix = np.eye(len(bars))
    for k, start, tree in zip(order.astype(int), near.astype(int), is_tree, strict=True):
        a, b = bars[k]
        far_share = weighting if tree else 0.5
        share_a, share_b = (1 - far_share, far_share) if start == a else (far_share, 1 - far_share)
        column = (rigidity[:, a] * share_a - rigidity[:, b] * share_b) @ unit[k]
        matrix += np.outer(column, matrix[k])
    return matrix


def _rigidity(bars: np.ndarray, unit: np.ndarray, joints: int) -> np.ndarray:
    """(B, N, 3): d length / d position of each joint."""
    rows = np.zeros((len(bars), joints, 3))
    here = np.arange(len(bars))
    rows[here, bars[:, 0]] -= unit
    rows[here, bars[:, 1]] += unit
    return rows


def spectral_radius(matrix: np.ndarray) -> float:
    """Largest absolute eigenvalue: the factor by which errors shrink (or grow) a sweep at last."""
    return float(np.max(np.abs(np.linalg.eigvals(matrix)))) if matrix.size else 0.0


def closing_rate(framework: pliant.Framework, positions: np.ndarray, root: int) -> float | None:
    """(cos^2 a + cos^2 b) / 2 at the closing bar of a framework with one cycle, weighting 1.

    a and b are the angles between that bar and the tree bars by which its two ends were reached. At
    weighting 1 a forward sweep leaves only the two bars beside the closing bar broken, by half its
    error times cos a and cos b; mending them moves the ends back, by cos a and cos b again. None if
    an end of the bar is the root: then only the other angle counts.
    """
    order, near, is_tree = pliant.order(framework, "bfs_cycle", root)
    bars = framework.bars.astype(int)
    (closing,) = order[~is_tree].astype(int)
    parents = {
        _other(bars[k], n): int(n) for k, n, tree in zip(order, near, is_tree, strict=True) if tree
    }
    total = 0.0
    for end, other in (bars[closing], bars[closing][::-1]):
        if end not in parents:
            return None
        towards, along = positions[parents[end]] - positions[end], positions[other] - positions[end]
        cosine = towards @ along / np.linalg.norm(towards) / np.linalg.norm(along)
        total += 0.5 * float(cosine) ** 2
    return total


def _other(bar: np.ndarray, joint: int) -> int:
    return int(bar[1] if bar[0] == joint else bar[0])
