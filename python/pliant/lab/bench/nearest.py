# SPDX-License-Identifier: MIT
"""The nearest positions at which all bars are whole: what every repair is held against.

    minimise sum_i m_i |x_i - y_i|^2   such that   |x_b - x_a| = L of every bar

by steps that solve the problem linearised at x: with J the bars' directions (B x 3N), C their
length errors and W = 1 / m, (J W J^T) lambda = J (y - x) + C and x <- y - W J^T lambda. What is
left out, the bars' curvature, makes each step's error about |y - x| / L of the one before. Nothing
of the library's own solvers is used, so that it can judge them.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import csr_matrix, diags_array
from scipy.sparse.linalg import splu

from pliant.lab.bench.target import Target

MOST_STEPS = 100
WHOLE = 1e-12  #: largest relative residual of what counts as whole
AT_REST = 1e-10  #: Angstrom; an x that moves less has arrived


def nearest_whole(
    target: Target, broken: np.ndarray, masses: np.ndarray | None = None
) -> np.ndarray | None:
    """(N, 3) Angstrom; `masses` (N,) weigh the distance, if given. None if steps lead nowhere."""
    weights = diags_array(np.repeat(1.0 / (np.ones(len(broken)) if masses is None else masses), 3))

    x: np.ndarray = broken.copy()
    for _ in range(MOST_STEPS):
        jacobian, error = _linearised(target, x)
        gram = (jacobian @ weights @ jacobian.T).tocsc()
        try:
            factor = splu(gram, permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
        except RuntimeError:  # exactly singular
            return None
        multipliers = factor.solve(jacobian @ (broken - x).ravel() + error)
        after = broken - (weights @ (jacobian.T @ multipliers)).reshape(-1, 3)
        move = np.abs(after - x).max()
        if not np.isfinite(move):
            return None
        x = after
        if move < AT_REST and target.residual(x) < WHOLE:
            return x
    return None


def _linearised(target: Target, x: np.ndarray) -> tuple[csr_matrix, np.ndarray]:
    bars = target.bars
    along = x[bars[:, 1]] - x[bars[:, 0]]
    length = np.linalg.norm(along, axis=1)
    unit = along / length[:, None]
    rows = np.repeat(np.arange(len(bars)), 6)
    columns = (3 * bars[:, :, None] + np.arange(3)).reshape(-1)
    values = np.concatenate([-unit, unit], axis=1).reshape(-1)
    shape = (len(bars), x.size)
    return csr_matrix((values, (rows, columns)), shape), length - target.rest_lengths
