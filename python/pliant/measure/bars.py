# SPDX-License-Identifier: MIT
"""Bars measured: lengths, residuals, energies; broken copies; triangles and pairs of bars.

Besides ours, OpenMM is measured with it: what SETTLE may move, which angles CCMA asks for.
"""

from __future__ import annotations

import numpy as np

FLOAT_ROUNDING = 2.0**-24  #: OpenMM's SETTLE keeps its two distances as 32-bit floats


def lengths(positions: np.ndarray, bars: np.ndarray) -> np.ndarray:
    """(..., B) lengths of the bars (B, 2) at positions (..., N, 3)."""
    between = positions[..., bars[:, 1], :] - positions[..., bars[:, 0], :]
    found: np.ndarray = np.sqrt(np.einsum("...i,...i->...", between, between))
    return found


def relative_residuals(
    positions: np.ndarray, bars: np.ndarray, rest_lengths: np.ndarray
) -> np.ndarray:
    """(..., B) |length - rest| / rest."""
    residuals: np.ndarray = np.abs(lengths(positions, bars) - rest_lengths) / rest_lengths
    return residuals


def worst_residual(positions: np.ndarray, bars: np.ndarray, rest_lengths: np.ndarray) -> float:
    """Largest |length - rest| / rest; not a number if a length is none; 0 without bars."""
    if len(bars) == 0:
        return 0.0
    with np.errstate(over="ignore", invalid="ignore"):
        return float(np.max(relative_residuals(positions, bars, rest_lengths)))


def furthest_move(after: np.ndarray, before: np.ndarray) -> float:
    """Largest distance that an atom moved; not a number if a coordinate is none."""
    with np.errstate(over="ignore", invalid="ignore"):
        return float(np.max(np.linalg.norm(after - before, axis=-1), initial=0.0))


def harmonic_energy(
    positions: np.ndarray, bars: np.ndarray, rest_lengths: np.ndarray, constants: np.ndarray
) -> tuple[float, float]:
    """Energy sum k/2 (r - d)^2 of the bars, and how much of it rounding may change.

    A length r is known to about 4 units in its last place, u = 4 * 2^-53 r, so that k/2 (r - d)^2
    is known to k |r - d| u + k/2 u^2, whoever computes it.
    """
    r = lengths(positions, bars)
    stretch = r - rest_lengths
    unit = 4.0 * 2.0**-53 * r
    energy = float(np.sum(0.5 * constants * stretch**2))
    rounding = float(np.sum(constants * (np.abs(stretch) * unit + 0.5 * unit**2)))
    return energy, rounding


def displaced(positions: np.ndarray, size: float, seed: int) -> np.ndarray:
    """A copy in which each coordinate is off by a normal deviate of standard deviation `size`."""
    draw = np.random.Generator(np.random.PCG64(seed))
    return positions + draw.normal(scale=size, size=positions.shape)


def stretched(
    positions: np.ndarray, bars: np.ndarray, rest_lengths: np.ndarray, bar: int, by: float
) -> np.ndarray:
    """A copy in which one joint was moved along one bar, which is now too long by `by` (relative).

    The smallest break there is: whoever does not notice it does not look at this bar.
    """
    near, far = bars[bar]
    along = positions[far] - positions[near]
    copy: np.ndarray = positions.copy()
    copy[far] = positions[near] + along * (rest_lengths[bar] * (1 + by) / np.linalg.norm(along))
    return copy


def isolated_triangles(bars: np.ndarray, joint_count: int) -> np.ndarray:
    """(T, 3) joints of the triangles of bars that no other bar touches, such as rigid water."""
    near = np.concatenate([bars[:, 0], bars[:, 1]])
    far = np.concatenate([bars[:, 1], bars[:, 0]])
    sequence = np.argsort(near, kind="stable")
    degree = np.bincount(near, minlength=joint_count)
    first = np.concatenate([[0], np.cumsum(degree)])[:-1]
    pairs = np.flatnonzero(degree == 2)
    if len(pairs) == 0:
        return np.empty((0, 3), np.int64)
    others = far[sequence[first[pairs][:, None] + np.arange(2)]]
    closed = np.sort(np.column_stack([pairs, others]), axis=1)
    triangles, count = np.unique(closed, axis=0, return_counts=True)
    isolated: np.ndarray = triangles[count == 3]
    return isolated


