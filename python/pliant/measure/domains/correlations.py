# SPDX-License-Identifier: MIT
"""Which sites of a molecule move together, pair by pair."""

from __future__ import annotations

import numpy as np

#: sites whose directions to all others are in memory at once
_ROWS = 64


def correlations(positions: np.ndarray) -> np.ndarray:
    """Correlation matrix (n, n) of displacements: <d_i . d_j> / sqrt(<d_i^2> <d_j^2>).

    positions: (F, n, 3) superposed. 1: along with each other, -1: against each other, 0: neither
    (or at right angles, which this measure cannot tell apart; T. Ichiye, M. Karplus, Proteins 11
    (1991) 205). What does not move correlates with nothing.
    """
    table = positions - positions.mean(axis=0)
    flat = table.transpose(1, 0, 2).reshape(table.shape[1], -1)
    matrix: np.ndarray = flat @ flat.T
    spread = np.sqrt(np.diag(matrix))
    for row, own in zip(matrix, spread, strict=True):  # in place: there may be a million pairs
        scale = own * spread
        row[:] = np.divide(row, scale, out=np.zeros_like(row), where=scale > 0)
    return np.clip(matrix, -1.0, 1.0, out=matrix)


def distance_fluctuations(positions: np.ndarray) -> np.ndarray:
    """(n, n) r.m.s. change of the distance of each two sites, to first order, Angstrom.

    sigma_ij^2 = n_ij . <(d_i - d_j)(d_i - d_j)^T> n_ij with n_ij along the mean distance.
    """
    average = positions.mean(axis=0)
    frames = len(positions)
    table = (positions - average).reshape(frames, -1)
    sites = positions.shape[1]
    shifts = table.reshape(frames, sites, 3)
    own = np.einsum("fia,fib->iab", shifts, shifts) / frames
    ends, cross = np.empty((sites, sites)), np.empty((sites, sites))
    for rows in np.array_split(np.arange(sites), -(-sites // _ROWS)):
        some = slice(rows[0], rows[-1] + 1)
        apart = average[some, None] - average[None]
        length = np.linalg.norm(apart, axis=2)
        along = apart / np.where(length > 0, length, 1.0)[:, :, None]
        ends[some] = np.einsum("ija,iab,ijb->ij", along, own[some], along, optimize=True)
        rows3 = slice(3 * some.start, 3 * some.stop)  # the whole covariance has 9 numbers a pair
        covariance = (table[:, rows3].T @ table / frames).reshape(len(rows), 3, sites, 3)
        cross[some] = np.einsum("ija,iajb,ijb->ij", along, covariance, along, optimize=True)
    return np.asarray(np.sqrt(np.maximum(ends + ends.T - cross - cross.T, 0.0)))
