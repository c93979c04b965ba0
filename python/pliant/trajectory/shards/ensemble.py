# SPDX-License-Identifier: MIT
"""The frames of an ensemble by their numbers, over all of its shards."""

from __future__ import annotations

import warnings
from collections import OrderedDict
from collections.abc import Mapping
from functools import cached_property
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np

from pliant._core import FileError, InputError, PliantWarning, Structure
from pliant.trajectory.frames import Frames, Positions
from pliant.trajectory.h5md import FramesOfH5md
from pliant.trajectory.shards.inspect_shard import REMAKE, ShardRecord, counted_shard
from pliant.trajectory.shards.manifest import Manifest
from pliant.trajectory.shards.plan import NO_SHARD, SHARDS, EnsemblePlan, load_plan, strangers

#: Shards that are open at once: frames are mostly asked for one after another.
_OPEN = 4


def _why_empty(folder: Path, plan: EnsemblePlan) -> str:
    if any((folder / SHARDS).glob("shard-*.h5md")):  # of a job array, or of --shard
        return "no shard is counted yet: run the command of the ensemble once more"
    return f"none of its {plan.shard_count} shards is complete yet"


class EnsembleFrames(Frames):
    """All frames of the shards that are complete, shard after shard.

    A shard is checked when it is first opened: every byte, against the manifest. Raises FileError
    and InputError if there is no ensemble, a shard that was counted is gone, or there is a file
    among the shards that is none of them.
    """

    path: Path

    def __init__(self, folder: Path) -> None:
        self.path = folder
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
        self._open: OrderedDict[int, FramesOfH5md] = OrderedDict()
        #: whether every byte of all shards was found to be as it was counted
        self.are_checked = False
        self._check_all_there()

    def records_to_check(self) -> list[ShardRecord | None]:
        """What to check the file of each shard by; None where that was done."""
        return [None if self.are_checked else record for record in self.records]

    def _check_all_there(self) -> None:
        for path in strangers(self.path, self.plan):
            raise InputError(f"{path}: {NO_SHARD}")
        gone = [path for path in self.paths if not path.exists()]
        if gone:
            others = f"; so are {len(gone) - 1} others" if len(gone) > 1 else ""
            raise FileError(f"{gone[0]}: is gone: {REMAKE}{others}")

    def __len__(self) -> int:
        return int(self.ends[-1])

    @property
    def first_shard(self) -> FramesOfH5md:
        """Which has what all shards share."""
        return self._shard(0)

    @cached_property
    def structure(self) -> Structure:
        """The atoms and bonds that were recorded."""
        return self.first_shard.structure

    @property
    def atom_count(self) -> int:
        """Those of each frame."""
        return self.first_shard.atom_count

    @property
    def masses(self) -> np.ndarray:
        """(N,) u."""
        return self.first_shard.masses

    @property
    def has_names(self) -> bool:
        """Of its atoms."""
        return self.first_shard.has_names

    @property
    def parameters(self) -> Mapping[str, Any]:
        """The options, which all shards share."""
        return self.first_shard.parameters

    @property
    def has_steps(self) -> bool:
        """Of walkers, or the numbers of drawn frames."""
        return True

    def locate(self, frame: int) -> tuple[int, int]:
        """The place of a frame's shard among those that are there, and its row in it."""
        if not 0 <= frame < len(self):
            raise IndexError(f"frame {frame} of {len(self)}")
        place = int(np.searchsorted(self.ends, frame, side="right"))
        return place, int(frame - (self.ends[place - 1] if place else 0))

    def _found(self, frame: int) -> tuple[FramesOfH5md, int]:
        """The shard of a frame, and its row in it."""
        place, row = self.locate(frame)
        return self._shard(place), row

    def positions(self, frame: int) -> Positions:
        """(N, 3) Angstrom."""
        shard, row = self._found(frame)
        return shard.positions(row)

    def read(self, frames: np.ndarray) -> Positions:
        """(f, N, 3) Angstrom, of ascending frames: of each shard at once."""
        found = [self._found(frame) for frame in frames.tolist()]
        parts = [
            shard.read(np.array([row for _, row in rows]))
            for shard, rows in groupby(found, itemgetter(0))
        ]
        return np.concatenate([np.empty((0, self.atom_count, 3)), *parts])

    def step(self, frame: int) -> int:
        """The step of a frame in the run of its walker; of a sample, its number."""
        shard, row = self._found(frame)
        return shard.step(row)

    def time(self, frame: int) -> float:
        """The time of a frame in the run of its walker, ps."""
        shard, row = self._found(frame)
        return shard.time(row)

    def walker(self, frame: int) -> int | None:
        """The walker of a frame; None of a sample."""
        shard, row = self._found(frame)
        return shard.walker(row)

    def numbers(self, frame: int) -> dict[str, float | int]:
        """Step, time and observables of a frame."""
        shard, row = self._found(frame)
        return shard.numbers(row)

    @property
    def time_between(self) -> float:
        """Between frames of the first walker, ps; 0 where it has one frame."""
        return max(0.0, self.first_shard.time_between)

    def close(self) -> None:
        """Closes the shards that are open."""
        self._open.clear()

    def _shard(self, place: int) -> FramesOfH5md:
        if place not in self._open:
            while len(self._open) >= _OPEN:
                self._open.popitem(last=False)
            record = None if self.are_checked else self.records[place]
            self._open[place] = counted_shard(self.plan, record, self.paths[place])
        self._open.move_to_end(place)
        return self._open[place]

    def __getstate__(self) -> dict[str, object]:
        return {**self.__dict__, "_open": OrderedDict()}
