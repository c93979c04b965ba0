# SPDX-License-Identifier: MIT
"""Principal component analysis (PCA, essential dynamics): the directions of the largest motions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from pliant.measure.frames import FrameAnalysis, Merge, joined, weights_of
from pliant.measure.principal_axes import NOISE, principal_axes, principal_squares
from pliant.measure.rmsf import Rmsf
from pliant.trajectory.frame_store import MEMORY_BYTES, FrameStore, sum_of
from pliant.trajectory.superposition import Superposition

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup
    from typing_extensions import Self

LEADING = 10
"""Components that are kept where all would be large and memory matters."""


class PrincipalComponents(FrameAnalysis):
    """PCA of atom positions superposed on their average (found by iteration, see Rmsf).

    The covariance <(q - <q>)(q - <q>)^T> (divided by F - 1) of q, the coordinates or, with
    `mass_weighted`, the coordinates times the root of the masses, is diagonalised through the
    smaller of X^T X and X X^T of the centred F x 3n table X, so that nothing of size 3n x 3n is
    made where the frames are few. Memory: 24 F n bytes, a few times.

    `MDAnalysis.analysis.pca.PCA` fits to the first frame only, has no masses, makes the 3n x 3n
    covariance and runs in one process; with ``align=False`` on superposed coordinates both agree.

    Parameters
    ----------
    atomgroup : MDAnalysis.AtomGroup
        The n atoms.
    superpose : bool
        False: take the coordinates as they are.
    mass_weighted : bool
        Also in the fit.
    n_components : int, optional
        K components are kept; default: all that have variance (more than 1e-14 of the largest:
        less is rounding), min(F - 1, 3n) at most.
    in_memory : bool
        False: coordinates of many frames are in a temporary file, and where all components would be
        large the first LEADING and the projections on them are kept; eigenvalues always of all.
        Larger tables are summed in parts, which may change the last digits. In one process only.
    average : (n, 3) array, optional
        What frames are superposed on, Angstrom. Default: their average, found by iteration.

    Attributes
    ----------
    results.average : (n, 3)
        Angstrom.
    results.eigenvalues : (K,)
        Variance along each component, falling; Angstrom^2, u Angstrom^2 if mass-weighted.
    results.explained : (K,)
        Share of the total variance, which also counts components that are not kept.
    results.components : (K, 3n)
        Unit vectors, x y z of the first atom first; the largest element is positive.
    results.projections : (F, K)
        Each frame along each component; Angstrom, sqrt(u) Angstrom if mass-weighted.
    results.cosine_content : (up to 5,)
        How much the first projections look like half cosines, 0 to 1: near 1 they are those of a
        random walk, which has not visited its states repeatedly (B. Hess, Phys. Rev. E 65 (2002)
        031910). Empty with fewer than 3 frames.
    """

    _merge: ClassVar[Mapping[str, Merge]] = {"coordinates": joined}

    def __init__(
        self,
        atomgroup: AtomGroup,
        superpose: bool = True,
        mass_weighted: bool = False,
        n_components: int | None = None,
        average: npt.ArrayLike | None = None,
        in_memory: bool = True,
        **kwargs: Any,
    ) -> None:
        super().__init__(atomgroup.universe.trajectory, **kwargs)
        self._given = None if average is None else np.asarray(average, dtype=np.float64)
        if self._given is not None and self._given.shape != (len(atomgroup), 3):
            raise ValueError(
                f"average: expected shape ({len(atomgroup)}, 3), got {self._given.shape}"
            )
        self._atoms = atomgroup
        self._superpose = superpose
        self._weights = weights_of(atomgroup, "mass" if mass_weighted else None)
        self._scale = np.repeat(np.sqrt(self._weights), 3)
        self._n_components = n_components
        self._in_memory = in_memory

    def run(
        self,
        start: int | None = None,
        stop: int | None = None,
        step: int | None = None,
        frames: npt.ArrayLike | None = None,
        **kwargs: Any,
    ) -> Self:
        """Finds the average, then the components; arguments as for AnalysisBase.run."""
        selected: dict[str, Any] = {"start": start, "stop": stop, "step": step, "frames": frames}
        self._reference = (
            self._average(**selected, **kwargs) if self._given is None else self._given
        )
        self._is_stored = not self._in_memory and kwargs.get("backend", "serial") == "serial"
        return super().run(**selected, **kwargs)

    def _average(self, **kwargs: Any) -> np.ndarray:
        found = Rmsf(self._atoms, weights=self._weights, superpose=self._superpose).run(**kwargs)
        average: np.ndarray = found.results.average
        return average

    def _prepare(self) -> None:
        if self._is_stored:
            self._store = FrameStore(self.n_frames, len(self._atoms))
        else:
            self._allocate("coordinates", len(self._atoms), 3)
        self._superposition = Superposition(self._reference, self._weights)

    def _single_frame(self) -> None:
        positions = self._atoms.positions.astype(np.float64)
        if self._superpose:
            positions = self._superposition.apply(positions)
        shift = (positions - self._reference)[None]
        if self._is_stored:
            self._store.put(self._frame_index, shift)
        else:
            self.results.coordinates[self._frame_index] = shift[0]

    def _conclude(self) -> None:
        if self._is_stored:
            table = self._store
            del self._store
        else:
            table = FrameStore.of(self.results.pop("coordinates"))
        mean = sum_of(table.blocks()) / len(table)
        self.results.average = self._reference + mean
        total = self._centre(table, mean)
        squares, along = principal_squares(table)
        kept = self._kept(squares, len(table))
        components = principal_axes(table, squares, along, self._leading(kept, table))
        largest = np.argmax(np.abs(components), axis=1)
        components *= np.sign(components[np.arange(len(components)), largest])[:, None]
        self.results.components = components
        self.results.eigenvalues = squares[:kept] / max(len(table) - 1, 1)
        self.results.explained = squares[:kept] / total if total > 0 else np.zeros(kept)
        self.results.projections = np.concatenate(
            [block.reshape(len(block), -1) @ components.T for block in table.blocks()]
        )
        self.results.cosine_content = _cosine_contents(self.results.projections)
        for name in ("_reference", "_superposition"):
            self.__dict__.pop(name, None)  # as large as a frame each

    def _centre(self, table: FrameStore, mean: np.ndarray) -> float:
        """Takes the mean from all frames and weighs them; the sum of all squares."""
        scale, total = self._scale.reshape(-1, 3), 0.0
        for part in table.parts():
            block = (table.take(part) - mean) * scale
            table.put(int(part[0]), block)
            total += float(np.sum(block.reshape(len(block), -1) ** 2))
        return total

    def _leading(self, kept: int, table: FrameStore) -> int:
        """How many of the components are worked out."""
        is_large = self._is_stored and 24 * table.shape[1] * kept > MEMORY_BYTES
        return min(kept, LEADING) if is_large else kept

    def _kept(self, squares: np.ndarray, n_frames: int) -> int:
        """Components with variance, at most as many as asked for."""
        noise = squares[0] * NOISE if len(squares) else 0.0
        kept = min(int(np.count_nonzero(squares > noise)), n_frames - 1)
        return kept if self._n_components is None else min(kept, self._n_components)


def _cosine_contents(projections: np.ndarray) -> np.ndarray:
    """As MDAnalysis.analysis.pca.cosine_content has them, whose import takes a quarter second."""
    frames = len(projections)
    if frames < 3:
        return np.zeros(0)
    first, weights = projections[:, :5], simpson_weights(frames)
    halves = np.arange(1, first.shape[1] + 1)
    cosines = np.cos(np.pi / frames * np.arange(frames)[:, None] * halves)
    return np.asarray(2 / frames * (weights @ (cosines * first)) ** 2 / (weights @ first**2))


def simpson_weights(count: int) -> np.ndarray:
    """Of values at equal distances, three or more, in their integral by Simpson's rule; the last
    of an odd number of intervals is Cartwright's (J. Math. Sci. Math. Educ. 12 (2017) 1)."""
    whole = count - 1 + count % 2
    weights = np.zeros(count)
    weights[:whole:2], weights[1:whole:2] = 2 / 3, 4 / 3
    weights[[0, whole - 1]] = 1 / 3
    if whole < count:
        weights[-3:] += (-1 / 12, 2 / 3, 5 / 12)
    return weights
