# SPDX-License-Identifier: MIT
"""The frames of an ensemble by their numbers, over all of its shards."""

from __future__ import annotations

import warnings
from collections import OrderedDict
from pathlib import Path

import h5py
import numpy as np

from pliant import _hdf5
from pliant._core import InputError, PliantWarning
from pliant.ensemble.inspect_shard import POSITION
from pliant.ensemble.manifest import Manifest
from pliant.ensemble.plan import load_plan

#: Shards that are open at once: frames are mostly asked for one after another.
_OPEN = 4


def folder_of(path: Path) -> Path:
    """The folder of an ensemble, of which `path` is this folder or the plan in it."""
    return path if path.is_dir() else path.parent


class EnsembleFrames:
    """All frames of the shards that are whole, shard after shard.

    Raises FileError and InputError if there is no ensemble, or none of its shards.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.plan = load_plan(folder)
        self.records = Manifest(folder).in_order()
        if not self.records:
            raise InputError(f"{folder}: no shard is whole yet")
        if len(self.records) < self.plan.shard_count:
            there = f"{len(self.records)} of {self.plan.shard_count}"
            warnings.warn(f"{folder}: {there} shards are there", PliantWarning, stacklevel=3)
        # Names come from the plan: nothing in the manifest leads to another file.
        self.paths = [folder / self.plan.shard(record.shard).name for record in self.records]
        self.ends = np.cumsum([record.frames for record in self.records])
        self._files: OrderedDict[int, h5py.File] = OrderedDict()

    def __len__(self) -> int:
        return int(self.ends[-1])

    @property
    def atom_count(self) -> int:
        """Atoms of each frame."""
        return int(self._positions(self._file(0)).shape[1])

    def locate(self, frame: int) -> tuple[int, int]:
        """The place of a frame's shard among those that are there, and its row in it."""
        if not 0 <= frame < len(self):
            raise IndexError(f"frame {frame} of {len(self)}")
        place = int(np.searchsorted(self.ends, frame, side="right"))
        return place, int(frame - (self.ends[place - 1] if place else 0))

    def read(self, frame: int, into: np.ndarray) -> dict[str, float | int]:
        """Puts positions (N, 3) into an array; returns step, time and observables."""
        place, row = self.locate(frame)
        file = self._file(place)
        positions = self._positions(file)
        if row >= len(positions) or positions.shape[1:] != into.shape:
            raise InputError(f"{file.filename}: expected frame {row} of {len(into)} atoms")
        into[:] = _hdf5.read(positions, row)
        return {name: _number(file, path, row) for name, path in _series(file).items()}

    def time_between_frames(self) -> float:
        """Of the first walker (ps); 0 where it has one frame."""
        file = self._file(0)
        times = [_number(file, f"{POSITION}/time", row) for row in range(min(2, int(self.ends[0])))]
        return max(0.0, times[-1] - times[0])

    def close(self) -> None:
        """Closes the shards that are open; reading opens them again."""
        while self._files:
            self._files.popitem()[1].close()

    def _file(self, place: int) -> h5py.File:
        if place not in self._files:
            while len(self._files) >= _OPEN:
                self._files.popitem(last=False)[1].close()
            self._files[place] = _hdf5.open_file(self.paths[place])
        self._files.move_to_end(place)
        return self._files[place]

    def _positions(self, file: h5py.File) -> h5py.Dataset:
        found = _hdf5.item(file, f"{POSITION}/value")
        if not _hdf5.is_array(found, "f", (None, None, 3)):
            raise InputError(f"{file.filename}: /{POSITION}: expected positions")
        dataset: h5py.Dataset = found
        return dataset

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_files": OrderedDict()}


def _series(file: h5py.File) -> dict[str, str]:
    """The path of each number that a frame has, by name."""
    group = _hdf5.item(file, "observables")
    names = _hdf5.names_in(group) if isinstance(group, h5py.Group) else []
    return {
        "step": f"{POSITION}/step",
        "time": f"{POSITION}/time",
        **{name: f"observables/{name}/value" for name in names},
    }


def _number(file: h5py.File, path: str, row: int) -> float | int:
    found = _hdf5.item(file, path)
    if not isinstance(found, h5py.Dataset) or found.ndim != 1 or row >= len(found):
        raise InputError(f"{file.filename}: /{path}: expected a value of frame {row}")
    number: float | int = _hdf5.read(found, row).item()
    return number
