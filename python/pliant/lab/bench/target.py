# SPDX-License-Identifier: MIT
"""What is broken and repaired in a benchmark: a framework, and positions in which it is whole."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np

import pliant
from pliant.measure import bars as _bars


@dataclass
class Target:
    """A framework with every joint free, and its bars as arrays."""

    name: str
    framework: pliant.Framework
    positions: np.ndarray  #: (N, 3) Angstrom, whole
    bars: np.ndarray  #: (B, 2)
    rest_lengths: np.ndarray  #: (B,) Angstrom
    masses: np.ndarray  #: (N,) u

    def broken(self, displacement: float, seed: int) -> np.ndarray:
        """A copy, each coordinate off by a normal deviate of that standard deviation, Angstrom."""
        return _bars.displaced(self.positions, displacement, seed)

    def residual(self, positions: np.ndarray) -> float:
        """Largest |length - rest| / rest, measured here in double precision."""
        return _bars.worst_residual(positions, self.bars, self.rest_lengths)


def target_of(
    framework: pliant.Framework, positions: np.ndarray, masses: np.ndarray, name: str
) -> Target:
    """A target from its parts; arrays are copies."""
    return Target(
        name,
        framework,
        np.array(positions, dtype=float),
        np.array(framework.bars, dtype=np.int64).reshape(-1, 2),
        np.array(framework.rest_lengths, dtype=float),
        np.array(masses, dtype=float),
    )


def read_target(path: str | os.PathLike[str], bars: str = "bonds") -> Target:
    """The molecule of a file. Raises InputError if it gives no bar."""
    structure = pliant.read(path)
    framework = structure.framework(bars)
    if framework.bar_count == 0:
        raise pliant.InputError(f"{os.fspath(path)}: the framework has no bar")
    name = os.path.basename(os.fspath(path))
    return target_of(framework, structure.positions, structure.masses, name)
