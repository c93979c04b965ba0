# SPDX-License-Identifier: MIT
"""Which frames of a trajectory can be analysed, and the step and time of each."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from pliant.measure.frames import FrameAnalysis, Merge, joined

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup


class FrameIndex(FrameAnalysis):
    """Whether the coordinates of a frame are finite numbers, and its step.

    A frame that was never filled, or was damaged, may hold coordinates that are not a number.

    Parameters
    ----------
    atomgroup : MDAnalysis.AtomGroup
        The atoms that are looked at.

    Attributes
    ----------
    results.finite : (F,) bool
    results.step : (F,) int
        -1 where the file tells none.
    times : (F,)
        ps.
    """

    _merge: ClassVar[Mapping[str, Merge]] = {"finite": joined, "step": joined}

    def __init__(self, atomgroup: AtomGroup, **kwargs: Any) -> None:
        super().__init__(atomgroup.universe.trajectory, **kwargs)
        self._atoms = atomgroup

    def _prepare(self) -> None:
        self._allocate("finite", dtype=bool)
        self._allocate("step", dtype=np.int64)

    def _single_frame(self) -> None:
        k = self._frame_index
        self.results.finite[k] = bool(np.isfinite(self._atoms.positions).all())
        self.results.step[k] = int(self._ts.data.get("step", -1))
