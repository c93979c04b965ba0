# SPDX-License-Identifier: MIT
"""Bar residuals (length errors) frame by frame, measured anew from the stored coordinates."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from pliant.measure.frames import FrameAnalysis, Merge, joined, largest
from pliant.trajectory.record import DEFAULT_TOLERANCE, read_record
from pliant.trajectory.stored import StoredPositions

if TYPE_CHECKING:
    from MDAnalysis import Universe

    from pliant.trajectory.record import RunRecord


class BarResiduals(FrameAnalysis):
    """How far each bar is from its rest length: largest, root mean square and worst bar.

    The relative residual of a bar is (length - rest) / rest. Coordinates come from the file in
    the precision in which they are stored (see :class:`~pliant.trajectory.stored.StoredPositions`);
    bars, rest lengths and tolerance from the file too, unless given.

    Parameters
    ----------
    universe : MDAnalysis.Universe
    bars : (B, 2) integers, optional
        Atom indices from 0. Default: /connectivity/bars of the H5MD file.
    rest_lengths : (B,) floats, optional
        Angstrom. Default: /parameters/framework/rest_length of the H5MD file.
    tolerance : float, optional
        Largest |relative residual| of a whole bar. Default: that of the run, or 1e-6.
    tolerance_length : float, optional
        Largest |length - rest| in Angstrom; if > 0 it holds in place of `tolerance`.
    positions : StoredPositions, optional
        Where coordinates come from; default: the file of the universe's trajectory.

    Attributes
    ----------
    results.max_relative, results.rms_relative : (F,)
        Largest and root mean square |relative residual| of a frame.
    results.max_length : (F,)
        Largest |length - rest|, Angstrom.
    results.worst_bar : (F,)
        Index of the bar with the largest |relative residual|.
    results.within : (F,) bool
        Every bar of the frame is within the tolerance.
    results.bar_max_relative : (B,)
        Largest |relative residual| of a bar over the frames.
    precision : str
        "float64" or "float32": what the residuals were computed from. A 32-bit coordinate of
        50 Angstrom is known to 4e-6 Angstrom only.
    rounded_to : float
        What the file says that coordinates were rounded to, Angstrom; 0: they were not.

    Raises
    ------
    ValueError
        When there are no bars, or bars and lengths do not fit each other or the atoms.
    """

    _merge: ClassVar[Mapping[str, Merge]] = {
        "max_relative": joined,
        "rms_relative": joined,
        "max_length": joined,
        "worst_bar": joined,
        "within": joined,
        "bar_max_relative": largest,
    }

    def __init__(
        self,
        universe: Universe,
        bars: npt.ArrayLike | None = None,
        rest_lengths: npt.ArrayLike | None = None,
        *,
        tolerance: float | None = None,
        tolerance_length: float | None = None,
        positions: StoredPositions | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(universe.trajectory, **kwargs)
        if (bars is None) != (rest_lengths is None):
            raise ValueError("bars and rest_lengths: expected both or neither")
        record = _record_of(universe) if bars is None or tolerance is None else None
        if bars is None or rest_lengths is None:
            if record is None or record.bars is None or record.rest_lengths is None:
                raise ValueError("the trajectory holds no bars with rest lengths: give them")
            bars, rest_lengths = record.bars, record.rest_lengths
        self.bars, self.rest_lengths = _checked(bars, rest_lengths, len(universe.atoms))
        self.tolerance, self.tolerance_length = _tolerances(record, tolerance, tolerance_length)
        self._positions = positions or StoredPositions(universe.trajectory)
        self.precision = self._positions.precision
        self.rounded_to = self._positions.rounded_to

    @property
    def accepted(self) -> np.ndarray:
        """(B,) largest |length - rest| that is within the tolerance, Angstrom.

        What rounding may do to a length comes on top, where the file says that it was done.
        """
        rounding = math.sqrt(3.0) * self.rounded_to  # half of it at both ends, each axis
        if self.tolerance_length > 0:
            return np.full(len(self.bars), self.tolerance_length + rounding)
        return self.tolerance * self.rest_lengths + rounding

    def _prepare(self) -> None:
        for name in ("max_relative", "rms_relative", "max_length"):
            self._allocate(name)
        self._allocate("worst_bar", dtype=np.int64)
        self._allocate("within", dtype=bool)
        self.results.bar_max_relative = np.zeros(len(self.bars))

    def _single_frame(self) -> None:
        positions = self._positions.at(self._ts)
        error = np.abs(_lengths(positions, self.bars) - self.rest_lengths)
        relative = error / self.rest_lengths
        k = self._frame_index
        worst = int(np.argmax(relative))
        self.results.worst_bar[k] = worst
        self.results.max_relative[k] = relative[worst]
        self.results.rms_relative[k] = np.sqrt(np.mean(relative**2))
        self.results.max_length[k] = error.max()
        self.results.within[k] = bool(np.all(error <= self.accepted))
        np.maximum(self.results.bar_max_relative, relative, out=self.results.bar_max_relative)

    def _conclude(self) -> None:
        self._positions.close()


def bar_residuals(
    positions: npt.ArrayLike, bars: np.ndarray, rest_lengths: np.ndarray
) -> np.ndarray:
    """Signed relative residuals (B,) of the bars (B, 2) at positions (N, 3), Angstrom."""
    lengths = _lengths(np.asarray(positions, dtype=np.float64), bars)
    return np.asarray(lengths / rest_lengths - 1.0)


def _lengths(positions: np.ndarray, bars: np.ndarray) -> np.ndarray:
    along = positions.take(bars[:, 1], axis=0)
    along -= positions.take(bars[:, 0], axis=0)
    return np.asarray(np.sqrt(np.einsum("ij,ij->i", along, along)))


def _record_of(universe: Universe) -> RunRecord | None:
    filename = universe.trajectory.filename
    if not isinstance(filename, (str, bytes)) and not hasattr(filename, "__fspath__"):
        return None
    try:
        return read_record(filename)
    except OSError:
        return None


def _tolerances(
    record: RunRecord | None, tolerance: float | None, tolerance_length: float | None
) -> tuple[float, float]:
    if tolerance_length is None:
        tolerance_length = 0.0
        if record is not None and tolerance is None:
            tolerance_length = record.tolerance_length
    if tolerance is None:
        tolerance = record.tolerance if record is not None else DEFAULT_TOLERANCE
    return float(tolerance), float(tolerance_length)


def _checked(
    bars: npt.ArrayLike, rest_lengths: npt.ArrayLike, n_atoms: int
) -> tuple[np.ndarray, np.ndarray]:
    bars = np.asarray(bars, dtype=np.int64)
    rest_lengths = np.asarray(rest_lengths, dtype=np.float64)
    if bars.ndim != 2 or bars.shape[1:] != (2,) or rest_lengths.shape != bars.shape[:1]:
        raise ValueError(
            "bars and rest_lengths: expected shapes (B, 2) and (B,), "
            f"got {bars.shape} and {rest_lengths.shape}"
        )
    if len(bars) == 0:
        raise ValueError("bars: expected at least one")
    if bars.min() < 0 or bars.max() >= n_atoms:
        raise ValueError(f"bars: expected atom indices from 0 to {n_atoms - 1}")
    if not np.all(np.isfinite(rest_lengths)) or rest_lengths.min() <= 0:
        raise ValueError("rest_lengths: expected finite numbers > 0")
    return bars, rest_lengths
