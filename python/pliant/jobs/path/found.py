# SPDX-License-Identifier: MIT
"""What a path is, frame by frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, cast

import numpy as np

from pliant._core import MolecularModel, PathFrame, PathOptions, Structure, TightPlace, tight_places
from pliant.base.display import Displayed, Facts
from pliant.trajectory.frames import FramesInMemory
from pliant.trajectory.trajectory import HasFrames, Trajectory

__all__ = ["MolecularPath", "PathFrame", "TightPlace"]


#: what JSON and tables have of a frame and of a tight place, in this order
FRAME = (
    *("step", "to_end", "from_start", "lost", "made", "max_residual", "held_off", "overlap"),
    "tightest",
)
PLACE = ("atoms", "overlap", "step", "frames")


def _row(of: PathFrame | TightPlace, names: Sequence[str]) -> dict[str, Any]:
    return {name: getattr(of, name) for name in names}


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
            ("contacts", f"{self.held} held, {self.only_start} released, {self.only_end} of END"),
            *(("tightest", text) for text in tight),
            *(("note", note) for note in self.notes),
        ]

    def as_json(self) -> dict[str, Any]:
        """How far it came, what had to give way, and a row for each frame."""
        return {
            "arrived": self.arrived,
            "rmsd_at_start": self.frames[0].to_end,
            "rmsd_reached": self.reached,
            "atoms": self.atoms,
            "residues_matched": self.matched,
            "contacts_held": self.held,
            "contacts_of_start": self.only_start,
            "contacts_of_end": self.only_end,
            "worst_residual": max(frame.max_residual for frame in self.frames),
            "attempts": self.attempts,
            "turned": self.turned,
            "tightest": [_row(place, PLACE) for place in self.tight_places()],
            "seconds": self.seconds,
            "notes": self.notes,
            "left_out": self.model.left_out,
            "frames": [_row(frame, FRAME) for frame in self.frames],
        }

    def tight_places(self, count: int = 3) -> list[TightPlace]:
        """Pairs of atoms that are the nearest of a frame, the most overlapping first."""
        return tight_places(self.frames, count)
