# SPDX-License-Identifier: MIT
"""Frameworks of which the cases of ``pliant lab bench stress`` are made."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from pliant.measure import bars as _bars


@dataclass
class Broken:
    """Bars and the positions from which they are to be made whole."""

    positions: np.ndarray  #: (N, 3) Angstrom
    bars: np.ndarray  #: (B, 2)
    rest_lengths: np.ndarray  #: (B,) Angstrom
    masses: np.ndarray  #: (N,) u
    pinned: np.ndarray = field(default_factory=lambda: np.empty(0, np.uint32))


def broken(
    positions: npt.ArrayLike,
    bars: npt.ArrayLike,
    rest_lengths: npt.ArrayLike | None = None,
    masses: float | np.ndarray = 1.0,
    pinned: npt.ArrayLike = (),
) -> Broken:
    """From lists; rest lengths default to the distances there are."""
    x = np.array(positions, dtype=float).reshape(-1, 3)
    pairs = np.asarray(bars, dtype=np.int64).reshape(-1, 2)
    rest = _bars.lengths(x, pairs) if rest_lengths is None else np.array(rest_lengths, float)
    return Broken(x, pairs, rest, masses * np.ones(len(x)), np.asarray(pinned, np.uint32))


def shaken(whole: Broken, size: float) -> Broken:
    """With every coordinate of joints that are not pinned off by `size` Angstrom."""
    moved = _bars.displaced(whole.positions, size, 0)
    moved[whole.pinned] = whole.positions[whole.pinned]
    whole.positions = moved
    return whole


def along(count: int) -> np.ndarray:
    """Bars from each joint to the next."""
    return np.column_stack([np.arange(count - 1), np.arange(1, count)])


def bent_chain(count: int) -> Broken:
    """A staircase of `count` joints in space."""
    return broken(np.cumsum(np.eye(3)[np.arange(count) % 3], axis=0), along(count))


def straight_chain(count: int) -> Broken:
    """A chain of unit bars along x."""
    return broken(np.column_stack([np.arange(count), np.zeros((count, 2))]), along(count))


def ring(count: int) -> Broken:
    """A regular polygon of unit sides."""
    angle = 2 * np.pi * np.arange(count) / count
    radius = 0.5 / np.sin(np.pi / count)
    x = radius * np.column_stack([np.cos(angle), np.sin(angle), np.zeros(count)])
    joints = np.arange(count)
    return broken(x, np.column_stack([joints, (joints + 1) % count]), np.ones(count))


def complete(count: int) -> Broken:
    """Joints at random places in a cube, each joined to each; 3 n - 6 bars are independent."""
    x = np.random.Generator(np.random.PCG64(0)).random((count, 3)) * count ** (1 / 3)
    return broken(x, np.column_stack(np.triu_indices(count, 1)))


def star(leaves: int) -> Broken:
    """Leaves a unit away from joint 0, spread by the golden angle."""
    k = np.arange(leaves) + 0.5
    polar, around = np.arccos(1 - 2 * k / leaves), np.pi * (1 + 5**0.5) * k
    x = np.column_stack(
        [np.cos(around) * np.sin(polar), np.sin(around) * np.sin(polar), np.cos(polar)]
    )
    bars = np.column_stack([np.zeros(leaves, int), np.arange(1, leaves + 1)])
    return broken(np.concatenate([[[0.0, 0, 0]], x]), bars, np.ones(leaves))


def dodecahedron() -> Broken:
    """20 vertices, 30 edges."""
    golden = (1 + 5**0.5) / 2
    signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, -1).T
    pairs = np.array(np.meshgrid([-1, 1], [-1, 1])).reshape(2, -1).T
    rows = [np.column_stack([np.zeros(4), pairs[:, 0] / golden, pairs[:, 1] * golden])]
    rows += [np.roll(rows[0], 1, axis=1), np.roll(rows[0], 2, axis=1)]
    x = np.concatenate([signs, *rows])
    apart = np.linalg.norm(x[:, None] - x[None], axis=2)
    return broken(x, np.argwhere(np.triu(np.isclose(apart, 2 / golden))))


def random_chain(count: int) -> Broken:
    """Unit bars of random directions: OpenMM, tests/TestVerletIntegrator.h."""
    steps = np.random.Generator(np.random.PCG64(0)).normal(size=(count, 3))
    steps /= np.linalg.norm(steps, axis=1, keepdims=True)
    return broken(np.cumsum(steps, axis=0), along(count))


def diamond() -> Broken:
    """OpenMM's issue 3603: four beads of Martini's cholesterol, five bars."""
    x = 10 * np.array(
        [[5.566, 7.728, 3.213], [5.494, 7.973, 3.631], [5.354, 7.788, 3.773], [5.295, 7.811, 4.307]]
    )
    bars = [[0, 1], [0, 2], [1, 2], [3, 1], [3, 2]]
    return broken(x, bars, 10 * np.array([0.4904, 0.6019, 0.2719, 0.7237, 0.5376]), 50.0)
