# SPDX-License-Identifier: MIT
"""The frames of one shard while it is open: its datasets are looked up once, and read in blocks."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from pathlib import Path

import h5py
import numpy as np

from pliant._core import FileError, InputError
from pliant.trajectory import hdf5 as _hdf5
from pliant.trajectory.shards.inspect_shard import POSITION, REMAKE, ShardRecord, check_shard
from pliant.trajectory.shards.plan import EnsemblePlan

_POSITION_BYTES = 1 << 22  #: of a block of positions
_NUMBERS = 1024  #: of one observable in a block

#: Shards that were found to be those of their manifest, as they were then, by this process:
#: path -> device, number, size, time, SHA-256.
_good: dict[Path, tuple[int | str, ...]] = {}


def expect_counted(plan: EnsemblePlan, record: ShardRecord, path: Path) -> None:
    """Reads every byte of a shard, once as long as the file stays as it is.

    Raises FileError where it is gone or cannot be read, InputError unless it is what the manifest
    counts.
    """
    try:
        status = path.stat()
        state = (status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns, record.sha256)
        if _good.get(path) != state:
            check_shard(plan, plan.shard(record.shard), record, path)
            _good[path] = state
    except FileNotFoundError:
        raise FileError(f"{path}: is gone: {REMAKE}") from None
    except InputError as error:
        raise InputError(f"{error}; {REMAKE}") from None


def open_shard(path: Path) -> h5py.File:
    """The file of a shard. Raises FileError where it is gone, else as `_hdf5.open_file` does."""
    try:
        return _hdf5.open_file(path)
    except FileNotFoundError:
        raise FileError(f"{path}: is gone: {REMAKE}") from None


def counted_files(
    plan: EnsemblePlan, paths: Sequence[Path], records: Sequence[ShardRecord | None]
) -> Iterator[h5py.File]:
    """Each of these shards while it is open, first checked where there is a record to check it by.

    Raises as `expect_counted` and `open_shard`.
    """
    for path, record in zip(paths, records, strict=True):
        if record is not None:
            expect_counted(plan, record, path)
        with open_shard(path) as file:
            yield file


def positions_in(file: h5py.File) -> h5py.Dataset:
    """Positions (F, N, 3) of a shard. Raises InputError if it has none."""
    found = _hdf5.item(file, f"{POSITION}/value")
    if not _hdf5.is_array(found, "f", (None, None, 3)):
        raise InputError(f"{file.filename}: /{POSITION}: expected positions")
    dataset: h5py.Dataset = found
    return dataset


class Rows:
    """Rows of a dataset by their numbers, of which a block is in memory.

    Single numbers are always read in blocks. Wider rows are once they are asked for one after
    another: of frames that are far apart a block would be read in vain.
    """

    def __init__(self, dataset: h5py.Dataset, most: int) -> None:
        self._dataset = dataset
        self._most = most
        self._held = np.empty(0)
        self._first = 0
        self._last = -1

    def __len__(self) -> int:
        return len(self._dataset)

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of one row."""
        return tuple(self._dataset.shape[1:])

    def at(self, row: int) -> np.ndarray:
        """A row that is there. Not to be changed."""
        follows, self._last = row == self._last + 1, row
        if not self._first <= row < self._first + len(self._held):
            size = self._most if follows or self._dataset.ndim == 1 else 1
            self._first = row - row % size
            self._held = _hdf5.read(self._dataset, slice(self._first, self._first + size))
        found: np.ndarray = self._held[row - self._first]
        return found


class OpenShard:
    """Positions and observables of the frames of a shard; raises as `open_shard`."""

    def __init__(self, path: Path) -> None:
        self._file = open_shard(path)
        dataset = positions_in(self._file)
        row_bytes = dataset.dtype.itemsize * math.prod(dataset.shape[1:])
        self._positions = Rows(dataset, max(1, _POSITION_BYTES // max(1, row_bytes)))
        self._series: dict[str, Rows] | None = None

    @property
    def atom_count(self) -> int:
        """Atoms of each frame."""
        return self._positions.shape[0]

    def positions(self, row: int, into: np.ndarray) -> None:
        """Puts positions (N, 3) into an array. Raises InputError if it does not fit."""
        if row >= len(self._positions) or self._positions.shape != into.shape:
            name = self._file.filename
            raise InputError(f"{name}: expected frame {row} of {len(into)} atoms")
        into[:] = self._positions.at(row)

    def numbers(self, row: int) -> dict[str, float | int]:
        """Step, time and observables of a frame. Raises InputError if one is missing."""
        if self._series is None:
            paths = _paths_of_numbers(self._file)
            self._series = {name: self._rows(path) for name, path in paths.items()}
        return {name: self._number(name, rows, row) for name, rows in self._series.items()}

    def _rows(self, path: str) -> Rows:
        found = _hdf5.item(self._file, path)
        if not isinstance(found, h5py.Dataset) or found.ndim != 1:
            raise InputError(f"{self._file.filename}: /{path}: expected a number a frame")
        return Rows(found, _NUMBERS)

    def _number(self, name: str, rows: Rows, row: int) -> float | int:
        if row >= len(rows):
            raise InputError(f"{self._file.filename}: {name}: expected a value of frame {row}")
        number: float | int = rows.at(row).item()
        return number

    def close(self) -> None:
        """Closes the file."""
        self._file.close()


def _paths_of_numbers(file: h5py.File) -> dict[str, str]:
    group = _hdf5.item(file, "observables")
    names = _hdf5.names_in(group) if isinstance(group, h5py.Group) else []
    return {
        "step": f"{POSITION}/step",
        "time": f"{POSITION}/time",
        **{name: f"observables/{name}/value" for name in names},
    }
