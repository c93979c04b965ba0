# SPDX-License-Identifier: MIT
"""Pockets of many frames on a grid, found and measured by all processors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pliant import _core

SPACING: float = _core.POCKET_STEP  #: of the grid, Angstrom

#: Angstrom (A. Bondi, J. Phys. Chem. 68 (1964) 441); others: that of carbon
RADII = {"C": 1.70, "N": 1.55, "O": 1.52, "S": 1.80, "P": 1.80}


@dataclass(frozen=True)
class Pockets:
    """The room of all pockets of a frame, point by point of a grid."""

    pocket: np.ndarray  #: (v,) the pocket of each point, from 0 by size
    atom: np.ndarray  #: (v,) the atom nearest to each point

    volume = SPACING**3  #: that each point stands for, Angstrom^3

    @property
    def count(self) -> int:
        """How many pockets there are."""
        return int(self.pocket.max(initial=-1)) + 1

    def size(self, pocket: int) -> float:
        """Its room, Angstrom^3."""
        return self.volume * np.count_nonzero(self.pocket == pocket)

    def lining(self, pocket: int) -> np.ndarray:
        """The atoms that are nearest to its points."""
        return np.unique(self.atom[self.pocket == pocket])


@dataclass(frozen=True)
class Room:
    """Room within a convex hull, and how much of it is a pocket, Angstrom^3."""

    all: float
    enclosed: float  #: where atoms are around

    @property
    def share(self) -> float:
        """Of the room that is enclosed; 1 where there is none."""
        return self.enclosed / self.all if self.all else 1.0


def find_pockets(frames: np.ndarray, radii: np.ndarray) -> list[Pockets]:
    """Pockets between atoms (F, n, 3) of radii (n,), Angstrom, of each frame.

    Where there is room for a small probe, out of reach of a large one from outside.
    """
    return [Pockets(*one) for one in _core.find_pockets(frames, radii)]


def rooms_among(
    frames: np.ndarray,
    radii: np.ndarray,
    linings: Sequence[np.ndarray],
    spacing: float = SPACING,
    offset: float = 0.0,
) -> list[list[Room]]:
    """Room within the hull of the atoms of each lining (indices): a list for each frame.

    frames (F, n, 3), radii (n,): all atoms, Angstrom. The grid lies `offset` steps further along
    x, y and z.
    """
    found = _core.rooms_among(frames, radii, linings, spacing, offset)
    rooms = [Room(*row) for row in found.tolist()]
    return [rooms[k : k + len(linings)] for k in range(0, len(rooms), max(1, len(linings)))]
