# SPDX-License-Identifier: MIT
"""Protein-like frameworks and zigzag chains of any size, made without a loop over joints.

Residues lie along a snake through a cube, so that coordinates stay small: a million joints reach
150 Angstrom, not 1.5 million, and rounding stays below every tolerance.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np


class Large(NamedTuple):
    """A framework in its whole positions."""

    positions: np.ndarray  #: (N, 3) Angstrom
    bars: np.ndarray  #: (B, 2)


RESIDUE_SPACING = 8.0
ZIGZAG_LENGTH, ZIGZAG_ANGLE = 1.53, 112.0  #: Angstrom, degrees


def snake(count: int) -> np.ndarray:
    """(count, 3) whole numbers, each a unit step from the one before, filling a cube."""
    side = max(1, math.ceil(count ** (1 / 3)))
    index = np.arange(count)
    row, plane = index // side, index // side**2
    x, y = index % side, row % side
    x = np.where(row % 2 == 0, x, side - 1 - x)
    y = np.where(plane % 2 == 0, y, side - 1 - y)
    return np.column_stack([x, y, plane]).astype(float)


# Stylised residues: N, H, CA, HA, C, O, CB and two hydrogens on it; then a hydrogen (alanine) or a
# six-membered ring with five hydrogens (phenylalanine). Angstrom; bars as pairs of atoms.
_BACKBONE = (
    (0.0, 0.0, 0.0), (-0.4, 0.9, 0.0), (1.4, -0.4, 0.0), (1.5, -1.1, 0.8), (2.4, 0.7, 0.0),
    (2.2, 1.9, 0.0), (1.7, -1.2, -1.3), (1.0, -2.0, -1.3), (2.7, -1.6, -1.2),
)  # fmt: skip  # some points a line
_BACKBONE_BARS = ((0, 1), (0, 2), (2, 3), (2, 4), (4, 5), (2, 6), (6, 7), (6, 8))


def _alanine() -> Large:
    atoms = [*_BACKBONE, (1.6, -0.6, -2.2)]
    return Large(np.array(atoms), np.array([*_BACKBONE_BARS, (6, 9)]))


def _phenylalanine() -> Large:
    angle = np.arange(6) * np.pi / 3
    around = np.column_stack([np.cos(angle), np.zeros(6), -np.sin(angle)])
    centre = np.array([1.7 + 1.39, -0.4, -2.6])
    ring, hydrogens = centre - 1.39 * around, centre - 2.47 * around[1:]
    atoms = np.concatenate([np.array(_BACKBONE), ring, hydrogens])
    closed = [(9 + k, 9 + (k + 1) % 6) for k in range(6)]
    spokes = [(9 + k, 14 + k) for k in range(1, 6)]
    return Large(atoms, np.array([*_BACKBONE_BARS, (6, 9), *closed, *spokes]))


def protein(count: int, seed: int = 0) -> Large:
    """Of about `count` joints: four alanines and a phenylalanine, again and again.

    The topology of a protein with its hydrogens: chains, branches, a ring in each fifth residue.
    Bars between residues are as long as the snake of residues makes them.
    """
    residues = [_alanine()] * 4 + [_phenylalanine()]
    first = np.cumsum([0, *(len(r.positions) for r in residues)])
    repeats = max(1, round(count / first[-1]))
    origins = RESIDUE_SPACING * snake(5 * repeats).reshape(repeats, 5, 1, 3)
    positions = np.concatenate(
        [r.positions + origins[:, k] for k, r in enumerate(residues)], axis=1
    ).reshape(-1, 3)
    own = np.concatenate([r.bars + first[k] for k, r in enumerate(residues)])
    links = np.column_stack([first[:5] + 4, first[1:]])  # C to the next N
    shift = first[-1] * np.arange(repeats)[:, None, None]
    bars = (np.concatenate([own, links]) + shift).reshape(-1, 2)
    whole = bars[bars.max(axis=1) < len(positions)]  # the last C has no next N
    draw = np.random.Generator(np.random.PCG64(seed))
    return Large(positions + draw.normal(scale=0.15, size=positions.shape), whole)


def zigzag(count: int) -> Large:
    """A planar zigzag chain, as of carbon atoms: under angles the hardest of all chains."""
    joints = np.arange(count)
    half = math.radians(0.5 * ZIGZAG_ANGLE)
    x, y = ZIGZAG_LENGTH * math.sin(half) * joints, ZIGZAG_LENGTH * math.cos(half) * (joints % 2)
    positions = np.column_stack([x - x.mean(), y, np.zeros(count)])
    return Large(positions, np.column_stack([joints[:-1], joints[1:]]))
