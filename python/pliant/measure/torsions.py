# SPDX-License-Identifier: MIT
"""Torsion (dihedral) angles of the rotatable bonds and how they are distributed."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt
from MDAnalysis.lib.distances import calc_dihedrals

from pliant.measure.frames import FrameAnalysis, Merge, joined
from pliant.measure.rotatable import rotatable_torsions

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.rotatable import Torsion


class TorsionDistributions(FrameAnalysis):
    """Angles of torsions frame by frame, their histograms, circular means and spreads.

    Angles follow IUPAC: 0 is cis, positive is clockwise when looking along the bond.

    Parameters
    ----------
    atomgroup : MDAnalysis.AtomGroup
        Its rotatable bonds are taken.
    torsions : sequence of Torsion, optional
        Default: :func:`~pliant.measure.rotatable.rotatable_torsions` of the atoms.
    bonds : (B, 2) integers, optional
        Atom indices; default: the bonds of the topology.
    heavy_only : bool
        Leave out hydrogens and what turns nothing but hydrogens.
    bins : int
        Of the histograms, over the whole turn.

    Attributes
    ----------
    torsions : list of Torsion
        T torsions: their four atoms, kind and label.
    results.angles : (F, T)
        Degrees, in [-180, 180].
    results.density : (T, bins)
        Share of the frames per degree; each row times the bin width adds up to 1.
    results.edges : (bins + 1,)
        Degrees.
    results.mean : (T,)
        Circular mean, degrees.
    results.spread : (T,)
        Circular standard deviation sqrt(-2 ln R), degrees, where R is the length of the mean of
        the unit vectors (K. V. Mardia, P. E. Jupp, Directional Statistics (2000), 2.3.1). It
        exceeds 180 where the angle takes all values alike; at most 360 is given.
    """

    _merge: ClassVar[Mapping[str, Merge]] = {"angles": joined}

    def __init__(
        self,
        atomgroup: AtomGroup,
        torsions: Sequence[Torsion] | None = None,
        bonds: npt.ArrayLike | None = None,
        heavy_only: bool = True,
        bins: int = 36,
        **kwargs: Any,
    ) -> None:
        super().__init__(atomgroup.universe.trajectory, **kwargs)
        if torsions is None:
            torsions = rotatable_torsions(atomgroup, bonds=bonds, heavy_only=heavy_only)
        self.torsions = list(torsions)
        self._bins = bins
        indices = np.array([t.atoms for t in self.torsions], dtype=np.int64).reshape(-1, 4)
        self._ends = [atomgroup.universe.atoms[column] for column in indices.T]

    def _prepare(self) -> None:
        self._allocate("angles", len(self.torsions))

    def _single_frame(self) -> None:
        if self.torsions:
            radians = calc_dihedrals(*(end.positions for end in self._ends))
            self.results.angles[self._frame_index] = np.degrees(radians)

    def _conclude(self) -> None:
        angles = self.results.angles
        self.results.edges = np.linspace(-180.0, 180.0, self._bins + 1)
        self.results.density = np.array(
            [np.histogram(row, self.results.edges, density=True)[0] for row in angles.T]
        ).reshape(-1, self._bins)
        self.results.mean, self.results.spread = circular_moments(angles)


def circular_moments(angles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Circular mean and standard deviation (T,), degrees, of angles (F, T) in degrees."""
    parts = np.array_split(angles, max(1, angles.nbytes >> 21), axis=1)
    vector = np.concatenate([np.exp(1j * np.radians(part)).mean(axis=0) for part in parts])
    length = np.clip(np.abs(vector), np.exp(-0.5 * (2 * np.pi) ** 2), 1.0)
    return np.degrees(np.angle(vector)), np.degrees(np.sqrt(-2.0 * np.log(length)))
