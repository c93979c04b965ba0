# SPDX-License-Identifier: MIT
"""Radius of gyration: how spread out a molecule is."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from pliant.measure.frames import FrameAnalysis, Merge, joined, weights_of

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.frames import Weights


class RadiusOfGyration(FrameAnalysis):
    """sqrt(sum_i w_i |x_i - c|^2 / sum_i w_i), c the weighted centre, frame by frame.

    Parameters
    ----------
    atomgroup : MDAnalysis.AtomGroup
        The n atoms. Periodic images are not put together first.
    weights : "mass", None or (n,) array
        Masses (the usual definition), equal weights, or numbers >= 0.

    Attributes
    ----------
    results.radius : (F,)
        Angstrom.
    """

    _merge: ClassVar[Mapping[str, Merge]] = {"radius": joined}

    def __init__(self, atomgroup: AtomGroup, weights: Weights = "mass", **kwargs: Any) -> None:
        super().__init__(atomgroup.universe.trajectory, **kwargs)
        self._atoms = atomgroup
        self._weights = weights_of(atomgroup, weights)
        self._weights = self._weights / self._weights.sum()

    def _prepare(self) -> None:
        self._allocate("radius")

    def _single_frame(self) -> None:
        positions = self._atoms.positions.astype(np.float64)
        squares = np.sum((positions - self._weights @ positions) ** 2, axis=1)
        self.results.radius[self._frame_index] = np.sqrt(self._weights @ squares)
