# SPDX-License-Identifier: MIT
"""Root mean square fluctuation (RMSF, mobility) of atoms and residues about their average."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from pliant.measure.frames import FrameAnalysis, Merge, reference_positions, summed, weights_of
from pliant.trajectory.superposition import AVERAGE_TOLERANCE, Superposition

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup
    from MDAnalysis.coordinates.base import ProtoReader
    from typing_extensions import Self

    from pliant.measure.frames import Weights


class Rmsf(FrameAnalysis):
    """RMSF of each atom: sqrt(<|x_i - <x_i>|^2>) over frames superposed on their average.

    The average is found by iteration: the frames are superposed on the first of them, averaged,
    superposed on that average, and so on until the average rests. Each iteration is a pass over
    the trajectory; three or four are usual. If other atoms are fitted than measured, these passes
    look at the fitted ones only, and one more pass measures.

    Parameters
    ----------
    atomgroup : MDAnalysis.AtomGroup
        The n atoms whose fluctuation is measured.
    superpose_on : MDAnalysis.AtomGroup, optional
        The m atoms that are fitted. Default: those measured.
    weights : None, "mass" or (m,) array
        Weights of the fit.
    superpose : bool
        False: take the coordinates as they are, in one pass.
    max_iterations : int
        Passes over the fitted atoms at most.

    Attributes
    ----------
    results.rmsf : (n,)
        Angstrom.
    results.residue_rmsf : (R,)
        Angstrom; root of the mean of rmsf^2 over the atoms of a residue that are in `atomgroup`.
    results.residues : (R,)
        Their resindices, rising.
    results.average : (n, 3)
        Average structure, Angstrom.
    results.fitted_average : (m, 3)
        That of the fitted atoms; a reference to superpose on.
    results.iterations : int
        Passes done over the fitted atoms.
    results.average_converged : bool
        The last of them moved the average by less than 1e-5 Angstrom.
    """

    _merge: ClassVar[Mapping[str, Merge]] = {"count": summed, "shift": summed, "square": summed}

    def __init__(
        self,
        atomgroup: AtomGroup,
        superpose_on: AtomGroup | None = None,
        weights: Weights = None,
        superpose: bool = True,
        max_iterations: int = 20,
        **kwargs: Any,
    ) -> None:
        super().__init__(atomgroup.universe.trajectory, **kwargs)
        if max_iterations < 1:
            raise ValueError(f"max_iterations: expected at least 1, got {max_iterations}")
        self._atoms = atomgroup
        self._fitted = atomgroup if superpose_on is None else superpose_on
        self._weights = weights_of(self._fitted, weights)
        self._superpose = superpose
        self._max_iterations = max_iterations

    def run(
        self,
        start: int | None = None,
        stop: int | None = None,
        step: int | None = None,
        frames: npt.ArrayLike | None = None,
        **kwargs: Any,
    ) -> Self:
        """Runs the passes; arguments as for AnalysisBase.run."""
        first = _first_frame(self._trajectory, start, stop, step, frames)
        selected: dict[str, Any] = {"start": start, "stop": stop, "step": step, "frames": frames}
        reference = reference_positions(self._fitted, first)
        converged = False
        iterations = 0
        while not converged and iterations < self._max_iterations:
            iterations += 1
            self._pass(self._fitted, reference, reference, **selected, **kwargs)
            moved = self.results.average - reference
            converged = not self._superpose or _rms(moved) < AVERAGE_TOLERANCE
            reference = self.results.average
        if self._fitted != self._atoms:
            nearby = reference_positions(self._atoms, first)
            self._pass(self._atoms, nearby, reference, **selected, **kwargs)
        for name in ("_measured", "_nearby", "_reference", "_superposition"):
            self.__dict__.pop(name, None)  # as large as a frame each
        self.results.fitted_average = reference
        self.results.iterations = iterations
        self.results.average_converged = converged
        return self

    def _pass(
        self, measured: AtomGroup, nearby: np.ndarray, reference: np.ndarray, **kwargs: Any
    ) -> None:
        """Measures atoms that are not far from `nearby`, fitted on `reference`."""
        self._measured = measured
        self._nearby = nearby
        self._reference = reference
        super().run(**kwargs)

    def _prepare(self) -> None:
        n = len(self._nearby)
        self.results.count = np.zeros(())
        self.results.shift = np.zeros((n, 3))
        self.results.square = np.zeros((n, 3))
        self._superposition = Superposition(self._reference, self._weights)

    def _single_frame(self) -> None:
        positions = self._measured.positions.astype(np.float64)
        if self._superpose:
            same = self._measured is self._fitted
            fitted = positions if same else self._fitted.positions.astype(np.float64)
            positions = self._superposition.apply(positions, fitted)
        # Sums of deviations from a point near the mean keep all digits of the variance.
        deviation = positions - self._nearby
        # In place: an assignment to results lists all their names anew.
        for name, addend in (("count", 1.0), ("shift", deviation), ("square", deviation**2)):
            total = self.results[name]
            total += addend

    def _conclude(self) -> None:
        count, shift, square = (self.results.pop(name) for name in self._merge)
        mean = shift / count
        variance = np.maximum(square / count - mean**2, 0.0)
        self.results.average = self._nearby + mean
        self.results.rmsf = np.sqrt(variance.sum(axis=1))
        self.results.residues, self.results.residue_rmsf = per_residue(
            self._measured.resindices, self.results.rmsf
        )


def per_residue(resindices: np.ndarray, rmsf: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Residues (R,) in rising order and the root mean square (R,) of their atoms' `rmsf` (n,)."""
    residues, place = np.unique(resindices, return_inverse=True)
    squares = np.bincount(place, weights=np.asarray(rmsf) ** 2)
    return residues, np.sqrt(squares / np.bincount(place))


def _rms(shift: np.ndarray) -> float:
    return float(np.sqrt(np.mean(np.sum(shift**2, axis=1))))


def _first_frame(
    trajectory: ProtoReader,
    start: int | None,
    stop: int | None,
    step: int | None,
    frames: npt.ArrayLike | None,
) -> int:
    if frames is not None:
        frames = np.asarray(frames)
        chosen: np.ndarray | range = np.flatnonzero(frames) if frames.dtype == bool else frames
    else:
        chosen = range(*trajectory.check_slice_indices(start, stop, step))
    if len(chosen) == 0:
        raise ValueError("no frames to average")
    return int(chosen[0])
