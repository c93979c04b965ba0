# SPDX-License-Identifier: MIT
"""The frames of an ensemble by their numbers, over all of its shards."""

from __future__ import annotations

import warnings
from collections import OrderedDict
from pathlib import Path

import numpy as np

from pliant._core import FileError, InputError, PliantWarning
from pliant.trajectory.shards.inspect_shard import REMAKE, ShardRecord
from pliant.trajectory.shards.manifest import Manifest
from pliant.trajectory.shards.open_shard import OpenShard, expect_counted
from pliant.trajectory.shards.plan import NO_SHARD, SHARDS, EnsemblePlan, load_plan, strangers

#: Shards that are open at once: frames are mostly asked for one after another.
_OPEN = 4


def folder_of(path: Path) -> Path:
    """The folder of an ensemble, of which `path` is this folder or the plan in it."""
    return path if path.is_dir() else path.parent


def _why_empty(folder: Path, plan: EnsemblePlan) -> str:
    if any((folder / SHARDS).glob("shard-*.h5md")):  # of a job array, or of --shard
        return "no shard is counted yet: run the command of the ensemble once more"
    return f"none of its {plan.shard_count} shards is complete yet"


class EnsembleFrames:
    """All frames of the shards that are complete, shard after shard.

    A shard is checked when it is first opened: every byte, against the manifest. Raises FileError
    and InputError if there is no ensemble, or none of its shards.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.plan = load_plan(folder)
        self.records = Manifest(folder, self.plan).in_order()
        if not self.records:
            raise InputError(f"{folder}: {_why_empty(folder, self.plan)}")
        if len(self.records) < self.plan.shard_count:
            there = f"{len(self.records)} of {self.plan.shard_count}"
            warnings.warn(f"{folder}: {there} shards are there", PliantWarning, stacklevel=3)
        # Names come from the plan: nothing in the manifest leads to another file.
        self.paths = [folder / self.plan.shard(record.shard).name for record in self.records]
        self.ends = np.cumsum([record.frames for record in self.records])
        self._open: OrderedDict[int, OpenShard] = OrderedDict()
        #: whether every byte of all shards was found to be as it was counted
        self.are_checked = False

    def records_to_check(self) -> list[ShardRecord | None]:
        """What to check the file of each shard by; None where that was done."""
        return [None if self.are_checked else record for record in self.records]

    def check_all_there(self) -> None:
        """Raises FileError naming the first shard that was counted and is gone.

        Raises InputError naming a file among the shards that is none of this ensemble.
        """
        for path in strangers(self.folder, self.plan):
            raise InputError(f"{path}: {NO_SHARD}")
        gone = [path for path in self.paths if not path.exists()]
        if gone:
            others = f"; so are {len(gone) - 1} others" if len(gone) > 1 else ""
            raise FileError(f"{gone[0]}: is gone: {REMAKE}{others}")

    def __len__(self) -> int:
        return int(self.ends[-1])

    @property
    def atom_count(self) -> int:
        """Atoms of each frame."""
        return self._shard(0).atom_count

    def locate(self, frame: int) -> tuple[int, int]:
        """The place of a frame's shard among those that are there, and its row in it."""
        if not 0 <= frame < len(self):
            raise IndexError(f"frame {frame} of {len(self)}")
        place = int(np.searchsorted(self.ends, frame, side="right"))
        return place, int(frame - (self.ends[place - 1] if place else 0))

    def read(self, frame: int, into: np.ndarray) -> dict[str, float | int]:
        """Puts positions (N, 3) into an array; returns step, time and observables."""
        self.read_positions(frame, into)
        return self.numbers(frame)

    def read_positions(self, frame: int, into: np.ndarray) -> None:
        """Puts positions (N, 3) into an array, and looks at nothing else."""
        place, row = self.locate(frame)
        self._shard(place).positions(row, into)

    def numbers(self, frame: int) -> dict[str, float | int]:
        """Step, time and observables of a frame."""
        place, row = self.locate(frame)
        return self._shard(place).numbers(row)

    def time_between_frames(self) -> float:
        """Time between frames of the first walker, ps; 0 where it has one frame."""
        times = [self.numbers(frame)["time"] for frame in range(min(2, int(self.ends[0])))]
        return max(0.0, times[-1] - times[0])

    def close(self) -> None:
        """Closes the shards that are open; reading opens them again."""
        while self._open:
            self._open.popitem()[1].close()

    def _shard(self, place: int) -> OpenShard:
        if place not in self._open:
            while len(self._open) >= _OPEN:
                self._open.popitem(last=False)[1].close()
            if not self.are_checked:
                expect_counted(self.plan, self.records[place], self.paths[place])
            self._open[place] = OpenShard(self.paths[place])
        self._open.move_to_end(place)
        return self._open[place]

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_open": OrderedDict()}
