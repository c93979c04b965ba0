# SPDX-License-Identifier: MIT
"""What a path is, frame by frame."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, cast

import numpy as np

from pliant._core import MolecularModel, PathFrame, PathOptions, Structure, TightPlace, tight_places
from pliant._display import Displayed, Facts
from pliant._trajectory.frames import FramesInMemory
from pliant._trajectory.trajectory import HasFrames, Trajectory

__all__ = ["MolecularPath", "PathFrame", "TightPlace"]


@dataclass
class MolecularPath(HasFrames, Displayed):
    """A path, and what it took."""

    model: MolecularModel = field(repr=False)  #: of the start, with the contacts that both have
    positions: np.ndarray = field(repr=False)  #: (F, N, 3) Angstrom, atoms of the model
    frames: list[PathFrame]  #: F, the start first
    matched: int  #: residues
    atoms: str  #: "CA" or "heavy"
    held: int  #: contacts that both structures have
    only_start: int  #: contacts that only the start has
    only_end: int
    notes: list[str]  #: how residues were matched, where the ends met, why it ended
    attempts: int = 0  #: times that it went back and tried again
    #: degrees: the largest turn of a piece that the way was guessed with; 0 where it is straight
    turned: float = 0.0
    seconds: float = 0.0

    @property
    def structure(self) -> Structure:
        """The molecule of the start, prepared."""
        return self.model.structure

    @property
    def trajectory(self) -> Trajectory:
        """The frames, in memory."""
        return Trajectory._of(FramesInMemory(self.structure, self.positions))

    @property
    def reached(self) -> float:
        """How far the last frame is from the end, Angstrom."""
        return self.frames[-1].to_end

    @property
    def arrived(self) -> bool:
        """Whether the last frame is at the end: CA within 0.5 Angstrom, heavy atoms within 1."""
        return self.reached <= PathOptions(atoms=cast("Any", self.atoms)).arrived_within

    def facts(self) -> Facts:
        """How far it came, and what is in its way."""
        at_first = self.frames[0].to_end
        tight = [f"{one.atoms}, {one.overlap:.2f} Å" for one in self.tight_places(1)]
        return [
            ("frames", f"{len(self.frames)}"),
            ("matched", f"{self.matched} residues, by {self.atoms}"),
            ("distance from the end", f"{at_first:.2f} Å at first, {self.reached:.2f} Å reached"),
            ("contacts", f"{self.held} held, {self.only_start} let go, {self.only_end} of the end"),
            *(("tightest", text) for text in tight),
            *(("note", note) for note in self.notes),
        ]

    def tight_places(self, count: int = 3) -> list[TightPlace]:
        """Pairs of atoms that are the nearest of a frame, the most overlapping first."""
        return tight_places(self.frames, count)
