# SPDX-License-Identifier: MIT
"""Positions as they are stored: in double precision from H5MD files, which MDAnalysis rounds."""

from __future__ import annotations

import copy
import os
from typing import TYPE_CHECKING, Any

import h5py
import numpy as np
import numpy.typing as npt
from MDAnalysis import units
from MDAnalysis.coordinates.H5MD import H5MDReader

from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.hdf5.expansion import refused

if TYPE_CHECKING:
    from MDAnalysis.coordinates.base import ProtoReader
    from MDAnalysis.coordinates.timestep import Timestep


#: of positions that are read ahead
AHEAD_BYTES = 1 << 22


class StoredPositions:
    """Reads positions of a trajectory with all the digits that its file has.

    MDAnalysis holds positions as 32-bit floats: 4e-6 Angstrom at 50 Angstrom, too coarse to judge
    a bar of 1 Angstrom to one part in a million. For H5MD files the dataset is therefore read with
    h5py, as stored: transformations added to the reader do not act on it. For everything else the
    rounded positions are what there is, and `precision` says so.

    Can be copied to another process; the file is opened there when it is first read.
    """

    def __init__(self, trajectory: ProtoReader) -> None:
        self._file: h5py.File | None = None
        self._path: str | None = None
        self._numbers: np.ndarray | None = None
        self._ahead: np.ndarray | None = None
        self._ahead_from = self._last = -1
        self.precision = "float32"  #: of the numbers read: "float64" or "float32"
        self.rounded_to = 0.0  #: coordinates are multiples of this, Angstrom; 0: as they were
        #: atoms of the molecule, of which the file holds some; None: it holds all
        self.joints_of_whole: int | None = None
        if isinstance(trajectory, H5MDReader) and isinstance(
            trajectory.filename, (str, os.PathLike)
        ):
            self._use(os.fspath(trajectory.filename))

    def _use(self, path: str) -> None:
        with _hdf5.open_file(path) as file:
            group = _hdf5.first_in(file, "particles")
            value = None if group is None else _hdf5.item(group, "position/value")
            if not _hdf5.is_array(value, "fiu", (None, None, 3)):
                return
            self._path = path
            self._dataset = value.name
            unit = H5MDReader._unit_translation["length"].get(_hdf5.text(value, "unit"), "Angstrom")
            self._to_angstrom = units.get_conversion_factor("length", unit, "Angstrom")
            self.precision = "float64" if value.dtype.itemsize >= 8 else "float32"
            self.rounded_to = _hdf5.rounded_to(value) * self._to_angstrom
            self.joints_of_whole = _hdf5.joints_of_whole(group)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_file": None, "_ahead": None}

    @property
    def in_file(self) -> bool:
        """Whether positions are read from an H5MD file, by the number of the frame."""
        return self._path is not None

    def at(self, timestep: Timestep) -> np.ndarray:
        """Positions (N, 3) of an MDAnalysis timestep, Angstrom, float64."""
        if not self.in_file:
            rounded: np.ndarray = timestep.positions.astype(np.float64)
            return rounded
        return self.read(timestep.frame if self._numbers is None else self._numbers[timestep.frame])

    def read(self, frames: int | slice) -> np.ndarray:
        """Positions (N, 3) of a frame of an H5MD file, (f, N, 3) of a slice; Angstrom, float64.

        Frames that are asked for one after the other are read ahead, a block at a time.
        """
        if not isinstance(frames, slice):
            return self._one(int(frames))
        found = _hdf5.read(self._open()[self._dataset], frames)
        positions: np.ndarray = found.astype(np.float64) * self._to_angstrom
        return positions

    def _one(self, frame: int) -> np.ndarray:
        follows, self._last = frame == self._last + 1, frame
        first = self._ahead_from
        if self._ahead is not None and first <= frame < first + len(self._ahead):
            return np.array(self._ahead[frame - first])
        if not follows or frame < 0:
            found = _hdf5.read(self._open()[self._dataset], frame)
            positions: np.ndarray = found.astype(np.float64) * self._to_angstrom
            return positions
        shape = self._open()[self._dataset].shape
        count = max(1, AHEAD_BYTES // max(24 * shape[1], 1))
        self._ahead = self.read(slice(frame, min(frame + count, shape[0])))
        self._ahead_from = frame
        return np.array(self._ahead[0])

    def times_and_steps(self) -> tuple[np.ndarray, np.ndarray | None]:
        """Times (F,), ps, and steps (F,) of all frames of an H5MD file; None if it has no steps."""
        group = self._open()[self._dataset].parent
        time, step = _hdf5.item(group, "time"), _hdf5.item(group, "step")
        if not _hdf5.is_array(time, "fiu", (None,)):
            raise refused(group, "time", "expected one number a frame")
        unit = H5MDReader._unit_translation["time"].get(_hdf5.text(time, "unit"), "ps")
        times = _hdf5.read(time) * units.get_conversion_factor("time", unit, "ps")
        return times, _hdf5.read(step) if _hdf5.is_array(step, "iu", (None,)) else None

    def renumbered(self, frames: npt.ArrayLike) -> StoredPositions:
        """The same file for a universe that holds only some frames: its k-th is `frames[k]`."""
        other = copy.copy(self)
        other._file, other._ahead, other._numbers = None, None, np.asarray(frames)
        return other

    def _open(self) -> h5py.File:
        if self._file is None:
            self._file = _hdf5.open_file(self._path or "")
        return self._file

    def close(self) -> None:
        """Closes the file; the next read opens it again."""
        if self._file is not None:
            self._file.close()
            self._file = None
