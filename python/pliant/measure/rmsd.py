# SPDX-License-Identifier: MIT
"""Root mean square deviation (RMSD) from where a trajectory starts, after superposition."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from pliant.measure.frames import FrameAnalysis, Merge, joined, reference_positions, weights_of
from pliant.trajectory.superposition import Superposition

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup

    from pliant.measure.frames import Weights


class RmsdToStart(FrameAnalysis):
    """RMSD of atoms from a reference frame: sqrt(sum_i w_i |x_i - r_i|^2 / sum_i w_i).

    Each frame is first superposed on the reference by a least-squares fit.

    Parameters
    ----------
    atomgroup : MDAnalysis.AtomGroup
        The n atoms that are measured.
    superpose_on : MDAnalysis.AtomGroup, optional
        The atoms that are fitted, with the same kind of weights. Default: those measured.
    weights : None, "mass" or (n,) array
        Equal, masses, or numbers >= 0 (then only without `superpose_on`).
    reference_frame : int
        Frame of the trajectory that is the reference, by default the first.

    Attributes
    ----------
    results.rmsd : (F,)
        Angstrom.
    """

    _merge: ClassVar[Mapping[str, Merge]] = {"rmsd": joined}

    def __init__(
        self,
        atomgroup: AtomGroup,
        superpose_on: AtomGroup | None = None,
        weights: Weights = None,
        reference_frame: int = 0,
        **kwargs: Any,
    ) -> None:
        super().__init__(atomgroup.universe.trajectory, **kwargs)
        self._atoms = atomgroup
        self._fitted = superpose_on
        self._weights = weights_of(atomgroup, weights)
        self._weights = self._weights / self._weights.sum()
        fitted = atomgroup if superpose_on is None else superpose_on
        self._superposition = Superposition(
            reference_positions(fitted, reference_frame), weights_of(fitted, weights)
        )
        self._reference = reference_positions(atomgroup, reference_frame)

    def _prepare(self) -> None:
        self._allocate("rmsd")

    def _single_frame(self) -> None:
        fitted = None if self._fitted is None else self._fitted.positions.astype(np.float64)
        moved = self._superposition.apply(self._atoms.positions.astype(np.float64), fitted)
        squares = np.sum((moved - self._reference) ** 2, axis=1)
        self.results.rmsd[self._frame_index] = np.sqrt(self._weights @ squares)
