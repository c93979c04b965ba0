# SPDX-License-Identifier: MIT
"""How two ensembles of one molecule are compared: fits, fluctuations, modes, distributions.

Coordinates are arrays (F, n, 3) in Angstrom: all frames at once, no loop over atoms.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

MOST_ITERATIONS = 50
LEAST_VARIANCE = 1e-12  #: Angstrom^2; less is the rounding of 32-bit coordinates
SETTLED = 1e-7  #: Angstrom, RMS change of an average structure that counts as none


def superposed(positions: np.ndarray, reference: np.ndarray, fit: np.ndarray) -> np.ndarray:
    """Each frame moved rigidly so that its atoms `fit` lie on those of reference (n, 3).

    Least squares over proper rotations (Kabsch, Acta Cryst. A 32 (1976) 922), for all frames at
    once by one stack of 3 x 3 singular value decompositions. The fitted atoms end up centred at 0.
    """
    centred = positions - positions[:, fit].mean(axis=1, keepdims=True)
    target = reference[fit] - reference[fit].mean(axis=0)
    u, _, vt = np.linalg.svd(np.einsum("fni,nj->fij", centred[:, fit], target))
    u[:, :, 2] *= np.sign(np.linalg.det(u) * np.linalg.det(vt))[:, None]
    turned: np.ndarray = centred @ (u @ vt)
    return turned


def superposed_on_mean(positions: np.ndarray, fit: np.ndarray) -> np.ndarray:
    """Each frame superposed on the average of all, which is found by iteration."""
    fitted = superposed(positions, positions[0], fit)
    for _ in range(MOST_ITERATIONS):
        mean = fitted.mean(axis=0)
        fitted = superposed(positions, mean, fit)
        if np.sqrt(np.mean((fitted.mean(axis=0) - mean)[fit] ** 2)) < SETTLED:
            break
    return fitted


def fluctuations(fitted: np.ndarray) -> np.ndarray:
    """(n,) RMSF: root of the mean squared distance of each atom from its average place."""
    deviation = fitted - fitted.mean(axis=0)
    rmsf: np.ndarray = np.sqrt(np.einsum("fni,fni->n", deviation, deviation) / len(fitted))
    return rmsf


def pearson(a: np.ndarray, b: np.ndarray) -> float:
    """Correlation coefficient; not a number if one of them does not vary or there are under 3."""
    x, y = a - np.mean(a), b - np.mean(b)
    scale = np.sqrt(np.sum(x**2) * np.sum(y**2))
    return float(np.sum(x * y) / scale) if len(a) > 2 and scale > 0 else float("nan")


@dataclass
class Modes:
    """Principal components of an ensemble, largest variance first."""

    vectors: np.ndarray  #: (K, 3n) unit vectors
    variances: np.ndarray  #: (K,) Angstrom^2
    total: float  #: variance of all components, Angstrom^2

    @property
    def share(self) -> float:
        """Of the total variance, what these components explain."""
        return float(self.variances.sum() / self.total) if self.total > 0 else 0.0


def principal_modes(fitted: np.ndarray, most: int) -> Modes:
    """The first `most` principal components that have variance, of superposed frames (F, n, 3)."""
    table = (fitted - fitted.mean(axis=0)).reshape(len(fitted), -1)
    _, singular, vectors = np.linalg.svd(table, full_matrices=False)
    variances = singular**2 / max(len(fitted) - 1, 1)
    with_variance = variances > max(LEAST_VARIANCE, 1e-12 * variances.max(initial=0.0))
    kept = min(most, int(with_variance.sum()))
    return Modes(vectors[:kept], variances[:kept], float(variances.sum()))


def overlaps(ours: Modes, theirs: Modes) -> np.ndarray:
    """(K, L) |u_i . v_j|: 1 where two modes are the same motion, 0 where they are perpendicular."""
    products: np.ndarray = np.abs(ours.vectors @ theirs.vectors.T)
    return products


def rmsip(ours: Modes, theirs: Modes) -> float:
    """Root mean square inner product sqrt(sum_ij (u_i . v_j)^2 / K) of two sets of K modes.

    1: the same subspace, 0: perpendicular ones (Amadei, Ceruso, Di Nola, Proteins 36 (1999) 419).
    Of sets of different size the first modes of the larger are taken.
    """
    count = min(len(ours.vectors), len(theirs.vectors))
    if count == 0:
        return float("nan")
    product = ours.vectors[:count] @ theirs.vectors[:count].T
    return float(np.sqrt(np.sum(product**2) / count))


def chance_rmsip(modes: int, atoms: int) -> float:
    """What RMSIP random subspaces have: sqrt(K / D) with D = 3n - 6 internal dimensions."""
    dimensions = 3 * atoms - 6
    return float(np.sqrt(min(1.0, modes / dimensions))) if dimensions > 0 else 1.0


def dihedrals(positions: np.ndarray, quadruples: np.ndarray) -> np.ndarray:
    """(F, T) torsion angles of quadruples (T, 4), degrees in (-180, 180], IUPAC's sign."""
    a, b, c, d = (positions[:, quadruples[:, k]] for k in range(4))
    first, axis, last = b - a, c - b, d - c
    normal, other = np.cross(first, axis), np.cross(axis, last)
    length = np.linalg.norm(axis, axis=-1)
    sine = np.einsum("fti,fti->ft", first, other) * length
    cosine = np.einsum("fti,fti->ft", normal, other)
    angles: np.ndarray = np.degrees(np.arctan2(sine, cosine))
    return angles


def shares(angles: np.ndarray, bins: int) -> np.ndarray:
    """(T, bins) share of the frames (F, T) in each bin of the whole turn, from -180 degrees."""
    place = np.floor((angles + 180.0) / (360.0 / bins)).astype(int) % bins
    return np.array([np.bincount(column, minlength=bins) for column in place.T]).reshape(
        -1, bins
    ) / max(len(angles), 1)


def jensen_shannon(p: np.ndarray, q: np.ndarray) -> np.ndarray:
    """Jensen-Shannon distance of distributions (..., bins): 0 if the same, 1 if nowhere both.

    Square root of the divergence in bits (Endres and Schindelin, IEEE Trans. Inf. Theory 49 (2003)
    1858), a metric.
    """
    middle = (p + q) / 2

    def entropy(x: np.ndarray) -> np.ndarray:
        logarithm = np.log2(x, out=np.zeros_like(x), where=x > 0)
        bits: np.ndarray = -np.sum(x * logarithm, axis=-1)
        return bits

    distance: np.ndarray = np.sqrt(np.maximum(entropy(middle) - (entropy(p) + entropy(q)) / 2, 0.0))
    return distance


def gyration_radii(positions: np.ndarray, masses: np.ndarray) -> np.ndarray:
    """(F,) mass-weighted radii of gyration, Angstrom."""
    share = masses / masses.sum()
    centre = np.einsum("n,fni->fi", share, positions)
    apart = positions - centre[:, None]
    radii: np.ndarray = np.sqrt(np.einsum("n,fni,fni->f", share, apart, apart))
    return radii
