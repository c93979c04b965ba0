# SPDX-License-Identifier: MIT
"""The reader by which MDAnalysis shows frames: of H5MD files of ours, of ensembles, in memory."""

from __future__ import annotations

import contextlib
import os
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt
from MDAnalysis.coordinates.base import ReaderBase
from MDAnalysis.coordinates.H5MD import H5MDWriter
from MDAnalysis.coordinates.timestep import Timestep
from MDAnalysis.lib.util import store_init_arguments

from pliant._core import Error, FileError, InputError, check_hdf5, writer_of
from pliant.trajectory.frames import Frames
from pliant.trajectory.opened import frames_of
from pliant.trajectory.sources import H5MD

AHEAD_BYTES = 1 << 20  #: of positions that are read at once where frames follow one another


def is_ours(thing: object) -> bool:
    """Whether MDAnalysis is given an H5MD file that Pliant wrote, or is writing."""
    if not isinstance(thing, (str, os.PathLike)) or Path(thing).suffix.lower() not in H5MD:
        return False
    if not Path(thing).is_file() or _is_written_here(thing):
        return False
    try:
        check_hdf5(thing)
        with h5py.File(thing, "r") as file:
            return bool(file["h5md/creator"].attrs["name"] == "pliant")
    except (Error, OSError, KeyError):
        return bool(writer_of(thing))


def expect_sound(path: str | os.PathLike[str]) -> None:
    """Looks at an H5MD file before h5py reads it. Raises InputError where it is damaged."""
    if not _is_written_here(path):
        check_hdf5(path)


def _is_written_here(path: str | os.PathLike[str]) -> bool:
    """Whether this process writes a file with h5py, which reads what it holds in memory."""
    name = os.fsencode(path)
    with contextlib.suppress(ValueError):  # closed since it was listed
        for file in h5py.h5f.get_obj_ids(h5py.h5f.OBJ_ALL, h5py.h5f.OBJ_FILE):
            if file.name == name and file.get_intent() != h5py.h5f.ACC_RDONLY:
                return True
    return False


class LateTimestep(Timestep):  # type: ignore[misc]  # MDAnalysis has no types
    """A frame whose ``data`` has the numbers of a file once somebody looks at it."""

    _late: Callable[[], dict[str, float | int]] | None = None

    def show(self, positions: npt.NDArray[np.float32], box: object, time: float) -> None:
        """Shows another frame."""
        self.positions, self.dimensions, self.time = positions, box, time

    def read_later(self, numbers: Callable[[], dict[str, float | int]]) -> None:
        """What `data` gets, but for the time, which it has."""
        self._late = numbers

    @property
    def data(self) -> dict[str, Any]:
        """Time, step and observables of the frame, and what others put there."""
        found: dict[str, Any] = Timestep.data.__get__(self)
        if self._late is not None:
            numbers, self._late = self._late(), None
            found.update({name: one for name, one in numbers.items() if name != "time"})
        return found

    @data.setter
    def data(self, values: dict[str, Any]) -> None:
        self._late = None
        Timestep.data.__set__(self, values)

    # The base class, which is compiled, does not go by way of `data`.

    def __getstate__(self) -> dict[str, Any]:
        _ = self.data
        state: dict[str, Any] = super().__getstate__()
        return state

    @classmethod
    def from_timestep(cls, other: Timestep, **kwargs: object) -> Any:
        """A copy of another frame."""
        _ = other.data
        return super().from_timestep(other, **kwargs)

    def copy_slice(self, sel: Any) -> Any:
        """A copy of some of the atoms."""
        _ = self.data
        return super().copy_slice(sel)


class FramesReader(ReaderBase):  # type: ignore[misc]  # MDAnalysis has no types
    """Frames as a trajectory; ``ts.data`` has the numbers of each that a file tells.

    source: the frames, or the path of an H5MD file, or of an ensemble, of which all shards are one
    trajectory.
    """

    format = "PLIANT"
    #: as MDAnalysis has them; frames have neither velocities nor forces
    units = {"time": "ps", "length": "Angstrom", "velocity": None, "force": None}  # noqa: RUF012
    _Timestep = LateTimestep
    _format_hint = staticmethod(is_ours)

    @store_init_arguments  # type: ignore[untyped-decorator]
    def __init__(self, source: Frames | str, **kwargs: object) -> None:
        self.source = source if isinstance(source, Frames) else frames_of(source)
        super().__init__(str(self.source.path or ""), **kwargs)
        self.n_frames, self.n_atoms = len(self.source), self.source.atom_count
        timing = {"dt": self.source.time_between or 1.0, **self._ts_kwargs}
        self.ts = self._Timestep(self.n_atoms, positions=True, **timing)
        self._forget()
        self._read_frame(0)

    def _forget(self) -> None:
        self._first = 0  # frame of the block of positions that was read last
        self._block = np.empty((0, self.n_atoms, 3), np.float32)

    def __getstate__(self) -> dict[str, object]:
        return {name: one for name, one in vars(self).items() if name != "_block"}

    def __setstate__(self, state: dict[str, object]) -> None:
        self.__dict__ |= state
        self._forget()

    def _reopen(self) -> None:
        self._frame = -1  # while `ts` stays as it is, which MDAnalysis expects

    def close(self) -> None:
        """Closes files that reading opens again."""
        self._forget()
        self.source.close()

    def Writer(  # noqa: N802  (as MDAnalysis has it)
        self, filename: str, n_atoms: int | None = None, **kwargs: object
    ) -> H5MDWriter:
        """MDAnalysis' writer of H5MD files."""
        return H5MDWriter(filename, n_atoms or self.n_atoms, **kwargs)

    def _read_next_timestep(self, ts: object = None) -> Any:
        if self._frame + 1 >= self.n_frames:
            raise EOFError
        try:
            return self._read_frame(self._frame + 1)
        except FileError as error:  # an OSError, which MDAnalysis takes for the end
            raise InputError(str(error)) from error

    def _read_frame(self, frame: int) -> Any:
        position = self._position(frame)
        self.ts.show(position, self.source.box(frame), self.source.time(frame))
        self.ts.read_later(partial(self.source.numbers, frame))
        self._frame = self.ts.frame = frame
        return self.ts

    def _position(self, frame: int) -> npt.NDArray[np.float32]:
        if not self._first <= frame < self._first + len(self._block):
            ahead = self._ahead() if frame == self._first + len(self._block) else 1
            frames = np.arange(frame, min(frame + ahead, self.n_frames))
            self._block = np.asarray(self.source.read(frames), np.float32)
            self._first = frame
        found: npt.NDArray[np.float32] = self._block[frame - self._first]
        return found

    def _ahead(self) -> int:
        """Frames that are read at once: twice as many each time that the next one is wanted."""
        most = AHEAD_BYTES // (12 * max(1, self.n_atoms))
        return max(1, min(2 * len(self._block), most))
