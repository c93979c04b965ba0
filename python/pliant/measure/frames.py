# SPDX-License-Identifier: MIT
"""What every analysis here has in common: it goes over frames, alone or in several processes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt
from MDAnalysis.analysis.base import AnalysisBase, Results

if TYPE_CHECKING:
    from MDAnalysis import AtomGroup
    from typing_extensions import Self


try:
    from MDAnalysis.analysis.results import ResultsGroup
except ImportError:  # MDAnalysis < 2.8 runs serially only
    ResultsGroup = None

#: whether analyses can run in several processes
HAS_BACKENDS = ResultsGroup is not None


#: Weights of n atoms: equal (None, "none"), masses ("mass"), or (n,) numbers.
Weights = npt.ArrayLike | None

#: How the parts of a result that several processes found become one.
Merge = Callable[[Sequence[np.ndarray]], np.ndarray]


def joined(arrays: Sequence[np.ndarray]) -> np.ndarray:
    """Rows of the first process, then those of the second, and so on."""
    return np.concatenate(arrays)


def summed(arrays: Sequence[np.ndarray]) -> np.ndarray:
    """Element by element sum over the processes."""
    total: np.ndarray = np.sum(arrays, axis=0)
    return total


def largest(arrays: Sequence[np.ndarray]) -> np.ndarray:
    """Element by element maximum over the processes; not a number if any is."""
    most: np.ndarray = np.max(arrays, axis=0)
    return most


class FrameAnalysis(AnalysisBase):  # type: ignore[misc]  # MDAnalysis has no types
    """An analysis whose frames are independent of each other.

    ``run()`` goes over the frames in this process;
    ``run(backend="multiprocessing", n_workers=4)`` deals them out to processes (MDAnalysis 2.8
    and later). Subclasses name what they collect, and how it is merged, in ``_merge``.
    """

    _analysis_algorithm_is_parallelizable = True

    #: name of a result that ``_single_frame`` fills -> how the parts of the processes are merged
    _merge: ClassVar[Mapping[str, Merge]] = {}

    @classmethod
    def get_supported_backends(cls) -> tuple[str, ...]:
        """Names that ``run(backend=...)`` takes."""
        return ("serial", "multiprocessing", "dask")

    def run(self, *args: Any, **kwargs: Any) -> Self:
        """Runs over the frames; arguments as for AnalysisBase.run. A second run starts afresh."""
        self.results = Results()
        super().run(*args, **kwargs)
        return self

    def _get_aggregator(self) -> ResultsGroup:
        return ResultsGroup(lookup=dict(self._merge))

    def _allocate(self, name: str, *shape: int, dtype: npt.DTypeLike = np.float64) -> None:
        """Makes ``results.name``, one row of the given shape for each frame."""
        self.results[name] = np.zeros((self.n_frames, *shape), dtype=dtype)


def reference_positions(atomgroup: AtomGroup, frame: int = 0) -> np.ndarray:
    """Positions (n, 3) of the atoms in a frame, Angstrom, float64; the trajectory stays put."""
    trajectory = atomgroup.universe.trajectory
    current = trajectory.ts.frame
    try:
        trajectory[frame]
        positions: np.ndarray = atomgroup.positions.astype(np.float64)
        return positions
    finally:
        trajectory[current]


def weights_of(atomgroup: AtomGroup, weights: Weights) -> np.ndarray:
    """Weights (n,) of atoms: None or "none" means equal, "mass" the masses, or an array.

    Raises ValueError when they are not n finite numbers >= 0 with a sum > 0.
    """
    if weights is None or (isinstance(weights, str) and weights == "none"):
        return np.ones(len(atomgroup))
    if isinstance(weights, str):
        if weights != "mass":
            raise ValueError(f"weights: expected None, 'mass' or an array, got {weights!r}")
        weights = atomgroup.masses
    weights = np.asarray(weights, dtype=np.float64)
    if weights.shape != (len(atomgroup),):
        raise ValueError(f"weights: expected shape ({len(atomgroup)},), got {weights.shape}")
    if not np.all(np.isfinite(weights)) or np.any(weights < 0) or weights.sum() <= 0:
        raise ValueError("weights: expected finite numbers >= 0 that are not all 0")
    return weights
