# SPDX-License-Identifier: MIT
"""Positions of many frames: in memory while they are few, else in a file that only we see."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from pliant._core import FileError
from pliant.trajectory.chosen_frames import runs_of
from pliant.trajectory.frames import Frames, Positions

if TYPE_CHECKING:
    from typing_extensions import Self

#: positions up to this size are in memory
MEMORY_BYTES = 1 << 22
#: of those in a file so many are in memory at once
AT_ONCE_BYTES = 1 << 21
#: frames up to which each is added by itself
FEW = 8


class FrameStore:
    """Positions (F, m, 3). Those of more than MEMORY_BYTES are in a file without a name in the
    folder for temporary files (TMPDIR), which is gone when nobody uses it any more.

    Raises FileError where there is no room for it.
    """

    def __init__(
        self, frames: int, atoms: int, dtype: npt.DTypeLike = np.float64, most: int = MEMORY_BYTES
    ) -> None:
        self.shape = (frames, atoms, 3)
        self._dtype = np.dtype(dtype)
        self._row = 3 * atoms * self._dtype.itemsize
        self._atoms: np.ndarray | None = None  # that are given; None: all
        #: all of them where they are in memory; else None
        self.array: np.ndarray | None = None
        self._file: Any = None
        if frames * self._row <= most:
            self.array = np.zeros(self.shape, dtype=self._dtype)
        else:
            self._file = self._guarded(_nameless_file)
            self._guarded(lambda: os.ftruncate(self._file.fileno(), frames * self._row))

    @classmethod
    def of(cls, positions: np.ndarray) -> Self:
        """Positions (F, m, 3) that are in memory, and stay there."""
        store = cls(len(positions), 0, positions.dtype)
        store.shape = (*positions.shape[:2], 3)
        store._row = 3 * positions.shape[1] * positions.itemsize
        store.array = positions
        return store

    def __len__(self) -> int:
        return self.shape[0]

    def __reduce__(self) -> tuple[Callable[[np.ndarray], FrameStore], tuple[np.ndarray]]:
        return FrameStore.of, (self.take(np.arange(len(self))),)

    def of_atoms(self, atoms: np.ndarray) -> Self:
        """The same store, of which only these of the m atoms are read."""
        other = type(self).__new__(type(self))
        vars(other).update(vars(self))
        is_all = len(atoms) == self.shape[1] and np.array_equal(atoms, np.arange(len(atoms)))
        other._atoms = None if is_all else atoms
        return other

    def cut(self, frames: int) -> None:
        """Keeps the first frames only."""
        self.shape = (frames, *self.shape[1:])
        if self.array is not None:
            self.array = self.array[:frames]

    def put(self, first: int, frames: np.ndarray) -> None:
        """Puts frames (f, m, 3) in their places, from number `first` on."""
        if self.array is not None:
            self.array[first : first + len(frames)] = frames
            return
        if frames.size == 0:  # nothing to cast
            return
        data, at = np.ascontiguousarray(frames, dtype=self._dtype).data.cast("B"), first * self._row
        while data:
            done = self._guarded(partial(os.pwrite, self._file.fileno(), data, at))
            data, at = data[done:], at + done

    def take(self, frames: np.ndarray) -> np.ndarray:
        """Frames (f, m, 3) by their numbers."""
        if self.array is not None:
            found: np.ndarray = self.array[frames]
        else:
            parts = [self._read(run) for run in runs_of(frames)]
            found = parts[0] if len(parts) == 1 else np.concatenate(parts)
        return found if self._atoms is None else np.asarray(found[:, self._atoms])

    def blocks(self, frames: np.ndarray | None = None) -> Iterator[np.ndarray]:
        """All frames, or those of these numbers, some at a time: (f, m, 3)."""
        for part in self.parts(frames):
            yield self.take(part)

    def parts(self, frames: np.ndarray | None = None) -> list[np.ndarray]:
        """Numbers of frames that are read together; all of them where they are in memory."""
        chosen = np.arange(len(self)) if frames is None else frames
        size = len(chosen) if self.array is not None else AT_ONCE_BYTES // max(1, self._row)
        return [chosen[k : k + max(1, size)] for k in range(0, len(chosen), max(1, size))]

    def columns(self) -> Iterator[np.ndarray]:
        """Coordinates (F, c) of some atoms in all frames, then of the next atoms."""
        if self.array is not None:
            yield self.array.reshape(len(self), -1)
            return
        size = self._dtype.itemsize
        count = max(1, AT_ONCE_BYTES // (size * len(self)))
        for first in range(0, self._row // size, count):
            length = min(count * size, self._row - first * size)
            rows = [
                np.frombuffer(os.pread(self._file.fileno(), length, row), dtype=self._dtype)
                for row in range(first * size, len(self) * self._row, self._row)
            ]
            yield np.array(rows)

    def _read(self, run: np.ndarray) -> np.ndarray:
        found = np.empty((len(run), *self.shape[1:]), dtype=self._dtype)
        data, place = found.reshape(-1).data.cast("B"), int(run[0]) * self._row
        while data:
            done = os.preadv(self._file.fileno(), [data], place)
            data, place = data[done:], place + done
        return found

    def _guarded(self, act: Callable[[], Any]) -> Any:
        try:
            return act()
        except OSError as error:
            size = self.shape[0] * self._row
            raise FileError(
                f"{tempfile.gettempdir()}: no room for {size} bytes of positions: "
                f"{error.strerror} (TMPDIR names another folder)"
            ) from error


class FramesHeld(Frames):
    """The frames of a store, and their boxes (F, 6), if they have any: of MDAnalysis, say."""

    def __init__(self, store: FrameStore, boxes: npt.NDArray[np.float32] | None = None) -> None:
        self._store, self._boxes = store, boxes

    def __len__(self) -> int:
        return len(self._store)

    @property
    def atom_count(self) -> int:
        """Those of each frame."""
        return self._store.shape[1]

    def read(self, frames: np.ndarray) -> Positions:
        """(f, N, 3) Angstrom."""
        return self._store.take(frames)

    def box(self, frame: int) -> npt.NDArray[np.float32] | None:
        """(6,) as it was; None where there is none."""
        return None if self._boxes is None else self._boxes[frame]


def _nameless_file() -> Any:
    return tempfile.TemporaryFile(prefix="pliant-")


def sum_of(blocks: Iterable[np.ndarray]) -> np.ndarray:
    """Sum over the frames of all blocks (f, ...), one after the other, as numpy sums them."""
    total: np.ndarray | None = None
    for block in blocks:
        if total is None:
            total = np.add.reduce(block, axis=0)
        elif len(block) > FEW:
            total = np.add.reduce(np.concatenate([total[None], block]), axis=0)
        else:
            for frame in block:  # takes no memory
                total += frame
    assert total is not None
    return total


def variance_of(store: FrameStore, frames: np.ndarray | None = None) -> np.ndarray:
    """(m, 3) variance over the frames, to the last bit as numpy has it."""
    count = len(store) if frames is None else len(frames)
    mean = sum_of(store.blocks(frames)) / count
    squares = sum_of(_squares(block - mean) for block in store.blocks(frames))
    return np.asarray(squares / count)


def _squares(values: np.ndarray) -> np.ndarray:
    values *= values
    return values