def bars_of_triangles(triangles: np.ndarray, bars: np.ndarray, joint_count: int) -> np.ndarray:
    """(T, 3) the bars opposite to nothing in particular: those of joints 01, 02, 12 of each."""
    keys = np.min(bars, axis=1) * joint_count + np.max(bars, axis=1)
    sequence = np.argsort(keys)
    wanted = triangles[:, [0, 0, 1]] * joint_count + triangles[:, [1, 2, 2]]
    found: np.ndarray = sequence[np.searchsorted(keys[sequence], wanted)]
    return found


def settle_bound(
    positions: np.ndarray,
    bars: np.ndarray,
    rest_lengths: np.ndarray,
    masses: np.ndarray,
    tolerance: np.ndarray,
) -> float:
    """How far SETTLE may move an atom of a frame whose bars are within `tolerance` (B,), Angstrom.

    SETTLE (Miyamoto and Kollman, J. Comput. Chem. 13 (1992) 952) solves isolated triangles afresh,
    whole or not, for distances that OpenMM keeps as 32-bit floats. To first order the move is
    M^-1 R^T (R M^-1 R^T)^-1 e with the rigidity matrix R of the triangle and bar errors e, of
    which each is at most (tolerance + 2^-24) rest; a tenth is added for what is of second order.
    0 if there is no such triangle.
    """
    triangles = isolated_triangles(bars, len(masses))
    if len(triangles) == 0:
        return 0.0
    own = bars_of_triangles(triangles, bars, len(masses))
    errors = (tolerance[own] + FLOAT_ROUNDING) * rest_lengths[own]
    response = _triangle_response(positions[triangles], masses[triangles])
    move = np.einsum("tcb,tb->tc", np.abs(response), errors).reshape(-1, 3, 3)
    return 1.1 * float(np.max(np.linalg.norm(move, axis=2)))


def _triangle_response(corners: np.ndarray, masses: np.ndarray) -> np.ndarray:
    """(T, 9, 3) M^-1 R^T (R M^-1 R^T)^-1 of triangles with corners (T, 3, 3)."""
    rigidity = np.zeros((len(corners), 3, 9))
    for row, (i, j) in enumerate([(0, 1), (0, 2), (1, 2)]):
        along = corners[:, j] - corners[:, i]
        along = along / np.linalg.norm(along, axis=1, keepdims=True)
        rigidity[:, row, 3 * i : 3 * i + 3] = -along
        rigidity[:, row, 3 * j : 3 * j + 3] = along
    mobility = np.repeat(1.0 / masses, 3, axis=1)[:, :, None] * rigidity.transpose(0, 2, 1)
    gram = rigidity @ mobility
    flat = np.linalg.cond(gram) > 1e12
    gram[flat] = np.eye(3)
    response: np.ndarray = mobility @ np.linalg.inv(gram)
    response[flat] = np.inf
    return response


def bar_pairs(bars: np.ndarray, joint_count: int) -> np.ndarray:
    """(A, 3) joints i, j, k for each two bars j-i and j-k that share a joint j."""
    near = np.concatenate([bars[:, 0], bars[:, 1]])
    far = np.concatenate([bars[:, 1], bars[:, 0]])[np.argsort(near, kind="stable")]
    degree = np.bincount(near, minlength=joint_count)
    first = np.concatenate([[0], np.cumsum(degree)])[:-1]
    found = [np.empty((0, 3), np.int64)]
    for d in np.unique(degree[degree > 1]):
        joints = np.flatnonzero(degree == d)
        around = far[first[joints][:, None] + np.arange(d)]
        p, q = np.triu_indices(d, 1)
        middle = np.broadcast_to(joints[:, None], (len(joints), len(p)))
        found.append(np.stack([around[:, p], middle, around[:, q]], axis=-1).reshape(-1, 3))
    return np.concatenate(found)


def angles_between(positions: np.ndarray, triples: np.ndarray) -> np.ndarray:
    """(A,) angles at the middle joints of triples (A, 3), radians."""
    u = positions[triples[:, 0]] - positions[triples[:, 1]]
    v = positions[triples[:, 2]] - positions[triples[:, 1]]
    across = np.linalg.norm(np.cross(u, v), axis=1)
    angles: np.ndarray = np.arctan2(across, np.einsum("ij,ij->i", u, v))
    return angles
