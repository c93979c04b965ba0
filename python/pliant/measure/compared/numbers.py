# SPDX-License-Identifier: MIT
"""Distributions of torsions and radii of gyration; the rest is `pliant.measure.agreement`.

Coordinates are arrays (F, n, 3) in Angstrom: all frames at once, no loop over atoms.
"""

from __future__ import annotations

import numpy as np


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
