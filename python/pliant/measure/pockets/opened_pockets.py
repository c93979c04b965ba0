# SPDX-License-Identifier: MIT
"""Pockets of a frame that are larger than at the start, by the residues that line them."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from pliant.measure.pockets.pocket_grid import RADII, find_pockets
from pliant.measure.rotatable import is_hydrogen
from pliant.measure.stages.parts import ReferenceStructure
from pliant.trajectory.superposition import Superposition

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.stages.analysis import Analysis

#: a pocket counts as opened where it has this much more room than at the start, Angstrom^3 ...
LEAST_GROWTH = 100.0
#: ... and so many standard deviations of the frames around the start more than these
LEAST_DEVIATIONS = 2.0
#: of each shape so many are told
MOST_POCKETS = 3
#: of larger molecules pockets are not looked for
MOST_ATOMS = 20_000
#: residues with fewer heavy atoms on average have lost their side chains
LEAST_ATOMS = 6.0


@dataclass(frozen=True)
class PocketChange:
    """The room beside the residues that line a pocket, Angstrom^3."""

    volume: float  #: in the frame
    at_start: float
    around: float  #: mean over some frames around the start
    deviation: float  #: standard deviation over these
    residues: np.ndarray  #: (r,) resindices of those that line it

    @property
    def growth(self) -> float:
        """How much more room there is than at the start."""
        return self.volume - self.at_start


def why_no_pockets(atoms: AtomGroup) -> str:
    """Why pockets of these atoms are not looked for; "" if they are."""
    if not hasattr(atoms, "elements"):
        return "the file does not say which elements the atoms are"
    heavy = atoms[~is_hydrogen(atoms)].select_atoms("protein or nucleic")
    if len(heavy) > MOST_ATOMS:
        return f"there are more than {MOST_ATOMS} atoms besides hydrogens"
    if len(heavy) < LEAST_ATOMS * len(heavy.residues):
        return "side chains are missing"
    return ""


class PocketFinder:
    """Measures pockets of frames, each superposed on the start by its trace."""

    def __init__(self, analysis: Analysis, trace: np.ndarray) -> None:
        self._analysis, self._trace = analysis, trace
        atoms = analysis.atoms
        self.why_not = why_no_pockets(atoms)
        if self.why_not:
            return
        atoms = atoms[~is_hydrogen(atoms)].select_atoms("protein or nucleic")
        self._atoms, self._residues = atoms.ix, atoms.resindices
        self._radii = np.array([RADII.get(e.capitalize(), RADII["C"]) for e in atoms.elements])
        start = analysis[ReferenceStructure].positions
        self._fit = Superposition(start[trace], np.ones(len(trace)))
        self._around: list[np.ndarray] = []
        self._at_start: np.ndarray | None = None

    def look_at(self, places: np.ndarray) -> None:
        """Measures the start, and frames around it."""
        near = [self._analysis.positions(k) for k in np.unique(places)]
        start = self._analysis[ReferenceStructure].positions
        self._at_start, *self._around = (rooms for rooms, _ in self._rooms([start, *near]))

    def larger_than_at_start(self, places: np.ndarray) -> list[tuple[PocketChange, ...]]:
        """Pockets of each of some frames that have opened, the largest growth first."""
        if self.why_not or self._at_start is None:
            return [()] * len(places)
        return [
            self._opened(rooms, lined)
            for rooms, lined in self._rooms([self._analysis.positions(k) for k in places])
        ]

    def _opened(self, rooms: np.ndarray, lined: list[np.ndarray]) -> tuple[PocketChange, ...]:
        assert self._at_start is not None
        changes = []
        for residues in lined:
            volume, before = float(rooms[residues].sum()), float(self._at_start[residues].sum())
            around = [one[residues].sum() for one in self._around] or [before]
            mean = float(np.mean(around))
            deviation = float(np.std(around, ddof=1)) if len(around) > 1 else 0.0
            least = max(before + LEAST_GROWTH, mean + LEAST_DEVIATIONS * deviation)
            if volume >= least:
                changes.append(PocketChange(volume, before, mean, deviation, residues))
        changes.sort(key=lambda change: -change.growth)
        return tuple(changes[:MOST_POCKETS])

    def _rooms(self, frames: list[np.ndarray]) -> Iterator[tuple[np.ndarray, list[np.ndarray]]]:
        """Of each frame: room beside each residue, and for each pocket the residues that line it.

        Each point of a pocket is beside the residue whose atom is nearest.
        """
        moved = [self._fit.apply(one[self._atoms], one[self._trace]) for one in frames]
        count = len(self._analysis.universe.residues)
        for found in find_pockets(np.array(moved), self._radii):
            owner = self._residues[found.atom]
            rooms = np.bincount(owner, minlength=count) * found.volume
            yield rooms, [np.unique(owner[found.pocket == k]) for k in range(found.count)]
