# SPDX-License-Identifier: MIT
"""The table of a path: what is told of each frame."""

from __future__ import annotations

import numpy as np

from pliant._core import Frame, Structure, measure
from pliant.path.contacts import BROKEN, off, rms
from pliant.path.ends import Ends
from pliant.path.found import PathFrame
from pliant.path.walker import ways


class Table:
    """Looks at frames of the molecule of the start."""

    def __init__(self, ends: Ends) -> None:
        self._ends = ends
        self._side = ends.start
        self._begun = ends.start.positions[ends.start.asked]

    def row(self, frame: Frame) -> PathFrame:
        """Of one frame."""
        ends, positions = self._ends, np.asarray(frame.positions)
        here = positions[self._side.asked]
        overlap, pair = self._tightest(positions)
        return PathFrame(
            frame.step,
            rms(ways(here, ends.goal)),
            rms(ways(here, self._begun)),
            int(np.sum(off(positions, ends.only_start) > BROKEN)),
            int(np.sum(off(positions, ends.to_make) <= BROKEN)),
            float(frame.max_residual),
            float(off(positions, self._side.model.contacts).max(initial=0.0)),
            overlap,
            pair,
        )  # fmt: skip

    def _tightest(self, positions: np.ndarray) -> tuple[float, str]:
        """How much nearer than allowed two atoms are at most (Angstrom), and which two."""
        found = measure(self._side.model.framework, positions)
        if found.max_overlap <= 0.0:
            return 0.0, ""
        structure = self._side.model.structure
        one, other = (_label(structure, atom) for atom in sorted(found.worst_overlap))
        return found.max_overlap, f"{one} - {other}"


def _label(structure: Structure, atom: int) -> str:
    """ "A:LYS12 NZ"."""
    return " ".join(structure.label(atom).rsplit(":", 1))
