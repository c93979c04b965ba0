# SPDX-License-Identifier: MIT
"""All shards of an ensemble as one H5mdReader would read them."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from pliant import _core
from pliant.trajectory.shards.frames import EnsembleFrames, folder_of


class ShardsReader:
    """Frames of all shards, one after another, with the methods of H5mdReader.

    Raises FileError and InputError if there is no ensemble, or a shard is gone.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self._frames = EnsembleFrames(folder_of(Path(path)))
        self._frames.check_all_there()

    def __len__(self) -> int:
        return len(self._frames)

    def structure(self, frame: int = 0) -> _core.Structure:
        """The atoms and bonds that were recorded, at the positions of a frame of all."""
        place, row = self._frames.locate(frame)
        return _core.H5mdReader(os.fspath(self._frames.paths[place])).structure(row)

    def positions(self, frame: int) -> np.ndarray:
        """(N, 3) float64, Angstrom: a new array."""
        found = np.empty((self._frames.atom_count, 3))
        self._frames.read_positions(frame, found)
        return found

    def step(self, frame: int) -> int:
        """The step of a frame in the run of its walker; of a sample, its number."""
        return int(self._frames.numbers(frame)["step"])

    def walker(self, frame: int) -> int | None:
        """The walker of a frame; None of a sample."""
        found = self._frames.numbers(frame).get("walker")
        return None if found is None else int(found)

    def time(self, frame: int) -> float:
        """The time of a frame in the run of its walker, ps."""
        return float(self._frames.numbers(frame)["time"])
