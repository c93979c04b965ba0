# SPDX-License-Identifier: MIT
"""Bar residuals (length errors) frame by frame, measured anew from the stored coordinates."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
import numpy.typing as npt

from pliant.measure.frames import FrameAnalysis, Merge, joined, largest
from pliant.trajectory.frames import Frames, Tolerance
from pliant.trajectory.universe import source_of

if TYPE_CHECKING:
    from MDAnalysis import Universe


class BarResiduals(FrameAnalysis):
    """How far each bar is from its rest length: largest, root mean square and worst bar.

    The relative residual of a bar is (length - rest) / rest. Coordinates come from the file in
    the precision in which they are stored, where MDAnalysis has 32-bit floats: 4e-6 Angstrom at 50
    Angstrom, too coarse to judge a bar of 1 Angstrom to one part in a million. Bars, rest lengths
    and tolerance come from the file too, unless given.

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
    frames : Frames, optional
        Where coordinates come from; default: the file of the universe's trajectory.
    numbers : (F,) integers, optional
        Which of `frames` those of the universe are. Default: they are the same.

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
        frames: Frames | None = None,
        numbers: np.ndarray | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(universe.trajectory, **kwargs)
        if (bars is None) != (rest_lengths is None):
            raise ValueError("bars and rest_lengths: expected both or neither")
        self._frames = source_of(universe.trajectory) if frames is None else frames
        self._numbers = numbers
        if bars is None or rest_lengths is None:
            if self._frames is None or len(self._frames.bars) == 0:
                raise ValueError("the trajectory holds no bars with rest lengths: give them")
            bars, rest_lengths = self._frames.bars, self._frames.rest_lengths
        self.bars, self.rest_lengths = _checked(bars, rest_lengths, len(universe.atoms))
        usual = Tolerance()
        if tolerance is None and self._frames is not None:
            usual = self._frames.tolerance
        length = usual.length if tolerance_length is None else tolerance_length
        self.tolerance = float(usual.relative if tolerance is None else tolerance)
        self.tolerance_length = float(length)
        is_exact = self._frames is not None and not self._frames.is_single
        self.precision = "float64" if is_exact else "float32"
        self.rounded_to = 0.0 if self._frames is None else self._frames.rounded_to

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
        positions = self._positions()
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

    def _positions(self) -> np.ndarray:
        """(N, 3) of the current frame, float64."""
        if self._frames is None:
            rounded: np.ndarray = self._ts.positions.astype(np.float64)
            return rounded
        number = self._ts.frame if self._numbers is None else self._numbers[self._ts.frame]
        stored: np.ndarray = self._frames.read(np.array([number]))[0]
        return stored


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
